#include "meshes/gmsh.hpp"

#include <doctest/doctest.h>
#include <gmsh.h>
#include <omp.h>
#include <sys/wait.h>
#include <unistd.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <map>

#include "base/errors.hpp"
#include "report/file.hpp"
#include "tests/support/folder.hpp"

using bodies::Body;
using bodies::Side;
using particles::Point;

namespace {

/// A drawing in a folder of its own.
struct File {
    support::Folder folder;
    std::string path;
    explicit File(const std::string& text, const std::string& name = "body.geo")
        : path(folder.path + "/" + name) {
        report::write_whole(path, text);
    }
};

meshes::Model read(const std::string& text, std::optional<double> size = {},
                   const std::string& name = "body.geo") {
    return meshes::read(File(text, name).path, size);
}

template <int dim>
Body<dim> body(const std::string& text, double size) {
    return std::get<Body<dim>>(read(text, size).body);
}

/// What is said of a file, without its folder.
std::string refusal(const std::string& text, std::optional<double> size = {},
                    const std::string& name = "body.geo") {
    const File file(text, name);
    try {
        static_cast<void>(meshes::read(file.path, size));
    } catch (const base::InvalidInput& error) {
        std::string message = error.what();
        for (auto at = message.find(file.folder.path); at != std::string::npos;
             at = message.find(file.folder.path))
            message.erase(at, file.folder.path.size() + 1);
        return message;
    }
    return "";
}

/// The mesh of a drawing, in a file of Gmsh's.
std::string mesh_of(const std::string& drawing, int dim, double size, double order = 1,
                    double version = 4.1) {
    const File file(drawing);
    gmsh::initialize(0, nullptr, false);
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::open(file.path);
    gmsh::option::setNumber("Mesh.MeshSizeMax", size);
    gmsh::option::setNumber("Mesh.ElementOrder", order);
    gmsh::option::setNumber("Mesh.MshFileVersion", version);
    gmsh::model::mesh::generate(dim);
    gmsh::write(file.folder.path + "/mesh.msh");
    gmsh::finalize();
    return report::read_whole(file.folder.path + "/mesh.msh");
}

template <int dim>
const Side<dim>& side(const Body<dim>& of, const std::string& name) {
    for (const Side<dim>& one : of.sides)
        if (one.name == name) return one;
    FAIL("no side " << name);
    return of.sides.front();
}

/// The normals of a side's places are unit, and those that a function of the place gives.
template <int dim, class Normal>
void check_normals(const Body<dim>& of, const Side<dim>& one, const Normal& normal, double tolerance) {
    CHECK(!one.places.empty());
    for (const auto& [particle, found] : one.places)
        CHECK((found - Point<dim>(normal(Point<dim>(of.x.col(particle))))).norm() < tolerance);
}

const std::string square = R"(SetFactory("OpenCASCADE");
Rectangle(1) = {0, 0, 0, 2, 1};
Physical Curve("bottom") = {1};
Physical Curve("right") = {2};
Physical Curve("top") = {3};
Physical Curve("left") = {4};
)";

const std::string all = "Physical Surface(1) = {1};\n";

/// A quarter plate with a hole by Gmsh's own kernel.
const std::string plate = R"(Point(1) = {0, 0, 0, 0.1};
Point(2) = {1, 0, 0, 0.1};
Point(3) = {3, 0, 0, 0.5};
Point(4) = {3, 3, 0, 0.5};
Point(5) = {0, 3, 0, 0.5};
Point(6) = {0, 1, 0, 0.1};
Line(1) = {2, 3};
Line(2) = {3, 4};
Line(3) = {4, 5};
Line(4) = {5, 6};
Circle(5) = {6, 1, 2};
Curve Loop(1) = {1, 2, 3, 4, 5};
Plane Surface(1) = {1};
Physical Curve("symmetry") = {1, 4};
Physical Curve("far") = {2, 3};
Physical Curve("hole") = {5};
)";

const std::string ell = R"(Point(1) = {0, 0, 0};
Point(2) = {2, 0, 0};
Point(3) = {2, 1, 0};
Point(4) = {1, 1, 0};
Point(5) = {1, 2, 0};
Point(6) = {0, 2, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 1};
Curve Loop(1) = {1:6};
Plane Surface(1) = {1};
)";

const std::string cylinder = R"(SetFactory("OpenCASCADE");
Cylinder(1) = {0, 0, 0, 0, 0, 2, 1};
Physical Surface("mantle") = {1};
Physical Surface("ends") = {2, 3};
)";

}  // namespace

TEST_CASE("gmsh: a rectangle has the sides and the size that are asked for, whatever sizes it draws") {
    const Body<2> coarse = body<2>(square, 0.25);
    CHECK(coarse.sides.size() == 4);
    CHECK(side(coarse, "bottom").pieces.size() == 8);
    CHECK(side(coarse, "right").places.size() == 5);
    check_normals(
        coarse, side(coarse, "left"), [](const Point<2>&) { return Point<2>(-1, 0); }, 1e-14);
    CHECK(coarse.gap == 0);
    for (const char* sizes :
         {"MeshSize {:} = 0.02;\n", "Mesh.MeshSizeMax = 0.01;\n", "Mesh.MeshSizeFactor = 0.1;\n",
          "Transfinite Curve {1:4} = 50;\n",
          "Field[1] = MathEval; Field[1].F = \"0.02\"; Background Field = 1;\n", "Mesh.ElementOrder = 2;\n",
          "Mesh 2;\n", "Mesh.Algorithm = 8;\nMesh.RecombineAll = 1;\n", "Mesh.SubdivisionAlgorithm = 1;\n",
          "General.NumThreads = 8;\n"}) {
        CAPTURE(sizes);
        CHECK(body<2>(square + sizes, 0.25).x == coarse.x);
    }
}

TEST_CASE("gmsh: the same file gives the same particles again, and threads stay as they were") {
    const int threads = omp_get_max_threads();
    const Body<2> first = body<2>(plate, 0.2), second = body<2>(plate, 0.2);
    CHECK(omp_get_max_threads() == threads);
    CHECK(first.x == second.x);
    CHECK(first.cells == second.cells);
}

TEST_CASE("gmsh: without a size those of the drawing hold") {
    const auto drawn = std::get<Body<2>>(read(plate).body);
    CHECK(side(drawn, "hole").pieces.size() == 16);
    CHECK(side(drawn, "far").pieces.size() == 12);
}

TEST_CASE("gmsh: normals of a drawn circle are exact, its ends included, and the corners have two places") {
    for (const double size : {1.0, 0.3}) {
        const Body<2> quarter = body<2>(plate, size);
        check_normals(
            quarter, side(quarter, "hole"), [](const Point<2>& x) { return Point<2>(-x.normalized()); },
            1e-10);
        const auto pieces = static_cast<double>(side(quarter, "hole").pieces.size());
        CHECK(quarter.gap == doctest::Approx(1 - std::cos(std::acos(-1.0) / 4 / pieces)).epsilon(0.15));
        const auto count = side(quarter, "far").pieces.size();
        CHECK(side(quarter, "far").places.size() == count + 2);
    }
}

TEST_CASE("gmsh: a mesh has the drawing's sides and nearly its normals, in old files and new ones") {
    const auto old = std::get<Body<2>>(read(mesh_of(plate + all, 2, 0.2, 1, 2.2), {}, "body.msh").body),
               now = std::get<Body<2>>(read(mesh_of(plate + all, 2, 0.2, 1, 4.1), {}, "body.msh").body);
    CHECK((old.x - now.x).norm() < 1e-12);
    CHECK(old.cells == now.cells);
    for (const Body<2>& one : {old, now}) {
        CHECK(one.sides.size() == 3);
        CHECK(side(one, "hole").pieces.size() == 16);
        CHECK(side(one, "hole").places.size() == 17);
        check_normals(
            one, side(one, "hole"), [](const Point<2>& x) { return Point<2>(-x.normalized()); }, 0.05);
    }
}

TEST_CASE("gmsh: elements of second order count by their corners, quadrangles are cut in two") {
    const auto [second, notes] = read(mesh_of(square + all, 2, 0.25, 2), {}, "body.msh");
    const auto first = std::get<Body<2>>(read(mesh_of(square + all, 2, 0.25), {}, "body.msh").body);
    CHECK(std::get<Body<2>>(second).x == first.x);
    CHECK(notes == std::vector<std::string>{"Elements of second order or higher count by their corners"});
    const auto cut = std::get<Body<2>>(
        read(mesh_of(square + all + "Mesh.RecombineAll = 1;\n", 2, 0.25), {}, "body.msh").body);
    double area = 0;
    for (const auto& [a, b, c] : cut.cells) {
        const Point<2> ab = cut.x.col(b) - cut.x.col(a), ac = cut.x.col(c) - cut.x.col(a);
        area += (ab[0] * ac[1] - ab[1] * ac[0]) / 2;
    }
    CHECK(area == doctest::Approx(2));
}

TEST_CASE("gmsh: an L without names is one side with two places at each of its six corners") {
    const Body<2> one = body<2>(ell, 0.25);
    REQUIRE(one.sides.size() == 1);
    CHECK(one.sides[0].name == "boundary");
    CHECK(one.sides[0].pieces.size() == 32);
    CHECK(one.sides[0].places.size() == 32 + 6);
}

TEST_CASE(
    "gmsh: in space a cube's corners have a place for each face; a cylinder, a cone and a ball have their normals") {
    const Body<3> cube = body<3>("SetFactory(\"OpenCASCADE\");\nBox(1) = {0, 0, 0, 1, 1, 1};\n", 0.5);
    std::map<int, int> places;  // of each particle
    for (const auto& [particle, normal] : cube.sides[0].places) {
        ++places[particle];
        CHECK(std::abs(normal.cwiseAbs().maxCoeff() - 1) < 1e-12);
    }
    for (const auto& [particle, count] : places) {
        const Point<3> x = cube.x.col(particle);
        CHECK(count == (x.array() < 1e-9).count() + (x.array() > 1 - 1e-9).count());
    }
    const Body<3> round = body<3>(cylinder, 0.4);
    check_normals(
        round, side(round, "mantle"), [](const Point<3>& x) { return Point<3>(x[0], x[1], 0).normalized(); },
        1e-10);
    check_normals(
        round, side(round, "ends"), [](const Point<3>& x) { return Point<3>(0, 0, x[2] > 1 ? 1 : -1); },
        1e-10);
    const Body<3> cone = body<3>(
        "SetFactory(\"OpenCASCADE\");\nCone(1) = {0, 0, 0, 0, 0, 1, 0.5, 0};\nPhysical Surface(\"mantle\") = {1};\nPhysical Surface(\"floor\") = {2};\n",
        0.3);
    for (const auto& [particle, normal] : side(cone, "mantle").places) {
        const Point<3> x = cone.x.col(particle);
        const double r = x.head<2>().norm();
        if (r > 1e-9) CHECK((normal - Point<3>(2 * x[0] / r, 2 * x[1] / r, 1).normalized()).norm() < 1e-10);
        CHECK(normal[2] > 0);
    }
    const Body<3> ball = body<3>("SetFactory(\"OpenCASCADE\");\nSphere(1) = {0, 0, 0, 1};\n", 0.4);
    check_normals(
        ball, ball.sides[0], [](const Point<3>& x) { return Point<3>(x.normalized()); }, 1e-10);
}

TEST_CASE("gmsh: of several surfaces those in groups count, as one material; others are left out") {
    const std::string three = R"(SetFactory("OpenCASCADE");
Rectangle(1) = {0, 0, 0, 1, 1};
Rectangle(2) = {1, 0, 0, 1, 1};
Rectangle(3) = {2, 0, 0, 1, 1};
Coherence;
Physical Surface("steel") = {1};
Physical Surface("iron") = {2};
Physical Point("origin") = {1};
)";
    const auto [two, notes] = read(three, 0.5);
    CHECK(std::get<Body<2>>(two).x.row(0).maxCoeff() == 2);
    CHECK(notes == std::vector<std::string>{"The Physical Point 'origin' is no side",
                                            "What is in no Physical Surface is left out",
                                            "Of one material: steel, iron"});
}

TEST_CASE("gmsh: groups without names have their numbers, and two parts may be apart") {
    const Body<2> apart = body<2>(
        "SetFactory(\"OpenCASCADE\");\nRectangle(1) = {0, 0, 0, 1, 1};\nRectangle(2) = {2, 0, 0, 1, 1};\nPhysical Curve(7) = {1:8};\n",
        0.5);
    CHECK(apart.sides[0].name == "7");
}

TEST_CASE("gmsh: what cannot be read or meshed is refused in one line, in Gmsh's words") {
    CHECK(
        refusal("Point(1) = {0, 0, 0};\nPoint(2) = {1, 0, 0}\nLine(1) = {1, 2};\n") ==
        "body.geo: Gmsh cannot read it: 'body.geo', line 3: syntax error (Line); correct it there, gmsh body.geo shows it");
    CHECK(
        refusal(ell.substr(0, ell.find("Curve Loop")) + "Curve Loop(1) = {1:5};\nPlane Surface(1) = {1};\n",
                0.5)
            .starts_with("body.geo: Gmsh cannot mesh it: The 1D mesh seems not to be forming a closed loop"));
    CHECK(refusal("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n", {}, "body.msh")
              .starts_with("body.msh: Gmsh cannot read it: Error loading 'body.msh'"));
    CHECK(refusal("Merge \"part.step\";\n").find("Unable to open file 'part.step'") != std::string::npos);
    for (const char* text : {"", "Point(1) = {0, 0, 0};\nPoint(2) = {1, 0, 0};\nLine(1) = {1, 2};\n"})
        CHECK(refusal(text) ==
              "body.geo: it has no surface and no volume; a body needs a Plane Surface or a Volume");
    CHECK_THROWS_WITH_AS(static_cast<void>(meshes::read("/nowhere/body.geo")),
                         "cannot read /nowhere/body.geo: No such file or directory", base::InvalidInput);
    CHECK_THROWS_WITH_AS(static_cast<void>(meshes::read("/tmp")), "/tmp is a folder; name a file in it",
                         base::InvalidInput);
}

TEST_CASE("gmsh: a script that says Exit ends the program with an error and a line that says so") {
    const File file("Exit;\n");
    const std::string said = file.folder.path + "/said";
    const pid_t child = fork();
    if (child == 0) {
        if (std::freopen(said.c_str(), "w", stderr) != nullptr) static_cast<void>(meshes::read(file.path));
        _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    CHECK(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 2);
    CHECK(report::read_whole(said) ==
          file.path + " says Exit, which ends the program that reads it; remove that line\n");
}

TEST_CASE("gmsh: a size that cannot be is refused with one that can") {
    CHECK(refusal(square, 0) == "--size 0 is not positive and finite");
    CHECK(refusal(square, -1) == "--size -1 is not positive and finite");
    CHECK(refusal(square, std::nan("")) == "--size nan is not positive and finite");
    CHECK(refusal(square, 1e-5) ==
          "--size 1e-05 gives about 2.3e+10 particles, more than 5 million; take 0.00075");
    CHECK(refusal(mesh_of(square + all, 2, 0.5), 0.1, "body.msh") ==
          "body.msh: it is a mesh, whose nodes are the particles; leave out --size, or give the drawing");
}

TEST_CASE("gmsh: a size is judged by the area, not by the box around it") {
    const std::string diagonal =
        "Point(1) = {0, 0, 0};\nPoint(2) = {1, 0.999, 0};\nPoint(3) = {1, 1, 0};\nLine(1) = {1, 2};\nLine(2) = {2, 3};\nLine(3) = {3, 1};\nCurve Loop(1) = {1:3};\nPlane Surface(1) = {1};\n";
    CHECK(refusal(diagonal, 4e-4).empty());
}

TEST_CASE("gmsh: meshes of another dimension and other cells are refused") {
    for (const double version : {2.2, 4.1})
        CHECK(
            refusal(mesh_of(square, 2, 0.5, 1, version), {}, "body.msh") ==
            "body.msh: it has no triangles and no tetrahedra; of a drawing with physical groups, Gmsh writes these only: add a Physical Surface or Volume to the drawing");
    CHECK(
        refusal(
            "SetFactory(\"OpenCASCADE\");\nRectangle(1) = {0, 0, 0, 1, 1};\nRotate {{1, 0, 0}, {0, 0, 0}, Pi/4} {Surface{1};}\n",
            0.5)
            .find("its surface lies between z = 0 and 0.707107; a body in the plane has one z") !=
        std::string::npos);
    CHECK(
        refusal(ell + "Recombine Surface {1};\nExtrude {0, 0, 1} {Surface{1}; Layers{2}; Recombine;}\n")
            .find(
                "it has elements of the type Hexahedron 8; mesh the volume by tetrahedra, without Recombine") !=
        std::string::npos);
}

TEST_CASE("gmsh: names that do not fit are refused with the curve and what to do") {
    CHECK(
        refusal(square.substr(0, square.find("Physical Curve(\"top\")")), 0.5) ==
        "body.geo: the boundary at (0, 0.25) is in no Physical Curve; add it to one, such as Physical Curve(\"free\") = {3, 4};");
    CHECK(refusal(square + "Physical Curve(\"lid\") = {3};\n", 0.5).find("curve 3 at (") !=
          std::string::npos);
    CHECK(refusal(R"(SetFactory("OpenCASCADE");
Rectangle(1) = {0, 0, 0, 1, 1};
Rectangle(2) = {1, 0, 0, 1, 1};
Coherence;
Physical Curve("glue") = {2};
)",
                  0.5)
              .starts_with("body.geo: the Physical Curve 'glue' lies inside the body at (1, "));
    CHECK(
        refusal(
            "SetFactory(\"OpenCASCADE\");\nRectangle(1) = {0, 0, 0, 1, 1};\nRectangle(2) = {1, 0, 0, 1, 1};\n",
            0.5)
            .starts_with("body.geo: two nodes lie at (1, "));
}
