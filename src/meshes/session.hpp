#pragma once

#include <string>

// Gmsh's library, started for one file.
namespace meshes {

/// Discards what libraries print on the standard output, which is for the table.
class Quiet {
  public:
    Quiet();
    ~Quiet();
    Quiet(const Quiet&) = delete;
    Quiet& operator=(const Quiet&) = delete;

  private:
    int output_;
};

/// Gmsh without anything of an earlier file, silent and on one thread.
class Session {
  public:
    explicit Session(std::string path);
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    /// Reads the file. \throws base::InvalidInput as check()
    void open() const;

    /// \throws base::InvalidInput with the first error of Gmsh's, if there is one
    void check(const std::string& what) const;

  private:
    std::string path_;
    int threads_;
};

/// \throws base::InvalidInput for a folder, and for a file that cannot be read
void check_file(const std::string& path);

}  // namespace meshes
