#include <cmath>

#include "report/table.hpp"
#include "tests/programs/run.hpp"
#include "tests/support/relative.hpp"

using programs::run;

TEST_CASE("static_test: columns by their names and the numbers of an independent calculation") {
    const auto [code, output, errors] =
        run("static_test --formulation chen_beraun,modified_fpm,second_order_fpm --particles 640");
    CHECK(code == 0);
    CHECK(errors.empty());
    CHECK(output.find("\nformulation,particles,spacing,perturbation,seed,error_displacement\n") !=
          std::string::npos);
    const auto table = report::parsed(output);
    REQUIRE(table.rows.size() == 3);
    CHECK(std::get<double>(table.rows[0].back()) == support::relative(2.455e-3, 1e-3));
    CHECK(std::get<double>(table.rows[1].back()) == support::relative(2.139e-6, 1e-3));
    CHECK(std::get<double>(table.rows[2].back()) == support::relative(3.997e-7, 1e-3));
}

TEST_CASE("static_test: the same bytes on any number of threads") {
    const std::string command = "static_test --particles 40,2000 --perturb 0.25 --seeds 3";
    const auto alone = run(command + " --threads 1");
    CHECK(alone.code == 0);
    CHECK(run(command + " --threads 2").output == alone.output);
    CHECK(run("OPENBLAS_NUM_THREADS=2 " + command + " --threads 3").output == alone.output);
}

TEST_CASE("static_test: the default's displacement, typed, gives the default's errors") {
    for (const std::string options : {"", " --perturb 0.25 --end fpm --volumes partition"}) {
        CAPTURE(options);
        const auto own = report::parsed(run("static_test --displacement '-exp(x)+e*x+1'" + options).output);
        const auto table = report::parsed(run("static_test" + options).output);
        REQUIRE(own.rows.size() == table.rows.size());
        const std::size_t column = table.column("error_displacement");
        for (std::size_t row = 0; row < table.rows.size(); ++row) {
            const double error = std::get<double>(table.rows[row][column]);
            CHECK(std::abs(std::get<double>(own.rows[row][column]) - error) < 1e-6 * error + 5e-10);
        }
    }
}

TEST_CASE("static_test: load and end values follow from --displacement") {
    const auto [code, output, errors] = run(
        "static_test --displacement '3*x^2-x+2' --formulation second_order_fpm,modified_fpm,ssph --particles 53");
    CHECK(code == 0);
    CHECK(output.find("with u = 3*x^2-x+2\n") != std::string::npos);
    const auto table = report::parsed(output);
    REQUIRE(table.rows.size() == 3);
    for (const auto& row : table.rows) CHECK(std::get<double>(row.back()) < 1e-10);  // exact on parabolas
    const auto sine = report::parsed(
        run("static_test --displacement 'x*exp(-x)+sin(3*x)' --formulation second_order_fpm --particles 320,640")
            .output);
    const std::size_t error = sine.column("error_displacement");
    CHECK(std::get<double>(sine.rows[0][error]) / std::get<double>(sine.rows[1][error]) ==
          support::relative(4, 0.05));
    CHECK(std::get<double>(sine.rows[1][sine.column("order_displacement")]) == support::relative(2, 0.05));
}

TEST_CASE("static_test: in quad precision second_order_fpm keeps order two") {
    const auto table = report::parsed(
        run("static_test --formulation second_order_fpm --precision quad --particles 1000,10000").output);
    const auto error = [&](std::size_t row) {
        return std::get<double>(table.rows[row][table.column("error_displacement")]);
    };
    CHECK(std::log(error(0) / error(1)) / std::log(9999.0 / 999) == support::relative(2, 0.0025));
}

TEST_CASE("static_test: --states shows each particle, and its largest error is that of the table without") {
    const std::string asked = "--particles 25 --end modified_fpm --perturb 0.2 --displacement \"sin(3*x)\"";
    const auto states = report::parsed(run("static_test --states " + asked).output),
               errors = report::parsed(run("static_test " + asked).output);
    REQUIRE(states.rows.size() == 25 * errors.rows.size());
    for (std::size_t row = 0; row < errors.rows.size(); ++row) {
        double largest = 0;
        for (std::size_t i = 25 * row; i < 25 * (row + 1); ++i)
            largest = std::max(
                largest, std::abs(std::get<double>(states.rows[i][states.column("error_displacement")])));
        CHECK(largest == support::relative(
                             std::get<double>(errors.rows[row][errors.column("error_displacement")]), 1e-6));
    }
}
