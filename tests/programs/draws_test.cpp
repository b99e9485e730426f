#include "report/table.hpp"
#include "tests/programs/run.hpp"
#include "tests/support/relative.hpp"

using programs::check_refused;
using programs::run;
using support::relative;

TEST_CASE("draws: percentiles increase, and the median is that of derivative_test over the same seeds") {
    const auto [code, output, errors] = run("draws --formulation second_order_fpm --particles 40 --seeds 51");
    CHECK(code == 0);
    const auto table = report::parsed(output);
    REQUIRE(table.rows.size() == 101);
    const std::size_t second = table.column("error_second");
    for (std::size_t row = 1; row < 101; ++row)
        CHECK(std::get<double>(table.rows[row][second]) >= std::get<double>(table.rows[row - 1][second]));
    const auto other = report::parsed(
        run("derivative_test --formulation second_order_fpm --particles 40 --perturb 0.25 --seeds 51 --median")
            .output);
    CHECK(std::get<double>(table.rows[50][second]) ==
          relative(std::get<double>(other.rows[0][other.column("error_second")]), 1e-6));
}

TEST_CASE("draws: the same bytes on any number of threads; bad input is refused") {
    const std::string command = "draws --formulation fpm --particles 30 --seeds 20 --threads ";
    CHECK(run(command + "1").output == run(command + "3").output);
    check_refused("draws --formulation sph", 2, "there is no formulation 'sph'");
    check_refused("draws --perturb 0.5", 2, "does not keep the particles in order");
    check_refused("draws --particles 1", 2, "at least 2 particles");
}
