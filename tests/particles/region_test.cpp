#include "particles/region.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "tests/support/regions.hpp"

using namespace particles;
using support::pi;

TEST_CASE("region: a place lies on a curve between its ends, both included") {
    const Curve side = Segment{{1, 1}, {5, 4}}, arc = Arc{{0, 0}, 0.4, 0, pi / 2};
    for (const Point<2>& on : {Point<2>(1, 1), Point<2>(5, 4), Point<2>(3, 2.5), Point<2>(3, 2.5 + 1e-9)})
        CHECK(lies_on(side, on, 5));
    for (const Point<2>& off : {Point<2>(3, 2.6), Point<2>(9, 7), Point<2>(-3, -2), Point<2>(3, 2.5 + 1e-7)})
        CHECK(!lies_on(side, off, 5));
    for (const double angle : {0.0, 0.1, 1.0, pi / 2, pi / 2 - 1e-12, -1e-12}) {
        CAPTURE(angle);
        CHECK(lies_on(arc, 0.4 * direction(angle), 1));
        CHECK(!lies_on(arc, 0.41 * direction(angle), 1));
    }
    for (const double angle : {-0.1, pi / 2 + 0.1, pi, -pi / 2})
        CHECK(!lies_on(arc, 0.4 * direction(angle), 1));
    const Curve third_quadrant = Arc{{0, 0}, 1, pi, 3 * pi / 2};
    CHECK(lies_on(third_quadrant, direction(-2), 1));
    CHECK(!lies_on(third_quadrant, direction(2), 1));
}

TEST_CASE("region: normals point out of the region, of a hole towards its centre") {
    CHECK((normal_at(Segment{{0, 0}, {2, 0}}, {1, 0}) - Point<2>(0, -1)).norm() < 1e-15);
    CHECK((normal_at(Segment{{2, 0}, {2, 2}}, {2, 1}) - Point<2>(1, 0)).norm() < 1e-15);
    CHECK((normal_at(Segment{{1, 1}, {5, 4}}, {1, 1}) - Point<2>(0.6, -0.8)).norm() < 1e-15);
    const Curve arc = Arc{{1, 2}, 0.5, 0, pi / 2};
    CHECK((normal_at(arc, {1.3, 2.4}) - Point<2>(-0.6, -0.8)).norm() < 1e-14);
    CHECK((ends(arc)[0] - Point<2>(1.5, 2)).norm() < 1e-15);
    CHECK((ends(arc)[1] - Point<2>(1, 2.5)).norm() < 1e-15);
}

TEST_CASE("region: the way along a part has the region to its left") {
    const Arc hole{{1, 2}, 0.5, 0, pi / 2}, bulge{{1, 2}, 0.5, 0, pi / 2, true};
    CHECK(way(hole)[0] == ends(hole)[1]);
    CHECK(way(hole)[1] == ends(hole)[0]);
    CHECK(way(bulge) == ends(bulge));
    CHECK((normal_at(bulge, {1.3, 2.4}) - Point<2>(0.6, 0.8)).norm() < 1e-14);
    for (const Curve& curve : {Curve(hole), Curve(bulge), Curve(Segment{{3, 1}, {1, 2}})}) {
        const Point<2> start = way(curve)[0], n = normal_at(curve, start);
        const Point<2> next = closest(curve, start + 0.01 * Point<2>(-n[1], n[0]));
        CHECK((next - start).norm() == doctest::Approx(0.01).epsilon(1e-3));
    }
}

TEST_CASE("region: the box around a part is that of many places on it") {
    support::Draws draw(3);
    for (int k = 0; k < 50; ++k) {
        const double from = 4 * draw(), to = from + pi * (1 + draw());
        const Arc arc{draw.point<2>(), 1 + draw(), from, to};
        Box around;
        for (int step = 0; step <= 2000; ++step)
            around.extend(arc.centre + arc.radius * direction(from + (to - from) * step / 2000));
        CHECK((box(arc).min() - around.min()).norm() < 1e-5);
        CHECK((box(arc).max() - around.max()).norm() < 1e-5);
    }
    CHECK(box(Segment{{3, 1}, {1, 2}}).isApprox(Box(Point<2>(1, 1), Point<2>(3, 2))));
}
