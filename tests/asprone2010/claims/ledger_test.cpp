#include "asprone2010/claims/ledger.hpp"

#include "tests/support/claims.hpp"
#include "tests/support/lines.hpp"

using support::expected;

namespace {

double measured(const std::string& id, std::size_t reading = 0, std::size_t convention = 0) {
    static const report::Ledger ledger = asprone2010::claims::ledger();
    return ledger.computations.at(id)(support::claim(id), convention).at(reading).value;
}

}  // namespace

TEST_CASE("claims: readings that add a condition are measured beside the claim as it stands") {
    CHECK(std::abs(measured("A-3.2-D2B-at-end")) < 0.01);
    CHECK(measured("A-3.2-D2B-at-end", 1) == support::relative(expected("A-3.2-D2B-at-end"), 0.01));
    CHECK(measured("A-5.3-eigenvalues") == support::relative(-0.9999, 1e-3));
    CHECK(measured("A-5.3-eigenvalues", 1) == support::relative(0.9999, 1e-3));
    CHECK(measured("A-5.3-printed-47") == support::relative(2, 1e-12));
    CHECK(measured("A-3.2-first-moment") == support::relative(-std::sqrt(std::acos(-1.0)) / 2, 1e-6));
    CHECK(measured("A-3.2-printed-15") > 0.1);
    CHECK(measured("A-3.2-printed-15", 1) < 1e-10);
    CHECK(measured("A-3.2-printed-19") > 0.1);
    CHECK(measured("A-3.2-printed-19", 1) < 1e-10);
    CHECK(measured("A-5.3-number") == 98);
    CHECK(measured("A-5.3-number", 1) == 100);
}

TEST_CASE("claims: the first convention takes volumes equal, the second as a partition; there is no third") {
    CHECK(measured("A-5.3-lowest-rkpm-second-order", 0, 0) == support::relative(0.6989, 1e-3));
    CHECK(measured("A-5.3-lowest-rkpm-second-order", 0, 1) == support::relative(0.7108, 1e-3));
    CHECK_THROWS(measured("A-5.3-lowest-rkpm-second-order", 0, 2));
}
