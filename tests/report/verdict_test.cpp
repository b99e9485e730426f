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
    CHECK_THROWS_AS(fits({"~", 1, 0}, 1), base::InvalidInput);
}

TEST_CASE("verdict: reproduced, conditional, different, undecided") {
    const Conventions volumes{
        "volumes", {"equal", "volumes are equal"}, {"partition", "volumes are a partition"}};
    const auto of_two = [&](const std::vector<Measurement>& one, const std::vector<Measurement>& other) {
        return verdict({"=", 2, 0.1}, volumes, one, other);
    };
    CHECK(of_two({{"", 2}}, {{"", 2.05}}) == "reproduced");
    CHECK(of_two({{"", 2}}, {{"", 1}}) == "holds only if volumes are equal");
    CHECK(of_two({{"", 1}}, {{"", 2}}) == "holds only if volumes are a partition");
    CHECK(of_two({{"", 1}}, {{"", 1}}) == "differs");
    CHECK(of_two({{"", 1}, {"DB is exact", 2}}, {{"", 1}, {"DB is exact", 2}}) ==
          "holds only if DB is exact");
    CHECK(of_two({{"", 1}, {"DB is exact", 2}}, {{"", 1}, {"DB is exact", 1}}) == "differs");
    CHECK(of_two({{"", std::nan("")}}, {{"", 2}}) == "cannot tell");
    CHECK(of_two({}, {}) == "cannot tell");
}
