#include "report/papers.hpp"

#include <doctest/doctest.h>

#include "base/errors.hpp"

using namespace report;

namespace {

std::vector<Paper> two_papers() {
    return papers(
        parsed_words("letter,paper,citation,own,conventions,one,if_one,other,if_other\n"
                     "A,first,First (1901),,volumes,equal,volumes are equal,partition,volumes tile\n"
                     "B,second,\"Second, Third (1902)\",yes,error,dn,E is a difference,nd,E is a norm\n"));
}

}  // namespace

TEST_CASE("papers: each has its letter, folder, citation and conventions") {
    const auto all = two_papers();
    CHECK(all.size() == 2);
    CHECK(paper_named("first", all).letter == "A");
    const Paper& second = paper_named("second", all);
    CHECK(second.letter == "B");
    CHECK(second.citation == "Second, Third (1902)");
    CHECK(second.own);
    CHECK_FALSE(all.front().own);
    CHECK(second.conventions.about == "error");
    CHECK(second.conventions.one.name == "dn");
    CHECK(second.conventions.one.condition == "E is a difference");
    CHECK(second.conventions.other.name == "nd");
    CHECK(second.conventions.other.condition == "E is a norm");
    CHECK_THROWS_AS(paper_named("third", all), base::InvalidInput);
}

TEST_CASE("papers: a row belongs to the paper whose letter its key begins with, and to one") {
    const auto all = two_papers();
    const auto parts = by_paper(parsed_words("equation,section\nA1,2\nB2.10,2\nA2,2\n"), all);
    CHECK(parts.size() == 2);
    CHECK(parts.at("first").rows.size() == 2);
    CHECK(parts.at("first").word(1, "equation") == "A2");
    CHECK(parts.at("second").rows.size() == 1);
    CHECK(parts.at("second").word(0, "equation") == "B2.10");
    CHECK(by_paper(parsed_words("equation,section\n"), all).at("second").rows.empty());
    CHECK_THROWS_WITH_AS(by_paper(parsed_words("equation\nA1\nC1\n"), all), "C1 belongs to no paper",
                         base::FailedComputation);
}
