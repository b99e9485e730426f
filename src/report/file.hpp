#pragma once

#include <string>

/// Results in and out: tables, files, statistics. Input and output live here and in programs/ only.
namespace report {

/// Writes a text to a file as a whole: to a temporary file beside it, which takes the file's name when it is complete. An
/// existing file stays as it is until then. A link is followed; what is no regular file, such as a pipe, is written directly.
/// \param path the file; empty for the standard output
/// \throws particles::FailedComputation naming the file and the system's reason
void write_whole(const std::string& path, const std::string& text);

/// \throws particles::FailedComputation naming the file and the system's reason
std::string read_whole(const std::string& path);

}  // namespace report
