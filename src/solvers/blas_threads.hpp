#pragma once

namespace solvers {

/// Makes OpenBLAS use one thread. This package runs its threads on particles and on cases; threads of BLAS
/// below them would make the order of sums, and so the last digits, depend on their number.
void use_one_blas_thread();

}  // namespace solvers
