#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "fpm_in_space/claims/ledger.hpp"
#include "fpm_in_space/claims/measures.hpp"
#include "fpm_in_space/section_6_vibration_test.hpp"
#include "tests/support/claims.hpp"

using namespace fpm_in_space;

namespace {

std::vector<report::Measurement> measured(const std::string& id) {
    static const auto all = claims::section_6();
    return all.at(id)(support::claim(id), 0);
}

/// Those of the second-order FPM on 26² particles. \param seed also of the order of the particles
vibration_test::Frequencies frequencies(double perturbation, double ratio, unsigned long seed = 1) {
    return vibration_test::frequencies(vibration_test::stiffness(
        formulation_named<double, 2>("definite_fpm"), derivative_test::body<2>(26, perturbation, seed),
        {particles::TruncatedGaussian<2>(3.5), ratio / 25}));
}

}  // namespace

TEST_CASE(
    "claims on a membrane: the lowest eigenvalue is that of the calculation whose Gaussian is not cut") {
    const auto lowest = measured("F-6-lowest");
    REQUIRE(lowest.size() == 2);
    CHECK(lowest[0].value == doctest::Approx(0.991574).epsilon(1e-6));
    CHECK(std::abs(lowest[1].value - support::expected("F-6-lowest")) < 5e-5);
}

TEST_CASE("claims on a membrane: the symbol has the lower half, and linear elements the lowest frequency") {
    CHECK(measured("F-6-symbol").front().value < support::expected("F-6-symbol"));
    CHECK(measured("F-6-elements").front().value > support::expected("F-6-elements"));
}

TEST_CASE(
    "claims on a membrane: complex pairs are as many as the calculation's 6 and 280 eigenvalues, and fewer with h = δ") {
    const auto grid = frequencies(0, 1.2);
    CHECK(2 * vibration_test::complex_pairs(grid) == 6);
    CHECK(2 * vibration_test::complex_pairs(frequencies(0.25, 1.2)) == doctest::Approx(280).epsilon(0.05));
    CHECK(vibration_test::complex_pairs(frequencies(0, 1)) == 0);
    CHECK(2 * vibration_test::complex_pairs(frequencies(0.25, 1)) < 576 / 2);
    // Round-off would differ in another order of the particles.
    const auto largest = [](const vibration_test::Frequencies& omega) {
        double most = 0;
        for (const auto& one : omega) most = std::max(most, one.imag());
        return most;
    };
    CHECK(largest(frequencies(0, 1.2, 2)) == doctest::Approx(largest(grid)).epsilon(1e-6));
}
