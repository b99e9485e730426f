#include "solvers/blas_threads.hpp"

// Declared here because cblas.h conflicts with GSL's headers.
extern "C" void openblas_set_num_threads(int threads);
extern "C" int openblas_get_num_threads();

namespace solvers {

void use_one_blas_thread() {
    openblas_set_num_threads(1);
}

OneBlasThread::OneBlasThread() : before_(openblas_get_num_threads()) {
    use_one_blas_thread();
}
OneBlasThread::~OneBlasThread() {
    openblas_set_num_threads(before_);
}

}  // namespace solvers
