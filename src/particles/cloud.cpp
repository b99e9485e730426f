#include "particles/cloud.hpp"

namespace particles {

template class Cloud<1>;
template class Cloud<2>;
template class Cloud<3>;

}  // namespace particles
