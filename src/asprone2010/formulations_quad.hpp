#pragma once

#include "asprone2010/formulations.hpp"
#include "base/quad.hpp"

// A header of its own, since base::Quad needs a library and takes long to compile. Compiled once, in
// operators.cpp and formulations_quad.cpp.
extern template particles::Operators<base::Quad> particles::assemble(const particles::Line<base::Quad>&,
                                                                     const particles::Smoothing<base::Quad>&,
                                                                     const particles::Requirement&,
                                                                     const particles::Rule<base::Quad>&,
                                                                     const particles::Range&);

namespace asprone2010 {

extern template const std::vector<Formulation<base::Quad>>& formulations();

}  // namespace asprone2010
