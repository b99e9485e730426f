#include "report/statistics.hpp"

#include <doctest/doctest.h>
#include "tests/relative.hpp"

TEST_CASE("statistics: quartiles of a sample in any order") {
    const auto [lower, median, upper] = report::quartiles({5, 1, 4, 2, 3});
    CHECK(lower == 2);
    CHECK(median == 3);
    CHECK(upper == 4);
    CHECK(report::quartiles({7}).median == 7);
    CHECK_THROWS_AS(report::quartiles({}), base::InvalidInput);
}

TEST_CASE("statistics: the observed order of a power is its exponent") {
    CHECK(report::observed_order({0.1, 0.05, 0.025}, {3e-2, 7.5e-3, 1.875e-3}) ==
          support::relative(2, 1e-12));
    CHECK(report::observed_order({0.1, 0.01}, {1, 10}) == support::relative(-1, 1e-12));
    CHECK_THROWS_AS(report::observed_order({0.1}, {1}), base::InvalidInput);
    CHECK_THROWS_AS(report::observed_order({0.1, 0.2}, {1, 0}), base::InvalidInput);
}
