#include "particles/kernels.hpp"

namespace particles {

template void evaluate(const Kernel<1>&, const Offsets<double, 1>&, Column<double>&, Offsets<double, 1>&);
template void evaluate(const Kernel<2>&, const Offsets<double, 2>&, Column<double>&, Offsets<double, 2>&);
template void evaluate(const Kernel<3>&, const Offsets<double, 3>&, Column<double>&, Offsets<double, 3>&);

}  // namespace particles
