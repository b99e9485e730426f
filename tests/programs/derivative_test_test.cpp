#include <cmath>
#include <fstream>

#include "base/text.hpp"
#include "command_line/formulations.hpp"
#include "report/table.hpp"
#include "tests/programs/run.hpp"
#include "tests/support/relative.hpp"

using programs::check_refused;
using programs::run;

namespace {

std::string without_comments(std::string csv) {
    while (csv.starts_with("#")) csv.erase(0, csv.find('\n') + 1);
    return csv;
}

}  // namespace

TEST_CASE(
    "derivative_test: columns by their names, a row per formulation, particles, perturbation and seed") {
    const auto [code, output, errors] = run("derivative_test --particles 10,20 --perturb 0,0.25 --seeds 2");
    CHECK(code == 0);
    CHECK(errors.empty());
    CHECK(without_comments(output).starts_with(
        "formulation,particles,spacing,perturbation,seed,error_first,error_second,error_first_interior,error_second_interior,order_first,order_second,order_first_interior,order_second_interior\n"));
    const auto table = report::parsed(output);
    CHECK(table.rows.size() == command_line::formulations().size() * 2 * (1 + 2));
}

TEST_CASE("derivative_test: the published statement, from the program") {
    const auto table =
        report::parsed(run("derivative_test --formulation second_order_fpm --particles 320,1280").output);
    const auto error = [&](std::size_t row) {
        return std::get<double>(table.rows[row][table.column("error_second")]);
    };
    CHECK(error(1) == support::relative(1.526e-6, 1e-3));
    CHECK(std::log(error(0) / error(1)) / std::log(1279.0 / 319) == support::relative(2, 0.005));
}

TEST_CASE("derivative_test: the same bytes on any number of threads") {
    const std::string command = "derivative_test --particles 50,800 --perturb 0.25 --seeds 5";
    const auto alone = run(command + " --threads 1");
    CHECK(alone.code == 0);
    CHECK(run(command + " --threads 2").output == alone.output);
    CHECK(run(command + " --threads 5").output == alone.output);
}

TEST_CASE("derivative_test: --output writes what the standard output shows") {
    const programs::Folder folder;
    const std::string file = folder.path + "/out.csv";
    const auto [code, output, errors] = run("derivative_test --particles 10 --output " + file);
    CHECK(code == 0);
    CHECK(output.empty());
    CHECK(report::read_whole(file) == run("derivative_test --particles 10").output);
}

TEST_CASE(
    "derivative_test: on the standard output, rows of several N show the observed orders between them") {
    const std::string command = "derivative_test --formulation second_order_fpm --particles 160,320,640";
    const auto table = report::parsed(run(command).output);
    CHECK(table.word(0, "order_second").empty());
    for (const std::size_t row : {1U, 2U})
        for (const char* order :
             {"order_first", "order_second", "order_first_interior", "order_second_interior"})
            CHECK(std::abs(std::get<double>(table.rows[row][table.column(order)]) - 2) < 0.05);
    const programs::Folder folder;
    CHECK(run(command + " --output " + folder.path + "/t.csv").code == 0);
    CHECK(report::read_whole(folder.path + "/t.csv").find(",order_") == std::string::npos);
}

TEST_CASE("derivative_test: a smoothing length that is too small is named as the option has it") {
    const programs::Folder folder;
    std::string lengths;
    for (int k = 0; k < 21; ++k) lengths += k % 2 == 0 ? "0.05\n" : "0.04\n";
    report::write_whole(folder.path + "/h.txt", lengths);
    const std::string command =
        "derivative_test --formulation second_order_fpm --kernel cubic_spline --particles 21 --smoothing-from " +
        folder.path + "/h.txt";
    const std::string errors = run(command + " --smoothing 1.2").errors;
    CAPTURE(errors);
    const std::size_t at = errors.find("; try --smoothing ");
    REQUIRE(at != std::string::npos);
    CHECK(run(command + errors.substr(at + 5, errors.find('\n', at) - at - 5)).code == 0);
}

TEST_CASE("derivative_test: --function exp(x) gives the numbers of the default") {
    for (const std::string options : {"", " --perturb 0.25 --seeds 2 --volumes partition"}) {
        const auto own = run("derivative_test --function 'exp(x)'" + options);
        CHECK(own.code == 0);
        CHECK(without_comments(own.output) == without_comments(run("derivative_test" + options).output));
    }
}

TEST_CASE("derivative_test: --function is differentiated, and named in the table") {
    const auto [code, output, errors] =
        run("derivative_test --function '3*x^2-x+2' --formulation second_order_fpm,ssph --particles 37");
    CHECK(code == 0);
    CHECK(output.find("for B = 3*x^2-x+2\n") != std::string::npos);
    const auto table = report::parsed(output);
    REQUIRE(table.rows.size() == 2);
    for (std::size_t row = 0; row < 2; ++row)  // exact on parabolas
        for (const char* column : {"error_first", "error_second"})
            CHECK(std::get<double>(table.rows[row][table.column(column)]) < 1e-9);
}

TEST_CASE(
    "derivative_test: in quad precision the order of second_order_fpm is two where double has drowned") {
    const auto table = report::parsed(
        run("derivative_test --formulation second_order_fpm --precision quad --particles 2000,20000").output);
    const auto error = [&](std::size_t row) {
        return std::get<double>(table.rows[row][table.column("error_second")]);
    };
    CHECK(std::log(error(0) / error(1)) / std::log(19999.0 / 1999) == support::relative(2, 0.0025));
}

TEST_CASE("derivative_test: the reader's function in each precision; another precision is refused") {
    const std::string command = "derivative_test --function 'sin(5*x)+x^2/3' --particles 37";
    const auto in_double = report::parsed(run(command).output);
    for (const char* precision : {"long", "quad"}) {
        const auto table = report::parsed(run(command + " --precision " + precision).output);
        for (std::size_t row = 0; row < table.rows.size(); ++row)
            CHECK(std::get<double>(table.rows[row][table.column("error_second")]) ==
                  support::relative(std::get<double>(in_double.rows[row][in_double.column("error_second")]),
                                    1e-6));
    }
    programs::check_refused("derivative_test --precision half", 2,
                            "there is no precision 'half'; choose one of double, long, quad");
}

TEST_CASE("derivative_test: --quality adds R of the worst row, and a comment says where it is") {
    const auto plain = run("derivative_test --formulation second_order_fpm --particles 20,40"),
               with_R = run("derivative_test --formulation second_order_fpm --particles 20,40 --quality");
    CHECK(plain.output.find("quality") == std::string::npos);
    CHECK(with_R.output.find("the largest is 6.23, second_order_fpm, D2B at particle ") != std::string::npos);
    const auto table = report::parsed(with_R.output);
    REQUIRE(table.rows.size() == 2);
    for (const auto& row : table.rows)
        CHECK(std::get<double>(row[table.column("quality")]) == support::relative(6.2272, 1e-4));
}

TEST_CASE("derivative_test, static_test, vibration_test: a row next to a zero of (43) is refused") {
    const support::Folder folder;
    const std::string file = folder.path + "/gap.txt";
    std::ofstream out(file);
    for (int j = 0; j <= 100; ++j)
        out << (j == 0 ? "0" : base::shown((0.0980558 + j - 1) / 99.0980558, 17)) << "\n";
    out.close();
    for (const char* program : {"derivative_test", "static_test", "vibration_test"})
        check_refused(
            std::string(program) +
                " --formulation second_order_fpm --smoothing 2 --smoothing-from largest --positions " + file,
            1, "leave one of them out, or try --smoothing 2.2");
}

TEST_CASE(
    "derivative_test: --states shows each particle, and its largest error is that of the table without") {
    for (const char* options :
         {"--formulation all --particles 12,30 --perturb 0.25 --seeds 2", "--particles 9 --precision long"}) {
        const std::string asked = options;
        const auto states = report::parsed(run("derivative_test --states " + asked).output),
                   errors = report::parsed(run("derivative_test " + asked).output);
        std::size_t at = 0;
        for (std::size_t row = 0; row < errors.rows.size(); ++row) {
            const auto N = std::stol(errors.word(row, "particles"));
            for (const std::string error : {"error_first", "error_second"}) {
                double largest = 0;
                for (std::size_t i = 0; i < static_cast<std::size_t>(N); ++i) {
                    CHECK(states.word(at + i, "formulation") == errors.word(row, "formulation"));
                    CHECK(states.word(at + i, "particle") == std::to_string(i));
                    largest = std::max(largest,
                                       std::abs(std::get<double>(states.rows[at + i][states.column(error)])));
                }
                CHECK(largest ==
                      support::relative(std::get<double>(errors.rows[row][errors.column(error)]), 1e-6));
            }
            at += static_cast<std::size_t>(N);
        }
        CHECK(at == states.rows.size());
    }
}

TEST_CASE("derivative_test: the largest error of the second derivative lies on the boundary") {
    const auto states = report::parsed(
        run("derivative_test --particles 100 --states --formulation chen_beraun,modified_fpm,second_order_fpm")
            .output);
    for (std::size_t first = 0; first < states.rows.size(); first += 100) {
        std::size_t worst = first;
        const auto error = [&](std::size_t row) {
            return std::abs(std::get<double>(states.rows[row][states.column("error_second")]));
        };
        for (std::size_t row = first; row < first + 100; ++row)
            if (error(row) > error(worst)) worst = row;
        CHECK(states.word(worst, "particle") == "99");
    }
}

TEST_CASE(
    "derivative_test: --plot of positions from a file, and of --states, draws the error at each particle") {
    const programs::Folder folder;
    std::ofstream(folder.path + "/positions.txt") << "0\n0.05\n0.2\n0.3\n0.45\n0.6\n0.8\n1\n";
    for (const std::string& asked : {"--smoothing-from local --positions " + folder.path + "/positions.txt",
                                     std::string("--particles 20 --states")}) {
        const std::string figure = folder.path + "/figure.svg";
        const auto outcome = run("derivative_test --formulation modified_fpm " + asked + " --plot " + figure);
        CHECK(outcome.errors.empty());
        std::ifstream svg(figure);
        const std::string text{std::istreambuf_iterator<char>(svg), {}};
        CHECK(text.find("error of D²B at each particle") != std::string::npos);
    }
    for (const auto& [asked, why] :
         {std::pair{"--states --median --seeds 2 --perturb 0.2",
                    "--median stands beside largest errors; leave --states out"},
          {"--states --quality", "--quality stands beside largest errors; leave --states out"},
          {"--states --plot /tmp/figure.svg", "--states --plot draws errors along one line of particles"}}) {
        const auto refused = run(std::string("derivative_test ") + asked);
        CHECK(refused.code == 2);
        CHECK(refused.output.empty());
        CHECK(refused.errors.find(why) != std::string::npos);
    }
}
