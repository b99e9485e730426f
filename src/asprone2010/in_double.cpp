#include "asprone2010/limit_stencils.hpp"
#include "asprone2010/list_of_formulations.hpp"
#include "asprone2010/section_5_1_derivative_test.hpp"
#include "asprone2010/section_5_2_static_test.hpp"

namespace asprone2010 {

template const std::vector<Formulation<double>>& formulations();

namespace numerical_tests {
template Particles<double> discretise(const Discretisation&, const Column<double>&);
template Particles<double> discretise(const Discretisation&, Index, unsigned long);
}  // namespace numerical_tests

namespace derivative_test {
template Errors<double> errors(const Formulation<double>&, const numerical_tests::Particles<double>&,
                               const Smooth<double>&);
}  // namespace derivative_test

namespace static_test {
template double error(const Formulation<double>&, const Formulation<double>&,
                      const numerical_tests::Particles<double>&, const Smooth<double>&, int);
}  // namespace static_test

namespace limit_stencils {
template Stencil<double> near_end(const Formulation<double>&, const numerical_tests::Discretisation&, Index,
                                  int, const double&);
}  // namespace limit_stencils

}  // namespace asprone2010
