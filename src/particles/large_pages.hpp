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
    const std::uintptr_t before = (page - reinterpret_cast<std::uintptr_t>(first) % page) % page;
    const std::uintptr_t bytes = static_cast<std::uintptr_t>(count) * sizeof(Number);
    if (bytes >= before + page)
        madvise(reinterpret_cast<char*>(first) + before, (bytes - before) / page * page, MADV_HUGEPAGE);
}

}  // namespace particles
