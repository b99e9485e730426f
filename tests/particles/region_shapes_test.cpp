#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "particles/region_check.hpp"
#include "particles/region_rules.hpp"
#include "tests/support/regions.hpp"
#include "tests/support/relative.hpp"

// The quadrature rules on bodies that are not convex, bulge, or have many sides.

using namespace particles;
using support::area, support::area_in_disc, support::circle, support::integral, support::pi, support::polygon,
    support::rectangle;

namespace {

using Corners = std::vector<Point<2>>;

const Corners l_shape{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};

/// Two towers, 0.1 apart.
const Corners slit{{0, 0}, {2.1, 0}, {2.1, 2}, {1.1, 2}, {1.1, 0.5}, {1, 0.5}, {1, 2}, {0, 2}};

/// Largest error of the area of discs in a polygon. \return relative to the largest disc
double error(const Corners& corners, const Corners& places, const std::vector<double>& radii, Index n) {
    const Boundary boundary(polygon(corners));
    double worst = 0;
    for (const Point<2>& x : places)
        for (const double radius : radii)
            worst =
                std::max(worst, std::abs(area(boundary, x, radius, n) - area_in_disc(corners, x, radius)) /
                                    (pi * radius * radius));
    return worst;
}

/// Places in a polygon, on its sides and at its corners.
Corners places_in(const Corners& corners, int inside, unsigned seed) {
    support::Draws draw(seed);
    const Boundary boundary(polygon(corners));
    Corners places = corners;
    for (std::size_t k = 0; k < corners.size(); ++k)
        places.push_back((corners[k] + corners[(k + 1) % corners.size()]) / 2);
    while (inside > 0) {
        const Point<2> x = 2 * draw.point<2>();
        if (signed_distance(boundary, x) > -0.02) continue;
        places.push_back(x);
        --inside;
    }
    return places;
}

}  // namespace

TEST_CASE("region_shapes: at a re-entrant corner three quarters of a disc take all points, to round-off") {
    const Boundary boundary(polygon(l_shape));
    const auto rule = polar_rule(boundary, {1, 1}, 0.8, 10, 40);
    CHECK(rule.size() == 400);
    CHECK(integral(rule) == support::relative(0.75 * pi * 0.64, 1e-14));
    CHECK(integral(rule, [](const Point<2>& at) { return at[0] - 1; }) ==
          support::relative(-std::pow(0.8, 3) / 3, 1e-13));
}

TEST_CASE("region_shapes: discs in polygons that are not convex have the areas of triangles and sectors") {
    for (const Corners* corners : {&l_shape, &slit}) {
        const Corners places = places_in(*corners, 30, 5);
        CHECK(error(*corners, places, {0.3, 0.8, 1.5, 4}, 10) < 2e-3);
        CHECK(error(*corners, places, {0.3, 0.8, 1.5, 4}, 40) < 1e-6);
    }
    for (unsigned seed = 1; seed <= 8; ++seed) {
        CAPTURE(seed);
        const Corners corners = support::star(13, seed), places = places_in(corners, 10, seed);
        CHECK(error(corners, places, {0.2, 0.5, 3}, 10) < 2e-3);
        CHECK(error(corners, places, {0.2, 0.5, 3}, 40) < 1e-6);
    }
}

TEST_CASE("region_shapes: a disc sees the body on both sides of walls, slits and gaps") {
    // From a wall of the left tower: half a disc, and the segment of it that the gap leaves of the right one.
    const Boundary towers(polygon(slit));
    const auto beyond = [](double radius, double distance) {
        return radius * radius * std::acos(distance / radius) -
               distance * std::sqrt(radius * radius - distance * distance);
    };
    CHECK(area(towers, {1, 1.25}, 0.5, 30) == support::relative(pi * 0.125 + beyond(0.5, 0.1), 1e-8));
    CHECK(area(towers, {0.9, 1.25}, 0.5, 30) ==
          support::relative(pi * 0.25 - beyond(0.5, 0.1) + beyond(0.5, 0.2), 1e-6));
    const Boundary two(checked(support::together(rectangle({0, 0}, {1, 1}), rectangle({1.3, 0}, {2, 1})), 1));
    CHECK(area(two, {1, 0.5}, 0.4, 30) == support::relative(pi * 0.08 + beyond(0.4, 0.3), 1e-8));
}

TEST_CASE("region_shapes: discs, rings, lenses and rounded corners have their areas") {
    const Boundary disc(checked({circle({0.1, 0.2}, 1, true)}, 1));
    CHECK(polar_rule(disc, {0.1, 0.2}, 2, 10, 40).size() == 400);
    CHECK(area(disc, {0.1, 0.2}, 2, 10) == support::relative(pi, 1e-14));
    CHECK(area(disc, {0.1, 0.2}, 0.5, 10) == support::relative(pi / 4, 1e-14));
    CHECK(area(disc, {0.4, 0.5}, 3, 30) == support::relative(pi, 1e-9));
    CHECK(area(disc, {1.1, 0.2}, 3, 10) == support::relative(pi, 1e-13));
    // Two circles of radius 1 whose centres lie 1 apart share 2 π/3 − √3/2.
    for (const double angle : {0.0, 0.7, pi / 2, 3.0})
        CHECK(area(disc, Point<2>(0.1, 0.2) + direction(angle), 1, 30) ==
              support::relative(2 * pi / 3 - std::sqrt(0.75), 1e-9));
    const Boundary ring(checked({circle({0, 0}, 1, true), circle({0, 0}, 0.5, false)}, 1));
    for (const Point<2>& x : {Point<2>(0.5, 0), Point<2>(0, 1), Point<2>(-0.5, 0.5)})
        CHECK(area(ring, x, 3, 40) == support::relative(0.75 * pi, 1e-7));
    const Boundary half(checked({Segment{{-1, 0}, {1, 0}}, Arc{{0, 0}, 1, 0, pi}}, 1));
    for (const Point<2>& x : {Point<2>(0, 0), Point<2>(1, 0), Point<2>(0.3, 0), Point<2>(0, 1)})
        CHECK(area(half, x, 3, 30) == support::relative(pi / 2, 1e-9));
    // A square with rounded corners, and a bulge on one side and a notch in another.
    const Boundary rounded(checked(
        {Segment{{0.2, 0}, {0.4, 0}}, Arc{{0.5, 0}, 0.1, 0, pi}, Segment{{0.6, 0}, {0.8, 0}},
         Arc{{0.8, 0.2}, 0.2, -pi / 2, 0}, Segment{{1, 0.2}, {1, 0.4}}, Arc{{1, 0.5}, 0.1, -pi / 2, pi / 2},
         Segment{{1, 0.6}, {1, 0.8}}, Arc{{0.8, 0.8}, 0.2, 0, pi / 2}, Segment{{0.8, 1}, {0.2, 1}},
         Arc{{0.2, 0.8}, 0.2, pi / 2, pi}, Segment{{0, 0.8}, {0, 0.2}}, Arc{{0.2, 0.2}, 0.2, pi, 3 * pi / 2}},
        1));
    const double exact = 1 - 0.04 * (4 - pi);
    for (const Point<2>& x : {Point<2>(0.5, 0.5), Point<2>(1, 0.3), Point<2>(0.5, 0.1), Point<2>(1.1, 0.5),
                              Point<2>(0.2, 0), Point<2>(0.2, 0.2)})
        CHECK(area(rounded, x, 3, 40) == support::relative(exact, 1e-7));
}

TEST_CASE("region_shapes: the divergence theorem holds in discs that hold a body of any shape") {
    const Region stars = support::together(polygon(support::star(17, 3)),
                                           {circle({2, 0}, 0.5, true), circle({2.1, 0}, 0.2, false)});
    const Boundary boundary(checked(stars, 1));
    const auto flux = [](const Point<2>& at) {
        return Point<2>(std::sin(at[0] * at[1]), at[0] - at[1] * at[1]);
    };
    double outwards = 0;
    for (const Curve& curve : boundary.curves())
        for (const QuadraturePoint& at : boundary_rule(curve, {0, 0}, 9, 30))
            outwards += at.weight * flux(at.x).dot(at.normal);
    const auto rule = polar_rule(boundary, {0.01, 0.02}, 9, 30, 120);
    CHECK(integral(rule, [](const Point<2>& at) { return at[1] * std::cos(at[0] * at[1]) - 2 * at[1]; }) ==
          support::relative(outwards, 1e-6));
}

TEST_CASE("region_shapes: a side in one or in many pieces has the same rule") {
    Corners corners;
    for (std::size_t k = 0; k < l_shape.size(); ++k)
        for (int piece = 0; piece < 100; ++piece)
            corners.push_back(l_shape[k] + piece / 100.0 * (l_shape[(k + 1) % l_shape.size()] - l_shape[k]));
    const Boundary whole(polygon(l_shape)), cut(checked(polygon(corners), 1));
    for (const Point<2>& x :
         {Point<2>(0.5, 0.5), Point<2>(1, 1), Point<2>(0.255, 0), Point<2>(1, 1.5), Point<2>(2, 1)}) {
        const auto one = polar_rule(whole, x, 0.8, 5, 20), other = polar_rule(cut, x, 0.8, 5, 20);
        REQUIRE(one.size() == other.size());
        for (std::size_t k = 0; k < one.size(); ++k) {
            CHECK((one[k].x - other[k].x).norm() < 1e-13);
            CHECK(std::abs(one[k].weight - other[k].weight) < 1e-13);
        }
    }
    Region arcs;
    for (int k = 0; k < 40; ++k) arcs.emplace_back(Arc{{0, 0}, 1, pi * k / 20, pi * (k + 1) / 20});
    const Boundary disc(checked(arcs, 1));
    CHECK(polar_rule(disc, {0, 0}, 2, 5, 20).size() == 100);
    CHECK(polar_rule(disc, {1, 0}, 0.5, 5, 20).size() ==
          polar_rule(Boundary({circle({0, 0}, 1, true)}), {1, 0}, 0.5, 5, 20).size());
}

TEST_CASE("region_shapes: a polygon of 2000 sides has its area in discs of every size") {
    const Corners corners = support::regular(2000);
    const Boundary boundary(checked(polygon(corners), 1));
    for (const Point<2>& x : {Point<2>(0, 0), Point<2>(0.3, 0.2), corners[3]})
        for (const double radius : {0.003, 0.01, 0.1, 1.1, 2.5})
            CHECK(area(boundary, x, radius, 8) == support::relative(area_in_disc(corners, x, radius), 2e-5));
}

TEST_CASE("region_shapes: a place off the boundary by round-off, in or out, sees what the boundary sees") {
    // Corners between sides and arcs that turn in and out, and places on both.
    const Boundary boundary(checked({Segment{{0, 0}, {2, 0}}, Arc{{2, 0.5}, 0.5, -pi / 2, pi / 2},
                                     Segment{{2, 1}, {1, 1}}, Arc{{1, 1.5}, 0.5, -pi / 2, pi},
                                     Segment{{0.5, 1.5}, {0, 1.5}}, Arc{{0, 0.75}, 0.75, -pi / 2, pi / 2}},
                                    2));
    support::Draws draw(4);
    for (const Curve& curve : boundary.curves())
        for (const Point<2>& on : {ends(curve)[0], ends(curve)[1], closest(curve, {0.7, 0.8})})
            for (const double radius : {0.3, 1.0}) {
                const double exact = area(boundary, on, radius, 20);
                for (const double away : {1e-17, 1e-15, 1e-12, 1e-10, 1e-9}) {
                    const Point<2> beside = on + away * draw.point<2>();
                    CHECK(std::abs(area(boundary, beside, radius, 20) - exact) < 1e-3 * radius * radius);
                }
            }
}
