#include "report/ledger.hpp"

#include <doctest/doctest.h>

#include "base/errors.hpp"

using namespace report;

namespace {

const Paper paper{
    "A", "first", "First (1901)", false, {"volumes", {"equal", "volumes are equal"}, {"tiled", "they tile"}}};

/// A computation that measures one number under the first convention and another under the second.
Computation measuring(double one, double other) {
    return [=](const Statement&, std::size_t convention) {
        return std::vector<Measurement>{{"", convention == 0 ? one : other}};
    };
}

Table claims(const std::string& rows) {
    return parsed("id,section,kind,claim,quantity,relation,expected,tolerance\n" + rows);
}

}  // namespace

TEST_CASE("ledger: sections are joined, and a claim that two decide is refused") {
    CHECK(joined({{{"a", measuring(1, 1)}}, {{"b", measuring(1, 1)}}}).size() == 2);
    CHECK_THROWS_WITH_AS(joined({{{"a", measuring(1, 1)}}, {{"a", measuring(2, 2)}}}),
                         "claim a has two computations", base::InvalidInput);
}

TEST_CASE("ledger: a statement in signs") {
    CHECK(shown(Statement{"=", 2, 0.1}) == "= 2 ± 0.1");
    CHECK(shown(Statement{"<", 1e-10, 0}) == "< 1e-10");
}

TEST_CASE(
    "ledger: a computation sees what the claim states, and its verdict stands beside what it measured") {
    const Computation nearest = [](const Statement& claim, std::size_t) {
        return std::vector<Measurement>{{"", 0}, {"the nearest is taken", claim.expected}};
    };
    int decided = 0;
    const Table table = judged(claims("a,2,,is two,a number,=,2,0.1\nb,2,,is three,another,=,3,0\n"), paper,
                               {{"a", measuring(2.05, 1)}, {"b", nearest}}, [&] { ++decided; });
    CHECK(decided == 2);
    REQUIRE(table.rows.size() == 2);
    CHECK(table.word(0, "statement") == "= 2 ± 0.1");
    CHECK(table.word(0, "measured_equal") == "2.05");
    CHECK(table.word(0, "measured_tiled") == "1");
    CHECK(table.word(0, "conditional").empty());
    CHECK(table.word(0, "verdict") == "holds only if volumes are equal");
    CHECK(table.word(1, "conditional") == "3");
    CHECK(table.word(1, "verdict") == "holds only if the nearest is taken");
}

TEST_CASE("ledger: the number of a condition is that of the reading which the verdict names") {
    const Computation second = [](const Statement&, std::size_t) {
        return std::vector<Measurement>{{"", 1}, {"it rains", 2}, {"the layout is polar", -3}};
    };
    const Table table = judged(claims("a,2,,is below,a number,<,0,0\n"), paper, {{"a", second}}, [] {});
    CHECK(table.word(0, "verdict") == "holds only if the layout is polar");
    CHECK(table.word(0, "conditional") == "-3");
}

TEST_CASE("ledger: a claim on which the second convention has no bearing is decided by the first alone") {
    const Computation once = [](const Statement&, std::size_t convention) {
        return convention == 0 ? std::vector<Measurement>{{"", 2}} : std::vector<Measurement>{};
    };
    const Table table = judged(claims("a,2,,is two,a number,=,2,0\nb,2,,is three,a number,=,3,0\n"), paper,
                               {{"a", once}, {"b", once}}, [] {});
    CHECK(table.word(0, "verdict") == "reproduced");
    CHECK(table.word(0, "measured_equal") == "2");
    CHECK(table.word(0, "measured_tiled").empty());
    CHECK(table.word(1, "verdict") == "differs");
}

TEST_CASE("ledger: a range stands in two columns, and a definition is named as one, if it holds") {
    const Computation range = [](const Statement&, std::size_t) {
        return std::vector<Measurement>{{"", 1}, {"it lies between", 1, 3}};
    };
    const Table table = judged(claims("a,2,,is two,a number,=,2,0\nb,2,definition,is one,a number,=,1,0\n"
                                      "c,2,definition,is two,a number,=,2,0\n"),
                               paper, {{"a", range}, {"b", measuring(1, 1)}, {"c", measuring(1, 1)}}, [] {});
    CHECK(table.word(0, "conditional") == "1");
    CHECK(table.word(0, "conditional_upper") == "3");
    CHECK(table.word(1, "verdict") == "by definition");
    CHECK(table.word(2, "verdict") == "differs");
}

TEST_CASE("ledger: what a claim states is found by its id") {
    const Table table = claims("a,2,,is two,a number,=,2,0.1\n");
    CHECK(statement(table, "a").expected == 2);
    CHECK_THROWS_WITH_AS(statement(table, "b"), "there is no claim b", base::InvalidInput);
}

TEST_CASE("ledger: a claim without a computation is refused, and a computation without a claim") {
    const auto nothing = [] {};
    CHECK_THROWS_WITH_AS(judged(claims("a,2,,is two,a number,=,2,0.1\n"), paper, {}, nothing),
                         "claim a has no computation that decides it", base::FailedComputation);
    CHECK_THROWS_WITH_AS(judged(claims("a,2,,is two,a number,=,2,0.1\n"), paper,
                                {{"a", measuring(2, 2)}, {"b", measuring(2, 2)}}, nothing),
                         "2 computations decide 1 claims; every computation needs its row",
                         base::FailedComputation);
}
