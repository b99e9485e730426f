#include "particles/region_check.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/errors.hpp"
#include "particles/region_rules.hpp"
#include "tests/support/regions.hpp"

using namespace particles;
using support::circle, support::pi, support::polygon, support::star, support::together;

namespace {

Region square() {
    return polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
}

Region quarter() {
    return support::quarter(0.4, 2);
}

Region l_shape() {
    return polygon({{0, 0}, {1, 0}, {1, 0.5}, {0.5, 0.5}, {0.5, 1}, {0, 1}});
}

/// A rectangle with half a disc at its right end.
Region stadium() {
    return {Segment{{0, 0}, {1, 0}}, Arc{{1, 0.5}, 0.5, -pi / 2, pi / 2}, Segment{{1, 1}, {0, 1}},
            Segment{{0, 1}, {0, 0}}};
}

Region turned(Region region) {
    for (Curve& curve : region)
        if (auto* side = std::get_if<Segment>(&curve)) std::swap(side->from, side->to);
    return region;
}

/// Area by the divergence theorem, from the boundary's rules: positive if all normals point out.
double area(const Region& region) {
    double sum = 0;
    for (const Curve& curve : region)
        for (const QuadraturePoint& at : boundary_rule(curve, {0, 0}, 1000, 20))
            sum += at.weight * at.normal.dot(at.x) / 2;
    return sum;
}

void refuses(const Region& region, const std::string& why) {
    CAPTURE(why);
    CHECK_THROWS_WITH_AS(checked(region, 1), doctest::Contains(why.c_str()), base::InvalidInput);
}

}  // namespace

TEST_CASE("region_check: regions pass in any order of their parts") {
    CHECK(area(checked(square(), 1)) == doctest::Approx(1));
    CHECK(area(checked(quarter(), 2)) == doctest::Approx(4 - pi * 0.04));
    Region shuffled = quarter();
    std::swap(shuffled[0], shuffled[3]);
    std::swap(shuffled[1], shuffled[4]);
    CHECK(area(checked(shuffled, 2)) == doctest::Approx(4 - pi * 0.04));

    Region holes = polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
    holes.emplace_back(Arc{{1, 1}, 0.5, 0, 2 * pi});
    holes.emplace_back(Arc{{3, 2}, 0.7, 1, 1 + pi});
    holes.emplace_back(Arc{{3, 2}, 0.7, 1 + pi, 1 + 2 * pi});
    CHECK(area(checked(holes, 4)) == doctest::Approx(16 - pi * (0.25 + 0.49)));

    std::vector<Point<2>> corners;
    for (int k = 0; k < 500; ++k) corners.emplace_back(std::cos(pi * k / 250), std::sin(pi * k / 250));
    CHECK(area(checked(polygon(corners), 1)) == doctest::Approx(250 * std::sin(pi / 250)));
}

TEST_CASE("region_check: sides that run clockwise, all or one of them, are turned") {
    CHECK(area(turned(square())) == doctest::Approx(-1));
    CHECK(area(checked(turned(square()), 1)) == doctest::Approx(1));
    CHECK(area(checked(turned(quarter()), 2)) == doctest::Approx(4 - pi * 0.04));
    for (std::size_t k = 0; k < 4; ++k) {
        Region region = quarter();
        auto& side = std::get<Segment>(region[k]);
        std::swap(side.from, side.to);
        const Region found = checked(region, 2);
        CHECK(area(found) == doctest::Approx(4 - pi * 0.04));
        CHECK(std::get<Segment>(found[k]).from == std::get<Segment>(quarter()[k]).from);
    }
}

TEST_CASE("region_check: a boundary with a gap is refused, with its place") {
    for (std::size_t k = 0; k < 4; ++k) {
        Region region = square();
        region.erase(region.begin() + static_cast<std::ptrdiff_t>(k));
        refuses(region, "the boundary is not closed: the side from ");
    }
    Region open = square();
    std::get<Segment>(open[1]).to = {1, 0.99};
    refuses(
        open,
        "not closed: the side from (1, 0) to (1, 0.99) ends at (1, 0.99), and the nearest end of another side lies 0.01 from there, at (1, 1)");
    refuses({square().front()}, "the boundary is not closed");
    refuses({}, "a body without a boundary");
    Region twice = square();
    twice.push_back(twice.front());
    refuses(twice, "where 2 other ends of sides lie: a boundary passes a place once");
}

TEST_CASE("region_check: rounded ends meet up to 1e-8 of the size") {
    Region region = square();
    std::get<Segment>(region[1]).to += Point<2>(3e-9, -4e-9);
    CHECK_NOTHROW(checked(region, 1));
    std::get<Segment>(region[1]).to += Point<2>(3e-8, 0);
    refuses(region, "the boundary is not closed");
}

TEST_CASE("region_check: bodies that are not convex, or bulge, pass in any direction of their sides") {
    CHECK(area(checked(l_shape(), 1)) == doctest::Approx(0.75));
    CHECK(area(checked(turned(l_shape()), 1)) == doctest::Approx(0.75));
    CHECK(area(checked(stadium(), 1)) == doctest::Approx(1 + pi / 8));
    CHECK(area(checked(turned(stadium()), 1)) == doctest::Approx(1 + pi / 8));
    CHECK(area(checked({Arc{{0, 0}, 1, 0, 2 * pi}}, 1)) == doctest::Approx(pi));
    Region notched = l_shape();
    notched[2] = Arc{{0.75, 0.5}, 0.25, pi, 2 * pi};
    CHECK(area(checked(notched, 1)) == doctest::Approx(0.75 - pi / 32));
    notched[2] = Arc{{0.75, 0.5}, 0.25, 0, pi};
    CHECK(area(checked(notched, 1)) == doctest::Approx(0.75 + pi / 32));
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const auto corners = star(40, seed);
        CHECK(area(checked(polygon({corners.rbegin(), corners.rend()}), 1)) ==
              doctest::Approx(support::area_in_disc(corners, {0, 0}, 2)));
    }
}

TEST_CASE("region_check: holes of any shape, islands in holes and bodies in pieces find their sides") {
    const Region frame = polygon({{-1, -1}, {2, -1}, {2, 2}, {-1, 2}});
    CHECK(area(checked(together(frame, square()), 3)) == doctest::Approx(8));
    CHECK(area(checked(together(frame, turned(square())), 3)) == doctest::Approx(8));
    const Region island{circle({0.5, 0.5}, 0.3, false)}, lake{circle({0.5, 0.5}, 0.1, true)};
    CHECK(area(checked(together(together(lake, island), together(square(), frame)), 3)) ==
          doctest::Approx(8 + pi * (0.09 - 0.01)));
    CHECK(area(checked(together(square(), {circle({2.5, 0.5}, 0.2, false)}), 3)) ==
          doctest::Approx(1 + pi * 0.04));
    // The hole's first corner and one of the frame lie at one height, but for round-off.
    const Region wheel =
        together(polygon({{0.5, 3e-17}, {0, 0.3}, {-0.3, 0}}),
                 {Segment{{-2, -1}, {2, 0}}, Segment{{2, -1e-17}, {-2, 1}}, Segment{{-2, 1}, {-2, -1}}});
    CHECK(area(checked(wheel, 2)) == doctest::Approx(4 - 0.12));
    // Holes whose corners lie at one height with others, in two rows of a hundred.
    Region plate = polygon({{-1, -1}, {101, -1}, {101, 4}, {-1, 4}});
    for (int k = 0; k < 200; ++k) {
        const Point<2> low(k % 100 + 0.1, 2 * (k / 100));
        plate = together(plate, support::rectangle(low, low + Point<2>(0.5, 1)));
    }
    CHECK(area(checked(plate, 100)) == doctest::Approx(510 - 100));
}

TEST_CASE("region_check: a boundary that crosses or touches itself is refused") {
    refuses(
        polygon({{0, 0}, {1, 1}, {1, 0}, {0, 1}}),
        "the boundary crosses itself: the side from (0, 0) to (1, 1) and the side from (1, 0) to (0, 1) meet at (0.5, 0.5)");
    std::vector<Point<2>> corners;
    for (int k = 0; k < 5; ++k) corners.emplace_back(std::cos(4 * pi * k / 5), std::sin(4 * pi * k / 5));
    refuses(polygon(corners), "the boundary crosses itself");
    refuses(polygon({{0, 0}, {1, 0}, {2, 0}}), "the boundary encloses no area");
    const auto with_hole = [](const Point<2>& centre, double radius) {
        return together(square(), {circle(centre, radius, false)});
    };
    refuses(
        with_hole({0.5, 0.9}, 0.2),
        "the boundary crosses itself: the side from (1, 1) to (0, 1) and the arc of radius 0.2 around (0.5, 0.9) meet at (");
    refuses(with_hole({0.5, 0.8}, 0.2), "the boundary touches itself");
    refuses(with_hole({0.5, 0.8}, 0.2 + 1e-9), "the boundary touches itself");
    CHECK_NOTHROW(checked(with_hole({0.5, 0.8}, 0.2 - 1e-7), 1));
    refuses(together(with_hole({0.4, 0.5}, 0.2), {circle({0.6, 0.5}, 0.2, false)}),
            "the boundary crosses itself: the arc of radius 0.2");
    refuses(together(with_hole({0.3, 0.5}, 0.2), {circle({0.7, 0.5}, 0.2, false)}),
            "the boundary touches itself");
    // A corner on a side, a side on a side, a spike, and a loop through one of its corners again.
    refuses(polygon({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}),
            "the boundary touches itself: the side from (0, 0) to (2, 0)");
    refuses(together(square(), polygon({{1, 0.2}, {2, 0.2}, {2, 0.8}, {1, 0.8}})),
            "the boundary touches itself");
    refuses(polygon({{0, 0}, {1, 0}, {1, 1}, {1, 2}, {1, 1 + 1e-10}, {0, 1}}), "other ends of sides lie");
    refuses(polygon({{0, 0}, {1, 0}, {1, 2}, {1, 1.5}, {0, 1}}), "the boundary touches itself");
    refuses(together(square(), polygon({{1, 1}, {2, 1}, {2, 2}})), "a boundary passes a place once");
}

TEST_CASE("region_check: parts without meaning are refused") {
    Region region = square();
    region[0] = Segment{{0, 0}, {NAN, 0}};
    refuses(region, "needs two different, finite ends");
    region[0] = Segment{{0, 0}, {0, 0}};
    refuses(region, "needs two different, finite ends");
    Region hole = square();
    hole.emplace_back(Arc{{0.5, 0.5}, -0.2, 0, 2 * pi});
    refuses(hole, "needs a positive, finite radius");
    hole.back() = Arc{{0.5, 0.5}, 0.2, pi, 0};
    refuses(hole, "the smaller one comes first");
    CHECK_THROWS_AS(checked(square(), 0), base::InvalidInput);
    CHECK_THROWS_AS(checked(square(), NAN), base::InvalidInput);
}
