#include "asprone2010/formulations.hpp"

namespace asprone2010 {

template const std::vector<Formulation<long double>>& formulations();

}  // namespace asprone2010
