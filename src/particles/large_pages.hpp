#pragma once

#include <sys/mman.h>

#include <Eigen/Core>
#include <cstdint>

namespace particles {

/// Asks the system for large pages before so many numbers are written for the first time: the faults of small ones cost as much
/// as computing what they hold. Without effect where the system has none.
template <class Number>
void prefer_large_pages(Number* first, Eigen::Index count) {
    constexpr std::uintptr_t page = std::uintptr_t{1} << 21;
    const auto begin = (reinterpret_cast<std::uintptr_t>(first) + page - 1) / page * page;
    const auto end = reinterpret_cast<std::uintptr_t>(first + count) / page * page;
    if (begin < end) madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
}

}  // namespace particles
