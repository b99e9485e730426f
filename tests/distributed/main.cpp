#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include "distributed/processes.hpp"
#include "solvers/blas_threads.hpp"
#include "tests/distributed/world.hpp"

// Each process runs the same tests; what they communicate belongs together.
int main(int argc, char** argv) {
    const distributed::Petsc petsc({});
    solvers::use_one_blas_thread();
    doctest::Context tests(argc, argv);
    if (!support::world().is_first()) tests.setOption("minimal", true);
    const int result = tests.run();
    return support::world().all(result == 0) ? 0 : 1;
}
