#include "solvers/blas_threads.hpp"

#include <doctest/doctest.h>

extern "C" int openblas_get_num_threads();

TEST_CASE("blas threads: one is used once it is asked for") {
    solvers::use_one_blas_thread();
    CHECK(openblas_get_num_threads() == 1);
}
