#pragma once

#include "batra2008/section_3_elastostatics.hpp"

namespace batra2008 {

/// Equations of elastostatics that are solved in little time and serve as a guide to the solution of a
/// method's own, solvers::iterated(): linear finite elements, on Delaunay's triangles between the particles,
/// \f$\int_\Omega \varepsilon^T D\,\varepsilon\,d\Omega\f$. Strong springs hold the components whose
/// displacement is given.
/// \param problem one that is elastostatics::checked()
solvers::Elements linear_elements(const Problem& problem, const Cloud<2>& cloud);

}  // namespace batra2008
