#include "report/statistics.hpp"

#include <doctest/doctest.h>
#include "tests/support/relative.hpp"

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

TEST_CASE("quantiles lie on the straight lines between the numbers of the sample") {
    const std::vector<double> sample{1, 2, 4, 8, 16};
    CHECK(report::quantile_of_sorted(sample, 0) == 1);
    CHECK(report::quantile_of_sorted(sample, 0.5) == 4);
    CHECK(report::quantile_of_sorted(sample, 0.625) == 6);
    CHECK(report::quantile_of_sorted(sample, 1) == 16);
}
