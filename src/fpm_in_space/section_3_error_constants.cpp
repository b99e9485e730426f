#include "fpm_in_space/section_3_error_constants.hpp"

namespace fpm_in_space::error_constants {

template Rows<base::Quad, 2> limit_stencils(const Formulation<base::Quad, 2>&, const Lattice<2>&);
template LeadingError<base::Quad, 2> leading_error(const Stencil<base::Quad, 2>&, const MultiIndex<2>&);
template Column<base::Quad> measured_constants(const Stencil<base::Quad, 2>&, const MultiIndex<2>&, int);
template Rows<base::Quad, 3> limit_stencils(const Formulation<base::Quad, 3>&, const Lattice<3>&);
template LeadingError<base::Quad, 3> leading_error(const Stencil<base::Quad, 3>&, const MultiIndex<3>&);
template Column<base::Quad> measured_constants(const Stencil<base::Quad, 3>&, const MultiIndex<3>&, int);

}  // namespace fpm_in_space::error_constants
