#pragma once

extern "C" void openblas_set_num_threads(
    int threads);  // cblas.h, which declares it, does not go with GSL's headers

namespace solvers {

/// Tells OpenBLAS to use one thread. The threads of this package work on particles and on cases; below them, more threads
/// would make the order of sums, and so the last digits, depend on their number.
inline void use_one_blas_thread() {
    openblas_set_num_threads(1);
}

}  // namespace solvers
