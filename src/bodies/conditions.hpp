#pragma once

#include <vector>

#include "bodies/problem.hpp"

namespace bodies {

/// One scalar condition at a boundary particle, along a direction d of the unknowns: \f$d\cdot u = g\f$, or
/// of the load on a plane with normal n, \f$d\cdot t = g - a\,d\cdot u\f$.
template <int dim, int n>
struct Condition {
    bool of_value = false;
    Values<n> direction;
    Point<dim> normal;
    double given = 0;     ///< g
    double exchange = 0;  ///< a
    int from = -1;        ///< place of the side in Problem::given; none for a free side
};

/// The conditions of each particle: n on the boundary, none inside.
template <int dim, int n>
using Conditions = std::vector<std::vector<Condition<dim, n>>>;

/// The conditions that a problem makes at the particles of a body.
///
/// At an edge or a corner several sides meet. A given value goes before a load; of two values, or of two
/// loads, that of the side named first holds. The shear that a plane of symmetry excludes comes after loads
/// that are named, and a free side comes last. Problem::corners overrides this.
/// \throws base::InvalidInput for a side that the body does not have, for a side given twice, and for a
///         corner with a wrong number of conditions or with a condition from a third side
/// \throws base::FailedComputation naming the side and the place where a given function is not finite
template <int dim, int n>
Conditions<dim, n> conditions(const Problem<dim, n>& problem, const Body<dim>& body);

/// Refuses a Corner whose sides meet at no particle: it would have no effect.
/// \throws base::InvalidInput naming the sides
template <int dim, int n>
void require_corners(const Problem<dim, n>& problem, const Body<dim>& body);

/// Refuses a body that can move as a rigid body, and a scalar determined only up to a constant.
/// \throws base::InvalidInput naming the motion
template <int dim, int n>
void require_held(const Problem<dim, n>& problem, const Body<dim>& body,
                  const Conditions<dim, n>& conditions);

}  // namespace bodies
