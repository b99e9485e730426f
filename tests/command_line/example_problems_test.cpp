#include "command_line/example_problems.hpp"

#include "tests/programs/run.hpp"
#include "tests/support/relative.hpp"

using namespace programs;

TEST_CASE("example_problems: --quality adds R of the worst derivative and the noise of the unknowns") {
    const auto table = report::parsed(run("plate --method strong,weak1 --quality").output);
    for (std::size_t row = 0; row < 2; ++row) {
        CHECK(std::get<double>(table.rows[row][table.column("quality")]) == support::relative(1.5943, 1e-4));
        CHECK(std::get<double>(table.rows[row][table.column("noise")]) < 0.1);
    }
    CHECK(run("plate --quality --states particles").code == 2);
}

TEST_CASE("example_problems: with --quality, comments name the whole case, and where its worst row lies") {
    const std::string text =
        run("hole --method strong --radius 0.3,0.4 --draws 3 --poisson 0.3 --quality").output;
    CAPTURE(text);
    const std::size_t at = text.find("# quality: R of the worst derivative");
    REQUIRE(at != std::string::npos);
    const std::string line = text.substr(at, text.find('\n', at) - at);
    for (const char* part :
         {"the largest is ", "strong, 188 particles, scaling 4, poisson 0.3, layout graded-188-11, radius 0.",
          ", draw ", " derivative at particle ", " (x = ("})
        CHECK(line.find(part) != std::string::npos);
}

TEST_CASE("example_problems: a table says which solutions are noise, and of others nothing") {
    const std::string quiet = run("hole --method strong").output;
    CHECK(quiet.find("# noise") == std::string::npos);
    const std::string noisy =
        run("hole --method strong,weak1 --smoothing-from 6-nearest --states x2-axis").output;
    CHECK(
        noisy.find(
            "# noise: the unknowns alternate between neighbours, and stresses may be wrong, in 2 cases, most of all in: weak1, 188 particles, scaling 4 (noise ") !=
        std::string::npos);
}
