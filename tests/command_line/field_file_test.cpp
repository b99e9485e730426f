#include "command_line/field_file.hpp"

#include "tests/programs/run.hpp"

using namespace programs;

TEST_CASE("field_file: --field writes displacements and stresses at the particles, as CSV and for ParaView") {
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
TEST_CASE("field_file: an independent reader finds in the file for ParaView the numbers of the CSV") {
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

TEST_CASE("field_file: --field for ParaView holds the exact states of each material") {
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
