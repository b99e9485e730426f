#include "particles/operators.hpp"

#include "base/quad.hpp"

namespace particles {

template Operators<double> assemble(const Line<double>&, const Smoothing<double>&, const Requirement&,
                                    const Rule<double>&, const Range&);
template Operators<long double> assemble(const Line<long double>&, const Smoothing<long double>&,
                                         const Requirement&, const Rule<long double>&, const Range&);
template Operators<base::Quad> assemble(const Line<base::Quad>&, const Smoothing<base::Quad>&,
                                        const Requirement&, const Rule<base::Quad>&, const Range&);

}  // namespace particles
