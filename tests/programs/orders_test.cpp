#include <cmath>

#include "report/table.hpp"
#include "tests/programs/run.hpp"
#include "tests/support/relative.hpp"

using programs::check_refused;
using programs::run;
using support::relative;

TEST_CASE("orders: the paper's orders of D and D2 stand in the map, for the Gaussian with h = delta") {
    const auto [code, output, errors] = run("orders --from 1 --to 1");
    CHECK(code == 0);
    const auto table = report::parsed(output);
    CHECK(table.rows.size() == 8 * 5 * 2);
    const auto order = [&](const std::string& formulation, const std::string& column) {
        for (std::size_t row = 0; row < table.rows.size(); ++row)
            if (table.word(row, "formulation") == formulation && table.word(row, "kernel") == "gaussian" &&
                table.word(row, "perturbation") == "0")
                return std::get<double>(table.rows[row][table.column(column)]);
        return -99.0;
    };
    CHECK(order("second_order_fpm", "order_first") == relative(2, 0.02));
    CHECK(order("second_order_fpm", "order_second") == relative(2, 0.02));
    CHECK(order("second_order_fpm", "order_displacement") == relative(2, 0.02));
    CHECK(order("modified_fpm", "order_second") == relative(1, 0.02));
    CHECK(std::abs(order("chen_beraun", "order_second")) < 0.02);
    CHECK(order("original", "order_second") == relative(-1, 0.02));
}

TEST_CASE("orders: the same bytes on any number of threads; a range that is none is refused") {
    CHECK(run("orders --from 1.6 --to 1.6 --threads 1").output ==
          run("orders --from 1.6 --to 1.6 --threads 3").output);
    check_refused("orders --from 2 --to 1", 2, "is no range");
    check_refused("orders --step 0", 2, "in steps of 0 is no range");
}
