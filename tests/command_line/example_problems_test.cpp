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
         {"DATASET POLYDATA", "POINTS 64 double", "POINT_DATA 64", "VECTORS u_exact double",
          "VECTORS u_strong double", "SCALARS s11_weak1 double 1"})
        CHECK(vtk.find(part) != std::string::npos);
    CHECK(std::count(vtk.begin(), vtk.end(), '\n') == 5 + 64 + 1 + 64 + 1 + 3 * (65 + 3 * 66));
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

TEST_CASE("example_problems: --seconds says what a solution took") {
    const auto table = report::parsed(run("plate --method strong --seconds").output);
    for (const char* name : {"seconds_assembly", "seconds_solution", "megabytes"})
        CHECK(std::get<double>(table.rows[0][table.column(name)]) > 0);
}
