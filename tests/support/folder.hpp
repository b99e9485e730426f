#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

namespace support {

/// A new empty folder for the files of a test, removed at the end of the scope.
struct Folder {
    std::string path =
        (std::filesystem::temp_directory_path() / ("particles_test_" + std::string(6, 'X'))).string();
    Folder() { mkdtemp(path.data()); }
    ~Folder() { std::filesystem::remove_all(path); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    [[nodiscard]] long entries() const {
        return std::distance(std::filesystem::directory_iterator(path),
                             std::filesystem::directory_iterator());
    }
};

}  // namespace support
