#include "fpm_in_space/claims/measures.hpp"

#include <doctest/doctest.h>

#include "base/errors.hpp"

using namespace fpm_in_space::claims;

TEST_CASE(
    "claims on FPM in space: the errors of a table are those of each place, from inside to the corners") {
    const auto by_place = errors_in_table<3>(DataTable("space"), "definite_fpm", 17, 0.25);
    REQUIRE(by_place.size() == 4);
    CHECK(by_place[0].second < by_place[1].second);
    CHECK(by_place[0].first < by_place[0].second);
}

TEST_CASE(
    "claims on FPM in space: a table without the rows of a claim is refused, with a remedy that works") {
    DataTable plane("plane");
    CHECK_THROWS_WITH_AS(
        errors_in_table<2>(plane, "definite_fpm", 17, 0.25),
        "data/fpm_in_space/plane.csv lacks a row of definite_fpm, particles 17, perturbation 0.25, inside; remove it and run make data/fpm_in_space/plane.csv",
        base::FailedComputation);
    plane.table.rows[0][plane.table.column("error_second")] = {};
    CHECK_THROWS_WITH_AS(
        errors_in_table<2>(plane, "definite_fpm", 16, 0),
        "data/fpm_in_space/plane.csv lacks a number in row 1, error_second; remove it and run make data/fpm_in_space/plane.csv",
        base::FailedComputation);
}
