#include "asprone2010/formulations.hpp"

namespace asprone2010 {

template const std::vector<Formulation<double>>& formulations();

}  // namespace asprone2010
