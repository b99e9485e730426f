#include "report/file.hpp"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>

#include "base/errors.hpp"
#include "tests/support/folder.hpp"

using support::Folder;

TEST_CASE("file: what is written is read, and nothing else is left") {
    const Folder folder;
    const std::string path = folder.path + "/a file.csv";
    const std::string text("one\ntwo\0three\n", 14);
    report::write_whole(path, text);
    CHECK(report::read_whole(path) == text);
    report::write_whole(path, "shorter");
    CHECK(report::read_whole(path) == "shorter");
    CHECK(folder.entries() == 1);
}

TEST_CASE("file: a failure names the file and the reason and leaves nothing behind") {
    const Folder folder;
    const std::string missing = folder.path + "/missing/file.csv";
    CHECK_THROWS_WITH_AS(report::write_whole(missing, "text"),
                         ("cannot write " + missing + ": No such file or directory").c_str(),
                         base::FailedComputation);
    CHECK_THROWS_WITH_AS(report::read_whole(missing),
                         ("cannot read " + missing + ": No such file or directory").c_str(),
                         base::FailedComputation);
    CHECK_THROWS_AS(report::write_whole(folder.path, "text"), base::FailedComputation);
    CHECK(folder.entries() == 0);
}

TEST_CASE("file: a disk that fills up leaves an existing file untouched, and nothing beside it") {
    const Folder folder;
    const std::string path = folder.path + "/file.csv";
    report::write_whole(path, "kept");
    // No file may grow beyond 1000 bytes: to the program, a full disk.
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const rlimit little{1000, before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &little);
    auto* const handler = std::signal(SIGXFSZ, SIG_IGN);
    CHECK_THROWS_WITH_AS(report::write_whole(path, std::string(100000, 'x')),
                         ("cannot write " + path + ": File too large").c_str(), base::FailedComputation);
    std::signal(SIGXFSZ, handler);
    setrlimit(RLIMIT_FSIZE, &before);
    CHECK(report::read_whole(path) == "kept");
    CHECK(folder.entries() == 1);
}

TEST_CASE("file: a link is followed and stays a link; a device stays a device") {
    const Folder folder;
    const std::string target = folder.path + "/target.csv", link = folder.path + "/link.csv",
                      pipe = folder.path + "/pipe";
    report::write_whole(target, "old");
    std::filesystem::create_symlink(target, link);
    report::write_whole(link, "new");
    CHECK(std::filesystem::is_symlink(link));
    CHECK(report::read_whole(target) == "new");

    REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
    const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
    report::write_whole(pipe, "through");
    std::string read(7, ' ');
    CHECK(::read(reader, read.data(), read.size()) == 7);
    CHECK(read == "through");
    CHECK(std::filesystem::is_fifo(pipe));
    close(reader);
}

TEST_CASE("file: a link to a file that is yet to be made stays a link, and the file is made") {
    const Folder folder;
    const std::string target = folder.path + "/target.csv", link = folder.path + "/link.csv",
                      second = folder.path + "/second.csv", lost = folder.path + "/lost.csv";
    std::filesystem::create_symlink("target.csv", link);
    std::filesystem::create_symlink(link, second);
    report::write_whole(second, "new");
    CHECK(std::filesystem::is_symlink(second));
    CHECK(std::filesystem::is_symlink(link));
    CHECK(report::read_whole(target) == "new");
    std::filesystem::create_symlink("none/target.csv", lost);
    CHECK_THROWS_WITH_AS(report::check_writable(lost), doctest::Contains("No such file or directory"),
                         base::FailedComputation);
}

TEST_CASE("file: a name may be as long as names can be") {
    const Folder folder;
    const std::string longest = folder.path + "/" + std::string(255, 'x');
    report::write_whole(longest, "text");
    CHECK(report::read_whole(longest) == "text");
    CHECK_THROWS_WITH_AS(report::check_writable(longest + "x"), doctest::Contains("File name too long"),
                         base::FailedComputation);
    CHECK(folder.entries() == 1);
}

TEST_CASE("file: an existing file keeps who may read it, and a link to itself is refused") {
    using std::filesystem::perms;
    const Folder folder;
    const std::string target = folder.path + "/target.csv", loop = folder.path + "/loop.csv";
    report::write_whole(target, "new");
    std::filesystem::permissions(target, perms::owner_read | perms::owner_write);
    report::write_whole(target, "newer");
    CHECK(std::filesystem::status(target).permissions() == (perms::owner_read | perms::owner_write));

    std::filesystem::create_symlink("loop.csv", loop);
    CHECK_THROWS_WITH_AS(report::write_whole(loop, "text"),
                         doctest::Contains("Too many levels of symbolic links"), base::FailedComputation);
}

TEST_CASE("file: an open file keeps what it holds; one that is closed is refused") {
    const Folder folder;
    const std::string path = folder.path + "/log";
    report::write_whole(path, "before\n");
    const int log = open(path.c_str(), O_WRONLY | O_APPEND);
    for (int k = 0; k < 2; ++k) report::write_whole("/dev/fd/" + std::to_string(log), "after\n");
    close(log);
    CHECK_THROWS_AS(report::check_writable("/dev/fd/" + std::to_string(log)), base::FailedComputation);
    CHECK(report::read_whole(path) == "before\nafter\nafter\n");
    CHECK(folder.entries() == 1);
}

TEST_CASE("file: an open file is written where it stands, by any of its names") {
    const Folder folder;
    const std::string path = folder.path + "/log", link = folder.path + "/link";
    const int log = open(path.c_str(), O_WRONLY | O_CREAT, 0600);
    const std::string number = std::to_string(log);
    std::filesystem::create_symlink("/proc/self/fd/" + number, link);
    for (const std::string& name :
         {"/dev/fd/" + number, "/proc/self/fd/" + number, "/dev/../dev/fd/" + number, link})
        report::write_whole(name, "a\n");
    CHECK(write(log, "last\n", 5) == 5);
    close(log);
    CHECK(report::read_whole(path) == "a\na\na\na\nlast\n");
}

TEST_CASE("file: a file that is open for reading is not written to") {
    const Folder folder;
    const std::string path = folder.path + "/input";
    report::write_whole(path, "input");
    const int input = open(path.c_str(), O_RDONLY);
    const std::string name = "/dev/fd/" + std::to_string(input);
    CHECK_THROWS_WITH_AS(report::write_whole(name, "output"), doctest::Contains("Bad file descriptor"),
                         base::FailedComputation);
    close(input);
    CHECK(report::read_whole(path) == "input");
}

TEST_CASE("file: what could not be written in the end is known before") {
    const Folder folder;
    const std::string path = folder.path + "/file.csv";
    CHECK_NOTHROW(report::check_writable(""));
    CHECK_NOTHROW(report::check_writable(path));
    CHECK_NOTHROW(report::check_writable("/dev/null"));
    report::write_whole(path, "kept");
    CHECK_NOTHROW(report::check_writable(path));
    for (const std::string& bad : {folder.path, folder.path + "/none/file.csv", path + "/file.csv",
                                   folder.path + "/" + std::string(300, 'x')})
        CHECK_THROWS_WITH_AS(report::check_writable(bad),
                             doctest::Contains(("cannot write " + bad + ": ").c_str()),
                             base::FailedComputation);
    CHECK(report::read_whole(path) == "kept");
    CHECK(folder.entries() == 1);
}
