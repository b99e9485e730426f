#include "report/table.hpp"
#include "tests/programs/run.hpp"
#include "tests/support/relative.hpp"

using programs::check_refused;
using programs::run;
using support::relative;

TEST_CASE(
    "roundoff: measured errors lie between a fifth of the predicted round-off and the sum of both predictions") {
    const auto [code, output, errors] = run("roundoff --most 100000 --most-quad 1000");
    CHECK(code == 0);
    const auto table = report::parsed(output);
    const auto number = [&](std::size_t row, const char* column) {
        return std::get<double>(table.rows[row][table.column(column)]);
    };
    std::size_t drowned = 0;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        CAPTURE(row);
        const double truncation = number(row, "predicted_truncation"),
                     round_off = number(row, "predicted_roundoff");
        if (number(row, "particles") < 100) continue;  // the expansion's next term still counts
        CHECK(number(row, "error_second") < 1.05 * (truncation + round_off));
        if (round_off < 30 * truncation) continue;
        CHECK(number(row, "error_second") > round_off / 20);
        ++drowned;
    }
    CHECK(drowned >= 3);
}

TEST_CASE("roundoff: a formulation whose error does not fall is refused") {
    check_refused("roundoff --formulation chen_beraun", 2, "does not fall with delta");
    check_refused("roundoff --formulation sph", 2, "there is no formulation 'sph'");
}
