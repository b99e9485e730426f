#include "report/table.hpp"
#include "tests/programs/run.hpp"
#include "tests/support/relative.hpp"

using programs::run;

TEST_CASE("hole: columns by their names, and the sizes that the print gives") {
    const auto [code, output, errors] = run("hole");
    CHECK(code == 0);
    CHECK(errors.empty());
    const auto table = report::parsed(output);
    REQUIRE(table.rows.size() == 3);
    for (const char* name : {"method", "particles", "layout", "log_error_dn", "log_error_nd",
                             "deviation_u1_mm", "deviation_u2_mm", "stress_concentration"})
        CHECK_NOTHROW((void)table.column(name));
    CHECK(table.word(1, "particles") == "188");
    CHECK(std::abs(std::get<double>(table.rows[1][table.column("stress_concentration")]) - 3) < 0.2);
    CHECK(std::get<double>(table.rows[1][table.column("log_error_nd")]) < -2);
}

TEST_CASE("hole: the same bytes on any number of threads") {
    const std::string command = "hole --method strong,weak1 --gauss 4";
    const auto alone = run(command + " --threads 1");
    CHECK(alone.code == 0);
    CHECK(run(command + " --threads 3").output == alone.output);
}

TEST_CASE("hole: layouts by name, drawn again, and from a file") {
    const auto table = report::parsed(
        run("hole --method strong --layout graded-188-11,polar-11x17 --radius 0.4 --draws 2").output);
    CHECK(table.rows.size() == 3);  // a polar layout is drawn once
    CHECK(table.word(0, "draw") == "1");
    CHECK(table.word(1, "draw") == "2");
    CHECK(table.word(2, "draw").empty());
    CHECK(table.word(2, "particles") == "187");

    const programs::Folder folder;
    const std::string file = folder.path + "/positions.csv";
    const auto states =
        report::parsed(run("hole --method strong --layout polar-11x17 --states particles").output);
    std::string lines = "\xEF\xBB\xBF# x1, x2\n";
    for (std::size_t row = 0; row < states.rows.size(); ++row)
        lines += states.word(row, "x1") + ", " + states.word(row, "x2") + "\n";
    report::write_whole(file, lines);
    const auto again = report::parsed(run("hole --method weak1 --gauss 4 --layout " + file).output);
    const auto direct = report::parsed(run("hole --method weak1 --gauss 4 --layout polar-11x17").output);
    CHECK(std::get<double>(again.rows[0][again.column("log_error_nd")]) ==
          support::relative(std::get<double>(direct.rows[0][direct.column("log_error_nd")]), 1e-4));
}

TEST_CASE("hole: bad invocations end with one line, exit code 2 and no output") {
    const programs::Folder folder;
    const auto file = [&](const std::string& name, const std::string& text) {
        report::write_whole(folder.path + "/" + name, text);
        return folder.path + "/" + name;
    };
    for (const auto& [options, reason] : std::vector<std::pair<std::string, std::string>>{
             {"--layout nonsense", "there is no layout 'nonsense'"},
             {"--layout polar-11x17 --draws 2", "--draws changes nothing without a graded layout; add one"},
             {"--layout polar-11x17 --draw 2", "--draw changes nothing without a graded layout"},
             {"--layout polar-11x17 --snap 0.5", "--snap 0.5: then particles "},
             {"--layout graded-20-11", "take more than 52 particles"},
             {"--layout polar-2x9", "a polar layout needs"},
             {"--states 46x10", "--states 46x10: a grid around the hole has rings x rays"},
             {"--radius 4", "the hole's radius must lie between 0 and the side 3"},
             {"--poisson 0.5", "Poisson's ratio"},
             {"--draws 0", "--draws"},
             {"--layout " + file("words.csv", "0 1\nhello world\n"), "line 2: 'hello' is no number"},
             {"--layout " + file("hexadecimal.csv", "0 0x1p0\n"), "line 1: '0x1p0' is no number"},
             {"--layout " + file("infinite.csv", "0 1\nnan inf\n"), "line 2: 'nan' is no number"},
             {"--layout " + file("three.csv", "0 1\n1 2 3\n"),
              "line 2: '1 2 3' has 3 columns, the first line 2"},
             {"--layout " + file("outside.csv", "0 1\n1 2\n1 9\n"),
              "particle 2 at (1, 9) lies outside the body"},
             {"--layout " + file("twice.csv", "0 1\n1 2\n1 2\n"), "coincide at (1, 2)"},
             {"--layout " + file("empty.csv", "# nothing\n"),
              "empty.csv has no particle; at least two are needed"}})
        programs::check_refused("hole " + options, 2, reason);
    programs::check_refused("hole --layout /nowhere.csv", 2, "cannot read /nowhere.csv");
}

TEST_CASE("hole: a layout in another unit of length is refused by its name") {
    const programs::Folder folder;
    const std::string file = folder.path + "/x.csv";
    for (const auto& [unit, most] :
         {std::pair{"mm", "3000"}, {"cm", "300"}, {"inches", "118.11"}, {"km", "0.003"}}) {
        report::write_whole(file, "0 " + std::string(most) + "\n" + most + " 0\n");
        programs::check_refused("hole --layout " + file, 2,
                                "x.csv reaches to " + std::string(most) + ", as the quarter does in " + unit +
                                    "; write its positions in m");
    }
}

TEST_CASE("hole: a snap that makes particles coincide is named, with a smaller one that does not") {
    const std::string command = "hole --method strong --layout polar-11x17 --snap ",
                      errors = run(command + "0.5").errors;
    CAPTURE(errors);
    const std::size_t at = errors.find("; take a smaller distance, such as ");
    REQUIRE(at != std::string::npos);
    const std::string smaller = errors.substr(at + 35, errors.find('\n', at) - at - 35);
    CHECK(run(command + smaller).errors.find("coincide") == std::string::npos);
}

TEST_CASE("hole: --snap moves the particles of layouts that the program makes, too") {
    const programs::Folder folder;
    // Next to a hole that is nearly as large as the quarter, particles lie beside the outer sides.
    const std::string command = "hole --method strong --radius 2.9 --layout graded-20-3";
    programs::check_refused(command, 2, "; try --snap 0.095");
    programs::check_refused(command + " --snap 0.095", 1, "; try --smoothing-from ");
    CHECK(
        programs::run("hole --method strong --layout graded-80-7 --snap 1e-6").output.find("graded-80-7: ") !=
        std::string::npos);
}

TEST_CASE(
    "hole: each remedy for a scaling factor that is too small solves the case, between the particles too") {
    int followed = 0;
    for (const char* method : {"strong", "weak1", "weak2"})
        for (const char* layout : {"polar-11x17", "graded-120-9"}) {
            const std::string command = std::string("hole --method ") + method +
                                        (method[0] == 'w' ? " --gauss 5" : "") + " --layout " + layout;
            const std::string why = run(command + " --scaling 1.5").errors;
            CAPTURE(command);
            CAPTURE(why);
            for (const std::string& option : {std::string("--scaling "), std::string("--smoothing-from ")}) {
                const std::size_t at = why.find(option, why.find("; "));
                if (at == std::string::npos) continue;
                const std::size_t from = at + option.size();
                const std::string value = why.substr(from, why.find_first_of(" \n", from) - from);
                const std::string remedy =
                    option == "--scaling " ? " " + option + value : " --scaling 1.5 " + option + value;
                ++followed;
                CHECK(run(command + remedy).code == 0);
            }
        }
    CHECK(followed >= 6);
}
