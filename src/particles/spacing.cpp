#include "particles/spacing.hpp"

namespace particles {

template Column<double> spacing(const Cloud<1>&, const Spacing&);
template Column<double> spacing(const Cloud<2>&, const Spacing&);
template Column<double> spacing(const Cloud<3>&, const Spacing&);

}  // namespace particles
