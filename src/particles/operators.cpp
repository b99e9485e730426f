#include "particles/operators.hpp"

#include "base/quad.hpp"

namespace particles {

template void assemble_again(Operators<double>&, const Line<double>&, const Smoothing<double>&,
                             const Requirement&, const Rule<double>&, const Range&);
template void assemble_again(Operators<long double>&, const Line<long double>&, const Smoothing<long double>&,
                             const Requirement&, const Rule<long double>&, const Range&);
template void assemble_again(Operators<base::Quad>&, const Line<base::Quad>&, const Smoothing<base::Quad>&,
                             const Requirement&, const Rule<base::Quad>&, const Range&);

template Operators<double, 1> assemble(const Cloud<1>&, const Smoothing<double, 1>&, const Requirement&,
                                       const CloudRule<1>&, const Range&);
template Operators<double, 2> assemble(const Cloud<2>&, const Smoothing<double, 2>&, const Requirement&,
                                       const CloudRule<2>&, const Range&);
template Operators<double, 3> assemble(const Cloud<3>&, const Smoothing<double, 3>&, const Requirement&,
                                       const CloudRule<3>&, const Range&);

}  // namespace particles
