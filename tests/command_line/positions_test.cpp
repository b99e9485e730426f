#include "command_line/positions.hpp"

#include <vector>

#include "base/errors.hpp"
#include "base/text.hpp"
#include "report/table.hpp"
#include "tests/programs/run.hpp"
#include "tests/support/relative.hpp"

using namespace command_line;
using namespace programs;

namespace {

/// What is read from a file with this text.
particles::Column<double> read(const std::string& text) {
    const Folder folder;
    const std::string file = folder.path + "/x.csv";
    report::write_whole(file, text);
    return read_positions(file);
}

std::string uniform(long N) {
    std::string text;
    for (const double x : particles::uniform_positions<double>(N)) text += base::shown(x, 17) + "\n";
    return text;
}

/// Irregular, with a largest spacing of 0.1 where the mean is 1/14.
const char* const irregular =
    "0\n0.05\n0.11\n0.2\n0.26\n0.35\n0.41\n0.5\n0.6\n0.66\n0.75\n0.8\n0.9\n0.95\n1\n";

}  // namespace

TEST_CASE("positions: a number on a line or the first column of a CSV, with comments, blanks and a header") {
    for (const char* text :
         {"0\n0.25\n1\n", "0\n0.25\n1", "0\r\n0.25\r\n1\r\n", "x\n0\n0.25\n1\n",
          "# spacing\n\n  x , name\n0,first\n\t0.25 # here\n1e0,,last\n\n", "\"x\",\"u\"\n0,1\n0.25,2\n1,3\n",
          "\357\273\2770\n0.25\n1\n", "+0.0\n+0.25\n+1.0D0\n", "0,\n0.25 ,\n1,\n", "u x\n7 0\n7 0.25\n7 1\n",
          "0 7\n0.25 8\n1 9\n", ",x\n0,0\n1,0.25\n2,1\n", "\"x\"\n\"1\" 0\n\"2\" 0.25\n\"3\" 1\n",
          "0\r0.25\r1\r", "-1e-12\n0.25\n1.000000001\n"}) {
        CAPTURE(text);
        const auto x = read(text);
        REQUIRE(x.size() == 3);
        CHECK(x[0] == 0);
        CHECK(x[1] == 0.25);
        CHECK(x[2] == 1);
    }
}

TEST_CASE("positions: a column by its name or its number from 1") {
    const Folder folder;
    const std::string file = folder.path + "/x.csv";
    const particles::Column<double> expected{{0, 0.25, 1}};
    for (const char* text : {"n,s\n1,0\n2,0.25\n3,1\n", "n s\n1 0\n2 0.25\n3 1\n"}) {
        report::write_whole(file, text);
        for (const char* column : {"s", "2"}) CHECK((read_positions(file, {column}) == expected).all());
    }
    for (const auto& [column, reason] : std::vector<std::pair<const char*, const char*>>{
             {"t", "x.csv has no column 't'; its header is 'n s'"},
             {"0", "x.csv has no column '0'"},
             {"3", "line 2: '1 0' has no column 3"}})
        CHECK_THROWS_WITH_AS(static_cast<void>(read_positions(file, {column})), doctest::Contains(reason),
                             base::InvalidInput);
    CHECK_THROWS_WITH_AS(static_cast<void>(read_positions(file, {"n", "s"})),
                         doctest::Contains("one column of positions, not 2"), base::InvalidInput);
}

TEST_CASE("positions: anything else is refused with its line and its value") {
    struct Case {
        const char *text, *reason;
    };
    const std::vector<Case> all{
        {"", "x.csv holds no position"},
        {"# nothing\nx\n", "x.csv holds no position"},
        {"0\n0.5\n0.5\n1\n", "line 3: '0.5' coincides with the position before it; leave one of the two out"},
        {"0\n0.6\n# here\n0.5\n1\n", "line 4: '0.5' does not lie beyond the position before it, 0.6"},
        {"0.1\n0.5\n1\n", "line 1: '0.1' is the first position; it must be 0"},
        {"-1\n0\n1\n", "line 1: '-1' is the first position; it must be 0"},
        {"0\n0.5\n", "line 2: '0.5' is the last position; it must be 1"},
        {"0\n0.5\n1\n1.5\n", "line 4: '1.5' lies beyond 1; scale the positions to [0, 1]"},
        {"0\nabc\n1\n", "line 2: 'abc' is no number"},
        {"x\ny\n0\n1\n", "line 2: 'y' is no number"},
        {"0\n0.5m\n1\n", "line 2: '0.5m' is no number"},
        {"0\n0.5 0.6\n1\n", "line 2: '0.5 0.6' has 2 columns, the first line 1"},
        {"0\n,0.5\n1\n", "line 2: '' is no number"},
        {"0\nnan\n1\n", "line 2: 'nan' is no number"},
        {"0\ninf\n", "line 2: 'inf' is no number"},
        {"0\n1e999\n", "line 2: '1e999' is larger than a double can be"},
        {"0\n\x7F\n1\n", "line 2: '?' is no number"},
        {"0,0\n0,25\n1,0\n",
         "line 2: '0' coincides with the position before it; leave one of the two out; if its comma is decimal, write 0.25"},
        {"0,0\n1,0.5\n2,1\n",
         "counts its lines in the first column; name the column of positions, --columns 2"},
        {"1 0\n2 0.5\n3 1\n",
         "counts its lines in the first column; name the column of positions, --columns 2"},
        {"0 0.25 1\n", "line 1: '0 0.25 1' has 3 numbers; write each position on a line of its own"},
        {"0\n0.9999999\n", "line 2: '0.9999999' is the last position; it must be 1"},
    };
    for (const auto& [text, reason] : all) {
        const std::string tried = text;  // clang++ 14 captures no bindings
        CAPTURE(tried);
        CHECK_THROWS_WITH_AS(static_cast<void>(read(text)), doctest::Contains(reason), base::InvalidInput);
    }
    CHECK_THROWS_WITH_AS(static_cast<void>(read_positions("/nowhere/x.csv")),
                         "--positions: cannot read /nowhere/x.csv: No such file or directory",
                         base::InvalidInput);
}

TEST_CASE("positions: in the plane two numbers on a line, between them a comma or blanks") {
    const Folder folder;
    const std::string file = folder.path + "/x.csv";
    const auto points = [&](const std::string& text) {
        report::write_whole(file, text);
        return read_points(file);
    };
    for (const char* text : {"0 0.25\n1 2\n", "0,0.25\r\n1,2", "x1,x2\n0 , 0.25\n1\t 2\n",
                             "# layout\n\n  x1 x2\n 0   0.25 # here\n1e0, 2.0\n",
                             "\"x1\", \"x2\"\n0,0.25\n1,2\n", "\357\273\2770 0.25\n1 2\n"}) {
        CAPTURE(text);
        const auto x = points(text);
        REQUIRE(x.cols() == 2);
        CHECK(x == (particles::Points<2>(2, 2) << 0, 1, 0.25, 2).finished());
    }
    CHECK_THROWS_WITH_AS(points("# nothing\nx1, x2\n"),
                         doctest::Contains("has no particle; at least two are needed"), base::InvalidInput);
    CHECK_THROWS_WITH_AS(points("0 1\n"), doctest::Contains("has one particle"), base::InvalidInput);
    CHECK(points("+0,+0.25,\n1D0, 2,\n") == points("0 0.25\n1 2\n"));
    CHECK(points("x,y,\n0,0.25,\n1,2,\n") == points("0 0.25\n1 2\n"));
    for (const char* text : {"id,u,v\n1,0,0.25\n2,1,2\n", "id,v,u\n1,0.25,0\n2,2,1\n"}) {
        report::write_whole(file, text);
        CHECK(read_points(file, {"u", "v"}) == (particles::Points<2>(2, 2) << 0, 1, 0.25, 2).finished());
    }
    CHECK(read_points(file, {"3", "2"}) == (particles::Points<2>(2, 2) << 0, 1, 0.25, 2).finished());
    CHECK_THROWS_WITH_AS(static_cast<void>(read_points(file, {"u"})),
                         "--columns: a layout has two columns, x,y, not 1", base::InvalidInput);
    CHECK_THROWS_WITH_AS(static_cast<void>(read_points(file, {"u", "w"})),
                         doctest::Contains("has no column 'w'; its header is 'id,v,u'"), base::InvalidInput);
    const auto named = (particles::Points<2>(2, 2) << 0, 1, 0.25, 2).finished();
    CHECK(points("x1,x2,h\n0,0.25,0.1\n1,2,0.1\n") == named);
    CHECK(points("name h \"y\" x # columns\na 0.1 0.25 0\nb 0.1 2 1\n") == named);
    CHECK(points("particles in the plane\n0 0.25\n1 2\n") == named);
    for (const auto& [text, reason] : std::vector<std::pair<const char*, const char*>>{
             {"0 1\n2\n", "x.csv, line 2: '2' has 1 column, the first line 2"},
             {"0 1\n1 2 3\n", "line 2: '1 2 3' has 3 columns, the first line 2"},
             {"0,1,2\n",
              "line 1: '0,1,2' has 3 columns; a layout needs x,y: choose them, such as --columns 1,2"},
             {"0,,1\n", "line 1: '0,,1' has 3 columns"},
             {"id,u,v\n1,2,3\n",
              "line 2: '1,2,3' has 3 columns; a layout needs x,y: choose them, such as --columns u,v"},
             {"id,a,b\n7,0.5,0\n9,1,0.25\n",
              "line 2: '7,0.5,0' has 3 columns; a layout needs x,y: choose them, such as --columns a,b"},
             {"a,id,b\n0.5,7,0.1\n", "choose them, such as --columns a,b"},
             {"0.5 7 0.1\n", "choose them, such as --columns 1,3"},
             {"id,pos x,pos y\n7,0.5,0.1\n", "such as --columns \"pos x,pos y\""},
             {"1,0.2,0.3\n2,0.4,0.3\n",
              "line 1: '1,0.2,0.3' has 3 columns; a layout needs x,y: choose them, such as --columns 2,3"},
             {"0,5,0,7\n", "such as --columns 1,2; or, if its commas are decimal, write points"},
             {"x [m] y [m]\n0 1\n",
              "line 2: '0 1' has 2 columns, the header 4; choose two by number, such as --columns 1,2"},
             {"x,y,h\n0,0,1\n0,1\n", "line 3: '0,1' has 2 columns, the header 3"},
             {"0,\n", "line 1: '0,' has 1 column; a layout needs x,y"},
             {",0\n", "line 1: '' is no number"},
             {"0 1, 2\n", "line 1: '0 1' is no number"},
             {"x1 x2\ny1 y2\n", "line 2: 'y1' is no number"},
             {"nan inf\n", "line 1: 'nan' is no number"},
             {"0 0x1p0\n", "line 1: '0x1p0' is no number"}}) {
        const std::string tried = text;
        CAPTURE(tried);
        CHECK_THROWS_WITH_AS(static_cast<void>(points(text)), doctest::Contains(reason), base::InvalidInput);
    }
}

TEST_CASE("positions: those of a uniform grid give the numbers of --particles") {
    const Folder folder;
    const std::string file = folder.path + "/uniform.csv";
    report::write_whole(file, uniform(40));
    for (const std::string program : {"derivative_test", "static_test", "vibration_test"})
        for (const std::string options :
             {" --volumes equal", " --volumes partition --kernel quintic_spline --smoothing 1.5"}) {
            CAPTURE(program + options);
            const auto given = report::parsed(run(program + options + " --positions " + file).output);
            const auto made = report::parsed(run(program + options + " --particles 40").output);
            REQUIRE(!given.rows.empty());
            REQUIRE(given.rows.size() == made.rows.size());
            for (std::size_t row = 0; row < made.rows.size(); ++row)
                for (const auto& column : made.columns) {
                    CAPTURE(column.name);
                    // Of a file it is not known that its particles were drawn, or lie on a lattice.
                    const bool drawn = column.name == "seed" || column.name == "perturbation" ||
                                       column.name == "ratio_symbol";
                    CHECK(given.word(row, column.name) == (drawn ? "" : made.word(row, column.name)));
                }
        }
}

TEST_CASE("positions: any increasing set serves, with h from the mean or from the largest spacing") {
    const Folder folder;
    const std::string file = folder.path + "/irregular.csv";
    report::write_whole(file, irregular);
    const std::string command = "static_test --formulation second_order_fpm --positions " + file;
    const auto error = [&](const std::string& options) {
        const auto table = report::parsed(run(command + options).output);
        REQUIRE(table.rows.size() == 1);
        CHECK(table.word(0, "particles") == "15");
        return std::get<double>(table.rows[0][table.column("error_displacement")]);
    };
    CHECK(error("") == error(" --smoothing-from mean"));
    CHECK(error(" --smoothing-from largest") == support::relative(error(" --smoothing 1.4"), 1e-9));
    CHECK(error("") != error(" --smoothing-from largest"));
    CHECK(run(command).output.find("positions of a file, 0.05 to 0.1 apart") != std::string::npos);
    CHECK(run(command + " --smoothing-from largest").output.find("h/largest spacing 1") != std::string::npos);
}

TEST_CASE("positions: perturbed particles too may be smoothed by their largest spacing") {
    const std::string command = "derivative_test --formulation fpm --particles 30 --perturb 0.2";
    const auto by_mean = run(command), by_largest = run(command + " --smoothing-from largest");
    CHECK(by_largest.code == 0);
    CHECK(by_largest.output != by_mean.output);
}

TEST_CASE("positions: the programs refuse what does not go together, in one line") {
    const Folder folder;
    const std::string file = folder.path + "/x.csv";
    report::write_whole(file, "0\n0.5\n0.4\n1\n");
    for (const std::string program : {"derivative_test", "static_test", "vibration_test"}) {
        const std::string command = program + " --positions " + file;
        check_refused(command, 2, "x.csv, line 3: '0.4' does not lie beyond the position before it, 0.5");
        for (const std::string option : {"--particles 10", "--perturb 0.1", "--seed 2", "--seeds 2"}) {
            check_refused(command + " " + option, 2, option.substr(0, option.find(' ')));
            check_refused(command + " " + option, 2, " exclude each other; leave one out");
        }
        check_refused(program + " --positions /nowhere/x.csv", 2, "cannot read /nowhere/x.csv");
        check_refused(program + " --smoothing-from least", 2,
                      "there is no spacing 'least'; choose one of mean, largest, local");
    }
    report::write_whole(file, "0\n1\n");
    check_refused("vibration_test --positions " + file, 2, "take at least 3");
    check_refused("derivative_test --positions ''", 2, "--positions is empty");
}

TEST_CASE(
    "positions: with h from the local spacing, a graded line costs no more neighbours than a uniform one") {
    const Folder folder;
    const std::string file = folder.path + "/graded.txt";
    std::string text;
    for (int k = 0; k < 60; ++k)
        text += std::to_string((std::pow(1.1, k) - 1) / (std::pow(1.1, 59) - 1)) + "\n";
    text.replace(text.rfind("1.0"), 8, "1");
    report::write_whole(file, text);
    const std::string command =
        "derivative_test --formulation second_order_fpm --kernel quintic_spline --smoothing 1.5";
    // With the mean spacing, the wide cells of this line have too few neighbours.
    check_refused(command + " --positions " + file, 1, "second_order_fpm: particle 5");
    for (const std::string from : {"local", "2-nearest"}) {
        const auto table =
            report::parsed(run(command + " --positions " + file + " --smoothing-from " + from).output);
        REQUIRE(table.rows.size() == 1);
        CHECK(std::get<double>(table.rows[0][table.column("error_second")]) < 0.1);
    }
    check_refused(command + " --positions " + file + " --smoothing-from 60-nearest", 2,
                  "60 nearest of 60 particles");
    // The remedy is a --smoothing, with the same --smoothing-from.
    for (const std::string from : {"local", "nearest", "mean", "0.001", "1e300"}) {
        const std::string refused =
            "derivative_test --formulation second_order_fpm --kernel cubic_spline --smoothing-from " + from +
            " --positions " + file;
        const std::string why = check_refused(refused, 1, "; try --smoothing ");
        CHECK(run(refused + why.substr(why.find(" --smoothing "))).code == 0);
    }
}

TEST_CASE("positions: smoothing lengths from a number, and from a file with a number for each particle") {
    const Folder folder;
    const std::string file = folder.path + "/h.csv";
    std::string lengths = "length\n";
    for (int k = 0; k < 20; ++k) lengths += "0.1  # comment\n";
    report::write_whole(file, lengths);
    const auto error = [](const std::string& from) {
        const auto table = report::parsed(
            run("derivative_test --formulation modified_fpm --particles 20 --smoothing-from " + from).output);
        return std::get<double>(table.rows[0][table.column("error_second")]);
    };
    CHECK(error("0.1") == error(file));
    CHECK(error("0.1") != error("mean"));
    CHECK(error("0.05263157894736842") == support::relative(error("mean"), 1e-9));
    const std::string command = "derivative_test --particles 20 --smoothing-from ";
    check_refused("derivative_test --particles 19 --smoothing-from " + file, 2,
                  "h.csv has 20 numbers, for 19 particles");
    check_refused(command + "-1", 2, "--smoothing-from: '-1' is not positive");
    check_refused(command + "/nowhere/h.csv", 2, "cannot read /nowhere/h.csv");
    report::write_whole(file, "0.1\n0\n");
    check_refused(command + file, 2, "h.csv, line 2: '0' is not positive");
    check_refused(command + file + " --output " + file, 2, "--smoothing-from");
    check_refused(command + "/dev/null", 2, "/dev/null holds no number");
}

TEST_CASE("positions: smoothing lengths from a column of a file, by its name or its number") {
    const Folder folder;
    const std::string file = folder.path + "/xh.csv", colon = folder.path + "/a:h";
    const auto lengths = [](const std::string& text) { return spacing_from(text).lengths; };
    const particles::Column<double> expected{{0.1, 0.2}};
    for (const std::string text :
         {"x,h\n0,0.1\n1,0.2\n", "\"x\", \"h\" # lengths\n0, 0.1\n\n1 ,0.2", "x\th\n0\t0.1\n1  0.2\n"}) {
        report::write_whole(file, text);
        for (const std::string column : {":h", ":2"}) {
            REQUIRE(lengths(file + column).size() == 2);
            CHECK((lengths(file + column) == expected).all());
        }
        CHECK_THROWS_WITH_AS(lengths(file + ":1"), doctest::Contains("'0' is not positive"),
                             base::InvalidInput);
        CHECK_THROWS_WITH_AS(lengths(file), doctest::Contains("has 2 columns; name one, such as "),
                             base::InvalidInput);
        CHECK_THROWS_WITH_AS(lengths(file + ":H"),
                             doctest::Contains("xh.csv has no column 'H'; its header is "),
                             base::InvalidInput);
        CHECK_THROWS_WITH_AS(lengths(file + ":0"), doctest::Contains("has no column '0'"),
                             base::InvalidInput);
        CHECK_THROWS_WITH_AS(lengths(file + ":3"), doctest::Contains("has no column 3"), base::InvalidInput);
    }
    report::write_whole(file, "0,0.1\n1,0.2\n");
    CHECK((lengths(file + ":2") == expected).all());
    CHECK_THROWS_WITH_AS(lengths(file + ":h"),
                         doctest::Contains("has no column 'h'; it has no header, take a number from 1"),
                         base::InvalidInput);
    report::write_whole(colon, "0.1\n0.2\n");
    CHECK((lengths(colon) == expected).all());

    std::string body = "x,h\n";
    for (int k = 0; k < 20; ++k) body += base::shown(k / 19.0, 17) + ",0.1\n";
    report::write_whole(file, body);
    const auto by_column = run("derivative_test --positions " + file + " --smoothing-from " + file + ":h");
    CHECK(by_column.output.find("h the numbers of " + file + ":h, volumes") != std::string::npos);
    const auto by_number = run("derivative_test --positions " + file + " --smoothing-from 0.1");
    CHECK(by_number.output.find(", h = 0.1, volumes") != std::string::npos);
    CHECK(by_column.output.substr(by_column.output.find("\nformulation")) ==
          by_number.output.substr(by_number.output.find("\nformulation")));
    check_refused("derivative_test --positions " + file + " --smoothing-from " + file + ":h --output " + file,
                  2, "--output");
}

TEST_CASE(
    "positions: a smoothing length is a number in any usual form, and what is neither number, name nor file is refused") {
    for (const std::string number : {"0.2", "+0.2", " 0.2 ", "2e-1", "2D-1"}) {
        const auto spacing = spacing_from(number);
        REQUIRE(spacing.kind == particles::Spacing::given);
        CHECK(spacing.lengths[0] == 0.2);
    }
    CHECK(spacing_from(" local ").kind == particles::Spacing::local);
    for (const std::string wrong : {"2.5-nearest", "least", "x:h", "nan", "inf"})
        CHECK_THROWS_WITH_AS(spacing_from(wrong), doctest::Contains("; choose one of mean, largest, local"),
                             base::InvalidInput);
    for (const std::string wrong : {"0.2m", "0.2,0.3", "-", "+", "++1", "."})
        CHECK_THROWS_WITH_AS(spacing_from(wrong),
                             doctest::Contains("is no number; take a length, a name such as largest or"),
                             base::InvalidInput);
    for (const auto& [wrong, why] : std::vector<std::pair<const char*, const char*>>{
             {"0", "--smoothing-from: '0' is not positive; take a length"},
             {"-1", "'-1' is not positive"},
             {"1e999", "'1e999' is larger than a double can be"},
             {"0,2", "write a decimal comma as a point, 0.2; take a length"}})
        CHECK_THROWS_WITH_AS(spacing_from(wrong), doctest::Contains(why), base::InvalidInput);
    CHECK_THROWS_WITH_AS(spacing_from("h.csv"), doctest::Contains("cannot read h.csv"), base::InvalidInput);
    const Folder folder;
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path(folder.path);
    report::write_whole("lengths", "0.1\n0.2\n");
    CHECK(spacing_from("lengths").lengths.size() == 2);
    std::filesystem::current_path(before);
}

TEST_CASE("positions: what is no number or infinite is no header") {
    for (const char* first : {"nan", "NaN", "inf", "-inf", "infinity"})
        CHECK_THROWS_WITH_AS(read(std::string(first) + "\n" + irregular), doctest::Contains("is no number"),
                             base::InvalidInput);
    CHECK(read("nanometres\n" + std::string(irregular)).size() == 15);
}
