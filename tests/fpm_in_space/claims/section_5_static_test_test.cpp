#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "fpm_in_space/claims/ledger.hpp"
#include "tests/support/claims.hpp"

namespace {

/// What a claim measures in the plane or in space, on the tables of the figures.
double measured(const std::string& id, bool in_space) {
    static const auto all = fpm_in_space::claims::section_5();
    const auto found = all.at(id)(support::claim(id), in_space ? 1 : 0);
    REQUIRE(found.size() == 1);
    return found.front().value;
}

}  // namespace

TEST_CASE("claims on Poisson's equation: values on grids are of second order in the plane and in space") {
    for (const bool in_space : {false, true})
        CHECK(std::abs(measured("F-5-dirichlet", in_space) - support::expected("F-5-dirichlet")) < 0.2);
}

TEST_CASE(
    "claims on Poisson's equation: perturbed particles of the plane keep the order, those of space not yet") {
    CHECK(measured("F-5-mixed", false) > support::expected("F-5-mixed"));
    CHECK(measured("F-5-mixed", true) < 1);
    CHECK(measured("F-5-stretched", false) > 1.5);
}

TEST_CASE("claims on Poisson's equation: SSPH of degree 2 errs little more, against the prediction") {
    for (const bool in_space : {false, true}) {
        CHECK(measured("F-5-ssph", in_space) > 1);
        CHECK(measured("F-5-ssph", in_space) < support::expected("F-5-ssph"));
    }
}
