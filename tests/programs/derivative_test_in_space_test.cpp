#include <algorithm>
#include <cmath>
#include <string>

#include "report/file.hpp"
#include "tests/programs/numbers.hpp"

using namespace programs;

TEST_CASE("derivative_test_in_space: a row for each place, with the orders of the errors") {
    const auto table = report::parsed(run("derivative_test_in_space --formulation definite_fpm").output);
    REQUIRE(table.rows.size() == 9);
    CHECK(table.word(0, "place") == "inside");
    CHECK(table.word(8, "place") == "corner");
    CHECK(number(table, 7, "count") == 236);
    for (std::size_t row = 3; row < 9; ++row) CHECK(number(table, row, "order_second") == relative(2, 0.05));
    const auto space =
        report::parsed(run("derivative_test_in_space --dimension 3 --particles 9 --sample 20").output);
    REQUIRE(space.rows.size() == 8);
    CHECK(space.word(1, "place") == "face");
    CHECK(number(space, 1, "count") == 20);
    CHECK(number(space, 3, "count") == 8);
}

TEST_CASE("derivative_test_in_space: the function typed is the function built in") {
    const std::string command = "derivative_test_in_space --particles 11 --formulation definite_fpm";
    const auto built_in = report::parsed(run(command).output),
               typed = report::parsed(run(command + " --function 'exp(x+y/2)+sin(x+2*y)'").output);
    const std::string in_space =
        "derivative_test_in_space --dimension 3 --particles 7 --sample 30 --formulation ssph";
    const auto built_in_space = report::parsed(run(in_space).output),
               typed_in_space =
                   report::parsed(run(in_space + " --function 'exp(x+y/2-0.3*z)+sin(x+2*y+1.5*z)'").output);
    for (const auto& [one, other] : {std::pair{&built_in, &typed}, {&built_in_space, &typed_in_space}})
        for (std::size_t row = 0; row < one->rows.size(); ++row)
            for (const char* column : {"error_first", "error_second", "quality"})
                CHECK(number(*one, row, column) == relative(number(*other, row, column), 1e-6));
}

TEST_CASE("derivative_test_in_space: medians and quartiles are those of the seeds") {
    const std::string command =
        "derivative_test_in_space --formulation definite_fpm --particles 11 --perturb 0.25 --seeds 3";
    const auto each = report::parsed(run(command).output),
               all = report::parsed(run(command + " --median").output);
    REQUIRE(each.rows.size() == 9);
    REQUIRE(all.rows.size() == 3);
    for (std::size_t place = 0; place < 3; ++place) {
        std::array<double, 3> errors{};
        for (std::size_t seed = 0; seed < 3; ++seed)
            errors.at(seed) = number(each, 3 * seed + place, "error_second");
        std::sort(errors.begin(), errors.end());
        CHECK(number(all, place, "error_second") == errors[1]);
        CHECK(number(all, place, "error_second_lower") == relative((errors[0] + errors[1]) / 2, 1e-6));
        CHECK(number(all, place, "seeds") == 3);
    }
}

TEST_CASE("derivative_test_in_space: particles of a file, in the plane and in space, are those of the grid") {
    const programs::Folder folder;
    for (const int dim : {2, 3}) {
        std::string text = dim == 2 ? "id,x,y\n" : "id,x,y,z\n";
        int id = 0;
        for (int k = 0; k < (dim == 2 ? 1 : 7); ++k)
            for (int j = 0; j < 7; ++j)
                for (int i = 0; i < 7; ++i)
                    text += std::to_string(id++) + "," + std::to_string(i / 6.0) + "," +
                            std::to_string(j / 6.0) + (dim == 2 ? "" : "," + std::to_string(k / 6.0)) + "\n";
        const std::string file = folder.path + "/body.csv";
        report::write_whole(file, text);
        const std::string command =
            "derivative_test_in_space --formulation definite_fpm --dimension " + std::to_string(dim);
        const auto own = report::parsed(run(command + " --layout " + file).output),
                   grid = report::parsed(run(command + " --particles 7").output);
        REQUIRE(own.rows.size() == 1);
        CHECK(own.word(0, "place") == "all");
        double most = 0;
        for (std::size_t row = 0; row < grid.rows.size(); ++row)
            most = std::max(most, number(grid, row, "error_second"));
        CHECK(number(own, 0, "error_second") == relative(most, 1e-3));
    }
}

TEST_CASE("derivative_test_in_space: states have the largest errors among them, on any number of threads") {
    const std::string command =
        "derivative_test_in_space --formulation definite_fpm --particles 9 --perturb 0.25 --seed 4";
    const std::string states = run(command + " --states --threads 1").output;
    CHECK(states == run(command + " --states --threads 2").output);
    const auto table = report::parsed(states), largest = report::parsed(run(command).output);
    REQUIRE(table.rows.size() == 81);
    double inside = 0, corner = 0;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        if (table.word(row, "place") == "inside")
            inside = std::max(inside, number(table, row, "error_second"));
        if (table.word(row, "place") == "corner")
            corner = std::max(corner, number(table, row, "error_second"));
    }
    CHECK(inside == number(largest, 0, "error_second"));
    CHECK(corner == number(largest, 2, "error_second"));
}

TEST_CASE("derivative_test_in_space: what has no meaning is refused, with what to do") {
    const std::string name = "derivative_test_in_space ";
    check_refused(name + "--function '1/(x-y)'", 2,
                  "the function is not real and bounded near (x, y) = (0, 0)");
    check_refused(name + "--function 'x*z'", 2, "there is no 'z'");
    check_refused(name + "--dimension 4", 2, "--dimension");
    check_refused(name + "--dimension 3 --layout graded-188-11", 2, "(such as stretched-4), or a file");
    check_refused(name + "--layout none.csv", 2, "cannot read none.csv");
    check_refused(name + "--particles 2", 2, "--particles: a side needs at least 3, got 2");
    check_refused(name + "--particles 11 --perturb 0.5", 2, "--perturb must lie in [0, 1/2), got 0.5");
    check_refused(name + "--seeds 3", 2, "--seeds changes nothing");
    check_refused(name + "--sample 9 --layout graded-188-11", 2, "--sample changes nothing without a grid");
    check_refused(name + "--smoothing 0.5 --particles 11 --formulation definite_fpm", 1,
                  "try --smoothing 0.86");
    check_refused(name + "--kernel sinc", 2, "there is no kernel 'sinc'");
    check_refused(name + "--particles 100000 --dimension 3", 2, "take fewer --particles");
    CHECK(run(name + "--smoothing 0.86 --particles 11 --formulation definite_fpm").code == 0);
}
