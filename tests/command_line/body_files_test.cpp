#include "command_line/body_files.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "base/errors.hpp"
#include "base/text.hpp"
#include "report/file.hpp"
#include "tests/support/folder.hpp"

using command_line::read_body;
using particles::Point;
using Sides = std::vector<bodies::Side<2>>;

namespace {

/// Two files in a folder of their own.
struct Files {
    support::Folder folder;
    std::string points, boundary;
    Files(const std::string& of_points, const std::string& of_boundary)
        : points(folder.path + "/nodes.csv"), boundary(folder.path + "/sides.csv") {
        report::write_whole(points, of_points);
        report::write_whole(boundary, of_boundary);
    }
};

command_line::BodyFromFiles read(const std::string& points, const std::string& boundary,
                                 std::optional<double> snap = {}) {
    const Files files(points, boundary);
    return read_body(files.points, files.boundary, snap);
}

/// What is said of the files, without their folder.
std::string refusal(const std::string& points, const std::string& boundary, std::optional<double> snap = {}) {
    const Files files(points, boundary);
    try {
        static_cast<void>(read_body(files.points, files.boundary, snap));
    } catch (const base::InvalidInput& error) {
        std::string message = error.what();
        for (auto at = message.find(files.folder.path); at != std::string::npos;
             at = message.find(files.folder.path))
            message.erase(at, files.folder.path.size() + 1);
        return message;
    }
    return "";
}

/// A row of numbers, with the digits given.
std::string row(const Point<2>& x, int digits = 17) {
    return base::shown(x[0], digits) + "," + base::shown(x[1], digits) + "\n";
}

/// (n + 1)² particles of the square from (0, 0) to (1, 1), where `holds`.
template <class Holds>
std::string grid(int n, const Holds& holds) {
    std::string text = "x,y\n";
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i)
            if (const Point<2> x = Point<2>(i, j) / n; holds(x)) text += row(x);
    return text;
}

std::string square_grid(int n) {
    return grid(n, [](const Point<2>&) { return true; });
}

const std::string square = R"(name,order,x,y
bottom,1,0,0
bottom,2,1,0
top,1,0,1
top,2,1,1
left,1,0,0
left,2,0,1
right,1,1,1
right,2,1,0
)";

}  // namespace

TEST_CASE("body_files: sides in any order and direction have the body to their left and outward normals") {
    const bodies::Body<2> body = read(square_grid(4), square).body;
    REQUIRE(body.sides.size() == 4);
    CHECK(body.gap == 0);
    CHECK(body.cells.empty());
    const std::vector<std::pair<std::string, Point<2>>> expected{
        {"bottom", {0, -1}}, {"top", {0, 1}}, {"left", {-1, 0}}, {"right", {1, 0}}};
    for (std::size_t k = 0; k < 4; ++k) {
        CHECK(body.sides[k].name == expected[k].first);
        REQUIRE(body.sides[k].pieces.size() == 1);
        CHECK((particles::normal_at(body.sides[k].pieces[0], {}) - expected[k].second).norm() < 1e-15);
        REQUIRE(body.sides[k].places.size() == 5);
        for (const auto& place : body.sides[k].places)
            CHECK((place.normal - expected[k].second).norm() < 1e-15);
    }
}

TEST_CASE("body_files: rows in any order, names in quotes, other columns, blanks and comments") {
    CHECK(
        read(
            square_grid(4),
            "# sides\nz,\"name\",y,x,order\n1,\"a b\",0,1,2\n1,\"a b\",0,0,1\n2,c,1,0,4\n2,c,0,0,5\n2,c,1,1,3.5\n2,c,0,1,-1\n")
            .body.sides[0]
            .name == "a b");
    CHECK(read("x y\n0 0\n1 0\n0.2 0.3\n0 1\n", "name order x y\nrim 3 0 1\nrim 1 0 0\nrim 2 1 0\n")
              .body.sides[0]
              .places.size() == 6);
}

TEST_CASE("body_files: a loop in a loop is a hole; an L has its corners; a side closes onto itself") {
    const std::string frame =
        "name,order,x,y\nhole,1,0.25,0.25\nhole,2,0.75,0.25\nhole,3,0.75,0.75\nhole,4,0.25,0.75\nrim,1,0,0\nrim,2,1,0\nrim,3,1,1\nrim,4,0,1\n";
    const auto outside = [](const Point<2>& x) { return (x.array() - 0.5).abs().maxCoeff() >= 0.25; };
    const Sides sides = read(grid(8, outside), frame).body.sides;
    REQUIRE(sides.size() == 2);
    CHECK(sides[0].places.size() == 16 + 4);
    CHECK(sides[1].places.size() == 32 + 4);
    for (const auto& piece : sides[0].pieces) {
        const Point<2> middle = particles::closest(piece, {0.5, 0.5});
        CHECK(particles::normal_at(piece, middle).dot(Point<2>(0.5, 0.5) - middle) > 0);
    }
    const std::string ell =
        "name,order,x,y\nrim,1,0,0\nrim,2,1,0\nrim,3,1,0.5\nrim,4,0.5,0.5\nrim,5,0.5,1\nrim,6,0,1\n";
    CHECK(read(grid(4, [](const Point<2>& x) { return x.minCoeff() <= 0.5; }), ell)
              .body.sides[0]
              .places.size() == 16 + 6);
}

TEST_CASE(
    "body_files: normals of a circle in pieces are exact at its places, and given ones go before them") {
    std::string points = "0,0\n0.5,0\n-0.5,0\n0,0.5\n0,-0.5\n", pieces, given;
    const double turn = 2 * std::acos(-1.0);
    for (int k = 0; k < 24; ++k) {
        const double angle = turn * (k + 0.2 * std::sin(k)) / 24;
        const Point<2> x(std::cos(angle), std::sin(angle));
        points += row(x);
        std::string line = "rim," + std::to_string(24 - k) + "," + row(x);
        pieces += line;
        line.back() = ',';
        given += line + row(3 * x + Point<2>(0.5, 0));
    }
    for (const bool with_normals : {false, true}) {
        const bodies::Body<2> body =
            read(points, "name,order,x,y" + (with_normals ? ",nx,ny\n" + given : "\n" + pieces)).body;
        REQUIRE(body.sides[0].places.size() == 24);
        for (const auto& [particle, normal] : body.sides[0].places) {
            const Point<2> x = body.x.col(particle), shape = with_normals ? 3 * x + Point<2>(0.5, 0) : x;
            CHECK((normal - shape.normalized()).norm() < 1e-12);
        }
        CHECK(body.gap > 0.5 * (1 - std::cos(turn / 48)));
    }
}

TEST_CASE(
    "body_files: what is rounded to six digits works where it is the same, and by --snap where it is not") {
    const double turned = 0.3;
    const auto turn = [&](const Point<2>& x) {
        return Point<2>(std::cos(turned) * x[0] - std::sin(turned) * x[1],
                        std::sin(turned) * x[0] + std::cos(turned) * x[1]);
    };
    std::string points;
    for (int j = 0; j <= 4; ++j)
        for (int i = 0; i <= 4; ++i) points += row(turn(Point<2>(i, j) / 4), 6);
    const std::vector<Point<2>> corners{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    std::string sides = "name,order,x,y\n";
    for (std::size_t k = 0; k < 4; ++k)
        for (const std::size_t end : {0U, 1U})
            sides += "s" + std::to_string(k) + "," + std::to_string(end) + "," +
                     row(turn(corners[(k + end) % 4]), 6);
    const std::string said = refusal(points, sides);
    REQUIRE(said.find("; try --snap ") != std::string::npos);
    const double snap = std::stod(said.substr(said.find("--snap ") + 7));
    CHECK(snap < 1e-5);
    const auto found = read(points, sides, snap);
    CHECK(found.moved > 0);
    CHECK(found.farthest < 1e-5);
    for (const auto& side : found.body.sides) CHECK(side.places.size() == 5);
    std::string wide = square;
    wide.replace(wide.find("top,1,0,1"), 9, "top,1,0,1.000001");
    CHECK(
        refusal(square_grid(4), wide) ==
        "--boundary: sides.csv, line 4: 'top,1,0,1.000001' is an open end of the boundary; the nearest end of another side, left, is 1e-06 away, in line 7; let them meet, or try --snap 1.1e-06");
    CHECK(read(square_grid(4), wide, 1.1e-6).body.sides.size() == 4);
}

TEST_CASE(
    "body_files: particles a little beside a curve of many pieces are moved by the distance that is named") {
    const double turn = 2 * std::acos(-1.0);
    std::string points = "0,0\n", sides = "name,order,x,y\n";
    for (int k = 0; k < 32; ++k) points += row(Point<2>(std::cos(turn * k / 32), std::sin(turn * k / 32)));
    for (int k = 0; k < 1000; ++k)
        sides += "rim," + std::to_string(k) + "," +
                 row(Point<2>(std::cos(turn * k / 1000), std::sin(turn * k / 1000)));
    const std::string said = refusal(points, sides);
    CAPTURE(said);
    REQUIRE(said.find("; try --snap ") != std::string::npos);
    const double snap = std::stod(said.substr(said.find("--snap ") + 7));
    CHECK(snap < 1e-5);
    const bodies::Body<2> body = read(points, sides, snap).body;
    CHECK(body.sides[0].places.size() == 32);
    for (const auto& [particle, normal] : body.sides[0].places)
        CHECK((normal - Point<2>(body.x.col(particle)).normalized()).norm() < 1e-5);
    for (const double none : {0.0, -1.0, std::nan("")})
        CHECK(refusal(points, sides, none).ends_with(" is no distance; it must be positive and finite"));
}

TEST_CASE("body_files: what is no boundary is refused with file and line") {
    const std::string points = square_grid(4);
    struct Case {
        std::string text, reason;
    };
    const std::string begin = "name,order,x,y\n", triangle = begin + "a,1,0,0\na,2,1,0\na,3,0,1\n";
    for (
        const auto& [text, reason] : std::vector<Case>{
            {"", "sides.csv has no rows; it needs name,order,x,y of each place"},
            {"name,x,y\na,0,0\n", "sides.csv has no column 'order'; it needs the header name,order,x,y"},
            {begin + "a,1,0\n", "line 2: 'a,1,0' needs name,order,x,y"},
            {begin + ",1,0,0\n", "line 2: ',1,0,0' needs name,order,x,y"},
            {begin + "a,1,zero,0\n", "line 2: 'zero' is no number"},
            {begin + "a,1,0,0\n",
             "line 2: 'a,1,0,0' is the only place of its side; a side needs two at least"},
            {begin + "a,1,0,0\na,1,1,0\n",
             "line 3: 'a,1,1,0' has the same order as line 2; number the places along the side"},
            {begin + "a,1,0,0\na,2,0,0\n", "line 3: 'a,2,0,0' repeats the place of line 2; leave one out"},
            {begin + "a,1,0,0\na,2,1,0\n",
             "line 2: 'a,1,0,0' begins a side of two places that meets no other side; add what closes the boundary"},
            {begin + "a,1,0,0\na,2,1,0\nb,1,1,0\nb,2,1,1\nb,3,0,1\n",
             "line 2: 'a,1,0,0' is an open end of the boundary; the nearest end of another side, b, is 1 away, in line 4; let them meet"},
            {begin + "a,1,0,0\na,2,1,1\na,3,1,0\na,4,0,1\n", "crosses"},
            {"name,order,x,y,nx\n" + triangle.substr(begin.size()),
             "sides.csv has one of nx and ny; give both or none"},
            {"name,order,x,y,nx,ny\na,1,0,0,0,0\na,2,1,0,1,0\na,3,0,1,0,1\n",
             "line 2: 'a,1,0,0,0,0' has a normal without length"},
            {"name,order,x,y,nx,ny\na,1,0,0,-1,-1\na,2,1,0,2,-1\na,3,0,1,1,-1\n",
             "line 4: 'a,3,0,1,1,-1' has a normal that points into the body or along its boundary; outward is (0.707107, 0.707107)"}}) {
        const std::string tried = text;
        CAPTURE(tried);
        const std::string said = refusal("0,0\n1,0\n0,1\n0.3,0.3\n", text);
        CAPTURE(said);
        CHECK(said.starts_with("--boundary: sides.csv"));
        CHECK(said.find(reason) != std::string::npos);
    }
}

TEST_CASE("body_files: particles that do not fit are refused with their file") {
    for (const auto& [points, reason] : std::vector<std::pair<std::string, std::string>>{
             {"", "--points: nodes.csv has no particle; at least two are needed, each on a line"},
             {"x,y,z\n0,0,0\n", ""},
             {square_grid(4) + "0.5,0.5\n", "particles 12 and 25 coincide at (0.5, 0.5)"},
             {square_grid(4) + "0.5,0.500000001\n",
              "particles 12 and 25 lie 1e-09 apart at (0.5, 0.5); leave one of them out"},
             {square_grid(4) + "0.5,1.1\n", "particle 25 at (0.5, 1.1) lies outside the body"},
             {"0.5,0.5\n0.2,0.5\n0.5,0.3\n", "has no particle"}}) {
        const std::string said = refusal(points, square);
        CAPTURE(said);
        if (!reason.empty()) CHECK(said.starts_with("--points: nodes.csv"));
        CHECK(said.find(reason) != std::string::npos);
    }
}
