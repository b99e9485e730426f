#include "particles/cells.hpp"

namespace particles {

template class Cells<1>;
template class Cells<2>;
template class Cells<3>;

}  // namespace particles
