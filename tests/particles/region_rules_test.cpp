#include "particles/region_rules.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>

#include "tests/support/clouds.hpp"
#include "tests/support/regions.hpp"
#include "tests/support/relative.hpp"

using namespace particles;
using support::area, support::Function, support::integral, support::pi, support::quarter, support::rectangle;

namespace {

const double reach = 0.8;

/// All of the plane that matters, but for a circular hole around the origin.
Region with_hole(double b) {
    Region region = rectangle({-9, -9}, {9, 9});
    region.emplace_back(support::circle({0, 0}, b, false));
    return region;
}

/// Area of what a chord at a distance from the centre cuts off.
double segment(double radius, double distance) {
    return radius * radius * std::acos(distance / radius) -
           distance * std::sqrt(radius * radius - distance * distance);
}

/// Area that two circles share. \param a, b radii \param apart distance of the centres
double lens(double a, double b, double apart) {
    const double chord = (apart * apart + a * a - b * b) / (2 * apart);
    return segment(a, chord) + segment(b, apart - chord);
}

/// The error of an area must fall to `final` as the number of points doubles from 4 to 64, and never rise:
/// but for the ten digits of GSL's rules of many points.
void check_converges(const Region& region, const Point<2>& x, double radius, double exact, double final) {
    constexpr double digits = 3e-10;
    double last = HUGE_VAL;
    for (const Index n : {4, 8, 16, 32, 64}) {
        CAPTURE(n);
        const double error = std::abs(area(region, x, radius, n) - exact) / exact;
        CHECK(error < std::max(last, digits));
        last = error;
    }
    CHECK(last < final);
}

}  // namespace

TEST_CASE(
    "region_rules: a whole disc has as many points as asked for, with the area of the disc and its moments") {
    const Region region = rectangle({-9, -9}, {9, 9});
    const Point<2> x(0.3, -0.2);
    for (const Index n : {1, 2, 5, 10}) {
        const auto rule = polar_rule(region, x, reach, n, 4 * n);
        CHECK(rule.size() == static_cast<std::size_t>(4 * n * n));
        CHECK(integral(rule) == support::relative(pi * reach * reach, 1e-14));
    }
    const auto rule = polar_rule(region, x, reach, 10, 40);
    CHECK(integral(rule, [](const Point<2>& at) { return at[0]; }) ==
          support::relative(pi * reach * reach * 0.3, 1e-13));
    CHECK(integral(rule, [&](const Point<2>& at) { return (at - x).squaredNorm(); }) ==
          support::relative(pi * std::pow(reach, 4) / 2, 1e-14));
    CHECK(integral(rule, [&](const Point<2>& at) { return std::pow(at[1] - x[1], 4); }) ==
          support::relative(pi * std::pow(reach, 6) / 8, 1e-13));
    CHECK(polar_rule(region, x, reach, 3, 7).size() == 21);
}

TEST_CASE("region_rules: a disc that touches a side is whole") {
    const Region region = rectangle({0, 0}, {9, 9});
    CHECK(polar_rule(region, {reach, 4}, reach, 5, 20).size() == 100);
    CHECK(area(region, {reach, reach}, reach, 5) == support::relative(pi * reach * reach, 1e-14));
}

TEST_CASE(
    "region_rules: half a disc at a side and a quarter at a corner take all points, with area and moments") {
    const Region region = rectangle({0, 0}, {9, 9});
    const auto half = polar_rule(region, {4, 0}, reach, 10, 40);
    CHECK(half.size() == 400);
    CHECK(integral(half) == support::relative(pi * reach * reach / 2, 1e-14));
    CHECK(integral(half, [](const Point<2>& at) { return at[1]; }) ==
          support::relative(2 * std::pow(reach, 3) / 3, 1e-14));
    const auto corner = polar_rule(region, {9, 9}, reach, 10, 40);
    CHECK(corner.size() == 400);
    CHECK(integral(corner) == support::relative(pi * reach * reach / 4, 1e-14));
    CHECK(integral(corner, [](const Point<2>& at) { return (9 - at[0]) * (9 - at[1]); }) ==
          support::relative(std::pow(reach, 4) / 8, 1e-14));
}

TEST_CASE("region_rules: a disc cut by a side, near and far, is its area without the segment") {
    const Region region = rectangle({0, 0}, {9, 9});
    for (const double distance : {0.7, 0.4, 0.1}) {
        CAPTURE(distance);
        const double exact = pi * reach * reach - segment(reach, distance);
        check_converges(region, {distance, 4}, reach, exact, 1e-9);
        check_converges(region, {4, 9 - distance}, reach, exact, 1e-9);
    }
    // Very near, the far ends of the rays run along the side: slower.
    check_converges(region, {0.01, 4}, reach, pi * reach * reach - segment(reach, 0.01), 2e-4);
}

TEST_CASE("region_rules: the first moment of a disc that a side cuts") {
    const double distance = 0.5, half_chord = std::sqrt(reach * reach - distance * distance);
    const auto rule = polar_rule(rectangle({0, 0}, {9, 9}), {distance, 4}, reach, 24, 96);
    CHECK(integral(rule, [&](const Point<2>& at) { return at[0] - distance; }) ==
          support::relative(2 * std::pow(half_chord, 3) / 3, 1e-9));
}

TEST_CASE("region_rules: a disc cut by two sides, with their corner inside and outside of it") {
    const Region region = rectangle({0, 0}, {9, 9});
    const auto strip = [](double d) {  // of a quarter of the disc, d wide
        return (d * std::sqrt(reach * reach - d * d) + reach * reach * std::asin(d / reach)) / 2;
    };
    for (const auto& [d1, d2] : {std::pair{0.3, 0.4}, {0.1, 0.7}, {0.5, 0.5}}) {
        const double exact = pi * reach * reach / 4 + strip(d1) + strip(d2) + d1 * d2;
        check_converges(region, {d1, d2}, reach, exact, 1e-9);
        check_converges(region, {9 - d2, d1}, reach, exact, 1e-9);
    }
    check_converges(region, {0.7, 0.6}, reach, pi * reach * reach - segment(reach, 0.7) - segment(reach, 0.6),
                    1e-9);
}

TEST_CASE("region_rules: parallel sides, a body within the disc, and a triangle") {
    check_converges(rectangle({0, -0.5}, {9, 0.5}), {4, 0.1}, reach,
                    pi * reach * reach - segment(reach, 0.4) - segment(reach, 0.6), 1e-9);
    check_converges(rectangle({0, 0}, {1, 0.2}), {0.5, 0.1}, 3, 0.2, 1e-9);
    check_converges(rectangle({0, 0}, {1, 0.2}), {0, 0}, 3, 0.2, 1e-9);
    const Region triangle{Segment{{0, 0}, {3, 0}}, Segment{{3, 0}, {0, 4}}, Segment{{0, 4}, {0, 0}}};
    check_converges(triangle, {1, 1}, 10, 6, 1e-9);  // from the centre of the inscribed circle
    const double angle = std::atan2(4, 3);
    CHECK(area(triangle, {3, 0}, 1, 8) == support::relative(angle / 2, 1e-14));
}

TEST_CASE(
    "region_rules: a disc that a hole cuts, from outside, with and without tangents, is its area without the lens") {
    const double b = 0.5;
    const Region region = with_hole(b);
    // Where the rays that touch the hole end as they do, at sqrt(b² + reach²) = 0.943, a narrow piece
    // converges slowly.
    for (const auto& [away, final] : {std::pair{0.52, 1e-9},
                                      {0.7, 1e-9},
                                      {0.9, 1e-9},
                                      {0.943, 1e-6},
                                      {0.95, 1e-6},
                                      {1.1, 1e-9},
                                      {1.25, 1e-9}}) {
        const double apart = away;  // clang++ 14 captures no bindings
        CAPTURE(apart);
        const double exact = pi * reach * reach - lens(reach, b, away);
        for (const double angle : {0.0, 0.7, 2.0, -1.0})
            check_converges(region, away * direction(angle), reach, exact, final);
    }
}

TEST_CASE("region_rules: a disc around a place on the hole") {
    for (const double b : {0.41, 0.5, 2.0}) {
        CAPTURE(b);
        const double exact = pi * reach * reach - lens(reach, b, b);
        for (const double angle : {0.0, 0.4, pi / 2, -3.0})
            check_converges(with_hole(b), b * direction(angle), reach, exact, 1e-9);
    }
}

TEST_CASE("region_rules: a hole within the disc") {
    for (const double away : {0.3, 0.45})
        check_converges(with_hole(0.25), {away, 0.1}, reach, pi * (reach * reach - 0.0625), 1e-7);
    check_converges(with_hole(0.25), {0, 0.25}, reach, pi * (reach * reach - 0.0625), 1e-9);
}

TEST_CASE("region_rules: the first moment of a disc that a hole cuts") {
    const double b = 0.5;
    for (const double away : {0.5, 0.7, 1.1}) {
        CAPTURE(away);
        // The moment of the lens about the hole's centre: the two segments' own moments cancel.
        const double chord = (away * away + reach * reach - b * b) / (2 * away);
        const double exact = away * (pi * reach * reach - segment(reach, chord));
        const auto rule = polar_rule(with_hole(b), {0, away}, reach, 48, 192);
        CHECK(integral(rule, [](const Point<2>& at) { return at[1]; }) == support::relative(exact, 1e-7));
        CHECK(std::abs(integral(rule, [](const Point<2>& at) { return at[0]; })) < 1e-7);
    }
}

TEST_CASE("region_rules: at a symmetry axis of a plate with a hole it is one half") {
    const double b = 0.5;
    const double radius = 0.6;  // short of the other axis
    for (const double away : {0.5, 0.6, 0.9, 1.0}) {
        CAPTURE(away);
        const double exact = (pi * radius * radius - lens(radius, b, away)) / 2;
        check_converges(quarter(b, 4), {away, 0}, radius, exact, 1e-7);
        check_converges(quarter(b, 4), {0, away}, radius, exact, 1e-7);
    }
}

TEST_CASE(
    "region_rules: anywhere in a quarter plate with a hole, area and first moments are those of slices") {
    const double b = 0.4, side = 1.5;
    const Region region = quarter(b, side);
    support::Draws draw(8);
    int cut = 0;
    for (int k = 0; k < 60; ++k) {
        const Point<2> x = side / 2 * (draw.point<2>() + Point<2>::Ones());
        const double radius = 0.1 + 0.4 * (1 + draw());
        if (!contains(region, x, side)) continue;
        constexpr int slices = 20000;
        Eigen::Vector3d exact = Eigen::Vector3d::Zero();
        const double from = std::max(x[0] - radius, 0.0), to = std::min(x[0] + radius, side);
        for (int slice = 0; slice < slices; ++slice) {
            const double width = (to - from) / slices, at = from + (slice + 0.5) * width;
            const double half = std::sqrt(radius * radius - (at - x[0]) * (at - x[0]));
            const double low = std::max(x[1] - half, std::sqrt(std::max(b * b - at * at, 0.0)));
            const double high = std::min(x[1] + half, side);
            if (high > low)
                exact +=
                    width * Eigen::Vector3d(high - low, at * (high - low), (high * high - low * low) / 2);
        }
        const auto rule = polar_rule(region, x, radius, 40, 160);
        CAPTURE(shown_point(x));
        CAPTURE(radius);
        CHECK(std::abs(integral(rule) - exact[0]) < 1e-5);
        CHECK(std::abs(integral(rule, [](const Point<2>& at) { return at[0]; }) - exact[1]) < 1e-5);
        CHECK(std::abs(integral(rule, [](const Point<2>& at) { return at[1]; }) - exact[2]) < 1e-5);
        CHECK(std::all_of(rule.begin(), rule.end(), [&](const QuadraturePoint& point) {
            return point.weight > 0 && (point.x - x).norm() < radius && contains(region, point.x, side);
        }));
        cut += integral(rule) < pi * radius * radius * (1 - 1e-6) ? 1 : 0;
    }
    CHECK(cut > 30);
}

TEST_CASE("region_rules: the boundary in a disc has the lengths of chords and arcs") {
    const auto length = [](const Curve& curve, const Point<2>& x, double radius, Index n) {
        return integral(boundary_rule(curve, x, radius, n));
    };
    const Curve side = Segment{{1, 1}, {5, 4}};  // of length 5
    const Point<2> along(0.8, 0.6), out(0.6, -0.8);
    const auto beside = [&](double s, double distance) -> Point<2> {
        return Point<2>(1, 1) + s * along - distance * out;
    };
    CHECK(length(side, beside(2.5, 0), 1, 3) == support::relative(2, 1e-14));
    CHECK(length(side, beside(2.5, 0.6), 1, 1) == support::relative(1.6, 1e-14));
    CHECK(length(side, beside(0.2, 0.6), 1, 3) == support::relative(1, 1e-14));
    CHECK(length(side, beside(5, 0), 1, 3) == support::relative(1, 1e-14));
    CHECK(length(side, beside(2, 0), 10, 3) == support::relative(5, 1e-14));
    CHECK(boundary_rule(side, beside(2.5, 1.001), 1, 3).empty());
    CHECK(boundary_rule(side, beside(2.5, 3), 1, 3).empty());
    CHECK(boundary_rule(side, beside(7, 0), 1, 3).empty());

    const Curve arc = Arc{{1, 2}, 0.5, 0, pi / 2};
    const auto around = [](double r, double angle) -> Point<2> {
        return Point<2>(1, 2) + r * direction(angle);
    };
    const double radius = 0.3, half = 2 * std::asin(radius / 2 / 0.5);  // a chord of the length of the radius
    CHECK(length(arc, around(0.5, 0.8), radius, 4) == support::relative(0.5 * 2 * half, 1e-13));
    CHECK(length(arc, around(0.5, 0), radius, 4) == support::relative(0.5 * half, 1e-13));
    CHECK(length(arc, around(0.5, pi / 2), radius, 4) == support::relative(0.5 * half, 1e-13));
    CHECK(length(arc, around(0.5, pi / 2 - 0.1), radius, 4) == support::relative(0.5 * (half + 0.1), 1e-13));
    CHECK(length(arc, around(0.7, 0.8), 0.3, 4) ==
          support::relative(2 * 0.5 * std::acos((0.25 + 0.49 - 0.09) / 0.7), 1e-13));
    CHECK(length(arc, around(0.7, 0.8), 3, 4) == support::relative(pi / 4, 1e-13));
    // The disc holds the whole circle; its centre lies on the far side of the arc, or in the hole.
    for (const double angle : {0.8, 2.5, -2.3, 4.0})
        for (const double r : {0.0, 0.2, 0.7})
            CHECK(length(arc, around(r, angle), 3, 4) == support::relative(pi / 4, 1e-13));

    const Curve circle = Arc{{1, 2}, 0.5, 0, 2 * pi}, open = Arc{{1, 2}, 0.5, 0.1, 2 * pi - 0.1};
    for (const double angle : {0.0, 0.1, 1.0, pi, 6.0, 2 * pi - 0.01}) {
        CAPTURE(angle);
        CHECK(length(circle, around(0.5, angle), radius, 4) == support::relative(0.5 * 2 * half, 1e-13));
        CHECK(length(circle, around(0.3, angle), 2, 4) == support::relative(pi, 1e-13));
    }
    CHECK(length(open, around(0.5, 0), radius, 4) == support::relative(0.5 * 2 * (half - 0.1), 1e-13));
    CHECK(length(open, around(0.5, 0.2), radius, 4) == support::relative(0.5 * (2 * half - 0.2), 1e-13));
    CHECK(boundary_rule(arc, around(0.8, 0.8), 0.3, 4).empty());
    CHECK(boundary_rule(arc, around(0.5, -1), 0.3, 4).empty());
}

TEST_CASE(
    "region_rules: points of a boundary rule lie on the boundary, in the disc, and carry the outward normal") {
    const double b = 0.4, side = 1.5;
    const Region region = quarter(b, side);
    support::Draws draw(4);
    std::size_t count = 0;
    for (int k = 0; k < 100; ++k) {
        const Point<2> x = side / 2 * (draw.point<2>() + Point<2>::Ones());
        if (!contains(region, x, side)) continue;
        for (const Curve& curve : region)
            for (const QuadraturePoint& at : boundary_rule(curve, x, 0.5, 6)) {
                ++count;
                REQUIRE(at.weight > 0);
                REQUIRE(lies_on(curve, at.x, side));
                REQUIRE((at.x - x).norm() < 0.5);
                REQUIRE((at.normal - normal_at(curve, at.x)).norm() < 1e-14);
                REQUIRE(at.normal.norm() == support::relative(1, 1e-14));
                REQUIRE(contains(region, at.x - 1e-4 * at.normal, side));
                REQUIRE(!contains(region, at.x + 1e-4 * at.normal, side));
            }
    }
    CHECK(count > 300);
}

TEST_CASE("region_rules: the divergence theorem holds for a body within the disc") {
    const Region region = quarter(0.4, 1.5);
    const Point<2> x(0.7, 0.6);
    const auto flux = [](const Point<2>& at) {
        return Point<2>(std::sin(at[0] * at[1]), at[0] - at[1] * at[1]);
    };
    const auto divergence = [](const Point<2>& at) { return at[1] * std::cos(at[0] * at[1]) - 2 * at[1]; };
    double outwards = 0;
    Point<2> closed = Point<2>::Zero();
    for (const Curve& curve : region)
        for (const QuadraturePoint& at : boundary_rule(curve, x, 5, 20)) {
            outwards += at.weight * flux(at.x).dot(at.normal);
            closed += at.weight * at.normal;
        }
    CHECK(closed.norm() < 1e-13);
    CHECK(integral(polar_rule(region, x, 5, 40, 160), divergence) == support::relative(outwards, 1e-8));
}

TEST_CASE("region_rules: a Gaussian over a rectangle within the disc is a product of error functions") {
    const Point<2> low(-0.1, 0.2), high(0.9, 0.7);
    const Function gaussian = [](const Point<2>& at) { return std::exp(-at.squaredNorm()); };
    const auto along = [&](Index axis) {
        return std::sqrt(pi) / 2 * (std::erf(high[axis]) - std::erf(low[axis]));
    };
    for (const Point<2>& x : {Point<2>(0.3, 0.4), Point<2>(0.4, 0.2), low}) {
        const auto rule = polar_rule(rectangle(low, high), x, 3, 32, 128);
        // GSL's rules of many points have ten digits.
        CHECK(integral(rule, gaussian) == support::relative(along(0) * along(1), 1e-9));
    }
}

TEST_CASE("region_rules: a smooth function's integral converges over every form of a disc") {
    const Region region = quarter(0.4, 1.5);
    const Function wave = [](const Point<2>& at) { return std::exp(at[0]) * std::cos(3 * at[1]); };
    for (const Point<2>& x : {Point<2>(0.8, 0.9), Point<2>(0.4, 0), Point<2>(0.3, 0.45), Point<2>(1.5, 1.5),
                              Point<2>(0.7, 0.2), Point<2>(0.4 * std::cos(0.3), 0.4 * std::sin(0.3))}) {
        CAPTURE(shown_point(x));
        const double exact = integral(polar_rule(region, x, 0.5, 100, 400), wave);
        const auto error = [&](Index n) {
            return std::abs(integral(polar_rule(region, x, 0.5, n, 4 * n), wave) - exact);
        };
        CHECK(error(6) < 1e-3);
        CHECK(error(12) < 3e-5);
        CHECK(error(40) < 1e-8);
    }
}
