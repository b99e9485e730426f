#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include "tests/programs/numbers.hpp"

using namespace programs;

TEST_CASE("vibration_test_in_space: a row for each mode, beside the exact frequency and the symbol's") {
    const auto [code, output, errors] = run("vibration_test_in_space --particles 12");
    CHECK(code == 0);
    CHECK(errors.empty());
    const auto table = report::parsed(output);
    REQUIRE(table.rows.size() == 4 * 100);
    std::size_t row = 0;
    while (table.word(row, "formulation") != "definite_fpm") ++row;
    CHECK(table.word(row, "mode") == "1");
    CHECK(table.word(row, "seed").empty());
    CHECK(number(table, row, "exact") == relative(std::numbers::pi * std::sqrt(2.0), 1e-8));
    CHECK(number(table, row, "ratio") == relative(0.98, 0.01));
    CHECK(number(table, row, "ratio_symbol") == relative(number(table, row, "ratio"), 1e-3));
    CHECK(number(table, row, "ratio") ==
          relative(number(table, row, "frequency") / number(table, row, "exact"), 1e-8));
}

TEST_CASE("vibration_test_in_space: comments count the complex pairs, and finite elements have none") {
    const std::string output =
        run("vibration_test_in_space --formulation definite_fpm,fem_lumped --particles 12 --perturb 0.25 --seed 3")
            .output;
    const auto table = report::parsed(output);
    REQUIRE(table.rows.size() == 200);
    int pairs = 0;
    for (std::size_t row = 0; row < 100; ++row) {
        const std::complex<double> omega(number(table, row, "frequency"),
                                         number(table, row, "frequency_imaginary"));
        pairs += omega.real() > 0 && omega.imag() > 0 ? 1 : 0;
        CHECK(table.word(row, "ratio_symbol").empty());
        CHECK(number(table, 100 + row, "frequency_imaginary") == 0);
    }
    CHECK(pairs > 5);
    const std::string where = "12 particles along a side, perturbation 0.25, seed 3: ";
    CHECK(output.find("# complex pairs: definite_fpm, " + where + std::to_string(pairs) +
                      ", of 100 modes\n") != std::string::npos);
    CHECK(output.find("# complex pairs: fem_lumped, " + where + "0, of 100 modes\n") != std::string::npos);
}

TEST_CASE("vibration_test_in_space: the lowest modes are the first of all, on any number of threads") {
    const std::string command =
        "vibration_test_in_space --formulation definite_fpm,fem_consistent --particles 13";
    const auto all = report::parsed(run(command).output);
    const std::string output = run(command + " --lowest 5 --threads 1").output;
    CHECK(output == run(command + " --lowest 5 --threads 2").output);
    const auto lowest = report::parsed(output);
    REQUIRE(lowest.rows.size() == 10);
    for (std::size_t row = 0; row < 10; ++row)
        for (const char* column : {"frequency", "ratio"})
            CHECK(number(lowest, row, column) ==
                  relative(number(all, row < 5 ? row : 121 + row - 5, column), 1e-7));
}

TEST_CASE("vibration_test_in_space: in space, a cube of particles") {
    const auto table = report::parsed(
        run("vibration_test_in_space --dimension 3 --formulation definite_fpm --lowest 4").output);
    REQUIRE(table.rows.size() == 4);
    CHECK(number(table, 0, "exact") == relative(std::numbers::pi * std::sqrt(3.0), 1e-8));
    for (const std::size_t row : {1UL, 2UL, 3UL})
        CHECK(number(table, row, "exact") == relative(std::numbers::pi * std::sqrt(6.0), 1e-8));
}

TEST_CASE("vibration_test_in_space: what has no meaning is refused, with what to do") {
    const std::string name = "vibration_test_in_space ";
    check_refused(name + "--particles 2", 2, "a side needs at least 3, got 2");
    check_refused(name + "--particles 2000", 2, "take fewer --particles, or --lowest 10");
    check_refused(name + "--particles 4 --lowest 3", 2, "have 4 modes, of which at most 2 can be found so");
    check_refused(name + "--formulation none", 2, "choose one of all, original, definite_fpm");
    check_refused(name + "--dimension 3 --formulation fem_lumped", 2, "there is no formulation 'fem_lumped'");
    check_refused(name + "--seeds 3", 2, "--seeds changes nothing");
    check_refused(name + "--perturb 0.6", 2, "--perturb must lie in [0, 1/2), got 0.6");
    check_refused(name + "--lowest 5 --plot /tmp/membrane.svg", 2, "leave --lowest out");
    check_refused(name + "--particles 9,12 --plot /tmp/membrane.svg", 2, "one number of --particles");
    check_refused(name + "--formulation fem_lumped --particles 12 --perturb 0.45", 1,
                  "is turned over; take --perturb up to 0.25");
    check_refused(name + "--formulation definite_fpm --smoothing 0.5 --particles 11", 1, "try --smoothing");
}
