#pragma once

#include "bodies/rows.hpp"

namespace bodies {

/// The local weak forms weak1 and weak2 of Batra and Zhang, \eq{B3.19}, in the plane: the test functions are
/// truncated Gaussians on a disc around each particle. Given values are imposed by a penalty. In elasticity
/// the equations are those of batra2008::mlpg::system().
/// \throws base::InvalidInput for a body whose boundary is not closed, crosses itself, or has particles
///         outside
template <int n>
System on_discs(const Problem<2, n>& problem, const Body<2>& body, const Approximation<2>& approximation,
                Wanted wanted = Wanted::solution);

}  // namespace bodies
