#include <algorithm>
#include <array>
#include <string>

#include "base/text.hpp"
#include "tests/programs/numbers.hpp"

using namespace programs;

TEST_CASE("static_test_in_space: a row for each condition and place, with the orders of the errors") {
    const auto table = report::parsed(
        run("static_test_in_space --formulation definite_fpm --particles 16,31 --conditions all").output);
    REQUIRE(table.rows.size() == 18);
    CHECK(table.word(0, "conditions") == "dirichlet");
    CHECK(table.word(3, "conditions") == "mixed");
    CHECK(table.word(8, "conditions") == "neumann");
    CHECK(table.word(8, "place") == "corner");
    CHECK(number(table, 1, "error_value") == 0);  // given
    for (std::size_t row = 12; row < 18; ++row) CHECK(number(table, row, "order_value") == relative(2, 0.1));
    const auto space =
        report::parsed(run("static_test_in_space --dimension 3 --formulation ssph --particles 7").output);
    REQUIRE(space.rows.size() == 4);
    CHECK(space.word(1, "place") == "face");
    CHECK(number(space, 3, "count") == 8);
}

TEST_CASE("static_test_in_space: exact on quadratics that are typed, on stretched and perturbed particles") {
    const auto table = report::parsed(
        run("static_test_in_space --formulation definite_fpm,ssph --function 'x^2-3*x*y+y' --particles 12 --layout stretched-4 --perturb 0.25 --conditions all")
            .output);
    REQUIRE(table.rows.size() == 18);
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        CHECK(number(table, row, "error_value") < 1e-9);
        CHECK(number(table, row, "error_first") < 1e-8);
    }
}

TEST_CASE(
    "static_test_in_space: a file of a grid gives the errors of the grid, also where its sides are rounded") {
    const Folder folder;
    std::string grid;
    for (int i = 0; i <= 8; ++i)
        for (int j = 0; j <= 8; ++j)
            grid += (i == 0   ? "1e-9"
                     : i == 8 ? "0.999999999"
                              : base::shown(i / 8.0)) +
                    "," + base::shown(j / 8.0) + "\n";
    report::write_whole(folder.path + "/grid.csv", grid);
    const std::string command = "static_test_in_space --formulation definite_fpm --conditions neumann ";
    const auto file = report::parsed(
                   run(command + "--layout " + folder.path + "/grid.csv --smoothing-from 0.125").output),
               same = report::parsed(run(command + "--particles 9,9").output);
    REQUIRE(same.rows.size() == 3);
    double largest = 0;
    for (std::size_t row = 0; row < 3; ++row) largest = std::max(largest, number(same, row, "error_value"));
    CHECK(number(file, 0, "error_value") == relative(largest, 1e-9));
}

TEST_CASE("static_test_in_space: states have the largest errors among them, on any number of threads") {
    const std::string command =
        "static_test_in_space --formulation definite_fpm --particles 9 --perturb 0.25 --seed 4";
    const std::string states = run(command + " --states --threads 1").output;
    CHECK(states == run(command + " --states --threads 2").output);
    const auto table = report::parsed(states), largest = report::parsed(run(command).output);
    REQUIRE(table.rows.size() == 81);
    double inside = 0;
    for (std::size_t row = 0; row < table.rows.size(); ++row)
        if (table.word(row, "place") == "inside")
            inside = std::max(inside, number(table, row, "error_value"));
    CHECK(inside == number(largest, 0, "error_value"));
}

TEST_CASE("static_test_in_space: what has no meaning is refused, with what to do") {
    const std::string name = "static_test_in_space ";
    check_refused(name + "--conditions robin", 2, "choose one of all, dirichlet, mixed, neumann");
    for (const char* layout : {"graded-188-11", "stretched", "Grid"})
        check_refused(name + "--layout " + layout, 2,
                      "choose grid, stretched-G (such as stretched-4), or a file");
    check_refused(name + "--layout stretched-1", 2, "distances do not grow; take grid");
    check_refused(name + "--layout stretched-5000", 2, "by a factor from 0.001 to 1000, got 5000");
    check_refused(name + "--layout stretched-10 --particles 12 --formulation ssph --smoothing 0.5", 1,
                  "try --smoothing 0.71");
    CHECK(run(name + "--layout stretched-10 --particles 12 --formulation ssph --smoothing 0.71").code == 0);
}
