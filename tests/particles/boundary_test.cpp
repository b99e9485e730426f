#include "particles/boundary.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "tests/support/regions.hpp"

using namespace particles;
using support::pi, support::quarter;

TEST_CASE(
    "boundary: a place lies in a region, on its boundary, or outside, up to a hundred-millionth of the size") {
    const Region region = quarter(0.4, 1.5);
    for (const Point<2>& inside : {Point<2>(0.7, 0.7), Point<2>(0.4, 0), Point<2>(0, 0.4), Point<2>(1.5, 1.5),
                                   Point<2>(1.5 + 1e-9, 0.3), Point<2>(0.9, -1e-9)})
        CHECK(contains(region, inside, 1.5));
    for (const Point<2>& outside : {Point<2>(1.5 + 1e-7, 0.3), Point<2>(0.9, -1e-7), Point<2>(0.2, 0.2),
                                    Point<2>(0.4 - 1e-7, 0), Point<2>(-3, 7)})
        CHECK(!contains(region, outside, 1.5));
}

TEST_CASE("boundary: the signed distance is negative inside, at re-entrant corners and sharp tips too") {
    const Boundary l_shape(support::polygon({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}));
    CHECK(signed_distance(l_shape, {0.9, 0.9}) == doctest::Approx(-std::sqrt(0.02)));
    CHECK(signed_distance(l_shape, {1.2, 1.1}) == doctest::Approx(0.1));
    CHECK(signed_distance(l_shape, {0.3, 1}) == doctest::Approx(-0.3));
    CHECK(signed_distance(l_shape, {5, 5}) == doctest::Approx(5));
    CHECK(signed_distance(l_shape, {-3, -4}) == doctest::Approx(5));
    const Boundary needle(support::polygon({{0, 0}, {9, -0.1}, {9, 0.1}}));
    CHECK(signed_distance(needle, {-1, 0.001}) == doctest::Approx(1));
    CHECK(signed_distance(needle, {0.9, 0.001}) < 0);
    const Boundary ring({support::circle({0, 0}, 1, true), support::circle({0, 0}, 0.4, false)});
    for (const double angle : {0.0, 1.0, pi, -2.0}) {
        CHECK(signed_distance(ring, 0.3 * direction(angle)) == doctest::Approx(0.1));
        CHECK(signed_distance(ring, 0.5 * direction(angle)) == doctest::Approx(-0.1));
        CHECK(signed_distance(ring, 1.1 * direction(angle)) == doctest::Approx(0.1));
    }
    CHECK(signed_distance(Boundary(Region()), {3, 7}) < 0);  // the whole plane
}

TEST_CASE("boundary: a place is in a polygon where the polygon's angles around it sum to a turn") {
    for (unsigned seed = 1; seed <= 10; ++seed) {
        const auto corners = support::star(50, seed);
        const Boundary boundary(support::polygon(corners));
        support::Draws draw(seed);
        for (int k = 0; k < 200; ++k) {
            const Point<2> x = draw.point<2>();
            double angles = 0;
            for (std::size_t c = 0; c < corners.size(); ++c) {
                const Point<2> a = corners[c] - x, b = corners[(c + 1) % corners.size()] - x;
                angles += std::atan2(a[0] * b[1] - a[1] * b[0], a.dot(b));
            }
            CHECK(contains(boundary, x, 1) == (angles > 1));
        }
    }
}

TEST_CASE("boundary: searches find the same parts as a look at each of them") {
    const Boundary boundary(support::polygon(support::star(300, 2)));
    support::Draws draw(7);
    for (int k = 0; k < 50; ++k) {
        const Point<2> x = 1.5 * draw.point<2>();
        const double reach = 0.3 * (1 + draw());
        std::vector<std::size_t> near;
        Nearest nearest{0, x, HUGE_VAL};
        for (std::size_t part = 0; part < boundary.curves().size(); ++part) {
            const Point<2> place = closest(boundary.curves()[part], x);
            const double distance = (place - x).norm();
            if (distance <= reach) near.push_back(part);
            if (distance < nearest.distance) nearest = {part, place, distance};
        }
        CHECK(boundary.near(x, reach) == near);
        CHECK(boundary.nearest(x).curve == nearest.curve);
        CHECK(boundary.nearest(x).distance == nearest.distance);
    }
}

TEST_CASE("boundary: joints turn left at corners, right where they re-enter, and runs end at sharp ones") {
    const Boundary boundary({Segment{{0, 0}, {2, 0}}, Segment{{2, 0}, {2, 1}},
                             Arc{{1, 1}, 1, 0, pi / 2, true}, Segment{{1, 2}, {1, 1}},
                             Segment{{1, 1}, {0, 1}}, Segment{{0, 1}, {0, 0}}});
    const double turns[] = {pi / 2, 0, pi / 2, -pi / 2, pi / 2, pi / 2};
    for (std::size_t k = 0; k < 6; ++k) {
        CAPTURE(k);
        CHECK(boundary.end(k).turn == doctest::Approx(turns[k]));
        CHECK(boundary.start((k + 1) % 6).turn == boundary.end(k).turn);
        CHECK(boundary.run(k) == (k == 2 ? 1 : k));
        CHECK(!boundary.end(k).smooth);  // nor from a side to an arc, where the curvature jumps
    }
    CHECK(boundary.end(3).sees({1, 1}));
    CHECK(boundary.end(3).sees({-1, -1}));
    CHECK(!boundary.end(3).sees({-1, 1}));
    CHECK(boundary.end(0).sees({-1, 1}));
    CHECK(!boundary.end(0).sees({1, 1}));
    const Boundary disc(support::polygon(support::regular(100)));
    for (std::size_t k = 0; k < 100; ++k) CHECK(disc.run(k) == 0);
}

TEST_CASE("boundary: a cusp of the body is seen by no ray, one into the body by all but one") {
    // A side that touches a circle: the body is thin between them, or all around their cusp.
    const Boundary thin({Segment{{0, 0}, {2, 0}}, Segment{{2, 0}, {1, 1}}, Arc{{0, 1}, 1, -pi / 2, 0}});
    CHECK(thin.start(0).turn == doctest::Approx(pi));
    CHECK(signed_distance(thin, {-0.5, 0}) == doctest::Approx(0.5));
    CHECK(signed_distance(thin, {1, 0.1}) == doctest::Approx(-0.1));
    const Boundary around({support::circle({0, 0}, 9, true), Segment{{2, 0}, {0, 0}}, Segment{{1, 1}, {2, 0}},
                           Arc{{0, 1}, 1, -pi / 2, 0, true}});
    CHECK(around.end(1).turn == doctest::Approx(-pi));
    CHECK(signed_distance(around, {-0.5, 0}) == doctest::Approx(-0.5));
    CHECK(signed_distance(around, {1, 0.1}) == doctest::Approx(0.1));
}
