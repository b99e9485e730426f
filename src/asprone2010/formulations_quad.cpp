#include "asprone2010/formulations_quad.hpp"

namespace asprone2010 {

template const std::vector<Formulation<base::Quad>>& formulations();

}  // namespace asprone2010
