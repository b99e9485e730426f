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

/// "x = 0.5" on a line, "x = (0.5, 0.2)" in a cloud.
template <class Scalar>
std::string position_in_words(const Line<Scalar>& line, Index i) {
    return "x = " + shown(static_cast<double>(line.x()[i]));
}
template <int dim>
std::string position_in_words(const Cloud<dim>& cloud, Index i) {
    return "x = " + shown_point(cloud.x().col(i));
}

/// Distances of all particles from particle i, in their order. [length]
template <class Scalar>
Column<double> distances(const Line<Scalar>& line, Index i) {
    return (line.x() - line.x()[i]).abs().template cast<double>();
}
template <int dim>
Column<double> distances(const Cloud<dim>& cloud, Index i) {
    return (cloud.x().colwise() - cloud.x().col(i)).colwise().norm().transpose();
}

/// "second_order_fpm: particle 0 (x = 0) has 2 neighbours within 2h"
/// \param points a line or a cloud \param near neighbours of particle i
template <class Points, class Scalar, int dim, class Neighbours>
std::string neighbours_in_words(const Points& points, const Smoothing<Scalar, dim>& smoothing, Index i,
                                const Neighbours& near, const Requirement& required) {
    return std::string(required.formulation) + ": particle " + std::to_string(i) + " (" +
           position_in_words(points, i) + ") has " + std::to_string(near.size()) +
           (near.size() == 1 ? " neighbour" : " neighbours") + " within " +
           shown(static_cast<double>(support<Scalar>(smoothing.kernel())), 3) + "h";
}

/// "try --smoothing 1.6": the smallest smoothing length with which particle i has enough neighbours, rounded
/// up to a tenth. Its unit is the spacing, or the particle's own smoothing length where each has one.
template <class Points, class Scalar, int dim>
std::string remedy(const Points& points, const Smoothing<Scalar, dim>& smoothing, Index i, Index needed) {
    if (points.size() < needed) return "take at least " + std::to_string(needed) + " particles";
    Column<double> distance = distances(points, i);
    std::nth_element(distance.begin(), distance.begin() + (needed - 1), distance.end());
    const Scalar unit = smoothing.is_local() ? smoothing.h(i) : points.spacing();
    const double ratio =
        distance[needed - 1] / static_cast<double>(unit * support<Scalar>(smoothing.kernel()));
    return "try --smoothing " + shown(std::floor(10 * ratio * (1 + 1e-6) + 1) / 10) +
           (smoothing.is_local() ? " times as large" : "");
}

/// \param near the neighbours of each particle \param some particles that need enough
/// \throws FailedComputation naming the first particle with too few neighbours, and a remedy
template <class Points, class Scalar, int dim, class Neighbours>
void require_neighbours(const Points& points, const Smoothing<Scalar, dim>& smoothing,
                        const std::vector<Neighbours>& near, const Requirement& required, const Range& some) {
    for_each_index(some.size(), [&](Index k) {
        const Index i = some.first + k;
        const Neighbours& near_i = near[static_cast<std::size_t>(i)];
        if (static_cast<Index>(near_i.size()) < required.particles)
            throw FailedComputation(neighbours_in_words(points, smoothing, i, near_i, required) + ", needs " +
                                    std::to_string(required.particles) + "; " +
                                    remedy(points, smoothing, i, required.particles));
    });
}

}  // namespace particles
