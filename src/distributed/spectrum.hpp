#pragma once

#include <complex>
#include <vector>

#include "distributed/system.hpp"

namespace distributed {

/// The eigenvalues λ of \f$A u = \lambda M u\f$ that are the smallest in size, as complex numbers; SLEPc
/// finds them with the inverse of A, a factorisation by MUMPS.
std::vector<std::complex<double>> smallest_eigenvalues(const System& system, Index count);

}  // namespace distributed
