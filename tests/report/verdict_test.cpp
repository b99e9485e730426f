#include "report/verdict.hpp"

#include <doctest/doctest.h>

using namespace report;

TEST_CASE("verdict: relations") {
    CHECK(fits({"=", 2, 0.1}, {"", 2.05}));
    CHECK_FALSE(fits({"=", 2, 0.1}, {"", 2.15}));
    CHECK(fits({"<", 1, 0}, {"", 0.5}));
    CHECK_FALSE(fits({"<", 1, 0}, {"", 1}));
    CHECK(fits({">", 1, 0}, {"", 1.5}));
    CHECK_FALSE(fits({">", 1, 0}, {"", 1}));
    for (const char* relation : {"=", "<", ">"}) CHECK_FALSE(fits({relation, 1, 1}, {"", std::nan("")}));
    CHECK_THROWS_AS(fits({"~", 1, 0}, {"", 1}), base::InvalidInput);
}

TEST_CASE("verdict: a range fits where one of its numbers does") {
    CHECK(fits({"=", 2, 0.1}, {"", 1, 3}));
    CHECK(fits({"=", 2, 0.1}, {"", 2.05, 3}));
    CHECK_FALSE(fits({"=", 2, 0.1}, {"", 2.2, 3}));
    CHECK_FALSE(fits({"=", 2, 0.1}, {"", 1, 1.8}));
    CHECK(fits({"<", 1, 0}, {"", 0.5, 3}));
    CHECK_FALSE(fits({"<", 1, 0}, {"", 1.5, 3}));
    CHECK(fits({">", 1, 0}, {"", 0.5, 3}));
    CHECK_FALSE(fits({">", 1, 0}, {"", 0.5, 0.6}));
}

TEST_CASE("verdict: reproduced, conditional, different, undecided") {
    const Conventions volumes{
        "volumes", {"equal", "volumes are equal"}, {"partition", "volumes are a partition"}};
    const auto of_two = [&](const std::vector<Measurement>& one, const std::vector<Measurement>& other) {
        return decided({"=", 2, 0.1}, volumes, one, other).verdict;
    };
    CHECK(of_two({{"", 2}}, {{"", 2.05}}) == "reproduced");
    CHECK(of_two({{"", 2}}, {{"", 1}}) == "holds only if volumes are equal");
    CHECK(of_two({{"", 1}}, {{"", 2}}) == "holds only if volumes are a partition");
    CHECK(of_two({{"", 1}}, {{"", 1}}) == "differs");
    CHECK(of_two({{"", 1}, {"DB is exact", 2}}, {{"", 1}, {"DB is exact", 2}}) ==
          "holds only if DB is exact");
    CHECK(of_two({{"", 1}, {"DB is exact", 1}}, {{"", 1}, {"DB is exact", 1}}) ==
          "differs, also if DB is exact");
    CHECK(of_two({{"", 1}, {"it rains", 1}, {"it snows", 1}}, {{"", 1}, {"it rains", 1}, {"it snows", 1}}) ==
          "differs, also if it rains, or if it snows");
    CHECK(of_two({{"", std::nan("")}}, {{"", 2}}) == "cannot tell");
    CHECK(of_two({}, {}) == "cannot tell");
}

TEST_CASE(
    "verdict: a condition that fits under both conventions goes before one that needs a convention, too") {
    const Conventions norms{"error norm", {"dn", "E is dn"}, {"nd", "E is nd"}};
    const auto decide = [&](const std::vector<Measurement>& one, const std::vector<Measurement>& other) {
        return decided({"=", 2, 0.1}, norms, one, other);
    };
    const auto with_one = decide({{"", 1}, {"it rains", 2}}, {{"", 1}, {"it rains", 1}});
    CHECK(with_one.verdict == "holds only if E is dn and it rains");
    CHECK(with_one.conditional->value == 2);
    const auto with_other = decide({{"", 1}, {"it rains", 1}}, {{"", 1}, {"it rains", 1.95}});
    CHECK(with_other.verdict == "holds only if E is nd and it rains");
    CHECK(with_other.conditional->value == 1.95);
    const auto with_both = decide({{"", 1}, {"it rains", 2}, {"it snows", 1, 3}},
                                  {{"", 1}, {"it rains", 1}, {"it snows", 1, 3}});
    CHECK(with_both.verdict == "holds only if it snows");
    CHECK(with_both.conditional->value == 1);
    CHECK(with_both.conditional->upper == 3);
    CHECK_FALSE(decide({{"", 2}, {"it rains", 2}}, {{"", 1}, {"it rains", 2}}).conditional);
}
