#include <algorithm>
#include <cmath>

#include "report/table.hpp"
#include "tests/programs/run.hpp"
#include "tests/support/claims.hpp"
#include "tests/support/relative.hpp"

using programs::run;
using support::expected;

TEST_CASE("plate: columns by their names, and the printed numbers of the three methods") {
    const auto [code, output, errors] = run("plate");
    CHECK(code == 0);
    CHECK(errors.empty());
    const auto table = report::parsed(output);
    REQUIRE(table.rows.size() == 3);
    for (const char* name : {"method", "particles", "nx", "ny", "scaling", "gauss", "degree", "log_error_dn",
                             "log_error_nd", "max_error_u2_percent"})
        CHECK_NOTHROW((void)table.column(name));
    const auto number = [&](std::size_t row, const char* name) {
        return std::get<double>(table.rows[row][table.column(name)]);
    };
    CHECK(std::abs(number(0, "log_error_dn") - expected("B-4.1-E-strong")) < 1e-4);
    CHECK(std::abs(number(1, "log_error_nd") - expected("B-4.1-E-weak1")) < 0.01);
    CHECK(std::abs(number(2, "log_error_dn") + 1.63) < 0.03);
    CHECK(std::abs(number(0, "max_error_u2_percent") - expected("B-4.1-u2-strong")) < 0.01);
}

TEST_CASE(
    "plate: fpm is collocation, takes the conditions at corners, and has no degree and no scaling factor") {
    const auto [code, output, errors] =
        run("plate --method strong,fpm --particles 31x7 --corner-1 all --quality");
    CHECK(code == 0);
    CHECK(errors.empty());
    const auto table = report::parsed(output);
    REQUIRE(table.rows.size() == 6);
    CHECK(table.word(5, "method") == "fpm");
    CHECK(table.word(5, "corner_1") == "s11 s22");
    for (const char* column : {"degree", "scaling", "gauss", "penalty", "noise"})
        CHECK(table.word(5, column).empty());
    CHECK(std::get<double>(table.rows[3][table.column("log_error_nd")]) < -1.5);
    CHECK(output.find("# fpm: (3.12) to (3.14) with (F24), h/nearest spacing 1.2") != std::string::npos);
}

TEST_CASE("plate: the same bytes on any number of threads") {
    const std::string command = "plate --particles 16x4,21x5 --gauss 4";
    const auto alone = run(command + " --threads 1");
    CHECK(alone.code == 0);
    CHECK(run(command + " --threads 2").output == alone.output);
    CHECK(run("OPENBLAS_NUM_THREADS=2 " + command + " --threads 3").output == alone.output);
}

TEST_CASE("plate: corners, a choice of each and all that the print compares") {
    const auto table = report::parsed(run("plate --method strong --corner-1 all --corner-3 u1,s12").output);
    CHECK(table.rows.size() == 3);
    CHECK(table.word(0, "corner_1") == "s11 s12");
    CHECK(table.word(2, "corner_3") == "u1 s12");
    CHECK(report::parsed(run("plate --method strong,weak1 --corner-1 all --gauss 4").output).rows.size() ==
          4);
}

TEST_CASE("plate: states along an edge and on a grid, with the exact ones beside them") {
    const auto bottom = report::parsed(run("plate --method strong --states bottom --points 5").output);
    CHECK(bottom.rows.size() == 5);
    CHECK(bottom.word(4, "x1") == "1");
    CHECK(std::get<double>(bottom.rows[4][bottom.column("u2_exact")]) == support::relative(2.26e-3, 0.02));
    CHECK(report::parsed(run("plate --method strong --states 7x3").output).rows.size() == 21);
}

TEST_CASE("plate: collocation takes no Gauss points, and has one row beside those of the weak forms") {
    const auto table = report::parsed(run("plate --method strong,weak1 --gauss 4,5 --penalty 1,2").output);
    CHECK(table.rows.size() == 1 + 4);
}

TEST_CASE("plate: rows of several grids show the observed orders between them, and files do not") {
    const std::string command = "plate --method strong --particles 16x4,31x7";
    const auto table = report::parsed(run(command).output);
    CHECK(table.word(0, "order_dn").empty());
    const double fall = std::get<double>(table.rows[0][table.column("log_error_dn")]) -
                        std::get<double>(table.rows[1][table.column("log_error_dn")]);
    CHECK(std::abs(std::get<double>(table.rows[1][table.column("order_dn")]) - fall / std::log10(2)) < 6e-4);
    const programs::Folder folder;
    CHECK(run(command + " --output " + folder.path + "/t.csv").code == 0);
    CHECK(report::read_whole(folder.path + "/t.csv").find("order") == std::string::npos);
    CHECK(run("plate --method strong").output.find("order") == std::string::npos);
}

TEST_CASE("plate: bad invocations end with one line, exit code 2 and no output") {
    for (const auto& [options, reason] : std::vector<std::pair<std::string, std::string>>{
             {"--method weak3", "there is no method 'weak3'"},
             {"--particles 16", "'16' is no pair of whole numbers such as 16x4"},
             {"--particles 1x4", "a grid needs at least 2x2 particles"},
             {"--scaling abc", "--scaling: 'abc' is no number"},
             {"--scaling 1:0:3", "'1:0:3' is no range"},
             {"--scaling nan", "--scaling: 'nan' is no number"},
             {"--scaling -1", "the scaling factor must be positive"},
             {"--degree 4", "--degree must be 1, 2 or 3, got 4"},
             {"--degree 1.5", "'1.5' is no whole number"},
             {"--method strong --degree 1", "take --degree 2 or 3"},
             {"--gauss 0", "--gauss must lie between 1 and 1000"},
             {"--poisson 0.6", "Poisson's ratio must lie above -1 and be at most 0.5, got 0.6"},
             {"--poisson 0.4999999999999999 --plane strain", "take at most 0.499999999999, or plane stress"},
             {"--plane flat", "choose one of stress, strain"},
             {"--penalty 0", "--penalty must be positive"},
             {"--corner-1 u1", "'u1' is no pair of conditions"},
             {"--corner-4 u1,u1", "corner 4 needs two different conditions"},
             {"--corner-2 u1,t1", "there is no condition 't1'"},
             {"--method weak1 --corner-1 all",
              "--corner-1 belongs to collocation; add strong or fpm to --method, or leave --corner-1 out"},
             {"--method strong --gauss 4",
              "--gauss belongs to the weak forms; add weak1 or weak2 to --method"},
             {"--method strong --penalty 2", "--penalty belongs to the weak forms"},
             {"--method strong --test-scaling 2", "--test-scaling belongs to the weak forms"},
             {"--states particles --points 7", "--points belongs to a line of --states; name one"},
             {"--states nowhere", "--states: 'nowhere' is no pair"},
             {"--particles 16x4,31x7 --field /dev/null", "--field holds one set of particles"},
             {"--nonsense", "--nonsense"}})
        programs::check_refused("plate " + options, 2, reason);
}

TEST_CASE(
    "plate: cells of 3:1 and 5:1 have too few neighbours within the nearest distances; the remedy solves them") {
    for (const std::string grid : {"21x13", "31x31"}) {
        const std::string command = "plate --method weak1 --particles " + grid;
        const std::string why = programs::check_refused(command, 1, "; try --smoothing-from 0.");
        const std::string remedy = why.substr(why.find("--smoothing-from"));
        const auto table = report::parsed(programs::run(command + " " + remedy).output);
        CHECK(std::count(table.comments.begin(), table.comments.end(),
                         "smoothing lengths from " + remedy.substr(17)) == 1);
        for (const auto& row : table.rows)
            CHECK(std::get<double>(row[table.column("max_error_u2_percent")]) < 1);
    }
    const auto by_number = programs::run("plate --particles 16x4 --smoothing-from 0.0666666666666666666");
    CHECK(by_number.code == 0);
    const programs::Folder folder;
    const std::string file = folder.path + "/h.txt";
    report::write_whole(file, "0.1\n0.1\n");
    programs::check_refused("plate --particles 16x4 --smoothing-from " + file, 2,
                            "h.txt has 2 numbers, for 64 particles");
}

TEST_CASE("plate: a support that is too small is a failed computation with a remedy") {
    programs::check_refused("plate --scaling 2", 1, "for the 6 monomials of degree 2; try --scaling 2.5");
    programs::check_refused("plate --output /nowhere/x.csv", 1, "cannot write /nowhere/x.csv");
}
