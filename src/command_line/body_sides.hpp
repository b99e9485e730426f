#pragma once

#include <vector>

#include "bodies/problem.hpp"
#include "command_line/command_line.hpp"

namespace command_line {

/// What options say on the sides of a body, in the order in which the sides are named.
/// \param conditions such as --traction "tip: 0, -1e6". Names may hold colons: the last colon behind the name
///        of a side ends it
/// \throws base::InvalidInput naming the option and the side: for a text that cannot be read, a side that the
///         body does not have, another number of components, a component that is given twice or carries a
///         load beside its value, and a function that is not finite, with the place
template <int dim, int n>
std::vector<bodies::Given<dim, n>> given_on_sides(const std::vector<Typed>& conditions,
                                                  const bodies::Body<dim>& body);

/// The corner of a text such as "wall+tip: wall, tip". \throws base::InvalidInput with what is wrong with it
template <int dim, int n>
bodies::Corner corner(const bodies::Body<dim>& body, const Typed& typed);

}  // namespace command_line
