#pragma once

#include "asprone2010/formulations.hpp"
#include "base/quad.hpp"

namespace asprone2010 {

// A header of its own, since base::Quad needs a library and takes long to compile. Compiled once, in
// formulations_quad.cpp.
extern template const std::vector<Formulation<base::Quad>>& formulations();

}  // namespace asprone2010
