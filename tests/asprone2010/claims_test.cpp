#include "asprone2010/claims.hpp"

#include "report/file.hpp"
#include "report/table.hpp"
#include "tests/support.hpp"

using particles::Volumes;

namespace {

double measured(const std::string& id, std::size_t reading = 0) {
    return asprone2010::claims::computations().at(id)(Volumes::equal).at(reading).value;
}

}  // namespace

TEST_CASE(
    "claims: every row of the ledger has a computation, every computation a row, and a test that exists") {
    const auto ledger = report::parsed(report::read_whole("paper/claims.csv"));
    const auto& computations = asprone2010::claims::computations();
    CHECK(ledger.rows.size() == computations.size());
    for (std::size_t row = 0; row < ledger.rows.size(); ++row) {
        CHECK(computations.count(ledger.word(row, "id")) == 1);
        CHECK_NOTHROW(report::read_whole("tests/" + ledger.word(row, "test")));
        CHECK_FALSE(ledger.word(row, "reason").empty());
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
