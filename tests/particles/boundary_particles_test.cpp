#include "particles/boundary_particles.hpp"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <string>

#include "base/errors.hpp"
#include "particles/layouts.hpp"
#include "particles/region_check.hpp"
#include "tests/support/regions.hpp"

using namespace particles;

namespace {

using support::pi;

const QuarterWithHole shape{0.3, 3};

Region quarter() {
    return support::quarter(0.3, 3);
}

const Points<2>& layout() {
    static const Points<2> x = graded_layout(shape, 188, 11, 1);
    return x;
}

void check(const Points<2>& x) {
    check_particles(Cloud<2>(x), quarter(), 3);
}

void refuses(const Points<2>& x, const std::string& why) {
    CAPTURE(why);
    CHECK_THROWS_WITH_AS(check(x), doctest::Contains(why.c_str()), base::InvalidInput);
}

/// Number of a particle on the arc, none of its ends.
Index on_arc(const Points<2>& x) {
    for (Index j = 0; j < x.cols(); ++j)
        if (std::abs(x.col(j).norm() - 0.3) < 1e-9 && x.col(j).minCoeff() > 0.05) return j;
    return -1;
}

/// Positions to some number of decimals. \param round to the nearest, down or up
Points<2> rounded(const Points<2>& x, int decimals, double (*round)(double)) {
    const double digit = std::pow(10, decimals);
    return x.unaryExpr([&](double number) { return round(number * digit) / digit; });
}

/// x without one particle.
Points<2> without(const Points<2>& x, Index j) {
    Points<2> left(2, x.cols() - 1);
    left << x.leftCols(j), x.rightCols(x.cols() - 1 - j);
    return left;
}

/// The distance that a message proposes.
double proposed(const Points<2>& x) {
    try {
        check(x);
    } catch (const base::InvalidInput& refused) {
        const std::string text = refused.what();
        const auto at = text.find("try --snap ");
        return at == std::string::npos ? 0 : std::stod(text.substr(at + 11));
    }
    return 0;
}

}  // namespace

TEST_CASE("boundary_particles: layouts with particles on the boundary pass, without corners too") {
    CHECK_NOTHROW(check(layout()));
    CHECK_NOTHROW(check(polar_layout(shape, 11, 17)));
    for (Index j = layout().cols() - 1; j >= 0; --j) {
        const Point<2> x = layout().col(j);
        const bool corner = (x - Point<2>(3, 3)).norm() < 1e-9 || (x - Point<2>(0.3, 0)).norm() < 1e-9;
        if (corner) CHECK_NOTHROW(check(without(layout(), j)));
    }
}

TEST_CASE("boundary_particles: a particle just beside the boundary is named, and the snap proposed helps") {
    const Index j = on_arc(layout());
    REQUIRE(j >= 0);
    const double spacing = Cloud<2>(layout()).apart()[j];
    for (const double away : {-5e-4 * spacing, -6e-8, 6e-8, 1e-4 * spacing, 0.1 * spacing, 0.4 * spacing}) {
        CAPTURE(away);
        Points<2> x = layout();
        x.col(j) *= 1 - away / 0.3;  // positive: out of the body
        refuses(x, "particle " + std::to_string(j) + " at ");
        refuses(x, std::string(away > 0 ? "lies outside the body, " : "lies only ") +
                       base::shown(std::abs(away), 3) + " from the arc of radius 0.3 around (0, 0)");
        const double distance = proposed(x);
        REQUIRE(distance >= std::abs(away));
        CHECK(distance < 1.2 * std::abs(away));
        const Snapped helped = snapped(x, quarter(), distance);
        CHECK_NOTHROW(check(helped.x));
        CHECK(helped.x.col(j).norm() == doctest::Approx(0.3).epsilon(1e-14));
        CHECK(helped.farthest == doctest::Approx(std::abs(away)));
    }
}

TEST_CASE(
    "boundary_particles: a particle inside takes none of the boundary's places unless it is far from it") {
    const Index j = on_arc(layout());
    const double spacing = Cloud<2>(layout()).apart()[j];
    for (const double away : {1.1e-3, 1e-2, 0.1, 0.2}) {
        Points<2> x = layout();
        x.col(j) *= 1 + away * spacing / 0.3;
        refuses(x, ", which has no particle of its own there; try --snap ");
        CHECK_NOTHROW(check(snapped(x, quarter(), proposed(x)).x));
    }
    Points<2> x = layout();
    x.col(j) *= 1 + 0.4 * spacing / 0.3;
    CHECK_NOTHROW(check(x));
}

TEST_CASE(
    "boundary_particles: a proposed snap moves no particle by more than half its distance to the next") {
    // Scaled so that the outer corner is farther from its place than inner particles are from the hole.
    int helped = 0;
    for (unsigned long draw = 1; draw <= 5; ++draw)
        for (const double scale : {0.98, 0.9871833, 0.995, 1.005, 1.02}) {
            CAPTURE(draw);
            CAPTURE(scale);
            const Points<2> x = scale * graded_layout(shape, 80, 7, draw);
            const double distance = proposed(x);
            if (distance == 0) continue;
            ++helped;
            const Points<2> moved = snapped(x, quarter(), distance).x;
            const Column<double> way = (moved - x).colwise().norm().transpose();
            CHECK((way <= Cloud<2>(x).apart() / 2).all());
        }
    CHECK(helped > 5);
}

TEST_CASE("boundary_particles: an inner particle may lie beside particles of the boundary") {
    for (const double away : {2e-3, 0.03, 0.2}) {
        const Index j = on_arc(layout());
        const double spacing = Cloud<2>(layout()).apart()[j];
        Points<2> x(2, layout().cols() + 1);
        const double angle = 0.5 * spacing / 0.3;  // between two particles of the arc
        const Point<2> there = Eigen::Rotation2Dd(angle) * layout().col(j);
        x << layout(), (1 + away * spacing / 0.3) * there;
        CHECK_NOTHROW(check(x));
    }
}

TEST_CASE("boundary_particles: a particle of a side may not lie just beside a corner") {
    Points<2> x = layout();
    Index corner = 0;
    while ((x.col(corner) - Point<2>(3, 3)).norm() > 1e-9) ++corner;
    x.col(corner) = Point<2>(3, 3 - 1e-5);
    refuses(x, "particle " + std::to_string(corner) +
                   " at (3, 2.99999) lies only 1e-05 from the side from (3, 3) to (0, 3)");
    CHECK(snapped(x, quarter(), proposed(x)).x.col(corner) == Point<2>(3, 3));
    x.col(corner) = Point<2>(3, 2.99);
    refuses(
        x,
        "lies only 0.01 from the side from (3, 3) to (0, 3), which has no particle of its own there; try --snap 0.011");
}

TEST_CASE(
    "boundary_particles: layouts rounded to six decimals are refused, and taken with the snap proposed") {
    for (const auto round :
         {static_cast<double (*)(double)>(std::round), static_cast<double (*)(double)>(std::floor),
          static_cast<double (*)(double)>(std::ceil)})
        for (const int decimals : {4, 5, 6, 7}) {
            CAPTURE(decimals);
            const Points<2> x = rounded(layout(), decimals, round);
            const double distance = proposed(x);
            REQUIRE(distance > 0);
            CHECK(distance < 3 * std::pow(10, -decimals));
            CHECK_NOTHROW(check(snapped(x, quarter(), distance).x));
        }
    CHECK_NOTHROW(check(rounded(layout(), 9, std::round)));
}

TEST_CASE("boundary_particles: a part of the boundary without particles is named, with both sizes") {
    Points<2> inner(2, 0);
    for (const auto& x : layout().colwise())
        if (std::abs(x.norm() - 0.3) > 1e-9) {
            inner.conservativeResize(2, inner.cols() + 1);
            inner.rightCols(1) = x;
        }
    refuses(inner, "the arc of radius 0.3 around (0, 0) has no particle on it; the nearest is particle ");
    refuses(graded_layout({0.3, 2.5}, 188, 11, 1), "the particles span 2.5 x 2.5, the body 3 x 3");
    refuses(1000 * layout(), "lies outside the body");
    refuses(1000 * layout(), "; the particles span 3000 x 3000, the body 3 x 3");
    CHECK(proposed(1000 * layout()) == 0);
}

TEST_CASE("boundary_particles: snapping takes a corner before a side, and leaves what is on the boundary") {
    Points<2> x(2, 6);
    x << 3, 2.9995, 1.5, 1.5, 0.3002, 2,  //
        3, 2.9998, 1e-4, 1e-2, 1e-4, 3;
    const auto [there, moved, farthest] = snapped(x, quarter(), 1e-3);
    CHECK(moved == 3);
    CHECK(farthest == doctest::Approx(std::hypot(5e-4, 2e-4)));
    CHECK(there.col(0) == x.col(0));
    CHECK(there.col(1) == Point<2>(3, 3));
    CHECK(there.col(2) == Point<2>(1.5, 0));
    CHECK(there.col(3) == x.col(3));
    CHECK(there.col(4) == Point<2>(0.3, 0));
    CHECK(there.col(5) == x.col(5));
    for (const double none : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
        CHECK_THROWS_AS(snapped(x, quarter(), none), base::InvalidInput);
}

TEST_CASE("boundary_particles: moves by round-off are not counted") {
    const double angle = 0.4;
    Points<2> x(2, 3);
    x << 0.3 * std::cos(angle) + 5e-17, 3 + 4e-16, 1.5,  //
        0.3 * std::sin(angle), 1, 1e-12;
    const auto [there, moved, farthest] = snapped(x, quarter(), 1e-3);
    CHECK(moved == 1);
    CHECK(farthest == doctest::Approx(1e-12));
}

TEST_CASE(
    "boundary_particles: a grid on a body that is not convex fits it, and a particle in the notch does not") {
    const Region l_shape = support::polygon({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
    Points<2> x(2, 0);
    for (int i = 0; i <= 20; ++i)
        for (int j = 0; j <= 20; ++j)
            if (i <= 10 || j <= 10) {
                x.conservativeResize(2, x.cols() + 1);
                x.rightCols(1) = Point<2>(i, j) / 10;
            }
    CHECK_NOTHROW(check_particles(Cloud<2>(x), l_shape, 2));
    x.rightCols(1) = Point<2>(1.04, 1.55);
    CHECK_THROWS_WITH_AS(
        check_particles(Cloud<2>(x), l_shape, 2),
        doctest::Contains("at (1.04, 1.55) lies outside the body, 0.04 from the side from (1, 1) to (1, 2)"),
        base::InvalidInput);
}

TEST_CASE(
    "boundary_particles: a curve cut into many sides needs particles as the curve does, not on each side") {
    // A disc with rings of particles, and polygons of up to a hundred times as many sides as particles.
    for (const int sides : {32, 96, 3200}) {
        CAPTURE(sides);
        const Region region = checked(support::polygon(support::regular(sides)), 2);
        Points<2> x(2, 1 + 32 * 5);
        x.col(0) = Point<2>(0, 0);
        for (int ring = 0; ring < 5; ++ring)
            for (int k = 0; k < 32; ++k)
                x.col(1 + 32 * ring + k) = (1 - 0.18 * ring) * direction(2 * pi * k / 32);
        CHECK_NOTHROW(check_particles(Cloud<2>(x), region, 2));
        const Points<2> inner = 0.97 * x;
        CHECK_THROWS_WITH_AS(check_particles(Cloud<2>(inner), region, 2),
                             doctest::Contains("which has no particle of its own there; try --snap 0.0"),
                             base::InvalidInput);
        CHECK_NOTHROW(check_particles(Cloud<2>(snapped(inner, region, 0.06).x), region, 2));
        const Points<2> far = 0.8 * x;
        CHECK_THROWS_WITH_AS(check_particles(Cloud<2>(far), region, 2),
                             doctest::Contains("has no particle on it; the nearest is particle "),
                             base::InvalidInput);
    }
}
