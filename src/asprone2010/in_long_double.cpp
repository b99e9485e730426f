#include "asprone2010/list_of_formulations.hpp"
#include "asprone2010/section_5_1_derivative_test.hpp"
#include "asprone2010/section_5_2_static_test.hpp"

namespace asprone2010 {

template const std::vector<Formulation<long double>>& formulations();

namespace numerical_tests {
template Particles<long double> discretise(const Discretisation&, const Column<long double>&);
template Particles<long double> discretise(const Discretisation&, Index, unsigned long);
}  // namespace numerical_tests

namespace derivative_test {
template Errors<long double> errors(const Formulation<long double>&,
                                    const numerical_tests::Particles<long double>&,
                                    const Smooth<long double>&);
}  // namespace derivative_test

namespace static_test {
template long double error(const Formulation<long double>&, const Formulation<long double>&,
                           const numerical_tests::Particles<long double>&, const Smooth<long double>&, int);
}  // namespace static_test

}  // namespace asprone2010
