#include <cmath>

#include "report/table.hpp"
#include "tests/programs/run.hpp"
#include "tests/support/relative.hpp"

using programs::check_refused;
using programs::run;
using support::relative;

TEST_CASE("constants: what the stencils predict is what exp shows, to a millionth") {
    const auto [code, output, errors] = run("constants --volumes equal,partition");
    CHECK(code == 0);
    const auto table = report::parsed(output);
    CHECK(table.rows.size() == 8 * 5 * 3 * 2 * 2 * 4);
    const std::size_t difference = table.column("relative_difference");
    std::size_t compared = 0;
    for (std::size_t row = 0; row < table.rows.size(); ++row)
        if (const auto* found = std::get_if<double>(&table.rows[row][difference])) {
            CAPTURE(row);
            CHECK(*found < 1e-6);
            ++compared;
        }
    CHECK(compared > 1500);
}

TEST_CASE("constants: second-order FPM at the end errs by -0.919921 e delta^2") {
    const auto table = report::parsed(
        run("constants --formulation second_order_fpm --kernel gaussian --smoothing 1").output);
    CHECK(table.rows.size() == 8);
    CHECK(table.word(4, "place") == "0");
    CHECK(std::get<double>(table.rows[4][table.column("constant")]) == relative(-0.919921, 1e-6));
    CHECK(std::get<double>(table.rows[4][table.column("exponent")]) == 2);
}

TEST_CASE("constants: where cases are chosen, each without numbers says why, and a remedy that works") {
    const std::string some =
        run("constants --formulation second_order_fpm --kernel quintic_spline,wendland_c4 --smoothing 1.2,2")
            .output;
    const std::string why =
        "# empty: second_order_fpm with wendland_c4, h/delta 1.2, volumes equal: a particle has 3 neighbours within 2h, needs 4; try --smoothing 1.6\n";
    const std::size_t at = some.find("# empty");
    CHECK(some.substr(at, why.size()) == why);
    CHECK(some.find("# empty", at + 1) == std::string::npos);
    CHECK(run("constants --formulation second_order_fpm --kernel wendland_c4 --smoothing 1.6")
              .output.find("empty") == std::string::npos);
    check_refused("constants --formulation second_order_fpm --kernel wendland_c4 --smoothing 1.2", 1,
                  "no case has numbers; second_order_fpm with wendland_c4, h/delta 1.2");
}

TEST_CASE("constants: names and ratios that have no meaning are refused") {
    check_refused("constants --formulation sph", 2, "there is no formulation 'sph'");
    check_refused("constants --kernel sinc", 2, "there is no kernel 'sinc'");
    check_refused("constants --volumes half", 2, "there is no volume convention 'half'");
    check_refused("constants --smoothing 0", 2, "h/delta of 0 ");
}
