#pragma once

#include <cstddef>
#include <string>

namespace base {

/// The size of a large page [bytes].
inline constexpr std::size_t large_page = std::size_t{1} << 21;

/// Asks the system for large pages, the ones at both ends included. It should be called before memory is
/// first written: the page faults of small pages take longer than computing the numbers that are written,
/// on a virtual machine ten times as long. A system without large pages ignores it.
void prefer_large_pages(void* first, std::size_t bytes);

/// The same for an array of numbers.
template <class Number>
void prefer_large_pages(Number* first, std::ptrdiff_t count) {
    prefer_large_pages(static_cast<void*>(first), static_cast<std::size_t>(count) * sizeof(Number));
}

/// Leaves freed memory below 32 MB with the process, for its own next arrays: to give it back and take it
/// again costs a page fault for each 4 kB. A choice for the whole process, so that its main function makes
/// it.
void keep_freed_memory();

/// The memory that this process may use [bytes]: the machine's, or less under a limit (ulimit -v).
double available_memory();

/// Refuses a computation that does not fit into memory, before it begins.
/// \param what subject of the message, such as "5000000 particles"
/// \param bytes least memory that the computation takes \param remedy what to take instead
/// \throws InvalidInput if that is more than the available memory
void require_memory(const std::string& what, double bytes, const std::string& remedy);

/// The same for sparse matrices, whose entries are numbered by an int.
/// \param entries of the largest matrix \param bytes of all matrices
void require_memory_of_entries(const std::string& what, double entries, double bytes,
                               const std::string& remedy);

}  // namespace base
