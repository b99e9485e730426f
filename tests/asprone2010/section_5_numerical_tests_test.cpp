#include "asprone2010/section_5_numerical_tests.hpp"

#include "tests/support/lines.hpp"

using namespace asprone2010::numerical_tests;
using particles::Volumes;

TEST_CASE("numerical tests: the default is the paper's case") {
    const auto [line, smoothing] = discretise<double>({}, 100, 1);
    CHECK(line.size() == 100);
    CHECK(line.x()[0] == 0);
    CHECK(line.x()[99] == 1);
    CHECK(line.spacing() == 1.0 / 99);
    CHECK(smoothing.h() == line.spacing());
    CHECK(particles::name(smoothing.kernel()) == "gaussian");
    CHECK((line.V() == line.spacing()).all());
}

TEST_CASE("numerical tests: h stays δ when particles are perturbed, and the seed decides where they go") {
    const Discretisation how{Volumes::equal, particles::Gaussian{}, 1.5, 0.25};
    const auto a = discretise<double>(how, 50, 1), b = discretise<double>(how, 50, 2);
    CHECK(a.smoothing.h() == support::relative(1.5 / 49, 1e-15));
    CHECK(a.smoothing.h() == b.smoothing.h());
    CHECK((a.line.x() != b.line.x()).any());
}

TEST_CASE("numerical tests: nonsense is refused") {
    CHECK_THROWS_AS(discretise<double>({}, 1, 1), base::InvalidInput);
    CHECK_THROWS_WITH_AS(discretise<double>({Volumes::equal, particles::Gaussian{}, 0, 0}, 10, 1),
                         "the smoothing length over the spacing must be positive and finite, got 0",
                         base::InvalidInput);
    CHECK_THROWS_AS(discretise<double>({Volumes::equal, particles::Gaussian{}, 1, 0.7}, 10, 1),
                    base::InvalidInput);
}

TEST_CASE("numerical tests: the norm is the largest difference") {
    CHECK(distance<double>(Eigen::Array3d(1, 2, 3), Eigen::Array3d(1.5, 0, 3)) == 2);
}
