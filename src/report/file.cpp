#include "report/file.hpp"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include "particles/errors.hpp"

namespace report {

namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

[[noreturn]] void fail(const std::string& action, const std::string& path) {
    throw particles::FailedComputation("cannot " + action + " " +
                                       (path.empty() ? "the standard output" : path) + ": " +
                                       std::strerror(errno));
}

bool put(std::FILE* file, const std::string& text) {
    return std::fwrite(text.data(), 1, text.size(), file) == text.size() && std::fflush(file) == 0;
}

}  // namespace

void write_whole(const std::string& path, const std::string& text) {
    if (path.empty()) {
        if (!put(stdout, text)) fail("write to", path);
        return;
    }
    // A link keeps pointing where it points, and what is no regular file (a pipe, a device) cannot be replaced by one.
    std::error_code none;
    const std::filesystem::file_status status = std::filesystem::status(path, none);
    const bool whole = !std::filesystem::exists(status) || std::filesystem::is_regular_file(status);
    const std::string target =
        std::filesystem::exists(status) ? std::filesystem::canonical(path, none).string() : path;
    const std::string temporary = whole ? target + ".tmp." + std::to_string(getpid()) : target;
    File file(std::fopen(temporary.c_str(), "wb"), std::fclose);
    if (!file) fail("write", path);
    const bool written = put(file.get(), text) && std::fclose(file.release()) == 0;
    if (!whole) {
        if (!written) fail("write", path);
    } else if (!written || std::rename(temporary.c_str(), target.c_str()) != 0) {
        const int reason = errno;
        std::remove(temporary.c_str());
        errno = reason;
        fail("write", path);
    }
}

std::string read_whole(const std::string& path) {
    const File file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file) fail("read", path);
    std::string text;
    std::array<char, 65536> buffer{};
    while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), file.get()))
        text.append(buffer.data(), count);
    if (std::ferror(file.get()) != 0) fail("read", path);
    return text;
}

}  // namespace report
