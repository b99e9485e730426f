#pragma once

#include <string>
#include <vector>

#include "base/index.hpp"
#include "base/text.hpp"
#include "particles/spacing.hpp"

namespace particles {

using base::Index;
using base::shown;

/// The numbers of particle i and of the one nearest to it, which lies far nearer than all others.
template <class Scalar>
std::vector<int> pair_around(const Line<Scalar>& line, Index i, double apart) {
    const bool left = i > 0 && static_cast<double>(line.x()[i] - line.x()[i - 1]) < 2 * apart;
    const int first = static_cast<int>(left ? i - 1 : i);
    return {first, first + 1};
}
template <int dim>
std::vector<int> pair_around(const Cloud<dim>& cloud, Index i, double apart) {
    return cloud.within(cloud.x().col(i), 2 * apart);
}

/// "particles 3 and 7 lie 0.001 apart, the next one 0.1; leave one of them out", where a particle's nearest
/// neighbour is ten times as near as its second nearest; else empty.
/// \param points a line or a cloud
template <class Points>
std::string close_pair(const Points& points, Index i) {
    if (points.size() < 3) return "";
    const auto apart = static_cast<double>(distance_to_nearest(points, i, 1)),
               second = static_cast<double>(distance_to_nearest(points, i, 2));
    if (second < 10 * apart) return "";
    const std::vector<int> pair = pair_around(points, i, apart);
    return "particles " + std::to_string(pair.front()) + " and " + std::to_string(pair.back()) + " lie " +
           shown(apart, 3) + " apart, the next one " + shown(second, 3) + "; leave one of them out";
}

}  // namespace particles
