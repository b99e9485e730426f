#include "report/table.hpp"
#include "tests/programs/run.hpp"
#include "tests/support/relative.hpp"

using programs::check_refused;
using programs::run;
using support::relative;

TEST_CASE(
    "stencil: modified FPM at the end with a kernel that reaches two neighbours is the one-sided difference") {
    const auto [code, output, errors] = run(
        "stencil --formulation modified_fpm --particle 0 --particles 20 --kernel cubic_spline --smoothing 1.2");
    CHECK(code == 0);
    const auto table = report::parsed(output);
    REQUIRE(table.rows.size() == 3);
    const double first[] = {-1.5, 2, -0.5}, second[] = {1, -2, 1};
    for (std::size_t row = 0; row < 3; ++row) {
        CHECK(std::get<double>(table.rows[row][table.column("weight_first")]) == relative(first[row], 1e-9));
        CHECK(std::get<double>(table.rows[row][table.column("weight_second")]) ==
              relative(second[row], 1e-9));
    }
    CHECK(output.find("D, moment 2 / 2!: ") != std::string::npos);
    CHECK(output.find("# D2, moment 3 / 3!: 1: leaves 1 delta^1 B^(3)\n") != std::string::npos);
    CHECK(output.find("# D2, quality R = 1.66667: the error is at most R delta^1 max|B^(3)|\n") !=
          std::string::npos);
    CHECK(output.find("condition of the system for DB and D2B: ") != std::string::npos);
}

TEST_CASE("stencil: every formulation has one, on perturbed particles too") {
    for (const char* name : {"original", "chen_beraun", "rkpm_first_order", "rkpm_second_order", "fpm",
                             "modified_fpm", "second_order_fpm", "ssph"}) {
        CAPTURE(name);
        const auto found = run("stencil --particles 30 --particle 7 --perturb 0.25 --seed 3 --formulation " +
                               std::string(name));
        CHECK(found.code == 0);
        CHECK(report::parsed(found.output).rows.size() > 8);
    }
}

TEST_CASE("stencil: one formulation, one line, a particle that exists") {
    check_refused("stencil", 2, "name one --formulation");
    check_refused("stencil --formulation fpm --particles 10,20", 2, "one number of --particles");
    check_refused("stencil --formulation fpm --particle 50", 2, "there is no particle 50; choose 0 to 49");
    check_refused("stencil --formulation fpm --plot /tmp/stencil.svg", 2, "there is no option '--plot'");
    check_refused("stencil --formulation fpm --particle -1", 2, "there is no particle -1");
}
