#include "report/verdict.hpp"

#include <doctest/doctest.h>

using namespace report;

TEST_CASE("verdict: relations") {
    CHECK(fits({"=", 2, 0.1}, 2.05));
    CHECK_FALSE(fits({"=", 2, 0.1}, 2.15));
    CHECK(fits({"<", 1, 0}, 0.5));
    CHECK_FALSE(fits({"<", 1, 0}, 1));
    CHECK(fits({">", 1, 0}, 1.5));
    CHECK_FALSE(fits({">", 1, 0}, 1));
    for (const char* relation : {"=", "<", ">"}) CHECK_FALSE(fits({relation, 1, 1}, std::nan("")));
    CHECK_THROWS_AS(fits({"~", 1, 0}, 1), particles::InvalidInput);
}

TEST_CASE("verdict: reproduced, conditional, different, undecided") {
    const Statement two{"=", 2, 0.1};
    CHECK(verdict(two, {{"", 2}}, {{"", 2.05}}) == "reproduced");
    CHECK(verdict(two, {{"", 2}}, {{"", 1}}) == "holds only if volumes are equal");
    CHECK(verdict(two, {{"", 1}}, {{"", 2}}) == "holds only if volumes are a partition");
    CHECK(verdict(two, {{"", 1}}, {{"", 1}}) == "differs");
    CHECK(verdict(two, {{"", 1}, {"DB is exact", 2}}, {{"", 1}, {"DB is exact", 2}}) ==
          "holds only if DB is exact");
    CHECK(verdict(two, {{"", 1}, {"DB is exact", 2}}, {{"", 1}, {"DB is exact", 1}}) == "differs");
    CHECK(verdict(two, {{"", std::nan("")}}, {{"", 2}}) == "cannot tell");
    CHECK(verdict(two, {}, {}) == "cannot tell");
}
