#include "command_line/sweep.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "tests/programs/run.hpp"

using command_line::failure_of;
using command_line::Sweep;
using namespace programs;

namespace {

/// A table of two columns that name a case, and one of numbers.
report::Table empty() {
    report::Table table;
    table.columns = {{"name"}, {"count"}, {"number"}};
    return table;
}

using Rows = std::vector<std::vector<report::Cell>>;

Rows refused() {
    throw base::InvalidInput("b: nothing has this meaning");
}
Rows failed() {
    throw base::FailedComputation("it is singular");
}

}  // namespace

TEST_CASE(
    "sweep: a case that fails has a row with empty numbers and its reason, and the first one is named") {
    report::Table table = empty();
    Sweep sweep(table, 2);
    sweep.attempt({"a", 1L}, [] { return Rows{{"a", 1L, 0.5}}; });
    sweep.attempt({"b", 1L}, refused);
    sweep.attempt({"b", 2L}, failed);
    sweep.finish();
    CHECK(report::csv(table) ==
          "name,count,number,failure\na,1,0.5,\nb,1,,nothing has this meaning\nb,2,,it is singular\n");
    CHECK(command_line::without_failures(table).rows.size() == 1);
    CHECK(table.incomplete ==
          "2 of 3 cases failed, as the table's last column says; name b, count 1: nothing has this meaning");
}

TEST_CASE("sweep: a case with a number that is not finite has failed") {
    report::Table table = empty();
    Sweep sweep(table, 2);
    sweep.attempt({"a", 1L}, [] { return Rows{{"a", 1L, 0.5}, {"a", 1L, HUGE_VAL}}; });
    sweep.attempt({"a", 2L}, [] { return Rows{{"a", 2L, 0.5}}; });
    sweep.finish();
    CHECK(report::csv(table) == "name,count,number,failure\na,1,,number is not finite\na,2,0.5,\n");
}

TEST_CASE("sweep: without a failure a table is as it was") {
    report::Table table = empty();
    Sweep sweep(table, 2);
    sweep.attempt({"a", 1L}, [] { return Rows{{"a", 1L, 0.5}, {"a", 1L, 0.7}}; });
    sweep.finish();
    CHECK(report::csv(table) == "name,count,number\na,1,0.5\na,1,0.7\n");
    CHECK(table.incomplete.empty());
}

TEST_CASE("sweep: where every case fails the first failure is thrown, with its case if there are others") {
    report::Table table = empty();
    Sweep one(table, 2);
    one.attempt({"b", 1L}, refused);
    CHECK_THROWS_WITH_AS(one.finish(), "b: nothing has this meaning", base::InvalidInput);

    table = empty();
    Sweep two(table, 2);
    two.attempt({"b", 1L}, failed);
    two.attempt({"b", 2L}, refused);
    CHECK_THROWS_WITH_AS(two.finish(), "none of the 2 cases can be computed; count 1: it is singular",
                         base::FailedComputation);
}

TEST_CASE("sweep: only the two errors of this package are failures of a case") {
    CHECK(!failure_of([] {}));
    CHECK(failure_of([] { throw base::InvalidInput("a"); })->invalid);
    CHECK(!failure_of([] { throw base::FailedComputation("a"); })->invalid);
    CHECK_THROWS_AS(failure_of([] { throw std::bad_alloc(); }), std::bad_alloc);
}

TEST_CASE("sweep: programs write what can be computed, name the case that cannot, and end with code 1") {
    struct Case {
        const char *command, *rows, *message;
    };
    const Folder folder;
    report::write_whole(folder.path + "/close.txt", "0\n0.25\n0.5\n0.500000001\n0.75\n1\n");
    for (
        const auto& [command, rows, message] : std::vector<Case>{
            {"static_test --formulation original,second_order_fpm --kernel cubic_spline --particles 20",
             "\nsecond_order_fpm,20,0.05263157895,0,1,,\"particle 0 (x = 0) has 2 neighbours within 2h, needs 4",
             ": 1 of 2 cases failed, as the table's last column says; formulation second_order_fpm: particle 0 "},
            {"derivative_test --formulation fpm,modified_fpm --kernel cubic_spline --particles 20 --perturb 0.2 --seeds 3 --median",
             "\nmodified_fpm,20,0.05263157895,0.2,1,,,,,,,,,,,,,,\"3 of 3 seeds fail, first seed 1: ",
             "; formulation modified_fpm: 3 of 3 seeds fail"},
            {"vibration_test --formulation second_order_fpm,fem_lumped --kernel cubic_spline --particles 20,30",
             "\nsecond_order_fpm,20,0,1,,,,,,,\"particle 0 (x = 0) has 2 neighbours",
             ": 2 of 4 cases failed, as the table's last column says; formulation second_order_fpm, particles 20: "},
            {"plate --method strong --particles 21x9,16x4",
             "\nstrong,189,3,,,2,0.33,stress,,21,9,s11 s22,s11 s22,u1 u2,u1 u2,,,,\"ssph_basis: at (0, 0) ",
             ": 1 of 2 cases failed, as the table's last column says; particles 189: ssph_basis: at (0, 0) "},
            {"plate --method strong --scaling 2,3 --states 2x2", "\nstrong,64,2,,,2,0.33,stress,,16,4,",
             "; scaling 2: ssph_basis: at (0, 0) "},
            {"hole --method strong --layout polar-3x3,graded-188-11",
             "\nstrong,9,4,,,2,0.33,strain,,polar-3x3,0.3,,,,,,,,,,,,,\"ssph",
             "; particles 9: ssph_basis: "}}) {
        const std::string tried = command;
        CAPTURE(tried);
        const auto outcome = run(command);
        const std::string &output = outcome.output, &errors = outcome.errors;
        CAPTURE(output);
        CAPTURE(errors);
        CHECK(outcome.code == 1);
        CHECK(output.find(rows) != std::string::npos);
        CHECK(errors.find(message) != std::string::npos);
        CHECK(std::count(errors.begin(), errors.end(), '\n') == 1);
        const auto table = report::parsed(output);
        CHECK(std::any_of(table.rows.begin(), table.rows.end(),
                          [](const auto& row) { return row.back() == report::Cell(); }));
    }
}

TEST_CASE("sweep: a figure shows what could be computed") {
    const Folder folder;
    const std::string figure = folder.path + "/a.svg";
    for (const std::string command :
         {"vibration_test --formulation fpm,second_order_fpm --kernel cubic_spline --particles 20",
          "derivative_test --formulation fpm,second_order_fpm --kernel cubic_spline --particles 20,40"}) {
        const auto [code, output, errors] = run(command + " --plot " + figure);
        CHECK(code == 1);
        CHECK(errors.find(" cases failed, as the table's last column says; ") != std::string::npos);
        const std::string svg = report::read_whole(figure);
        CHECK(svg.find("FPM") != std::string::npos);
        CHECK(svg.find("second-order FPM") == std::string::npos);
    }
}

TEST_CASE("sweep: --field holds what could be solved") {
    const Folder folder;
    const std::string file = folder.path + "/f.csv";
    CHECK(run("plate --method strong --scaling 2,3 --field " + file).code == 1);
    CHECK(report::parsed(report::read_whole(file)).rows.size() == 64);
}
