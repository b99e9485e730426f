#include "report/source.hpp"

#include <doctest/doctest.h>

using namespace report;
using Words = std::vector<std::string>;

TEST_CASE("source: the names of test cases, in one literal or in several") {
    CHECK(test_cases("TEST_CASE(\"one\") {}\nTEST_CASE(\n    \"two \"\n    \"parts\") {}\n") ==
          Words{"one", "two parts"});
    CHECK(test_cases(R"(TEST_CASE("a \"quoted\" name") {})") == Words{"a \"quoted\" name"});
    CHECK(test_cases("CHECK(\"none\");").empty());
}

TEST_CASE("source: the keys of a command, and of no longer one") {
    const std::string text =
        "/// \\eq{A16} \\eq{B2.11}, \\claim{A-5.1-perturbed} \\claims{A-5.1} \\defeq{A17}";
    CHECK(keys(text, "eq") == Words{"A16", "B2.11"});
    CHECK(keys(text, "claim") == Words{"A-5.1-perturbed"});
    CHECK(keys(text, "claims") == Words{"A-5.1"});
    CHECK(keys(text, "defeq") == Words{"A17"});
}
