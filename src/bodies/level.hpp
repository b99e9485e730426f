#pragma once

#include <limits>

#include "bodies/conditions.hpp"

namespace bodies {

/// What is given of a scalar lies in between.
struct Range {
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -lowest;

    /// The number of the range that is nearest to zero; zero of an empty one.
    [[nodiscard]] double nearest_to_zero() const;
};

/// The range of the values and of the surroundings that are given of a scalar; empty for a displacement, whose
/// planes of symmetry do not move with it.
/// \param conditions of the problem at the particles of the body
template <int dim, int n>
Range range_of(const Problem<dim, n>& problem, const Body<dim>& body, const Conditions<dim, n>& conditions);

/// The problem that a scalar u solves as \f$u - \ell\f$: a number less where values, surroundings and
/// \f$b - c\,\ell\f$ are given. \param level \f$\ell\f$; zero for a displacement
template <int dim, int n>
Problem<dim, n> above_level(Problem<dim, n> problem, double level);

}  // namespace bodies
