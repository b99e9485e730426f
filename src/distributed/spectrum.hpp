#pragma once

#include <complex>
#include <vector>

#include "distributed/system.hpp"

namespace distributed {

/// The eigenvalues λ of \f$A u = \lambda M u\f$ that are the smallest in size, as complex numbers; SLEPc
/// finds them with the inverse of A, a factorisation by MUMPS.
/// \throws base::InvalidInput where SLEPc's options ask for others
/// \throws base::FailedComputation where too few are found, or the residual of one is not small
std::vector<std::complex<double>> smallest_eigenvalues(const System& system, Index count);

}  // namespace distributed
