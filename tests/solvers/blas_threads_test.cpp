#include "solvers/blas_threads.hpp"

#include <doctest/doctest.h>

extern "C" int openblas_get_num_threads();
extern "C" void openblas_set_num_threads(int threads);

TEST_CASE("blas threads: one is used once it is asked for") {
    solvers::use_one_blas_thread();
    CHECK(openblas_get_num_threads() == 1);
}

TEST_CASE("blas threads: one is used for a while, and then as many as before") {
    openblas_set_num_threads(2);
    {
        const solvers::OneBlasThread alone;
        CHECK(openblas_get_num_threads() == 1);
    }
    CHECK(openblas_get_num_threads() == 2);
    solvers::use_one_blas_thread();
}
