#pragma once

#include <vector>

#include "bodies/rows.hpp"

namespace bodies {

/// Collocation, for `strong` and `fpm`: the equation at the particles inside, the conditions at those on the
/// boundary. In the plane and with an SSPH basis these are the equations of Section 3.1 of Batra and Zhang,
/// \eq{B3.12} to \eq{B3.14}.
/// \param conditions of each particle, conditions()
template <int dim, int n>
System collocated(const Problem<dim, n>& problem, const Conditions<dim, n>& conditions,
                  const Approximation<dim>& approximation, Wanted wanted = Wanted::solution);

/// The equations of some particles, n rows for each in the order of `rows`. They do not change where other
/// particles, beyond the neighbours of these, are left out.
template <int dim, int n>
System collocated(const Problem<dim, n>& problem, const Conditions<dim, n>& conditions,
                  const Approximation<dim>& approximation, Wanted wanted, const std::vector<int>& rows);

}  // namespace bodies
