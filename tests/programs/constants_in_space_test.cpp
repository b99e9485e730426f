#include <cmath>
#include <numbers>

#include "report/table.hpp"
#include "tests/programs/run.hpp"
#include "tests/support/relative.hpp"

using programs::check_refused;
using programs::run;
using support::relative;

TEST_CASE("constants_in_space: what the stencils predict is what exponentials show, to a millionth") {
    for (const char* which :
         {"--dimension 2 --formulation all", "--dimension 3 --formulation definite_fpm --cut 4"}) {
        const auto [code, output, errors] = run(std::string("constants_in_space ") + which);
        CHECK(code == 0);
        const auto table = report::parsed(output);
        const std::size_t difference = table.column("relative_difference");
        CHECK(table.rows.size() > 100);
        for (std::size_t row = 0; row < table.rows.size(); ++row) {
            CAPTURE(which);
            CAPTURE(row);
            CHECK(std::get<double>(table.rows[row][difference]) < 1e-6);
        }
    }
}

TEST_CASE("constants_in_space: each constant is named by place, derivative and monomial") {
    const auto table =
        report::parsed(run("constants_in_space --dimension 2 --formulation definite_fpm").output);
    std::size_t row = 0;
    while (table.word(row, "place") != "edge" || table.word(row, "derivative") != "11") ++row;
    CHECK(table.word(row, "monomial") == "1111");
    CHECK(std::get<double>(table.rows[row][table.column("constant")]) == relative(-0.92041817, 1e-7));
    CHECK(std::get<double>(table.rows[row][table.column("exponent")]) == 2);
}

TEST_CASE("constants_in_space: places without numbers say why, with a remedy that works") {
    const std::string chosen =
        "constants_in_space --dimension 2 --formulation definite_fpm --kernel wendland_c4";
    const auto [code, output, errors] = run(chosen + " --smoothing 1.3");
    CHECK(code == 0);
    CHECK(output.find(
              "# empty: dimension 2, definite_fpm with wendland_c4, h/delta 1.3, corner: a particle has "
              "8 neighbours within 2h, needs 10; try --smoothing 1.6\n") != std::string::npos);
    CHECK(output.find("\n2,definite_fpm,wendland_c4,1.3,corner,11,,,,,,\n") != std::string::npos);
    CHECK(run(chosen + " --smoothing 1.6").output.find("empty") == std::string::npos);
    check_refused(
        chosen + " --smoothing 0.4", 1,
        "no case has numbers; dimension 2, definite_fpm with wendland_c4, h/delta 0.4, inside: a particle has 1 neighbour within 2h, needs 10");
}

TEST_CASE("constants_in_space: the symbol of long waves is exact, and all waves of the plane are there") {
    const auto table = report::parsed(
        run("constants_in_space --symbol --formulation definite_fpm,ssph --smoothing 1,2").output);
    REQUIRE(table.rows.size() == 2 * 2 * 13 * 13);
    const std::size_t ratio = table.column("ratio"), theta = table.column("theta2");
    CHECK(std::get<double>(table.rows[0][ratio]) == 1);
    CHECK(std::get<double>(table.rows[1][ratio]) == relative(1, 0.02));
    CHECK(std::get<double>(table.rows[12][theta]) == relative(std::numbers::pi, 1e-9));
    CHECK(std::get<double>(table.rows[168][ratio]) == relative(0.1119, 1e-3));
}

TEST_CASE("constants_in_space: a Gaussian that is lowered to zero has other constants") {
    const auto table = report::parsed(
        run("constants_in_space --dimension 2 --formulation definite_fpm --cut 3 --smoothing 1").output);
    CHECK(table.word(0, "kernel") == "truncated_gaussian");
    CHECK(std::get<double>(table.rows[0][table.column("constant")]) < 0.2528);
}

TEST_CASE("constants_in_space: options that have no meaning are refused") {
    check_refused("constants_in_space --dimension 1", 2,
                  "--dimension 1 is neither 2, the plane, nor 3, space");
    check_refused("constants_in_space --formulation fpm", 2, "there is no formulation 'fpm'");
    check_refused("constants_in_space --kernel sinc", 2, "there is no kernel 'sinc'");
    check_refused("constants_in_space --cut 0", 2, "--cut must be positive, got 0");
    check_refused("constants_in_space --cut 3 --kernel gaussian", 2, "--cut exclude each other");
    check_refused("constants_in_space --symbol --dimension 3", 2, "--symbol exclude each other");
    check_refused("constants_in_space --smoothing 7", 2, "h/delta of 7 ");
}
