#include "asprone2010/claims.hpp"

#include "report/file.hpp"
#include "report/papers.hpp"
#include "tests/support.hpp"

namespace {

const report::Ledger& ledger() {
    static const report::Ledger of = asprone2010::claims::ledger();
    return of;
}

double measured(const std::string& id, std::size_t reading = 0, std::size_t convention = 0) {
    return ledger().computations.at(id)(convention).at(reading).value;
}

report::Table words_of(const std::string& path) {
    return report::parsed_words(report::read_whole(path));
}

}  // namespace

TEST_CASE(
    "claims: every row of the ledger has a computation, every computation a row, and a test that exists") {
    const auto papers = report::papers(words_of("paper/papers.csv"));
    const auto claims = report::by_paper(words_of("paper/claims.csv"), papers).at(ledger().paper);
    const auto& computations = ledger().computations;
    CHECK(claims.rows.size() == computations.size());
    for (std::size_t row = 0; row < claims.rows.size(); ++row) {
        CHECK(computations.count(claims.word(row, "id")) == 1);
        CHECK_NOTHROW(report::read_whole("tests/" + claims.word(row, "test")));
        CHECK_FALSE(claims.word(row, "reason").empty());
    }
}

TEST_CASE("claims: readings that add a condition are measured beside the claim as it stands") {
    CHECK(std::abs(measured("A06a")) < 0.01);
    CHECK(measured("A06a", 1) == support::relative(1, 0.01));
    CHECK(measured("A04c") < 1.3);
    CHECK(measured("A04c", 1) == support::relative(2, 0.01));
    CHECK(measured("A27b") == support::relative(-0.9999, 1e-3));
    CHECK(measured("A27b", 1) == support::relative(0.9999, 1e-3));
    CHECK(measured("A27a") == support::relative(2, 1e-12));
    CHECK(measured("A25") == support::relative(-std::sqrt(std::acos(-1.0)) / 2, 1e-6));
}

TEST_CASE("claims: the first convention takes volumes equal, the second as a partition; there is no third") {
    CHECK(measured("A22c", 0, 0) == support::relative(0.6989, 1e-3));
    CHECK(measured("A22c", 0, 1) == support::relative(0.7108, 1e-3));
    CHECK_THROWS(measured("A22c", 0, 2));
}
