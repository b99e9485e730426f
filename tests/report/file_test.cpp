#include "report/file.hpp"

#include <doctest/doctest.h>
#include <unistd.h>

#include <filesystem>

#include "particles/errors.hpp"

namespace {

/// A folder of its own, removed at the end.
struct Folder {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("file_test_" + std::to_string(getpid()));
    Folder() { std::filesystem::create_directories(path); }
    ~Folder() { std::filesystem::remove_all(path); }
    [[nodiscard]] std::size_t entries() const {
        return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(path), {}));
    }
};

}  // namespace

TEST_CASE("file: what is written is read, and nothing else is left") {
    const Folder folder;
    const std::string path = folder.path / "a file.csv";
    const std::string text("one\ntwo\0three\n", 14);
    report::write_whole(path, text);
    CHECK(report::read_whole(path) == text);
    report::write_whole(path, "shorter");
    CHECK(report::read_whole(path) == "shorter");
    CHECK(folder.entries() == 1);
}

TEST_CASE("file: a failure names the file and the reason and leaves nothing behind") {
    const Folder folder;
    const std::string missing = folder.path / "missing" / "file.csv";
    CHECK_THROWS_WITH_AS(report::write_whole(missing, "text"),
                         ("cannot write " + missing + ": No such file or directory").c_str(),
                         particles::FailedComputation);
    CHECK_THROWS_WITH_AS(report::read_whole(missing),
                         ("cannot read " + missing + ": No such file or directory").c_str(),
                         particles::FailedComputation);
    CHECK_THROWS_AS(report::write_whole(folder.path.string(), "text"), particles::FailedComputation);
    CHECK_FALSE(std::filesystem::exists(folder.path.string() + ".tmp." + std::to_string(getpid())));
    CHECK(folder.entries() == 0);
}

TEST_CASE("file: a full disk leaves an existing file untouched") {
    CHECK_THROWS_AS(report::write_whole("/dev/full/x", "text"), particles::FailedComputation);
}
