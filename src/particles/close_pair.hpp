#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/index.hpp"
#include "base/text.hpp"
#include "particles/smoothing.hpp"
#include "particles/spacing.hpp"

namespace particles {

using base::Index;
using base::shown;

/// Two particles far nearer to each other than one of them to all others.
struct ClosePair {
    Index first, second;  ///< their numbers, in increasing order
    double apart, next;   ///< their distance, and that to the next particle [length]

    /// "particles 3 and 7 lie 0.001 apart, the next one 0.1; leave one of them out"
    [[nodiscard]] std::string advice() const {
        return "particles " + std::to_string(first) + " and " + std::to_string(second) + " lie " +
               shown(apart, 3) + " apart, the next one " + shown(next, 3) + "; leave one of them out";
    }
};

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

/// Particle i and its nearest neighbour, if that is ten times as near as the second nearest.
/// \param points a line or a cloud
template <class Points>
std::optional<ClosePair> close_pair(const Points& points, Index i) {
    if (points.size() < 3) return {};
    const auto apart = static_cast<double>(distance_to_nearest(points, i, 1)),
               next = static_cast<double>(distance_to_nearest(points, i, 2));
    if (next < 10 * apart) return {};
    const std::vector<int> pair = pair_around(points, i, apart);
    return ClosePair{pair.front(), pair.back(), apart, next};
}

/// The numbers of a column without that of particle k.
template <class Scalar>
Column<Scalar> without(const Column<Scalar>& all, Index k) {
    Column<Scalar> rest(all.size() - 1);
    rest << all.head(k), all.tail(all.size() - 1 - k);
    return rest;
}

/// The same particles without particle k, with the same volumes.
template <class Scalar>
Line<Scalar> without(const Line<Scalar>& line, Index k) {
    return Line<Scalar>(without(line.x(), k), without(line.V(), k));
}
template <int dim>
Cloud<dim> without(const Cloud<dim>& cloud, Index k) {
    Points<dim> rest(dim, cloud.size() - 1);
    rest << cloud.x().leftCols(k), cloud.x().rightCols(cloud.size() - 1 - k);
    return Cloud<dim>(rest, without(cloud.V(), k));
}

/// A spacing of each particle without that of particle k. Where it is the distance to particle k, it becomes
/// that to the next one.
/// \param rest the points without particle k
template <class Points, class Scalar>
Column<Scalar> spacing_without(const Column<Scalar>& spacing, const Points& points, const Points& rest,
                               Index k) {
    Column<Scalar> left = without(spacing, k);
    for (Index j = 0; j < left.size(); ++j) {
        const Scalar apart = distance(points, j < k ? j : j + 1, k);
        using std::abs;
        if (abs(left[j] - apart) < 1e-12 * apart) left[j] = distance_to_nearest(rest, j, 1);
    }
    return left;
}

/// The smoothing of a line or a cloud without particle k: see spacing_without().
template <class Points, class Scalar, int dim>
Smoothing<Scalar, dim> without(const Smoothing<Scalar, dim>& smoothing, const Points& points,
                               const Points& rest, Index k) {
    if (!smoothing.is_local()) return smoothing;
    const Scalar ratio(smoothing.ratio().value_or(1));
    Column<Scalar> spacing(points.size());
    for (Index j = 0; j < points.size(); ++j) spacing[j] = smoothing.h(j) / ratio;
    const Column<Scalar> left = spacing_without(spacing, points, rest, k);
    return smoothing.ratio() ? Smoothing<Scalar, dim>(smoothing.kernel(), left, ratio)
                             : Smoothing<Scalar, dim>(smoothing.kernel(), left);
}

/// "particles 3 and 7 lie 0.001 apart, the next one 0.1; leave one of them out", where one of the two is
/// particle i, and where it helps.
/// \param serves whether the other particles do: a function of them and their Smoothing
template <class Points, class Scalar, int dim, class Serves>
std::string fewer_particles(const Points& points, const Smoothing<Scalar, dim>& smoothing, Index i,
                            const Serves& serves) {
    const auto pair = close_pair(points, i);
    if (!pair) return "";
    const Index k = pair->first == 0 ? pair->second : pair->first;  // the ends of a line stay
    const Points rest = without(points, k);
    return serves(rest, without(smoothing, points, rest, k)) ? pair->advice() : "";
}

}  // namespace particles
