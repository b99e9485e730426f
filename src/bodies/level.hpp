#pragma once

#include <limits>

#include "bodies/conditions.hpp"

namespace bodies {

/// The range of the given values and surroundings of a scalar; empty where lowest > highest.
struct Range {
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -lowest;

    /// The number in the range nearest to zero; zero for an empty range.
    [[nodiscard]] double nearest_to_zero() const;
};

/// The range of a scalar's given values and surroundings; empty for a displacement, since a plane of symmetry
/// would not shift with it.
/// \param conditions of the problem at the particles of the body
template <int dim, int n>
Range range_of(const Problem<dim, n>& problem, const Body<dim>& body, const Conditions<dim, n>& conditions);

/// The problem of \f$u - \ell\f$ in place of that of the scalar u: given values and surroundings less
/// \f$\ell\f$, and \f$b - c\,\ell\f$ in place of b. \param level \f$\ell\f$; zero for a displacement
template <int dim, int n>
Problem<dim, n> above_level(Problem<dim, n> problem, double level);

}  // namespace bodies
