#pragma once

#include "asprone2010/limit_stencils.hpp"
#include "asprone2010/section_5_1_derivative_test.hpp"
#include "asprone2010/section_5_2_static_test.hpp"
#include "base/quad.hpp"

// A header of its own, since base::Quad needs a library and takes long to compile. Compiled once, in
// operators.cpp and in_quad.cpp.

namespace particles {

extern template Operators<base::Quad> assemble(const Line<base::Quad>&, const Smoothing<base::Quad>&,
                                               const Requirement&, const Rule<base::Quad>&, const Range&);

}  // namespace particles

namespace asprone2010 {

extern template const std::vector<Formulation<base::Quad>>& formulations();

namespace numerical_tests {
extern template Particles<base::Quad> discretise(const Discretisation&, const Column<base::Quad>&);
extern template Particles<base::Quad> discretise(const Discretisation&, Index, unsigned long);
}  // namespace numerical_tests

namespace derivative_test {
extern template Errors<base::Quad> errors(const Formulation<base::Quad>&,
                                          const numerical_tests::Particles<base::Quad>&,
                                          const Smooth<base::Quad>&);
}  // namespace derivative_test

namespace static_test {
extern template base::Quad error(const Formulation<base::Quad>&, const Formulation<base::Quad>&,
                                 const numerical_tests::Particles<base::Quad>&, const Smooth<base::Quad>&,
                                 int);
}  // namespace static_test

namespace limit_stencils {
extern template Stencil<base::Quad> near_end(const Formulation<base::Quad>&,
                                             const numerical_tests::Discretisation&, Index, int,
                                             const base::Quad&);
}  // namespace limit_stencils

}  // namespace asprone2010
