#pragma once

#include <memory>
#include <string>

/// Results in and out: tables, files, statistics. Input and output live here and in programs/ only.
namespace report {

/// Signals that ask the process to end (Ctrl-C, a closed terminal, kill) wait until the scope ends, so that no temporary file is
/// left behind.
class Uninterrupted {
  public:
    Uninterrupted();
    ~Uninterrupted();
    Uninterrupted(const Uninterrupted&) = delete;
    Uninterrupted& operator=(const Uninterrupted&) = delete;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Refuses, before anything is computed, a file that could not be written in the end.
/// \param path the file; empty for the standard output
/// \throws base::FailedComputation naming the file and the system's reason
void check_writable(const std::string& path);

/// Writes a text to a file as a whole: to a temporary file beside it, which takes the file's name when it is complete. An
/// existing file stays as it is until then. A link is followed; what is no regular file, such as a pipe, is written directly.
/// \param path the file; empty for the standard output
/// \throws base::FailedComputation naming the file and the system's reason
void write_whole(const std::string& path, const std::string& text);

/// \throws base::FailedComputation naming the file and the system's reason, or a text that is too long: more than a
///         megabyte from a device (/dev/zero has no end), more than a gigabyte from anything else
std::string read_whole(const std::string& path);

}  // namespace report
