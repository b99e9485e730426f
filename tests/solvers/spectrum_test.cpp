#include "solvers/spectrum.hpp"

#include <doctest/doctest.h>

TEST_CASE("spectrum: eigenvalues of a companion matrix are the roots of its polynomial") {
    // (x − 1)(x² + 4) = x³ − x² + 4x − 4
    const Eigen::Matrix3d companion{{1, -4, 4}, {1, 0, 0}, {0, 1, 0}};
    auto lambda = solvers::eigenvalues(companion);
    std::sort(lambda.begin(), lambda.end(), [](auto a, auto b) { return a.imag() < b.imag(); });
    CHECK(std::abs(lambda[0] - std::complex<double>(0, -2)) < 1e-14);
    CHECK(std::abs(lambda[1] - 1.0) < 1e-14);
    CHECK(std::abs(lambda[2] - std::complex<double>(0, 2)) < 1e-14);
}

TEST_CASE("spectrum: symmetric problems come out in increasing order") {
    const Eigen::Matrix2d K{{2, 0}, {0, 3}}, M{{4, 0}, {0, 1}};
    CHECK(solvers::symmetric_eigenvalues(K, M) == std::vector<double>{0.5, 3});
}

TEST_CASE("spectrum: what has no eigenvalues is an error") {
    Eigen::Matrix2d K{{1, 2}, {3, std::nan("")}};
    CHECK_THROWS_AS(solvers::eigenvalues(K), particles::FailedComputation);
    CHECK_THROWS_AS(solvers::symmetric_eigenvalues(Eigen::Matrix2d::Identity(), -Eigen::Matrix2d::Identity()),
                    particles::FailedComputation);
}
