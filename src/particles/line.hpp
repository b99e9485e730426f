#pragma once

#include <Eigen/Core>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "base/choose.hpp"
#include "base/errors.hpp"
#include "base/index.hpp"
#include "base/random.hpp"
#include "base/text.hpp"
#include "particles/points.hpp"

namespace particles {

using base::Index;
using base::InvalidInput;
using base::shown;

/// Convention for the part of the domain that a particle represents.
enum class Volumes {
    equal,     ///< the mean spacing δ, for every particle
    partition  ///< the particle's cell, between the midpoints to its neighbours or an end of the line
};

/// \throws InvalidInput for a name that no convention has
inline Volumes volumes_named(std::string_view wanted) {
    return base::choose<Volumes>("volume convention", wanted,
                                 {{"equal", Volumes::equal}, {"partition", Volumes::partition}});
}

inline std::string name(Volumes volumes) {
    return volumes == Volumes::equal ? "equal" : "partition";
}

/// A line of particles: positions in increasing order, and a volume for each particle [length].
/// \tparam Scalar a real type
template <class Scalar = double>
class Line {
  public:
    /// \param x positions, strictly increasing, at least two
    /// \param V volumes, not negative, one per particle
    /// \throws InvalidInput naming the particle where a condition is broken
    Line(Column<Scalar> x, Column<Scalar> V) : x_(std::move(x)), V_(std::move(V)) {
        using std::isfinite;
        if (x_.size() < 2)
            throw InvalidInput("a line needs at least 2 particles, got " + std::to_string(x_.size()));
        if (V_.size() != x_.size())
            throw InvalidInput(std::to_string(x_.size()) + " particles need as many volumes, got " +
                               std::to_string(V_.size()));
        for (Index j = 0; j < x_.size(); ++j) {
            if (!isfinite(x_[j])) refuse(j, "is not at a finite position");
            if (j > 0 && x_[j] == x_[j - 1]) refuse(j, "coincides with the particle before it" + at(j));
            if (j > 0 && x_[j] < x_[j - 1])
                refuse(j, "lies before its predecessor; sort the positions" + at(j));
        }
        for (Index j = 0; j < V_.size(); ++j)
            if (!isfinite(V_[j]) || V_[j] < 0) refuse(j, "has a volume that is negative or not finite");
    }

    [[nodiscard]] const Column<Scalar>& x() const { return x_; }
    [[nodiscard]] const Column<Scalar>& V() const { return V_; }
    [[nodiscard]] Index size() const { return x_.size(); }
    [[nodiscard]] Scalar length() const { return x_[size() - 1] - x_[0]; }

    /// Mean distance δ between consecutive particles.
    [[nodiscard]] Scalar spacing() const { return length() / Scalar(size() - 1); }

  private:
    [[noreturn]] static void refuse(Index j, const std::string& why) {
        throw InvalidInput("particle " + std::to_string(j) + " " + why);
    }
    [[nodiscard]] std::string at(Index j) const { return " (x = " + shown(static_cast<double>(x_[j])) + ")"; }

    Column<Scalar> x_, V_;
};

/// Bounds of the particles' cells: N + 1 numbers, the ends of the line and the midpoints between neighbours.
template <class Scalar>
Column<Scalar> cell_bounds(const Column<Scalar>& x) {
    const Index N = x.size();
    Column<Scalar> bounds(N + 1);
    bounds[0] = x[0];
    bounds.segment(1, N - 1) = (x.head(N - 1) + x.tail(N - 1)) / Scalar(2);
    bounds[N] = x[N - 1];
    return bounds;
}

/// A line of the given positions with the volumes of a convention. Errors as for Line.
template <class Scalar>
Line<Scalar> line_at(const Column<Scalar>& x, Volumes convention) {
    const Index N = x.size();
    if (N < 2) return Line<Scalar>(x, Column<Scalar>::Zero(N));
    if (convention == Volumes::equal)
        return Line<Scalar>(x, Column<Scalar>::Constant(N, (x[N - 1] - x[0]) / Scalar(N - 1)));
    const Column<Scalar> bounds = cell_bounds(x);
    return Line<Scalar>(x, bounds.tail(N) - bounds.head(N));
}

/// N equally spaced positions on [0, 1], both ends included: \f$x_j = (j-1)/(N-1)\f$.
template <class Scalar = double>
Column<Scalar> uniform_positions(Index N) {
    if (N < 2) throw InvalidInput("a line needs at least 2 particles, got " + std::to_string(N));
    Column<Scalar> x(N);
    for (Index j = 0; j < N; ++j) x[j] = Scalar(j) / Scalar(N - 1);
    return x;
}

/// Uniform positions whose inner particles are moved by U(−1, 1)·a·δ; the ends stay.
/// Random numbers are drawn in the order of the particles and in double precision.
/// \param a amplitude in units of the spacing δ, 0 ≤ a < 1/2 so that the order of the particles is kept
template <class Scalar = double>
Column<Scalar> perturbed_positions(Index N, double a, unsigned long seed) {
    if (!(a >= 0 && a < 0.5))
        throw InvalidInput("a perturbation of " + shown(a) +
                           " spacings does not keep the particles in order; take 0 <= a < 0.5");
    Column<Scalar> x = uniform_positions<Scalar>(N);
    base::Random random(seed);
    for (Index j = 1; j < N - 1; ++j) x[j] += Scalar(random.uniform(-1, 1) * a) / Scalar(N - 1);
    return x;
}

}  // namespace particles
