#pragma once

#include <algorithm>
#include <cstddef>

/// The quantile of n numbers in increasing order, by linear interpolation.
inline double gsl_stats_quantile_from_sorted_data(const double* sample, std::size_t /*stride*/, std::size_t n,
                                                  double fraction) {
    const double place = fraction * static_cast<double>(n - 1);
    const auto below = static_cast<std::size_t>(place);
    const double part = place - static_cast<double>(below);
    return (1 - part) * sample[below] + part * sample[std::min(below + 1, n - 1)];
}
