#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/errors.hpp"
#include "base/index.hpp"
#include "base/parallel.hpp"
#include "particles/cloud.hpp"
#include "particles/line.hpp"
#include "particles/points.hpp"

namespace particles {

using base::for_each_index;
using base::Index;
using base::InvalidInput;

/// The distance δ that is the unit of smoothing lengths: one for all particles, or one for each.
///
/// | name | on a line | in a cloud |
/// | --- | --- | --- |
/// | mean | length/(N − 1) | that of a grid of N particles with the same bounding box |
/// | largest | the largest one between consecutive particles | the largest one to a nearest particle |
/// | local | each particle's to the farther of its two neighbours | to the farthest of the 2·dim nearest |
/// | nearest | each particle's to the nearest other one | the same |
/// | K-nearest | each particle's to the farthest of the K nearest | the same |
///
/// An end of a line has one neighbour. In one dimension the local spacing of a cloud is that of the line.
///
/// A smoothing length may be given as well, as one number for all particles or as one for each.
struct Spacing {
    enum Kind { mean, largest, local, nearest, given };

    Spacing(Kind which) : kind(which) {}
    /// \param length for all particles
    explicit Spacing(double length) : Spacing(Column<double>(Column<double>::Constant(1, length))) {}
    /// \param each a length for each particle
    explicit Spacing(Column<double> each) : kind(given), lengths(std::move(each)) {}
    /// The distance to the farthest of the k nearest particles.
    static Spacing to_nearest(Index k) {
        Spacing which(nearest);
        which.k = k;
        return which;
    }

    Kind kind;
    Index k = 1;             ///< number of nearest particles
    Column<double> lengths;  ///< if given
};

/// \throws InvalidInput for a name that no spacing has
inline Spacing spacing_named(std::string_view wanted) {
    constexpr std::array<std::pair<std::string_view, Spacing::Kind>, 4> kinds{
        {{"mean", Spacing::mean},
         {"largest", Spacing::largest},
         {"local", Spacing::local},
         {"nearest", Spacing::nearest}}};
    for (const auto& [name, kind] : kinds)
        if (name == wanted) return kind;
    Index k = 0;
    const char *const begin = wanted.data(), *const end = begin + wanted.size();
    const char* const rest = std::from_chars(begin, end, k).ptr;
    if (k > 0 && std::string_view(rest, static_cast<std::size_t>(end - rest)) == "-nearest")
        return Spacing::to_nearest(k);
    throw InvalidInput(
        "there is no spacing '" + std::string(wanted) +
        "'; choose one of mean, largest, local, nearest, or K-nearest with a number K, such as 6-nearest");
}

namespace detail {

/// \throws InvalidInput unless there is one length, or one for each of N particles
inline const Column<double>& given_lengths(const Spacing& which, Index N) {
    const Index count = which.lengths.size();
    if (count != 1 && count != N)
        throw InvalidInput(std::to_string(N) + " particles need as many spacings, or one, got " +
                           std::to_string(count));
    return which.lengths;
}

/// \throws InvalidInput unless each of N particles has k others
inline void require_others(Index k, Index N) {
    if (k < 1 || k >= N)
        throw InvalidInput("the " + std::to_string(k) + " nearest of " + std::to_string(N) +
                           " particles are not determined; take a number from 1 to " + std::to_string(N - 1));
}

}  // namespace detail

/// \f$|x_j - x_i|\f$
template <class Scalar>
Scalar distance(const Line<Scalar>& line, Index i, Index j) {
    using std::abs;
    return abs(line.x()[j] - line.x()[i]);
}
template <int dim>
double distance(const Cloud<dim>& cloud, Index i, Index j) {
    return (cloud.x().col(j) - cloud.x().col(i)).norm();
}

/// The distance from particle i to the farthest of the k nearest others, 0 < k < N.
template <class Scalar>
Scalar distance_to_nearest(const Line<Scalar>& line, Index i, Index k) {
    const Column<Scalar>& x = line.x();
    Index first = i, last = i;
    while (last - first < k)
        if (first == 0 || (last + 1 < line.size() && x[last + 1] - x[i] < x[i] - x[first - 1]))
            ++last;
        else
            --first;
    return std::max(x[last] - x[i], x[i] - x[first]);
}

template <int dim>
double distance_to_nearest(const Cloud<dim>& cloud, Index i, Index k) {
    return std::sqrt(cloud.cells().nearest(cloud.x().col(i), k + 1).back());
}

/// The same for each particle. \throws InvalidInput unless 0 < k < N
template <class Scalar = double, class Particles>
Column<Scalar> distances_to_nearest(const Particles& particles, Index k) {
    detail::require_others(k, particles.size());
    Column<Scalar> distances(particles.size());
    for_each_index(particles.size(), [&](Index i) { distances[i] = distance_to_nearest(particles, i, k); });
    return distances;
}

/// The spacing of a line's particles: one number for all, or one for each.
/// \throws InvalidInput if there are too few particles, or not as many as given lengths
template <class Scalar>
Column<Scalar> spacing(const Line<Scalar>& line, const Spacing& which) {
    const Index N = line.size();
    const Column<Scalar> apart = line.x().tail(N - 1) - line.x().head(N - 1);
    switch (which.kind) {
        case Spacing::mean:
            return Column<Scalar>::Constant(1, line.spacing());
        case Spacing::largest:
            return Column<Scalar>::Constant(1, apart.maxCoeff());
        case Spacing::local: {
            Column<Scalar> before(N), after(N);
            before << apart[0], apart;
            after << apart, apart[N - 2];
            return before.max(after);
        }
        case Spacing::nearest:
            return distances_to_nearest<Scalar>(line, which.k);
        case Spacing::given:
            break;
    }
    return detail::given_lengths(which, N).template cast<Scalar>();
}

namespace detail {

/// The local spacing of a line whose particles are in any order.
inline Column<double> local_on_a_line(const Cloud<1>& cloud) {
    const Index N = cloud.size();
    std::vector<Index> order(static_cast<std::size_t>(N));
    std::iota(order.begin(), order.end(), Index{0});
    std::sort(order.begin(), order.end(),
              [&](Index a, Index b) { return cloud.x()(0, a) < cloud.x()(0, b); });
    Column<double> x(N), local(N);
    for (Index k = 0; k < N; ++k) x[k] = cloud.x()(0, order[static_cast<std::size_t>(k)]);
    const Column<double> in_order = spacing(Line<double>(x, Column<double>::Zero(N)), Spacing::local);
    for (Index k = 0; k < N; ++k) local[order[static_cast<std::size_t>(k)]] = in_order[k];
    return local;
}

}  // namespace detail

/// The spacing of a cloud's particles: one number for all, or one for each.
/// \throws InvalidInput if there are too few particles, or not as many as given lengths
template <int dim>
Column<double> spacing(const Cloud<dim>& cloud, const Spacing& which) {
    const Index N = cloud.size();
    switch (which.kind) {
        case Spacing::mean:
            return Column<double>::Constant(1, cloud.spacing());
        case Spacing::largest:
            return Column<double>::Constant(1, cloud.apart().maxCoeff());
        case Spacing::local:
            if constexpr (dim == 1) return detail::local_on_a_line(cloud);
            return distances_to_nearest(cloud, std::min(Index{2} * dim, N - 1));
        case Spacing::nearest:
            return which.k == 1 ? cloud.apart() : distances_to_nearest(cloud, which.k);
        case Spacing::given:
            break;
    }
    return detail::given_lengths(which, N);
}

// Compiled once for each dimension, in spacing.cpp.
extern template Column<double> spacing(const Cloud<1>&, const Spacing&);
extern template Column<double> spacing(const Cloud<2>&, const Spacing&);
extern template Column<double> spacing(const Cloud<3>&, const Spacing&);

}  // namespace particles
