#include "report/file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/errors.hpp"

namespace report {

namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

[[noreturn]] void fail(const std::string& action, const std::string& path) {
    throw base::FailedComputation("cannot " + action + " " + (path.empty() ? "the standard output" : path) +
                                  ": " + std::strerror(errno));
}

/// The number of an open file that a path stands for, such as /dev/stdout or /dev/fd/3. It is written to as it is open: a file behind
/// it keeps what it holds.
std::optional<int> descriptor_of(const std::string& path) {
    if (path == "/dev/stdout") return STDOUT_FILENO;
    if (path == "/dev/stderr") return STDERR_FILENO;
    for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
        if (!path.starts_with(folder)) continue;
        const std::string number = path.substr(folder.size());
        int descriptor = -1;
        const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), descriptor);
        if (error == std::errc() && end == number.data() + number.size()) return descriptor;
    }
    return {};
}

/// The file that a path leads to, and whether one can take its place: a link keeps pointing where it points, be anything there or
/// not, and what is no regular file (a pipe, a device) cannot be replaced by one.
struct Target {
    std::string path;
    std::optional<int> descriptor;
    bool exists, replaceable;
    std::filesystem::perms permissions;
};

Target target_of(const std::string& path) {
    std::error_code none;
    std::filesystem::path end = path;
    constexpr int most_links = 40;  // as the system follows
    for (int k = 0; k < most_links && !descriptor_of(end) && std::filesystem::is_symlink(end, none); ++k)
        end = end.parent_path() / std::filesystem::read_symlink(end, none);
    const std::optional<int> descriptor = descriptor_of(end);
    const std::filesystem::file_status status = std::filesystem::status(end, none);
    const bool exists = std::filesystem::exists(status);
    return {end.string(), descriptor, exists,
            !descriptor && (!exists || std::filesystem::is_regular_file(status)), status.permissions()};
}

constexpr std::array<int, 3> ending{SIGINT, SIGTERM, SIGHUP};
volatile std::sig_atomic_t waiting = 0;  // a signal's handler can reach nothing else

extern "C" void wait_for_the_end(int signal) {
    waiting = signal;
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

}  // namespace

struct Uninterrupted::State {
    std::array<struct sigaction, ending.size()> before;
};

Uninterrupted::Uninterrupted() : state_(std::make_unique<State>()) {
    struct sigaction later {};
    later.sa_handler = wait_for_the_end;
    later.sa_flags = SA_RESTART;
    for (std::size_t k = 0; k < ending.size(); ++k) {
        sigaction(ending[k], nullptr, &state_->before[k]);
        if (state_->before[k].sa_handler == SIG_DFL) sigaction(ending[k], &later, nullptr);
    }
}

Uninterrupted::~Uninterrupted() {
    for (std::size_t k = 0; k < ending.size(); ++k) sigaction(ending[k], &state_->before[k], nullptr);
    // Within another such scope the signal goes on waiting, for that one's end.
    if (waiting != 0) std::raise(std::exchange(waiting, 0));
}

void check_writable(const std::string& path) {
    if (path.empty()) return;
    const Target target = target_of(path);
    if (target.descriptor) {
        const int flags = fcntl(*target.descriptor, F_GETFL);
        if (flags != -1 && (flags & O_ACCMODE) != O_RDONLY) return;
        errno = EBADF;
        fail("write", path);
    }
    std::error_code reason;
    errno = std::filesystem::is_directory(target.path, reason) ? EISDIR : reason.value();
    if (errno == ENOENT) errno = 0;  // it is to be made
    if (errno != 0 || (target.exists && access(target.path.c_str(), W_OK) != 0)) fail("write", path);
    const auto folder = std::filesystem::absolute(target.path).parent_path();
    if (target.replaceable && access(folder.c_str(), W_OK | X_OK) != 0) fail("write", path);
}

void write_whole(const std::string& path, const std::string& text) {
    if (path.empty()) {
        if (!put(stdout, text)) fail("write to", path);
        return;
    }
    check_writable(path);
    const auto [target, descriptor, exists, whole, permissions] = target_of(path);
    const std::string temporary = whole ? target + ".tmp." + std::to_string(getpid()) : target;
    std::optional<Uninterrupted> uninterrupted;
    if (whole) uninterrupted.emplace();
    File file(descriptor ? fdopen(dup(*descriptor), "wb") : std::fopen(temporary.c_str(), "wb"), std::fclose);
    if (!file) fail("write", path);
    std::error_code none;
    if (whole && exists) std::filesystem::permissions(temporary, permissions, none);
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
