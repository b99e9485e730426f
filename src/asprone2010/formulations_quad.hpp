#pragma once

#include "asprone2010/formulations.hpp"
#include "base/quad.hpp"

// A header of its own, since base::Quad needs a library and takes long to compile. Compiled once, in operators.cpp
// and formulations_quad.cpp.

namespace particles {

extern template Operators<base::Quad> assemble(const Line<base::Quad>&, const Smoothing<base::Quad>&,
                                               const Requirement&, const Rule<base::Quad>&, const Range&);

}  // namespace particles

namespace asprone2010 {

extern template const std::vector<Formulation<base::Quad>>& formulations();

}  // namespace asprone2010
