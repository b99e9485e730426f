#pragma once

#include "asprone2010/in_each_precision.hpp"
#include "base/quad.hpp"

// A header of its own, since base::Quad needs a library and takes long to compile. Compiled once, in
// operators.cpp and in_quad.cpp.

namespace particles {

extern template void assemble_again(Operators<base::Quad>&, const Line<base::Quad>&,
                                    const Smoothing<base::Quad>&, const Requirement&, const Rule<base::Quad>&,
                                    const Range&);

}  // namespace particles

ASPRONE2010_IN_PRECISION(extern template, base::Quad)
