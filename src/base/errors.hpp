#pragma once

#include <stdexcept>

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "-ffast-math removes infinity and NaN, which show where a computation has failed; compile without it"
#endif

namespace base {

/// The caller asked for something that has no meaning: N < 2, unsorted positions, h ≤ 0, an unknown name.
class InvalidInput : public std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

/// The question has a meaning but no answer: a singular neighbourhood, a singular system.
class FailedComputation : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace base
