#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "report/table.hpp"
#include "tests/programs/run.hpp"
#include "tests/support/relative.hpp"

using programs::run;

namespace {

/// A bar from (0, 0) to (2, 1), or a block of depth 1, in a folder of its own.
struct Drawing {
    programs::Folder folder;
    std::string bar = folder.path + "/bar.geo", block = folder.path + "/block.geo";

    Drawing() {
        const std::string shape =
            "Point(1) = {0, 0, 0}; Point(2) = {2, 0, 0}; Point(3) = {2, 1, 0}; Point(4) = {0, 1, 0};\n"
            "Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};\n"
            "Curve Loop(1) = {1:4}; Plane Surface(1) = {1};\n";
        report::write_whole(bar, shape +
                                     "Physical Curve(\"bottom\") = {1}; Physical Curve(\"end\") = {2};\n"
                                     "Physical Curve(\"top\") = {3}; Physical Curve(\"wall\") = {4};\n"
                                     "Physical Surface(\"bar\") = {1};\n");
        report::write_whole(
            block, shape +
                       "all[] = Extrude {0, 0, 1} { Surface{1}; };\n"
                       "Physical Surface(\"back\") = {1}; Physical Surface(\"front\") = {all[0]};\n"
                       "Physical Surface(\"bottom\") = {all[2]}; Physical Surface(\"end\") = {all[3]};\n"
                       "Physical Surface(\"top\") = {all[4]}; Physical Surface(\"wall\") = {all[5]};\n"
                       "Physical Volume(\"block\") = {1};\n");
    }
};

const std::string steel = " --young 200 --poisson 0.3";

/// The number of a quantity of a method; the first of them.
double number(const report::Table& table, const std::string& method, const std::string& quantity,
              const std::string& column = "value") {
    for (std::size_t row = 0; row < table.rows.size(); ++row)
        if (table.word(row, "method") == method && table.word(row, "quantity") == quantity)
            return std::get<double>(table.rows[row][table.column(column)]);
    FAIL("no row " << method << ", " << quantity);
    return 0;
}

report::Table table_of(const std::string& command) {
    CAPTURE(command);
    const auto [code, output, errors] = run(command);
    CAPTURE(errors);
    REQUIRE(code == 0);
    CHECK_FALSE(programs::has_non_finite_cell(output));
    return report::parsed(output);
}

bool has_comment(const report::Table& table, const std::string& text) {
    return std::any_of(table.comments.begin(), table.comments.end(),
                       [&](const std::string& comment) { return comment.find(text) != std::string::npos; });
}

}  // namespace

TEST_CASE("body: a pulled bar has the exact state by every method, and is in equilibrium") {
    const Drawing drawing;
    const auto table =
        table_of("body --mesh " + drawing.bar + " --size 0.2" + steel +
                 " --symmetry wall --symmetry bottom --traction 'end: 4, 0' --method all --at 1.5,0.7");
    for (const std::string method : {"fpm", "strong", "weak1", "weak2", "hats"}) {
        CAPTURE(method);
        CHECK(number(table, method, "u1") == support::relative(1.5 * 4 / 200, 1e-3));
        CHECK(number(table, method, "u2") == support::relative(-0.7 * 0.3 * 4 / 200, 1e-3));
        CHECK(number(table, method, "s11") == support::relative(4.0, 1e-3));
        CHECK(number(table, method, "von_mises") == support::relative(4.0, 1e-3));
        CHECK(number(table, method, "load1:end") == support::relative(4.0, 1e-3));
        CHECK(number(table, method, "reaction1:wall") == support::relative(-4.0, 1e-3));
        CHECK(number(table, method, "defect") < 1e-3);
        CHECK(number(table, method, "max_displacement", "x") == 2);
    }
    CHECK(has_comment(table, "since nothing is given there: top"));
}

TEST_CASE("body: a block in space, and plane strain, which is that block between fixed planes") {
    const Drawing drawing;
    const std::string load = steel + " --symmetry wall --symmetry bottom --pressure 'end: -4' --method hats";
    const auto plane =
        table_of("body --mesh " + drawing.bar + " --size 0.25 --plane strain" + load + " --at 1.5,0.7");
    const auto space = table_of("body --mesh " + drawing.block + " --size 0.4" + load +
                                " --symmetry back --symmetry front --at 1.5,0.7,0.5");
    for (const char* quantity : {"u1", "u2", "s11", "von_mises"}) {
        CAPTURE(quantity);
        CHECK(number(space, "hats", quantity) == support::relative(number(plane, "hats", quantity), 1e-4));
    }
    CHECK(number(space, "hats", "s33") == support::relative(0.3 * 4, 1e-4));
}

TEST_CASE("body: heat through a bar that convection cools") {
    const Drawing drawing;
    const auto table =
        table_of("body --mesh " + drawing.bar +
                 " --size 0.25 --equation poisson --conductivity 5 --flux 'wall: 10' --convection "
                 "'end: 2, 20' --along 0,0.5:2,0.5:3");
    // 10 = 2 (u - 20) at the end, and the slope is -10/5.
    CHECK(number(table, "hats", "u") == support::relative(25 + 2 * 2, 1e-5));
    CHECK(number(table, "hats", "q1") == support::relative(10.0, 1e-5));
    CHECK(number(table, "hats", "max_u") == support::relative(29.0, 1e-5));
    CHECK(number(table, "hats", "min_u") == support::relative(25.0, 1e-5));
    CHECK(std::count_if(table.rows.begin(), table.rows.end(), [&](const auto& row) {
              return std::get<std::string>(row[table.column("quantity")]) == "u";
          }) == 3);
    CHECK(has_comment(table, "insulated"));
}

TEST_CASE("body: loads without a sum, and no load at all, leave no defect and no noise") {
    const Drawing drawing;
    for (const std::string method : {"hats", "fpm"}) {
        CAPTURE(method);
        const auto rest =
            table_of("body --mesh " + drawing.bar +
                     " --size 0.25 --equation poisson --convection 'wall: 1, 293' --method " + method);
        CHECK(number(rest, method, "max_u") == support::relative(293.0, 1e-9));
        CHECK(number(rest, method, "defect") < 1e-6);
        CHECK(number(rest, method, "noise") < 1e-3);
    }
    const auto pressed = table_of("body --mesh " + drawing.bar + " --size 0.25" + steel +
                                  " --fix wall --pressure 'top: 1' --pressure 'bottom: 1' --method hats");
    CHECK(number(pressed, "hats", "defect") < 1e-9);
}

TEST_CASE(
    "body: finer clouds have an order, an extrapolated value and an uncertainty that holds the exact one") {
    const Drawing drawing;
    const auto table = table_of(
        "body --mesh " + drawing.bar +
        " --size 0.15 --refine 3 --equation poisson --source 'sin(pi*x/2)*sin(pi*y)' --value 'wall: 0' "
        "--value 'end: 0' --value 'top: 0' --value 'bottom: 0' --at 1,0.5");
    const double exact = 1 / (std::pow(std::acos(-1), 2) * 1.25);
    CHECK(std::abs(number(table, "hats", "u", "extrapolated") - exact) <=
          number(table, "hats", "u", "uncertainty"));
    CHECK(table.word(0, "quantity") == "u");
    CHECK(number(table, "hats", "u") == support::relative(exact, 0.02));
}

TEST_CASE("body: the seconds of each method stand in a row of their own, if they are asked for") {
    const Drawing drawing;
    const std::string command =
        "body --mesh " + drawing.bar + " --size 0.5" + steel + " --fix wall --method hats,weak1";
    const auto table = table_of(command + " --seconds");
    CHECK(number(table, "hats", "seconds") > 0);
    CHECK(number(table, "weak1", "seconds") > 0);
    const auto without = table_of(command);
    CHECK(table.rows.size() == without.rows.size() + 2);
}

TEST_CASE("body: the modes of a rectangular membrane") {
    const Drawing drawing;
    const auto table = table_of("body --mesh " + drawing.bar +
                                " --size 0.05 --equation poisson --value 'wall: 0' --value 'end: 0' --value "
                                "'top: 0' --value 'bottom: 0' --modes 2");
    REQUIRE(table.rows.size() == 2);
    const double pi2 = std::pow(std::acos(-1), 2);
    CHECK(number(table, "hats", "eigenvalue1") == support::relative(1.25 * pi2, 0.01));
    CHECK(number(table, "hats", "eigenvalue2") == support::relative(2 * pi2, 0.01));
}

TEST_CASE("body: files of the field and a drawing, the same on any number of threads") {
    const Drawing drawing;
    const std::string command = "body --mesh " + drawing.bar + " --size 0.25" + steel +
                                " --fix wall --traction 'end: 0, -1e-3' --field " + drawing.folder.path;
    const auto one = run(command + "/a.vtu --threads 1 --plot " + drawing.folder.path + "/a.svg");
    const auto two = run(command + "/b.vtu --threads 2");
    CHECK(one.errors.empty());
    CHECK(one.code == 0);
    CHECK(one.output == two.output);
    const std::string grid = report::read_whole(drawing.folder.path + "/a.vtu");
    CHECK(grid == report::read_whole(drawing.folder.path + "/b.vtu"));
    for (const char* name : {"\"u\"", "\"s12\"", "\"von_mises\""})
        CHECK(grid.find(name) != std::string::npos);
    CHECK(report::read_whole(drawing.folder.path + "/a.svg").find("von Mises") != std::string::npos);
}

TEST_CASE("body: a method that fails has a row that says why, and the others their numbers") {
    const programs::Folder folder;
    const std::string field = folder.path + "/f.csv";
    const auto [code, output, errors] =
        run("body --mesh examples/bodies/bracket.geo --size 5e-3 --young 210e9 --poisson 0.3 --fix wall "
            "--traction 'tip: 0, -1e6' --method strong,hats --field " +
            field);
    CHECK(code == 1);
    CHECK(errors.starts_with("body: 1 of 2 cases failed, as the table's last column says; method strong: "));
    CHECK(std::count(errors.begin(), errors.end(), '\n') == 1);
    const auto table = report::parsed(output);
    CHECK(table.word(0, "method") == "strong");
    CHECK(table.word(0, "quantity").empty());
    CHECK(table.word(0, "failure").starts_with("loads and reactions leave a defect of "));
    CHECK(number(table, "hats", "defect") < 1e-9);
    const std::string fields = report::read_whole(field);
    CHECK(fields.find("_hats") != std::string::npos);
    CHECK(fields.find("strong") == std::string::npos);
}

TEST_CASE("body: where all methods fail there is one line, no output and no field") {
    const programs::Folder folder;
    const std::string field = folder.path + "/f.csv";
    programs::check_refused(
        "body --mesh examples/bodies/bracket.geo --size 5e-3 --young 210e9 --poisson 0.3 --fix wall "
        "--traction 'tip: 0, -1e6' --method strong,weak1 --field " +
            field,
        1, "none of the 2 cases can be computed; method strong: ");
    CHECK_FALSE(std::filesystem::exists(field));
}

TEST_CASE("body: particles and sides from files, without cells") {
    const programs::Folder folder;
    std::string points = "x,y\n";
    for (int k = 0; k < 45; ++k)
        points += std::to_string(k % 9 * 0.25) + "," + std::to_string(k / 9 * 0.25) + "\n";
    report::write_whole(folder.path + "/points.csv", points);
    report::write_whole(folder.path + "/sides.csv",
                        "name,order,x,y\nbottom,1,0,0\nbottom,2,2,0\nend,1,2,0\nend,2,2,1\n"
                        "top,1,2,1\ntop,2,0,1\nwall,1,0,1\nwall,2,0,0\n");
    const auto table = table_of(
        "cd " + folder.path + "; body --points points.csv --boundary sides.csv" + steel +
        " --symmetry wall --symmetry bottom --traction 'end: 4, 0' --at 1.4,0.7 --method all --field "
        "f.csv");
    for (const std::string method : {"fpm", "strong", "weak1", "weak2"})
        CHECK(number(table, method, "u1") == support::relative(1.4 * 4 / 200, 1e-6));
    CHECK(report::read_whole(folder.path + "/f.csv").find("von_mises_weak2") != std::string::npos);
    programs::check_refused("body --points " + folder.path + "/points.csv --boundary " + folder.path +
                                "/sides.csv" + steel + " --symmetry wall --symmetry bottom --at 2,1.01",
                            2, "the nearest particle is (2, 1), 0.01 away");
}

TEST_CASE("body: bad invocations end with one line, exit code 2 and no output") {
    const Drawing drawing;
    const std::string elastic = "--mesh " + drawing.bar + " --size 0.5" + steel;
    for (const auto& [options, reason] : std::vector<std::pair<std::string, std::string>>{
             {"", "there is no body; give --mesh FILE"},
             {"--points p.csv", "--points needs --boundary; give both"},
             {"--mesh a.geo --points p.csv --boundary b.csv", "leave --points and --boundary out"},
             {"--mesh " + drawing.bar + " --size 0", "--size must be positive and finite, got 0"},
             {"--mesh " + drawing.bar + " --size 0.5 --young 1", "an elastic body needs --poisson"},
             {elastic + " --plane flat", "there is no 'flat'; choose one of stress, strain"},
             {elastic + " --fix wal", "the body has no side 'wal'; its sides are"},
             {elastic + " --value 'wall: 0'", "--value belongs to --equation poisson"},
             {elastic + " --fix wall --at 3,0.5", "the nearest particle is (2, 0.5), 1 away"},
             {elastic + " --fix wall --at 1", "'1' is no place of this body; write --at 0.1,0.2"},
             {elastic + " --fix wall --along 0,0:1,1", "is no line of places"},
             {elastic + " --fix wall --method weak3", "there is no method 'weak3'"},
             {elastic + " --fix wall --method strong --gauss 4", "--gauss belongs to weak1 and weak2"},
             {elastic + " --fix wall --smoothing 1.3", "--smoothing belongs to fpm"},
             {elastic + " --fix wall --method fpm,strong --plot a.svg", "--plot draws one method"},
             {elastic + " --fix wall --modes 2 --at 1,0.5", "--modes asks for eigenvalues"},
             {elastic + " --fix wall --modes 2 --seconds", "--seconds shows a solution"},
             {elastic + " --fix wall --refine 2", "--refine must lie between 3 and 12"},
             {elastic + " --fix wall --field a.vtk", ".vtu"},
             {"--mesh " + drawing.bar + steel + " --refine 3", "--refine needs the --size"},
             {elastic + " --traction 'end: 1, 0'", "move"}})
        programs::check_refused("body " + options, 2, reason);
}
