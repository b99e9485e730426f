#include "particles/requirement.hpp"

#include <omp.h>

#include "tests/support.hpp"

using namespace particles;
using support::particles_of;

namespace {

std::string message(std::string_view formulation, Index N,
                    const asprone2010::numerical_tests::Discretisation& how) {
    const auto [line, smoothing] = particles_of(N, how);
    try {
        static_cast<void>(asprone2010::formulation_named<double>(formulation).operators(line, smoothing));
    } catch (const FailedComputation& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace

TEST_CASE(
    "requirement: too few neighbours are an error with formulation, particle, count and a remedy that helps") {
    CHECK(message("second_order_fpm", 20, {Volumes::equal, CubicSpline{}, 1, 0}) ==
          "second_order_fpm: particle 0 (x = 0) has 2 neighbours within 2h, needs 4; try --smoothing 1.6");
    CHECK(message("second_order_fpm", 20, {Volumes::equal, CubicSpline{}, 1.6, 0}) == "no error");
    CHECK(message("chen_beraun", 20, {Volumes::equal, WendlandC2{}, 0.5, 0}) ==
          "chen_beraun: particle 0 (x = 0) has 1 neighbour within 2h, needs 3; try --smoothing 1.1");
    CHECK(message("chen_beraun", 20, {Volumes::equal, WendlandC2{}, 1.1, 0}) == "no error");
    CHECK(
        message("second_order_fpm", 3, {}) ==
        "second_order_fpm: particle 0 (x = 0) has 3 neighbours within 6h, needs 4; take at least 4 particles");
    CHECK(message("original", 2, {}) == "no error");
}

TEST_CASE("requirement: a formulation that fails at several particles names the first") {
    omp_set_num_threads(4);
    CHECK(message("modified_fpm", 2000, {Volumes::equal, CubicSpline{}, 0.4, 0}).find("particle 0 ") !=
          std::string::npos);
    omp_set_num_threads(omp_get_num_procs());
}

TEST_CASE("requirement: the remedy that the error names helps, for every kernel and number of particles") {
    for_each_kernel([](const Kernel<>& kernel) {
        for (Index N = 10; N < 60; ++N)
            for (const double smoothing : {0.3, 0.7, 1.0}) {
                const std::string error =
                    message("second_order_fpm", N, {Volumes::equal, kernel, smoothing, 0});
                const std::size_t remedy = error.find("try --smoothing ");
                if (remedy == std::string::npos) continue;
                CAPTURE(error);
                const double larger = std::stod(error.substr(remedy + 16));
                CHECK(larger > smoothing);
                CHECK(message("second_order_fpm", N, {Volumes::equal, kernel, larger, 0}).find("needs") ==
                      std::string::npos);
            }
    });
}
