#include "report/findings.hpp"

#include <doctest/doctest.h>

#include "base/errors.hpp"

using report::Reproduction;
using report::with_numbers;

namespace {

std::vector<Reproduction> two_claims() {
    Reproduction one;
    one.paper.own = false;
    one.paper.conventions.one.name = "equal";
    one.verdicts = report::parsed_words(
        "id,quantity,measured_equal,measured_partition,conditional,verdict\n"
        "A-2-a,error,1.5,1.25,,reproduced\nA-2-b,error,0.1,0.2,1.001,holds only if h is larger\n"
        "A-3-c,order of DB,-0.0002625,1,0.99949,holds only if h is larger\n");
    Reproduction own = one;
    own.paper.own = true;
    own.verdicts =
        report::parsed_words("id,quantity,measured_equal,conditional,verdict\nC-1-a,error,1,,differs\n");
    return {one, own};
}

}  // namespace

TEST_CASE("findings: braces become what was measured, with its condition, and counts") {
    const auto all = two_claims();
    CHECK(with_numbers("order {A-2-a}, else {A-2-b} or {A-2-b conditional}.", all) ==
          "order 1.5, else 0.1 or 1.001.");
    CHECK(with_numbers("{count A-2-a}, {count A-2} hold", all) == "all 1, 1 of 2 hold");
    CHECK(with_numbers("{verdicts}", all) ==
          "Of the papers' 3 testable statements, 1 is reproduced, 2 hold under a condition, and 0 differ.");
    CHECK(with_numbers("{own verdicts}", all) ==
          "Of the 1 statements of our own text, 0 are reproduced, 0 hold under a condition, and 1 differs.");
    CHECK(with_numbers("no brace", all) == "no brace");
    CHECK(with_numbers("{A-3-c}, {A-3-c conditional}", all) == "0, 0.999");  // orders, to a thousandth
}

TEST_CASE("findings: a claim that is not there, and a number that is empty, are refused") {
    const auto all = two_claims();
    CHECK_THROWS_WITH_AS(with_numbers("{A-3-a}", all),
                         "the findings name A-3-a, of which the verdicts have no measured number",
                         base::FailedComputation);
    CHECK_THROWS_AS(with_numbers("{A-2-a conditional}", all), base::FailedComputation);
    CHECK_THROWS_AS(with_numbers("{count B}", all), base::FailedComputation);
}
