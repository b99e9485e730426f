#include <cmath>
#include <fstream>

#include "command_line/formulations.hpp"
#include "report/table.hpp"
#include "tests/programs/run.hpp"
#include "tests/support/relative.hpp"

using programs::run;

TEST_CASE("vibration_test: columns by their names, 98 modes for each formulation and both references") {
    const auto [code, output, errors] = run("vibration_test");
    CHECK(code == 0);
    CHECK(errors.empty());
    const auto table = report::parsed(output);
    for (const char* name :
         {"formulation", "particles", "mode", "frequency", "frequency_imaginary", "exact", "ratio"})
        CHECK_NOTHROW(static_cast<void>(table.column(name)));
    CHECK(table.rows.size() == (command_line::formulations().size() + 2) * 98);
    const auto ratio = [&](const std::string& formulation, double mode) {
        for (const auto& row : table.rows)
            if (std::get<std::string>(row[0]) == formulation &&
                std::get<double>(row[table.column("mode")]) == mode)
                return std::get<double>(row[table.column("ratio")]);
        return 0.0;
    };
    CHECK(ratio("original", 1) == support::relative(0.6636, 1e-3));
    CHECK(ratio("second_order_fpm", 98) == support::relative(0.5866, 1e-3));
    CHECK(ratio("fem_lumped", 98) == support::relative(0.6430, 1e-3));
}

TEST_CASE("vibration_test: what changes nothing for finite elements is refused") {
    for (const std::string option :
         {"--kernel cubic_spline", "--smoothing 2", "--smoothing-from largest", "--volumes partition"})
        programs::check_refused(
            "vibration_test --formulation fem_lumped,fem_consistent --particles 20 " + option, 2,
            option.substr(0, option.find(' ')) + " changes nothing for finite elements");
}

TEST_CASE("vibration_test: what it cannot compute is refused") {
    programs::check_refused("vibration_test --median", 2, "--median");
    programs::check_refused("vibration_test --particles 2", 2, "take at least 3");
}

TEST_CASE(
    "vibration_test: --lowest gives the first of all modes where all are real or in pairs, signs and order included") {
    const std::string command =
        "vibration_test --formulation rkpm_second_order --particles 60 --perturb 0.25 --seed 7";
    const auto all = report::parsed(run(command).output),
               lowest = report::parsed(run(command + " --lowest 8").output);
    REQUIRE(lowest.rows.size() == 8);
    for (std::size_t row = 0; row < 8; ++row)
        for (const char* name : {"mode", "frequency", "frequency_imaginary", "ratio"}) {
            const auto of = [&](const report::Table& table) {
                return std::get<double>(table.rows[row][table.column(name)]);
            };
            CHECK(std::abs(of(lowest) - of(all)) <= 1e-7 * std::abs(of(all)));
        }
    CHECK(std::get<double>(all.rows[7][all.column("frequency_imaginary")]) > 0.5);  // a pair is among them
}

TEST_CASE(
    "vibration_test: --lowest takes finite elements with lumped masses, and says that it takes no others") {
    const std::string command = "vibration_test --formulation fem_lumped --particles 60";
    const auto all = report::parsed(run(command).output),
               lowest = report::parsed(run(command + " --lowest 8").output);
    REQUIRE(lowest.rows.size() == 8);
    for (std::size_t row = 0; row < 8; ++row)
        CHECK(lowest.word(row, "frequency").substr(0, 8) == all.word(row, "frequency").substr(0, 8));
    CHECK(report::parsed(run("vibration_test --particles 60 --lowest 1").output).rows.size() == 9);
    programs::check_refused("vibration_test --formulation fem_consistent --lowest 3", 2,
                            "--lowest does not know fem_consistent; leave it out");
}

TEST_CASE(
    "vibration_test: a frequency without a real part belongs to no mode, and a comment counts those that are not real") {
    const programs::Folder folder;
    std::ofstream(folder.path + "/own.txt") << "0\n0.01\n0.05\n0.1\n0.2\n0.3\n0.45\n0.6\n0.8\n0.9\n1\n";
    const std::string output =
        run("vibration_test --formulation second_order_fpm --smoothing-from largest --positions " +
            folder.path + "/own.txt")
            .output;
    CHECK(
        output.find(
            "# frequencies that are not real: second_order_fpm, 11 particles 1 of 9; those without a real part belong to no mode\n") !=
        std::string::npos);
    const auto table = report::parsed(output);
    CHECK(table.word(0, "frequency") == "0");
    for (const char* column : {"mode", "exact", "ratio", "ratio_symbol"})
        CHECK(table.word(0, column).empty());
    CHECK(table.word(1, "mode") == "1");
    CHECK(std::get<double>(table.rows[1][table.column("ratio")]) ==
          support::relative(3.06637484 / std::acos(-1.0), 1e-6));
    const std::string paper =
        run("vibration_test --formulation second_order_fpm,modified_fpm --particles 30").output;
    CHECK(paper.find("not real") == std::string::npos);
}
