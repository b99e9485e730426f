#pragma once

#include <cstddef>
#include <string>

namespace base {

/// Asks the system for large pages before memory is written for the first time: the faults of small ones cost as much as computing
/// what the memory holds. Without effect where the system has none.
void prefer_large_pages(void* first, std::size_t bytes);

/// The same for an array of numbers.
template <class Number>
void prefer_large_pages(Number* first, std::ptrdiff_t count) {
    prefer_large_pages(static_cast<void*>(first), static_cast<std::size_t>(count) * sizeof(Number));
}

/// The memory that this process may use [bytes]: what the machine has, or less where a limit (ulimit -v) says so.
double available_memory();

/// Refuses before it is begun what cannot be held.
/// \param what the subject of the message, such as "5000000 particles"
/// \param bytes that it takes at the least \param remedy what to take instead
/// \throws particles::InvalidInput if that is more than there is
void require_memory(const std::string& what, double bytes, const std::string& remedy);

/// The same for sparse matrices, whose entries are numbered by an int.
/// \param entries of the largest of them \param bytes of all
void require_memory_of_entries(const std::string& what, double entries, double bytes,
                               const std::string& remedy);

}  // namespace base
