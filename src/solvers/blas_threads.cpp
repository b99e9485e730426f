#include "solvers/blas_threads.hpp"

// Declared here because cblas.h conflicts with GSL's headers.
extern "C" void openblas_set_num_threads(int threads);

namespace solvers {

void use_one_blas_thread() {
    openblas_set_num_threads(1);
}

}  // namespace solvers
