#include "report/table.hpp"
#include "tests/programs/run.hpp"
#include "tests/relative.hpp"

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
