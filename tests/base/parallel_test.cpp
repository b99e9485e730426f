#include "base/parallel.hpp"

#include <doctest/doctest.h>
#include <omp.h>

#include <stdexcept>
#include <vector>

TEST_CASE("parallel: every index is worked on once") {
    std::vector<int> count(1000, 0);
    base::for_each_index(1000, [&](base::Index k) { ++count[static_cast<std::size_t>(k)]; });
    for (const int times : count) REQUIRE(times == 1);
    base::for_each_index(0, [](base::Index) { FAIL("nothing to do"); });
}

TEST_CASE("parallel: of several failures the first index's is thrown, on any number of threads") {
    for (const int threads : {1, 2, 5}) {
        omp_set_num_threads(threads);
        CHECK_THROWS_WITH(base::for_each_index(1000,
                                               [](base::Index k) {
                                                   if (k % 100 == 37)
                                                       throw std::runtime_error(std::to_string(k));
                                               }),
                          "37");
    }
    omp_set_num_threads(omp_get_num_procs());
}
