#include "command_line/example_problems.hpp"

#include "tests/programs/run.hpp"
#include "tests/relative.hpp"

using namespace command_line;
using namespace programs;

TEST_CASE(
    "example_problems: --field writes displacements and stresses at the particles, as CSV and for ParaView") {
    const Folder folder;
    CHECK(run("plate --method strong,weak1 --gauss 4 --field " + folder.path + "/f.csv").code == 0);
    const auto table = report::parsed(report::read_whole(folder.path + "/f.csv"));
    CHECK(table.rows.size() == 128);
    CHECK(table.word(127, "method") == "weak1");

    CHECK(run("plate --method strong,weak1 --gauss 4 --field " + folder.path + "/f.vtk").code == 0);
    const std::string vtk = report::read_whole(folder.path + "/f.vtk");
    CHECK(vtk.starts_with("# vtk DataFile Version 3.0\n"));
    for (const char* part :
         {"DATASET UNSTRUCTURED_GRID", "CELLS 64 128", "CELL_TYPES 64", "POINTS 64 double", "POINT_DATA 64",
          "VECTORS u_exact double", "VECTORS u_strong double", "SCALARS s11_weak1 double 1"})
        CHECK(vtk.find(part) != std::string::npos);
    CHECK(std::count(vtk.begin(), vtk.end(), '\n') == 5 + 3 * 64 + 3 + 3 * (65 + 3 * 66));
}

// meshio is Debian's python3-meshio, which make setup check installs.
TEST_CASE("example_problems: an independent reader finds in the file for ParaView the numbers of the CSV") {
    const Folder folder;
    const std::string field = folder.path + "/f";
    const std::string command = "plate --method weak1 --gauss 4 --field " + field;
    CHECK(run(command + ".csv").code == 0);
    CHECK(run(command + ".vtk").code == 0);
    report::write_whole(field + ".py", R"(import meshio, sys
mesh = meshio.read(sys.argv[1])
vertices = mesh.cells_dict["vertex"].ravel()
u, exact = mesh.point_data["u_weak1"], mesh.point_data["u_exact"]
print("x1,x2,u1,u2,u1_exact,u2_exact,s11,s22,s12,s12_exact")
for k in vertices:
    print(*mesh.points[k][:2], *u[k][:2], *exact[k][:2],
          *(mesh.point_data[name][k].item() for name in ("s11_weak1", "s22_weak1", "s12_weak1", "s12_exact")), sep=",")
)");
    const auto outcome = run("/usr/bin/python3 " + field + ".py " + field + ".vtk");
    CAPTURE(outcome.errors);
    REQUIRE(outcome.code == 0);
    const auto found = report::parsed(outcome.output),
               expected = report::parsed(report::read_whole(field + ".csv"));
    REQUIRE(found.rows.size() == expected.rows.size());
    for (std::size_t row = 0; row < found.rows.size(); ++row)
        for (const auto& column : found.columns) {
            CAPTURE(column.name);
            CHECK(std::get<double>(found.rows[row][found.column(column.name)]) ==
                  doctest::Approx(std::get<double>(expected.rows[row][expected.column(column.name)]))
                      .epsilon(1e-6));
        }
}

TEST_CASE("example_problems: --field for ParaView holds the exact states of each material") {
    const Folder folder;
    CHECK(run("plate --method strong --scaling 3,3.1 --poisson 0.3,0.4 --field " + folder.path + "/f.vtk")
              .code == 0);
    const std::string vtk = report::read_whole(folder.path + "/f.vtk");
    std::vector<std::string> names;
    const std::string before = "VECTORS u_";
    for (std::size_t at = vtk.find(before); at != std::string::npos; at = vtk.find(before, at + 1))
        names.push_back(
            vtk.substr(at + before.size(), vtk.find(' ', at + before.size()) - at - before.size()));
    CHECK(names ==
          std::vector<std::string>{"exact", "strong", "strong_1", "exact_2", "strong_2", "strong_3"});
}

TEST_CASE("example_problems: stresses near the incompressible are compared by what they are to strains") {
    const auto tolerance = [](double nu, const std::string& column) {
        ExampleCase of;
        of.material = {2e11, nu, batra2008::elastostatics::Plane::strain};
        report::Table table;
        table.columns = state_columns({of});
        return table.columns[table.column(column)].tolerance.absolute;
    };
    CHECK(tolerance(0.3, "s11") == 10);
    CHECK(tolerance(0.499999, "u1") == tolerance(0.3, "u1"));
    for (const char* column : {"s11", "s22", "s12", "s11_exact"})
        CHECK(tolerance(0.499999, column) == support::relative(33333.5, 1e-5));
}

TEST_CASE("example_problems: places on a line lie at equal distances, its ends among them") {
    const auto places = places_between({0, 0.3}, {0, 3}, 4);
    REQUIRE(places.size() == 4);
    CHECK(places[0][1] == 0.3);
    CHECK(places[1][1] == support::relative(1.2, 1e-15));
    CHECK(places[3][1] == support::relative(3, 1e-15));
}

TEST_CASE("example_problems: --seconds says what a solution took") {
    const auto table = report::parsed(run("plate --method strong --seconds").output);
    for (const char* name : {"seconds_assembly", "seconds_solution", "megabytes"})
        CHECK(std::get<double>(table.rows[0][table.column(name)]) > 0);
}

TEST_CASE("example_problems: --quality adds R of the worst derivative and the noise of the unknowns") {
    const auto table = report::parsed(run("plate --method strong,weak1 --quality").output);
    for (std::size_t row = 0; row < 2; ++row) {
        CHECK(std::get<double>(table.rows[row][table.column("quality")]) == support::relative(1.5943, 1e-4));
        CHECK(std::get<double>(table.rows[row][table.column("noise")]) < 0.1);
    }
    CHECK(run("plate --quality --states particles").code == 2);
}

TEST_CASE("example_problems: with --quality, comments name the whole case, and where its worst row lies") {
    const std::string text =
        run("hole --method strong --radius 0.3,0.4 --draws 3 --poisson 0.3 --quality").output;
    CAPTURE(text);
    const std::size_t at = text.find("# quality: R of the worst derivative");
    REQUIRE(at != std::string::npos);
    const std::string line = text.substr(at, text.find('\n', at) - at);
    for (const char* part :
         {"the largest is ", "strong, 188 particles, scaling 4, poisson 0.3, layout graded-188-11, radius 0.",
          ", draw ", " derivative at particle ", " (x = ("})
        CHECK(line.find(part) != std::string::npos);
}

TEST_CASE("example_problems: a table says which solutions are noise, and of others nothing") {
    const std::string quiet = run("hole --method strong").output;
    CHECK(quiet.find("# noise") == std::string::npos);
    const std::string noisy =
        run("hole --method strong,weak1 --smoothing-from 6-nearest --states x2-axis").output;
    CHECK(
        noisy.find(
            "# noise: the unknowns alternate between neighbours, and stresses may be wrong, in 2 cases, most of all in: weak1, 188 particles, scaling 4 (noise ") !=
        std::string::npos);
}
