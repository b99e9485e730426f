#pragma once

#include <string>

/// Results in and out: tables, files, statistics. Input and output live here and in programs/ only.
namespace report {

/// Refuses a file that could not be written, before anything is computed for it.
/// \param path the file; empty, - or /dev/stdout for the standard output
/// \throws base::FailedComputation naming the file and the system's reason
void check_writable(const std::string& path);

/// A name for a temporary file in the folder of another, as long as names may be. \param ending such as .csv
std::string temporary_beside(const std::string& path, const std::string& ending = "");

/// Writes a text to a file as a whole: to a temporary file beside it, which is renamed when it is complete.
/// Until then an existing file stays as it is. Devices and pipes are appended to instead, and open files
/// (/dev/fd/3) are written where they stand.
/// \param path as above; of a link, the file to which it leads is replaced or made
/// \throws base::FailedComputation naming the file and the system's reason
void write_whole(const std::string& path, const std::string& text);

/// \throws base::FailedComputation naming the file and the system's reason, or a text that is too long: more
///         than a megabyte from a device (/dev/zero has no end), more than a gigabyte from anything else
std::string read_whole(const std::string& path);

}  // namespace report
