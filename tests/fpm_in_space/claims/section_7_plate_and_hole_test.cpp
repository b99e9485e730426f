#include <doctest/doctest.h>

#include <string>

#include "fpm_in_space/claims/ledger.hpp"
#include "tests/support/claims.hpp"

namespace {

/// What a claim measures, on the tables of the figures.
double measured(const std::string& id) {
    static const auto all = fpm_in_space::claims::section_7();
    const auto found = all.at(id)(support::claim(id), 0);
    REQUIRE(found.size() == 1);
    return found.front().value;
}

}  // namespace

TEST_CASE("claims on the plate: SSPH of degree 3 is exact there, and FPM errs less than that of degree 2") {
    CHECK(measured("F-7-cubic") < support::expected("F-7-cubic"));
    CHECK(measured("F-7-plate") > support::expected("F-7-plate"));
}

TEST_CASE("claims on the hole: FPM gains with the number of particles, and R says nothing of it") {
    CHECK(measured("F-7-fine") < 0.7 * measured("F-7-coarse"));
    CHECK(measured("F-7-quality") < support::expected("F-7-quality"));
}
