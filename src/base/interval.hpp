#pragma once

namespace base {

/// A closed interval of real numbers, by its ends.
struct Interval {
    double lower = 0, upper = 0;

    friend bool operator==(const Interval& a, const Interval& b) = default;
};

}  // namespace base
