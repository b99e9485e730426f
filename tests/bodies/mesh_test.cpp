#include "bodies/mesh.hpp"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "base/errors.hpp"

using namespace bodies;

namespace {

/// The unit square as n × n squares, each cut in two, some cells clockwise.
Mesh<2> square(int n) {
    Mesh<2> mesh{Points<2>(2, (n + 1) * (n + 1)), {}, {}};
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) mesh.x.col(j * (n + 1) + i) = Point<2>(i, j) / n;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const int a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
            mesh.cells.push_back({a, b, d});
            mesh.cells.push_back({a, d, c});
            if (j % 2 == 1) std::swap(mesh.cells.back()[0], mesh.cells.back()[1]);
        }
    return mesh;
}

/// Its sides, counter-clockwise from the lower one.
std::vector<Patch<2>> sides_of_square(int n) {
    std::vector<Patch<2>> sides{{1, {"bottom"}, {}}, {2, {"right"}, {}}, {3, {"top"}, {}}, {4, {"left"}, {}}};
    const int row = n + 1;
    for (int k = 0; k < n; ++k) {
        sides[0].facets.push_back({k, k + 1});
        sides[1].facets.push_back({k * row + n, (k + 1) * row + n});
        sides[2].facets.push_back({n * row + k + 1, n * row + k});
        sides[3].facets.push_back({(k + 1) * row, k * row});
    }
    return sides;
}

/// A fan of n triangles around the origin, with corners at the given angles.
Mesh<2> fan(const std::vector<double>& angles) {
    const auto n = static_cast<int>(angles.size());
    Mesh<2> mesh{Points<2>::Zero(2, n + 1), {}, {}};
    for (int k = 0; k < n; ++k) {
        const double angle = angles[static_cast<std::size_t>(k)];
        mesh.x.col(k) = Point<2>(std::cos(angle), std::sin(angle));
        mesh.cells.push_back({n, k, (k + 1) % n});
    }
    return mesh;
}

/// Tetrahedra from the origin to triangles on the unit sphere: those of an octahedron, each cut in four,
/// `cuts` times.
Mesh<3> ball(int cuts) {
    std::vector<Point<3>> x{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    std::vector<std::array<int, 3>> faces;
    for (const int a : {0, 1})
        for (const int b : {2, 3})
            for (const int c : {4, 5}) faces.push_back({a, b, c});
    for (; cuts > 0; --cuts) {
        std::map<std::array<int, 2>, int> halves;
        const auto half = [&](int a, int b) {
            const auto [found, is_new] =
                halves.insert({{std::min(a, b), std::max(a, b)}, static_cast<int>(x.size())});
            if (is_new)
                x.push_back((x[static_cast<std::size_t>(a)] + x[static_cast<std::size_t>(b)]).normalized());
            return found->second;
        };
        std::vector<std::array<int, 3>> finer;
        for (const auto& [a, b, c] : faces) {
            const int ab = half(a, b), bc = half(b, c), ca = half(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        faces = finer;
    }
    const auto n = static_cast<int>(x.size());
    Mesh<3> mesh{Points<3>::Zero(3, n + 1), {}, {}};
    for (int k = 0; k < n; ++k) mesh.x.col(k) = x[static_cast<std::size_t>(k)];
    for (const auto& [a, b, c] : faces) mesh.cells.push_back({a, b, c, n});
    return mesh;
}

std::vector<double> even_angles(int n) {
    std::vector<double> angles;
    for (int k = 0; k < n; ++k) angles.push_back(2 * std::acos(-1.0) * k / n);
    return angles;
}

template <int dim>
std::string refusal(const Mesh<dim>& mesh) {
    try {
        static_cast<void>(body_of(mesh));
    } catch (const base::InvalidInput& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE(
    "mesh: the sides of a square have outward normals, the body to their left, and its corners two places") {
    constexpr int n = 4;
    Mesh<2> mesh = square(n);
    mesh.patches = sides_of_square(n);
    const Body<2> body = body_of(mesh);
    CHECK(body.x.cols() == mesh.x.cols());
    CHECK(body.gap == 0);
    const std::vector<Point<2>> normals{{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
    REQUIRE(body.sides.size() == 4);
    for (std::size_t k = 0; k < 4; ++k) {
        const Side<2>& side = body.sides[k];
        CHECK(side.name == mesh.patches[k].sides[0]);
        CHECK(side.pieces.size() == n);
        REQUIRE(side.places.size() == n + 1);
        for (const Place<2>& place : side.places) CHECK((place.normal - normals[k]).norm() < 1e-15);
        for (const Piece<2>& piece : side.pieces)
            CHECK((particles::normal_at(piece, {}) - normals[k]).norm() < 1e-15);
    }
    for (const auto& [a, b, c] : body.cells)
        CHECK((body.x.col(b) - body.x.col(a)).x() * (body.x.col(c) - body.x.col(a)).y() -
                  (body.x.col(b) - body.x.col(a)).y() * (body.x.col(c) - body.x.col(a)).x() >
              0);
}

TEST_CASE("mesh: neighbours are near to each other in memory") {
    constexpr int n = 64;
    const Body<2> body = body_of(square(n));
    double sum = 0;
    for (const auto& [a, b, c] : body.cells) sum += std::abs(a - b) + std::abs(b - c) + std::abs(c - a);
    CHECK(sum / (3.0 * static_cast<double>(body.cells.size())) < 2 * n);
}

TEST_CASE("mesh: without names the boundary is one side, with two places at a corner") {
    const Body<2> body = body_of(square(3));
    REQUIRE(body.sides.size() == 1);
    CHECK(body.sides[0].name == "boundary");
    CHECK(body.sides[0].pieces.size() == 12);
    CHECK(body.sides[0].places.size() == 16);
}

TEST_CASE("mesh: nodes of no cell are left out, and the order of nodes does not matter") {
    Mesh<2> mesh = square(2);
    const Body<2> whole = body_of(mesh);
    for (auto& cell : mesh.cells)
        for (int& node : cell) node = 9 - node;
    mesh.x = (Points<2>(2, 11) << Point<2>(9, 9), mesh.x.rowwise().reverse(), Point<2>(7, 7)).finished();
    const Body<2> body = body_of(mesh);
    CHECK(body.x == whole.x);
    CHECK(body.cells == whole.cells);
}

TEST_CASE("mesh: normals from the pieces are exact on a circle with uneven pieces, and the gap is theirs") {
    const Body<2> body = body_of(fan({0, 0.3, 0.7, 1.3, 1.8, 2.4, 2.9, 3.5, 4, 4.4, 5, 5.6, 6}));
    for (const Place<2>& place : body.sides[0].places)
        CHECK((place.normal - body.x.col(place.particle)).norm() < 1e-14);
    CHECK(body.gap == doctest::Approx(1 - std::cos(0.3)).epsilon(0.01));
}

TEST_CASE("mesh: normals from the pieces are exact on a sphere, and the gap is that of its triangles") {
    const Mesh<3> mesh = ball(3);
    const Body<3> body = body_of(mesh);
    REQUIRE(body.sides[0].places.size() == 258);
    double gap = 0;
    for (const Place<3>& place : body.sides[0].places)
        CHECK((place.normal - body.x.col(place.particle)).norm() < 1e-14);
    for (const Triangle& piece : body.sides[0].pieces) {
        const auto& [a, b, c] = piece.corners;
        CHECK((b - a).cross(c - a).dot(a) > 0);
        gap = std::max(gap, 1 - a.dot((b - a).cross(c - a).normalized()));
    }
    CHECK(body.gap == doctest::Approx(gap).epsilon(0.05));
    for (const auto& cell : body.cells) {
        const Point<3> a = body.x.col(cell[0]);
        CHECK((body.x.col(cell[1]) - a).cross(body.x.col(cell[2]) - a).dot(body.x.col(cell[3]) - a) > 0);
    }
}

TEST_CASE(
    "mesh: normals of the shape go before those of the pieces, turned outward; where they cannot be, not") {
    Mesh<2> mesh = fan(even_angles(12));
    Patch<2> patch{1, {"rim"}, {}};
    for (int k = 0; k < 12; ++k) {
        patch.facets.push_back({k, (k + 1) % 12});
        const Point<2> near = mesh.x.col(k) + Point<2>(0.1, 0);
        patch.normals[k] = k % 2 == 0 ? near : Point<2>(-3 * near);
    }
    patch.normals[3] = Point<2>(1, 0);
    patch.normals[4] = Point<2>::Zero();
    mesh.patches = {patch};
    const Body<2> body = body_of(mesh);
    REQUIRE(body.sides[0].places.size() == 12);
    for (const auto& [particle, normal] : body.sides[0].places) {
        const Point<2> x = body.x.col(particle);
        const auto k = std::lround(std::atan2(x[1], x[0]) / std::acos(-1.0) * 6);
        const Point<2> shape = x + Point<2>(k == 3 || k == 4 ? 0 : 0.1, 0);
        CHECK((normal - shape.normalized()).norm() < 1e-14);
    }
}

TEST_CASE("mesh: a hexagon has two places at each corner, a polygon of 20 sides one") {
    CHECK(body_of(fan(even_angles(6))).sides[0].places.size() == 12);
    CHECK(body_of(fan(even_angles(20))).sides[0].places.size() == 20);
}

TEST_CASE("mesh: what is no body is refused with its place and a remedy") {
    Mesh<2> mesh = square(2);
    const auto patched = [&](std::vector<Patch<2>> patches) {
        Mesh<2> changed = mesh;
        changed.patches = std::move(patches);
        return refusal(changed);
    };
    CHECK(refusal(Mesh<2>{mesh.x, {}, {}}) ==
          "it has no triangles; a body in the plane is a surface with a mesh");
    auto sides = sides_of_square(2);
    sides[1].sides = sides[3].sides = {};
    CHECK(
        patched(sides) ==
        "the boundary at (0, 0.25) is in no Physical Curve; add it to one, such as Physical Curve(\"free\") = {2, 4};");
    sides = sides_of_square(2);
    sides.push_back({5, {"wall"}, {{0, 1}}});
    CHECK(patched(sides) ==
          "curve 5 at (0.25, 0) has two names, 'wall' and 'bottom'; leave it in one Physical Curve");
    CHECK(
        patched({{5, {"crack"}, {{1, 4}}}}) ==
        "the Physical Curve 'crack' lies inside the body at (0.5, 0.25): a body has no cracks and no interfaces; take curve 5 out of this group");
    CHECK(
        patched({{5, {"chord"}, {{0, 8}}}}) ==
        "the Physical Curve 'chord' borders no cell at (0.5, 0.5); take curve 5 out of this group, or add the part that it borders to the body");
    Mesh<2> changed = mesh;
    changed.x(1, 4) = std::nan("");
    CHECK(refusal(changed) == "a node lies at (0.5, nan); positions must be finite, remesh the body");
    changed.x.col(4) = Point<2>(0, 0);
    CHECK(refusal(changed) == "the cell at (0.166667, 0) has no area; remove it, or remesh the body");
    changed = mesh;
    changed.x = (Points<2>(2, 12) << mesh.x, Points<2>(mesh.x.middleCols(2, 3).colwise() + Point<2>(0.5, 0)))
                    .finished();
    changed.cells.push_back({9, 10, 11});
    changed.x.col(9) = Point<2>(1, 0);
    changed.x.col(10) = Point<2>(2, 0);
    changed.x.col(11) = Point<2>(1, 1);
    CHECK(refusal(changed).starts_with("two nodes lie at (1, 0): parts that touch must share their nodes"));
    changed.x.col(9) = Point<2>(0.9, 0.3);
    CHECK(refusal(changed).starts_with(
        "a node lies in a cell of other nodes, at (0.9, 0.3): parts that touch"));
    changed = mesh;
    changed.cells.push_back(changed.cells[3]);
    CHECK(
        refusal(changed) ==
        "cells overlap beside the facet at (0.5, 0.25); remove duplicate cells, or draw the union of the parts");
    CHECK(refusal(Mesh<2>{mesh.x, {mesh.cells[0], mesh.cells[0]}, {}})
              .starts_with("cells overlap beside the facet"));
}

TEST_CASE("mesh: tetrahedra that meet in crossed diagonals are refused, with the place") {
    // Two cubes beside each other, each of six tetrahedra around a diagonal; the second one may be a mirror
    // image.
    const auto two_cubes = [](bool mirrored) {
        Mesh<3> mesh{Points<3>(3, 12), {}, {}};
        for (int k = 0; k < 12; ++k) mesh.x.col(k) = Point<3>(k % 3, k / 3 % 2, k / 6);
        const std::array<int, 3> step{1, 3, 6};
        for (int cube = 0; cube < 2; ++cube) {
            const int first = cube == 1 && mirrored ? cube + step[1] : cube,
                      y = first == cube ? step[1] : -step[1];
            std::array<int, 3> ways{step[0], y, step[2]};
            std::sort(ways.begin(), ways.end());
            do
                mesh.cells.push_back(
                    {first, first + ways[0], first + ways[0] + ways[1], first + ways[0] + ways[1] + ways[2]});
            while (std::next_permutation(ways.begin(), ways.end()));
        }
        return mesh;
    };
    CHECK(body_of(two_cubes(false)).sides[0].pieces.size() == 20);
    const std::string refused = refusal(two_cubes(true));
    CHECK(refused.starts_with("behind the facet at (1, "));
    CHECK(refused.ends_with(" lies a cell that does not share it: cells must fit together; remesh the body"));
}
