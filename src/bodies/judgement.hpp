#pragma once

#include <string>
#include <utility>
#include <vector>

#include "bodies/solution.hpp"

// What a solution says of itself, without a reference: whether its forces are in equilibrium, whether its
// stresses meet the loads, and whether its unknowns alternate.
namespace bodies {

/// What acts on a body, each side by itself. [force, in the plane for each unit of thickness; or heat]
template <int n>
struct Balance {
    std::vector<std::pair<std::string, Values<n>>> loads;      ///< given, by side
    std::vector<std::pair<std::string, Values<n>>> reactions;  ///< of given values, by side
    Values<n> volume;  ///< of the body force or the source, less the reaction c u
    /// What is left of the sum, over half of the sizes: of the loads as an integral, and of the reactions.
    /// Those of a scalar, and those of a body without loads, are integrals, too, since they may cancel on a
    /// side.
    double defect = 0;
};

/// The loads and the reactions. Those of `hats` are what the equations of the particles leave, in equilibrium
/// with the loads to the last bit; those of the other methods are integrals of the solution's own load
/// \f$F n\f$ over the sides with given values, and their defect tells whether the stresses can be trusted.
template <int dim, int n>
Balance<n> balance(const Problem<dim, n>& problem, const Body<dim>& body, const Solution<dim, n>& solution);

/// How far the solution's own load \f$F n\f$ is from the given one, zero on free sides: root mean squares
/// over the boundary, relative to that of F. It shows stresses that are wrong where displacements are right,
/// as in a material that is nearly incompressible.
template <int dim, int n>
double missed_loads(const Problem<dim, n>& problem, const Body<dim>& body, const Solution<dim, n>& solution);

/// The particles that see others across a gap: no edges of cells lead from the one to the other among its
/// neighbours, as where a slot is narrower than the kernel's support. Their equations do not know of the gap.
/// None of a body without cells.
template <int dim, int n>
std::vector<Index> across_gaps(const Body<dim>& body, const Solution<dim, n>& solution);

/// How much of the unknowns the function does not show, as batra2008::example_problems::noise().
template <int dim, int n>
double noise(const Solution<dim, n>& solution);

}  // namespace bodies
