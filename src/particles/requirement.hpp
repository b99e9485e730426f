#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "base/errors.hpp"
#include "base/index.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "particles/neighbourhood.hpp"

namespace particles {

using base::FailedComputation;
using base::for_each_index;
using base::Index;
using base::shown;

/// How many particles a formulation needs in each neighbourhood, the particle itself included.
struct Requirement {
    std::string_view formulation;
    Index particles;
};

/// "second_order_fpm: particle 0 (x = 0) has 2 neighbours within 2h"
template <class Scalar>
std::string neighbours_in_words(const Line<Scalar>& line, const Smoothing<Scalar>& smoothing, Index i,
                                const Range& near, const Requirement& required) {
    return std::string(required.formulation) + ": particle " + std::to_string(i) +
           " (x = " + shown(static_cast<double>(line.x()[i])) + ") has " + std::to_string(near.size()) +
           (near.size() == 1 ? " neighbour" : " neighbours") + " within " +
           shown(static_cast<double>(support<Scalar>(smoothing.kernel())), 3) + "h";
}

/// "try --smoothing 1.6": the smallest smoothing length with which particle i has enough neighbours, rounded
/// up to a tenth. Its unit is the spacing, or the particle's own smoothing length where each has one.
template <class Scalar>
std::string remedy(const Line<Scalar>& line, const Smoothing<Scalar>& smoothing, Index i, Index needed) {
    if (line.size() < needed) return "take at least " + std::to_string(needed) + " particles";
    std::vector<double> distance(static_cast<std::size_t>(line.size()));
    for (Index j = 0; j < line.size(); ++j)
        distance[static_cast<std::size_t>(j)] = std::abs(static_cast<double>(line.x()[j] - line.x()[i]));
    const auto wanted = distance.begin() + (needed - 1);
    std::nth_element(distance.begin(), wanted, distance.end());
    const Scalar unit = smoothing.is_local() ? smoothing.h(i) : line.spacing();
    const double ratio = *wanted / static_cast<double>(unit * support<Scalar>(smoothing.kernel()));
    return "try --smoothing " + shown(std::floor(10 * ratio * (1 + 1e-6) + 1) / 10) +
           (smoothing.is_local() ? " times as large" : "");
}

/// \param near the neighbours of each particle
/// \throws FailedComputation naming the first particle with too few neighbours, and a remedy
template <class Scalar>
void require_neighbours(const Line<Scalar>& line, const Smoothing<Scalar>& smoothing,
                        const std::vector<Range>& near, const Requirement& required) {
    for_each_index(line.size(), [&](Index i) {
        const Range& near_i = near[static_cast<std::size_t>(i)];
        if (near_i.size() < required.particles)
            throw FailedComputation(neighbours_in_words(line, smoothing, i, near_i, required) + ", needs " +
                                    std::to_string(required.particles) + "; " +
                                    remedy(line, smoothing, i, required.particles));
    });
}

}  // namespace particles
