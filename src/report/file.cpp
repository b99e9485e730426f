#include "report/file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <climits>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <system_error>

#include "base/errors.hpp"

namespace report {

namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

[[noreturn]] void fail(const std::string& action, const std::string& path) {
    throw base::FailedComputation("cannot " + action + " " + path + ": " + std::strerror(errno));
}

/// The number of an open file by its name.
std::optional<int> descriptor_named(const std::string& name) {
    if (name == "/dev/stdout") return 1;
    if (name == "/dev/stderr") return 2;
    for (const std::string folder : {"/dev/fd/", "/proc/self/fd/"}) {
        int number = -1;
        if (!name.starts_with(folder)) continue;
        const auto [end, error] =
            std::from_chars(name.data() + folder.size(), name.data() + name.size(), number);
        if (error == std::errc() && end == name.data() + name.size()) return number;
    }
    return {};
}

/// The open file that a path names, such as /dev/fd/3, itself or by a link.
std::optional<int> descriptor(const std::string& path) {
    std::error_code none;
    const auto name = std::filesystem::absolute(path, none).lexically_normal();
    if (const auto number = descriptor_named(name.string())) return number;
    return descriptor_named(std::filesystem::read_symlink(name, none).string());
}

bool is_standard_output(const std::string& path) {
    return path.empty() || path == "-" || descriptor(path) == 1;
}

/// Devices and pipes: another file cannot take their place.
bool is_appended_to(const std::string& path) {
    std::error_code none;
    const auto status = std::filesystem::status(path, none);
    return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
}

/// The file itself, where the path is a link to it, even if the link leads to a file that is yet to be made.
std::string behind_links(const std::string& path) {
    std::error_code none;
    auto file = std::filesystem::weakly_canonical(std::filesystem::absolute(path, none), none);
    constexpr int most_links = 40;  // as the system follows
    for (int k = 0; k < most_links && std::filesystem::is_symlink(file, none); ++k)
        file = std::filesystem::weakly_canonical(
            file.parent_path() / std::filesystem::read_symlink(file, none), none);
    return file.string();
}

/// The longest text that is read: a device such as /dev/zero has no end.
struct Limit {
    std::size_t bytes;
    const char* message;
};

Limit limit_of(const std::string& path) {
    std::error_code none;
    if (std::filesystem::is_character_file(path, none))
        return {std::size_t(1) << 20U, "the device gives more than a megabyte"};
    return {std::size_t(1) << 30U, "it holds more than a gigabyte"};
}

bool put(std::FILE* file, const std::string& text) {
    return std::fwrite(text.data(), 1, text.size(), file) == text.size() && std::fflush(file) == 0;
}

/// \return whether all of it was written; else errno has the reason
bool write(std::FILE* opened, const std::string& text) {
    File file(opened, std::fclose);
    return file && put(file.get(), text) && std::fclose(file.release()) == 0;
}

}  // namespace

std::string temporary_beside(const std::string& path, const std::string& ending) {
    const std::filesystem::path file = std::filesystem::absolute(path);
    const std::string mark = ".tmp." + std::to_string(getpid()) + ending;
    const std::string name = file.filename().string();
    return (file.parent_path() / (name.substr(0, NAME_MAX - mark.size()) + mark)).string();
}

void check_writable(const std::string& path) {
    if (is_standard_output(path)) return;
    if (const auto number = descriptor(path)) {
        const int flags = fcntl(*number, F_GETFL);
        errno = EBADF;
        if (flags == -1 || (flags & O_ACCMODE) == O_RDONLY) fail("write", path);
        return;
    }
    std::error_code reason;
    const auto status = std::filesystem::status(path, reason);
    const bool to_be_made = reason.value() == ENOENT;
    errno = std::filesystem::is_directory(status) ? EISDIR : reason.value();
    if (errno != 0 && !to_be_made) fail("write", path);
    if (!to_be_made && access(path.c_str(), W_OK) != 0) fail("write", path);
    if (is_appended_to(path)) return;
    const auto folder = std::filesystem::path(behind_links(path)).parent_path();
    if (access(folder.c_str(), W_OK | X_OK) != 0) fail("write", path);
}

void write_whole(const std::string& path, const std::string& text) {
    if (is_standard_output(path)) {
        if (!put(stdout, text)) fail("write to", "the standard output");
        return;
    }
    check_writable(path);
    if (const auto number = descriptor(path)) {
        if (!write(fdopen(dup(*number), "wb"), text)) fail("write", path);
        return;
    }
    if (is_appended_to(path)) {
        if (!write(std::fopen(path.c_str(), "ab"), text)) fail("write", path);
        return;
    }
    const std::string target = behind_links(path), temporary = temporary_beside(target);
    std::error_code none;
    const auto before = std::filesystem::status(target, none);
    bool written = write(std::fopen(temporary.c_str(), "wb"), text);
    if (written && std::filesystem::exists(before))
        std::filesystem::permissions(temporary, before.permissions(), none);
    written = written && std::rename(temporary.c_str(), target.c_str()) == 0;
    if (written) return;
    const int reason = errno;
    std::remove(temporary.c_str());
    errno = reason;
    fail("write", path);
}

std::string read_whole(const std::string& path) {
    const File file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file) fail("read", path);
    const Limit limit = limit_of(path);
    std::string text;
    std::array<char, 65536> buffer{};
    while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), file.get()))
        if (text.append(buffer.data(), count).size() > limit.bytes)
            throw base::FailedComputation("cannot read " + path + ": " + limit.message);
    if (std::ferror(file.get()) != 0) fail("read", path);
    return text;
}

}  // namespace report
