#include "particles/requirement.hpp"

#include <omp.h>

#include "tests/support/lines.hpp"

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

TEST_CASE("requirement: the remedy is said as h was, and serves all particles at once") {
    const auto squares = [](Index N) { return Column<double>(uniform_positions(N).square()); };
    const auto line = line_at<double>(squares(51), Volumes::equal);
    const auto& formulation = asprone2010::formulation_named<double>("second_order_fpm");
    const auto refused = [&](const Smoothing<>& smoothing) {
        try {
            static_cast<void>(formulation.operators(line, smoothing));
        } catch (const FailedComputation& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    const auto number = [](const std::string& message, const std::string& before) {
        const std::size_t at = message.find("; try " + before);
        CAPTURE(message);
        REQUIRE(at != std::string::npos);
        return std::stod(message.substr(at + 6 + before.size()));
    };
    for (const Kernel<>& kernel : {Kernel<>(Gaussian{}), Kernel<>(WendlandC2{})}) {
        for (const double unit : {0.001, 0.02, 0.3, 1e300}) {
            const Column<double> spacing = Column<double>::Constant(1, unit);
            const Smoothing<> in_spacings(kernel, spacing, 1.0), as_length(kernel, unit);
            if (refused(as_length).empty()) continue;
            const double ratio = number(refused(in_spacings), "--smoothing ");
            CHECK(refused(Smoothing<>(kernel, spacing, ratio)).empty());
            const double h = number(refused(as_length), "h = ");
            CHECK(refused(Smoothing<>(kernel, h)).empty());
        }
        const Column<double> too_small = 0.2 * spacing(line, Spacing::nearest);
        const double more = number(refused(Smoothing<>(kernel, too_small)), "smoothing lengths ");
        CHECK(refused(Smoothing<>(kernel, Column<double>(more * too_small))).empty());
        const double ratio = number(refused(Smoothing<>(kernel, too_small, 3.0)), "--smoothing ");
        CHECK(ratio == more);
        CHECK(refused(Smoothing<>(kernel, too_small, ratio)).empty());
    }
}

TEST_CASE("requirement: neighbours far within h are refused with a smaller length that serves") {
    const auto& formulation = asprone2010::formulation_named<double>("second_order_fpm");
    const auto line = line_at<double>(uniform_positions(20), Volumes::equal);
    const Column<double> mean = spacing(line, Spacing::mean);
    CHECK_THROWS_WITH_AS(static_cast<void>(formulation.operators(line, {Gaussian{}, mean, 1e9})),
                         doctest::Contains("singular"), FailedComputation);
    CHECK_THROWS_WITH_AS(static_cast<void>(formulation.operators(line, {Gaussian{}, mean, 1e9})),
                         doctest::Contains("; try --smoothing 0.5"), FailedComputation);
    CHECK_NOTHROW(static_cast<void>(formulation.operators(line, {Gaussian{}, mean, 0.5})));
}

TEST_CASE(
    "requirement: where no multiple of the smoothing lengths serves, those of another spacing are named") {
    const auto& formulation = asprone2010::formulation_named<double>("modified_fpm");
    const auto line = line_at<double>(uniform_positions(11), Volumes::equal);
    Column<double> lengths = Column<double>::Constant(11, 0.1);
    lengths[4] = 1e-9;
    CHECK_THROWS_WITH_AS(static_cast<void>(formulation.operators(line, {Gaussian{}, lengths, 1.5})),
                         doctest::Contains("needs 3; try --smoothing-from local"), FailedComputation);
    CHECK_NOTHROW(
        static_cast<void>(formulation.operators(line, {Gaussian{}, spacing(line, Spacing::local), 1.5})));
    CHECK_THROWS_WITH_AS(static_cast<void>(formulation.operators(line, {Gaussian{}, lengths})),
                         doctest::Contains("; take another smoothing length or other particles"),
                         FailedComputation);
}

TEST_CASE("requirement: where nothing is found, the words name no direction") {
    const auto line = line_at<double>(uniform_positions(9), Volumes::equal);
    const auto never = [](const Neighbourhood<double>&) -> Derivatives<double> {
        throw SingularNeighbourhood(0);
    };
    CHECK_THROWS_WITH_AS(static_cast<void>(assemble(line, Smoothing<>(Gaussian{}, 0.1), {"never", 2}, never)),
                         doctest::Contains("; take another smoothing length or other particles"),
                         FailedComputation);
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
