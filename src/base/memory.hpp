#pragma once

#include <cstddef>
#include <string>

namespace base {

/// Asks the system for large pages. It should be called before memory is first written: the page faults of
/// small pages take as long as computing the numbers that are written. A system without large pages ignores
/// it.
void prefer_large_pages(void* first, std::size_t bytes);

/// The same for an array of numbers.
template <class Number>
void prefer_large_pages(Number* first, std::ptrdiff_t count) {
    prefer_large_pages(static_cast<void*>(first), static_cast<std::size_t>(count) * sizeof(Number));
}

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
