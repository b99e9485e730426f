#pragma once

#include <gsl/gsl_fit.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "base/errors.hpp"

namespace report {

/// Median and quartiles of a sample.
struct Quartiles {
    double lower, median, upper;
};

/// The quantile of a sample in increasing order, between two of its numbers on the straight line between
/// them.
/// \param fraction 0 for the least, 1 for the largest
inline double quantile_of_sorted(const std::vector<double>& sample, double fraction) {
    return gsl_stats_quantile_from_sorted_data(sample.data(), 1, sample.size(), fraction);
}

/// \param sample at least one number
inline Quartiles quartiles(std::vector<double> sample) {
    if (sample.empty()) throw base::InvalidInput("an empty sample has no median");
    std::sort(sample.begin(), sample.end());
    return {quantile_of_sorted(sample, 0.25), quantile_of_sorted(sample, 0.5),
            quantile_of_sorted(sample, 0.75)};
}

/// Observed order p of errors that fall like \f$\delta^p\f$: the slope of the line fitted to their
/// logarithms.
/// \param spacing distances δ, at least two
/// \param error errors, positive, as many
inline double observed_order(const std::vector<double>& spacing, const std::vector<double>& error) {
    if (spacing.size() < 2 || spacing.size() != error.size())
        throw base::InvalidInput("an order needs at least two spacings and as many errors, got " +
                                 std::to_string(spacing.size()) + " and " + std::to_string(error.size()));
    std::vector<double> x, y;
    for (std::size_t k = 0; k < spacing.size(); ++k) {
        x.push_back(std::log(spacing[k]));
        y.push_back(std::log(error[k]));
    }
    double intercept = 0, slope = 0;
    std::array<double, 4> unused{};
    gsl_fit_linear(x.data(), 1, y.data(), 1, x.size(), &intercept, &slope, unused.data(), &unused[1],
                   &unused[2], &unused[3]);
    if (!std::isfinite(slope)) throw base::InvalidInput("errors that are zero or negative have no order");
    return slope;
}

}  // namespace report
