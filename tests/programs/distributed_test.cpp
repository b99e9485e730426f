#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "report/table.hpp"
#include "tests/programs/run.hpp"
#include "tests/support/relative.hpp"

using programs::check_refused;
using programs::run;

namespace {

/// The command on so many processes; without mpirun on one.
std::string on(int processes) {
    return processes == 1 ? "distributed "
                          : "mpirun --quiet -n " + std::to_string(processes) + " distributed ";
}

report::Table table_of(const std::string& command) {
    CAPTURE(command);
    const auto [code, output, errors] = run(command);
    CAPTURE(errors);
    REQUIRE(code == 0);
    CHECK_FALSE(programs::has_non_finite_cell(output));
    return report::parsed(output);
}

double number(const report::Table& table, std::size_t row, const std::string& column) {
    return std::get<double>(table.rows[row][table.column(column)]);
}

/// The rows are the same, in words and, to a relative difference, in numbers.
void check_same(const report::Table& found, const report::Table& expected) {
    REQUIRE(found.rows.size() == expected.rows.size());
    REQUIRE(found.columns.size() == expected.columns.size());
    for (std::size_t row = 0; row < found.rows.size(); ++row) {
        const std::string quantity = expected.word(row, "quantity");
        CAPTURE(quantity);
        CHECK(found.word(row, "quantity") == quantity);
        CHECK(found.word(row, "method") == expected.word(row, "method"));
        const double value = number(expected, row, "value");
        // What is small beside the terms that it is a sum of has fewer digits.
        CHECK(std::abs(number(found, row, "value") - value) <= 1e-7 * std::abs(value) + 1e-9);
    }
}

const std::string strip =
    "--mesh examples/bodies/strip.geo --size 2.8e-3 --young 210e3 --poisson 0.3 --symmetry middle --symmetry neck --traction 'end: 1, 0' --at 0,0.025 --along 0.02,0.03:0.05,0.04:4 --method fpm,strong ";
const std::string membrane =
    "--grid 21x17 --equation poisson --source 1 --value 'left: 0' --value 'right: y' ";

}  // namespace

TEST_CASE("distributed: its table is that of body on one machine, on any number of processes") {
    const report::Table expected = table_of("body " + strip);
    for (const int processes : {1, 2, 3}) check_same(table_of(on(processes) + strip), expected);
}

TEST_CASE("distributed: a grid has the same table on any number of processes, and more than are sensible") {
    const std::string command = membrane + "--at 0.3,0.4 --at 1,1 --method fpm,strong";
    const report::Table expected = table_of(on(1) + command);
    for (const int processes : {2, 5}) check_same(table_of(on(processes) + command), expected);
    const std::string negative = "--grid 9x9 --equation poisson --value 'top: 0' --source ";
    check_same(table_of(on(2) + negative + "-pi"), table_of(on(1) + negative + "-3.141592653589793"));
    check_same(table_of(on(2) + negative + "-pi"), table_of(on(1) + negative + "'-acos(-1)'"));
    const std::string few = "--grid 5x4 --equation poisson --source 1 --value 'left: 0'";
    check_same(table_of(on(11) + few), table_of(on(1) + few));
    const std::string cube =
        "--grid 7x9x7 --lengths 1x1.3x1 --equation poisson --source 1 --value left:0 --value right:z --at 0.5,1,0.6";
    check_same(table_of(on(4) + cube), table_of(on(1) + cube));
}

TEST_CASE("distributed: planes of symmetry need no factorisation of the whole matrix") {
    for (
        const std::string command :
        {"--grid 31x31 --young 1 --poisson 0.3 --symmetry left --symmetry bottom --traction 'right: 1, 0' --at 1,1",
         "--grid 9x9x9 --young 1 --poisson 0.3 --symmetry left --symmetry bottom --symmetry back --traction 'right: 1, 0, 0' --at 1,1,1"}) {
        const auto table = table_of(on(2) + command);
        CHECK(number(table, 0, "value") == support::relative(1.0, 1e-8));
        for (const std::string& comment : table.comments) CHECK(comment.find("MUMPS") == std::string::npos);
    }
}

TEST_CASE("distributed: a slender body in bending needs no more iterations than others") {
    const auto table = table_of(
        on(2) +
        "--grid 151x31 --lengths 1x0.2 --young 226.9e9 --poisson 0.33 --displacement 'left: -2e6/226.9e9*(5*y-0.5)*2.33*5*y*(5*y-1), 2e6/226.9e9*4.95*(5*y-0.5)^2' --traction 'right: 0, -3e7*5*y*(5*y-1)' --seconds");
    std::size_t row = 0;
    while (table.word(row, "quantity") != "iterations") ++row;
    CHECK(number(table, row, "value") > 5);
    CHECK(number(table, row, "value") < 60);
}

TEST_CASE("distributed: modes are those of body") {
    const std::string command =
        "--mesh examples/bodies/strip.geo --size 6e-3 --equation poisson --value 'end: 0' --modes 3 --method strong";
    const report::Table expected = table_of("body " + command);
    for (const int processes : {1, 3}) check_same(table_of(on(processes) + command), expected);
}

TEST_CASE("distributed: modes by options of SLEPc that do not give the lowest are refused") {
    const std::string membrane_modes = "--grid 21x21 --equation poisson --value left:0 --modes 3 ";
    for (const std::string prefix : {"", "mpirun --quiet -n 2 "}) {
        const auto refused = [&](const std::string& options, int code, const std::string& why) {
            check_refused("distributed " + membrane_modes + options, code, why, prefix);
        };
        refused("-st_pc_type jacobi", 1, "the relative residual of the eigenvalue ");
        refused("-st_ksp_type preonly -st_pc_type bjacobi", 1, "the relative residual of the eigenvalue ");
        refused("-eps_target 50", 2, "--modes finds the smallest eigenvalues");
        refused("-st_type shift", 2, "--modes finds the smallest eigenvalues");
    }
    check_same(table_of(on(2) + membrane_modes + "-eps_tol 1e-10"), table_of(on(1) + membrane_modes));
}

TEST_CASE("distributed: fields have a piece of each process, and the same numbers") {
    const programs::Folder folder;
    const std::string field = folder.path + "/u.pvtu";
    table_of(on(3) + membrane + "--field " + field);
    const std::string index = report::read_whole(field);
    for (const std::string piece : {"u_0.vtu", "u_1.vtu", "u_2.vtu"}) {
        CHECK(index.find("<Piece Source=\"" + piece + "\"/>") != std::string::npos);
        CHECK(report::read_whole(folder.path + "/" + piece).find("Name=\"quality\"") != std::string::npos);
    }
    table_of(on(1) + membrane + "--field '" + folder.path + "/a&b.pvtu'");
    CHECK(report::read_whole(folder.path + "/a&b.pvtu").find("\"a&amp;b_0.vtu\"") != std::string::npos);
}

TEST_CASE("distributed: a process without particles writes no piece, and waits for none") {
    const programs::Folder folder;
    table_of(
        on(12) +
        "--grid 3x3 --young 1 --poisson 0.3 --fix left --fix right --method strong --scaling 4 --field " +
        folder.path + "/u.pvtu");
    const std::string index = report::read_whole(folder.path + "/u.pvtu");
    std::size_t pieces = 0;
    for (std::size_t at = 0; (at = index.find("<Piece", at)) != std::string::npos; ++at) ++pieces;
    CHECK(pieces > 1);
    CHECK(pieces <= 9);
}

TEST_CASE("distributed: PETSc's options reach it, and one that nothing uses is refused") {
    const auto table = table_of(on(2) + membrane + "-pc_type bjacobi -ksp_rtol 1e-13 -ksp_max_it 2000");
    const bool named = std::any_of(
        table.comments.begin(), table.comments.end(),
        [](const std::string& comment) { return comment.find("gmres with bjacobi, ") != std::string::npos; });
    CHECK(named);
    CHECK(
        check_refused("distributed " + membrane + "-ksp_tpye cg", 2, "nothing used PETSc's option -ksp_tpye")
            .find("two dashes") != std::string::npos);
    const programs::Folder folder;
    check_refused("distributed " + membrane + "-ksp_tpye cg --field " + folder.path + "/u.pvtu", 2,
                  "-ksp_tpye");
    CHECK(std::filesystem::is_empty(folder.path));
    check_refused("distributed " + membrane + "-ksp_tpye cg --smoothing 0.3", 1, "fpm: at (");
    for (const std::string prefix : {"", "mpirun --quiet -n 2 "})
        check_refused("distributed " + membrane + "-pc_type nothing", 2, "PETSc: ", prefix);
    check_refused("distributed " + membrane + "-ksp_max_it 2 -pc_type none", 1,
                  "the linear system was not solved: gmres with none, 2 iterations");
}

TEST_CASE("distributed: what cannot be done is refused in one line, on many processes as on one") {
    for (const std::string prefix : {"", "mpirun --quiet -n 3 "}) {
        const auto refused = [&](const std::string& options, int code, const std::string& why) {
            check_refused("distributed " + options, code, why, prefix);
        };
        refused("", 2, "there is no body; give --mesh FILE, or --grid 101x51");
        refused("--grid 9x9 --mesh x.geo --equation poisson", 2, "--mesh and --grid are two bodies");
        refused("--grid 9 --equation poisson", 2, "--grid: '9' is not a size along each of 2 or 3 axes");
        refused("--grid 9x1 --equation poisson --value left:0", 2,
                "--grid: a grid needs at least 2 particles");
        refused("--grid 9x9 --lengths 1x1x1 --equation poisson", 2, "--lengths 1x1x1 has 3 lengths");
        refused("--grid 9x9 --lengths 1x-1 --equation poisson", 2, "the lengths of a grid must be positive");
        refused("--grid 9x9 --equation poisson --source 1", 2, "is known up to a constant");
        refused("--grid 9x9 --young 1 --poisson 0.3 --symmetry left", 2, "is not held: it can move along x2");
        refused("--grid 9x9 --equation poisson --value top:0 --value lef:0", 2, "lef");
        refused("--grid 9x9 --equation poisson --value top:0 --method hats", 2, "hats");
        refused("--grid 9x9 --equation poisson --value top:0 --method fpm --degree 3", 2,
                "add strong to --method");
        refused("--grid 9x9 --equation poisson --value top:0 --at 2,0", 2, "lies outside of the body");
        refused("--grid 9x9 --equation poisson --value 'top: 1/x'", 2, "(0, 1)");
        refused("--grid 9x9 --equation poisson --value top:0 --field u.vtu", 2,
                "the name must end with .pvtu");
        refused("--grid 9x9 --equation poisson --value top:0 --field u.pvtu --output u_0.vtu", 2,
                "--field and --output name the same file, u_0.vtu");
        refused("--grid 9x9 --equation poisson --value top:0 --output /nowhere/t.csv", 1, "/nowhere/t.csv");
        refused("--grid 9x9 --equation poisson --value top:0 --field /nowhere/u.pvtu", 1, "/nowhere/u.pvtu");
        refused("--grid 9x9 --equation poisson --value top:0 --modes 41", 2,
                "ask for 1 to 40 modes on 81 particles, got 41");
        refused("--grid 9x9 --equation poisson --value top:0 --smoothing 0.3", 1, "fpm: at (");
        refused(
            "--grid 11x11 --lengths 1e-6x1e-6 --equation poisson --conductivity 1e9 --convection 'left: 1,20' --flux 'right: 1'",
            1, "the conditions or the material hardly determine the solution");
        refused("--grid 9x9 --equation poisson --value left:0 --corner 'left+right: right'", 2,
                "the sides left and right have no corner");
        refused("--mesh nothing.geo --equation poisson", 2, "nothing.geo");
        refused(
            "--mesh examples/bodies/bracket.geo --size 4e-3 --young 1 --poisson 0.3 --fix wall --smoothing 0.4",
            1, "; try --smoothing ");
        refused("--grid 9x9 --equation poisson --value top:0 --unknown 3", 2,
                "there is no option '--unknown'");
    }
}

TEST_CASE("distributed: a remedy for a mesh serves all particles, wherever they are") {
    const std::string command =
        "--mesh examples/bodies/bracket.geo --size 4e-3 --young 1 --poisson 0.3 --fix wall --smoothing ";
    const std::string why =
        check_refused("distributed " + command + "0.4", 1, "; try --smoothing ", "mpirun --quiet -n 3 ");
    const std::string tried = why.substr(why.find("try --smoothing ") + 16);
    CHECK(why == check_refused("body " + command + "0.4 --method fpm", 1, "; try --smoothing ")
                     .replace(0, 4, "distributed"));
    CHECK(run(on(3) + command + tried.substr(0, tried.find(','))).errors.find("--smoothing") ==
          std::string::npos);
}
