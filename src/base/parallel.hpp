#pragma once

#include <algorithm>
#include <atomic>
#include <exception>

#include "base/index.hpp"

namespace base {

/// Runs `work(k)` for k = 0 … count − 1 in parallel. The calls must not depend on one another. If calls fail,
/// the exception of the one with the smallest k is thrown, on any number of threads; those with a larger k
/// need not run.
template <class Work>
void for_each_index(Index count, const Work& work) {
    std::exception_ptr failure;
    std::atomic<Index> failed = count;
    [[maybe_unused]] const Index chunk = std::max<Index>(1, count / 256);
#pragma omp parallel for schedule(dynamic, chunk) if (count > 1)
    for (Index k = 0; k < count; ++k) {
        if (k > failed) continue;
        try {
            work(k);
        } catch (...) {
#pragma omp critical(first_failure)
            if (k < failed) {
                failed = k;
                failure = std::current_exception();
            }
        }
    }
    if (failure) std::rethrow_exception(failure);
}

}  // namespace base
