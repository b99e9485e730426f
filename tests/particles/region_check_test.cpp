#include "particles/region_check.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/errors.hpp"
#include "tests/clouds.hpp"

using namespace particles;

namespace {

const double pi = std::acos(-1.0);

/// The sides of a polygon through given corners.
Region polygon(const std::vector<Point<2>>& corners) {
    Region region;
    for (std::size_t k = 0; k < corners.size(); ++k)
        region.emplace_back(Segment{corners[k], corners[(k + 1) % corners.size()]});
    return region;
}

Region square() {
    return polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
}

Region quarter() {
    return {Segment{{0.4, 0}, {2, 0}}, Segment{{2, 0}, {2, 2}}, Segment{{2, 2}, {0, 2}},
            Segment{{0, 2}, {0, 0.4}}, Arc{{0, 0}, 0.4, 0, pi / 2}};
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
        for (const QuadraturePoint& at : boundary_rule(curve, {0, 0}, 100, 20))
            sum += at.weight * at.normal.dot(at.x) / 2;
    return sum;
}

void refuses(const Region& region, const std::string& why) {
    CAPTURE(why);
    CHECK_THROWS_WITH_AS(checked(region, 1), doctest::Contains(why.c_str()), base::InvalidInput);
}

}  // namespace

TEST_CASE("region_check: convex polygons with circular holes pass, in any order of their parts") {
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
    refuses({}, "a body without straight sides around it does not work yet");
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

TEST_CASE("region_check: what does not work yet is said") {
    const auto l_shape = polygon({{0, 0}, {1, 0}, {1, 0.5}, {0.5, 0.5}, {0.5, 1}, {0, 1}});
    refuses(l_shape, "bodies that are not convex do not work yet: the boundary turns inward at (0.5, 0.5)");
    refuses(turned(l_shape), "the boundary turns inward at (0.5, 0.5)");
    Region with_square_hole = polygon({{-1, -1}, {2, -1}, {2, 2}, {-1, 2}});
    for (const Curve& side : square()) with_square_hole.push_back(side);
    refuses(with_square_hole, "holes that have straight sides, do not work yet");
    const Region stadium{Segment{{0, 0}, {1, 0}}, Arc{{1, 0.5}, 0.5, -pi / 2, pi / 2},
                         Segment{{1, 1}, {0, 1}}, Segment{{0, 1}, {0, 0}}};
    refuses(stadium,
            "bodies with edges that bulge outward do not work yet: the arc of radius 0.5 around (1, 0.5)");
    refuses({Arc{{0, 0}, 1, 0, 2 * pi}}, "without straight sides");
}

TEST_CASE("region_check: a boundary that crosses itself or a hole is refused") {
    refuses(polygon({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), "the boundary crosses itself");
    std::vector<Point<2>> star;
    for (int k = 0; k < 5; ++k) star.emplace_back(std::cos(4 * pi * k / 5), std::sin(4 * pi * k / 5));
    refuses(polygon(star), "the boundary crosses itself");
    refuses(polygon({{0, 0}, {1, 0}, {2, 0}}), "the boundary encloses no area");
    Region hole = square();
    hole.emplace_back(Arc{{0.5, 0.9}, 0.2, 0, 2 * pi});
    refuses(hole, "lies beyond the arc of radius 0.2 around (0.5, 0.9)");
    Region outside = square();
    outside.emplace_back(Arc{{2.5, 0.5}, 0.2, 0, 2 * pi});
    refuses(outside, "lies beyond the side from (1, 0) to (1, 1)");
    Region two = square();
    two.emplace_back(Arc{{0.4, 0.5}, 0.2, 0, 2 * pi});
    two.emplace_back(Arc{{0.6, 0.5}, 0.2, 0, 2 * pi});
    refuses(two, "lies beyond the arc of radius 0.2");
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
