#include "asprone2010/in_quad.hpp"
#include "asprone2010/list_of_formulations.hpp"

namespace asprone2010 {

template const std::vector<Formulation<base::Quad>>& formulations();

namespace numerical_tests {
template Particles<base::Quad> discretise(const Discretisation&, const Column<base::Quad>&);
template Particles<base::Quad> discretise(const Discretisation&, Index, unsigned long);
}  // namespace numerical_tests

namespace derivative_test {
template Errors<base::Quad> errors(const Formulation<base::Quad>&,
                                   const numerical_tests::Particles<base::Quad>&, const Smooth<base::Quad>&);
}  // namespace derivative_test

namespace static_test {
template base::Quad error(const Formulation<base::Quad>&, const Formulation<base::Quad>&,
                          const numerical_tests::Particles<base::Quad>&, const Smooth<base::Quad>&, int);
}  // namespace static_test

namespace limit_stencils {
template Stencil<base::Quad> near_end(const Formulation<base::Quad>&, const numerical_tests::Discretisation&,
                                      Index, int, const base::Quad&);
}  // namespace limit_stencils

}  // namespace asprone2010
