#include "bodies/field_file.hpp"

#include <cmath>
#include <limits>

#include "base/errors.hpp"
#include "report/file.hpp"
#include "report/table.hpp"
#include "tests/programs/run.hpp"

using namespace bodies;
using programs::run;
using support::Folder;

namespace {

Body<2> two_triangles() {
    return {(Points<2>(2, 4) << 0, 1.0 / 3, 0, 1, 0, 0, 1, 1).finished(), {}, {{0, 1, 2}, {1, 3, 2}}};
}

const std::vector<NamedField> fields{
    {"u", (Eigen::MatrixXd(2, 4) << 1, -2e-300, 3, 4, 0.1, 6, 7, 8).finished()},
    {"q", (Eigen::MatrixXd(1, 4) << 1, 2, 3, std::sqrt(2.0)).finished()}};

}  // namespace

// meshio is Debian's python3-meshio, which make setup check installs.
TEST_CASE("field_file: an independent reader finds in a .vtu file the particles, the cells and the numbers") {
    const Folder folder;
    const std::string file = folder.path + "/f";
    const Body<2> plane = two_triangles();
    Body<2> bare = plane;
    bare.cells.clear();
    const Body<3> space{
        (Points<3>(3, 4) << Eigen::Matrix3d::Identity(), Point<3>::Zero()).finished(), {}, {{3, 0, 1, 2}}};
    write_field(file + "_plane.vtu", plane, fields);
    write_field(file + "_bare.vtu", bare, fields);
    write_field(file + "_space.vtu", space, {{"v", space.x * 2}});
    report::write_whole(file + ".py", R"(import meshio, sys
plane, bare, space = (meshio.read(sys.argv[1] + end) for end in ("_plane.vtu", "_bare.vtu", "_space.vtu"))
assert plane.points.tolist() == [[0, 0, 0], [1/3, 0, 0], [0, 1, 0], [1, 1, 0]]
assert plane.cells_dict["triangle"].tolist() == [[0, 1, 2], [1, 3, 2]] and list(plane.cells_dict) == ["triangle"]
assert plane.point_data["u"].tolist() == [[1, 0.1, 0], [-2e-300, 6, 0], [3, 7, 0], [4, 8, 0]]
assert plane.point_data["q"].ravel().tolist() == [1, 2, 3, 2**0.5]
assert bare.cells_dict["vertex"].tolist() == [[0], [1], [2], [3]]
assert (bare.point_data["u"] == plane.point_data["u"]).all()
assert space.cells_dict["tetra"].tolist() == [[3, 0, 1, 2]]
assert (space.point_data["v"] == 2 * space.points).all() and space.points.trace() == 3
)");
    const auto outcome = run("/usr/bin/python3 " + file + ".py " + file);
    CAPTURE(outcome.errors);
    CHECK(outcome.code == 0);
}

TEST_CASE("field_file: in a table the components are numbered, and a scalar has its name") {
    const Folder folder;
    const std::string file = folder.path + "/f.csv";
    write_field(file, two_triangles(), fields, {"a plate"});
    const report::Table table = report::parsed(report::read_whole(file));
    CHECK(table.comments.front() == "a plate");
    CHECK(table.word(3, "x") == "1");
    CHECK(table.word(0, "u2") == "0.1");
    CHECK(table.word(2, "q") == "3");
}

TEST_CASE(
    "field_file: the same fields give the same bytes; what cannot be written leaves the file as it was") {
    const Folder folder;
    const std::string file = folder.path + "/f.vtu";
    write_field(file, two_triangles(), fields);
    const std::string first = report::read_whole(file);
    write_field(file, two_triangles(), fields);
    CHECK(report::read_whole(file) == first);
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        auto changed = fields;
        changed[1].values(0, 3) = bad;
        CHECK_THROWS_WITH_AS(write_field(file, two_triangles(), changed),
                             "the field q is not finite at (1, 1)", base::FailedComputation);
    }
    CHECK_THROWS_WITH_AS(write_field(file, two_triangles(), {{"q", Eigen::MatrixXd::Zero(1, 3)}}),
                         "the field q has 3 columns for 4 particles", base::FailedComputation);
    CHECK_THROWS_WITH_AS(check_field_path("f.vtk"),
                         "--field f.vtk: the name must end with .vtu, for ParaView, or with .csv",
                         base::InvalidInput);
    CHECK(report::read_whole(file) == first);
    CHECK(folder.entries() == 1);
}
