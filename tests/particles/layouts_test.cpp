#include "particles/layouts.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "base/errors.hpp"

using namespace particles;

namespace {

const QuarterWithHole shape;

}  // namespace

TEST_CASE("layouts: each particle that is added is the place farthest from all before it") {
    const auto candidates = logarithmic::random_places(shape, 2000, 3);
    std::vector<Point<2>> x = logarithmic::boundary_layout(shape, 4);
    const std::size_t given = x.size();
    add_farthest(x, candidates, 150);
    REQUIRE(x.size() == 150);
    for (std::size_t n = given; n < x.size(); ++n) {
        const auto away = [&](const Point<2>& place) {
            double least = HUGE_VAL;
            for (std::size_t j = 0; j < n; ++j) least = std::min(least, (place - x[j]).squaredNorm());
            return least;
        };
        double farthest = 0;
        for (const Point<2>& place : candidates) farthest = std::max(farthest, away(place));
        CHECK(away(x[n]) == farthest);
    }
}

TEST_CASE(
    "layouts: particles move to the centres of the places nearest to them, those on the boundary stay") {
    const std::vector<Point<2>> near_both{{0.1, 0}, {0.3, 0.2}, {1, 0.8}, {1.2, 1}, {1.1, 0.9}};
    std::vector<Point<2>> x{{0, 0}, {1, 1}, {9, 9}}, fixed = x;
    move_to_centres(x, near_both, 0);
    CHECK((x[0] - Point<2>(0.2, 0.1)).norm() < 1e-15);
    CHECK((x[1] - Point<2>(1.1, 0.9)).norm() < 1e-15);
    CHECK(x[2] == Point<2>(9, 9));  // nearest to no place
    move_to_centres(fixed, near_both, 1);
    CHECK(fixed[0] == Point<2>(0, 0));
    CHECK((fixed[1] - Point<2>(1.1, 0.9)).norm() < 1e-15);
}

TEST_CASE(
    "layouts: in every round each place belongs to the particle nearest to it, wherever particles began") {
    const auto places = logarithmic::random_places(shape, 3000, 5);
    // All begin close together, so that owners change far in the first rounds.
    std::vector<Point<2>> x(places.begin(), places.begin() + 40);
    for (Point<2>& start : x) start *= 0.05;
    std::vector<Point<2>> slowly = x;
    constexpr int rounds = 20;
    move_to_centres(x, places, 3, rounds);
    for (int round = 0; round < rounds; ++round) {
        std::vector<Point<2>> sum(slowly.size(), Point<2>::Zero());
        std::vector<int> count(slowly.size(), 0);
        for (const Point<2>& place : places) {
            std::size_t nearest = 0;
            for (std::size_t j = 1; j < slowly.size(); ++j)
                if ((place - slowly[j]).squaredNorm() < (place - slowly[nearest]).squaredNorm()) nearest = j;
            sum[nearest] += place;
            ++count[nearest];
        }
        for (std::size_t j = 3; j < slowly.size(); ++j)
            if (count[j] > 0) slowly[j] = sum[j] / count[j];
    }
    CHECK(x == slowly);
}

TEST_CASE("layouts: random places are those of GSL's mt19937 for the seed, and seed 0 is its default") {
    CHECK(logarithmic::random_places(shape, 50, 0) == logarithmic::random_places(shape, 50, 4357));
    const auto places = logarithmic::random_places(shape, 2, 1);  // 1791095845, 4282876139, 3093770124, …
    const double depth = logarithmic::edge(shape, std::atan(1.0));
    CHECK(places[0][0] == depth * (1791095845 / 4294967296.0));
    CHECK(places[0][1] == std::acos(0.0) * (4282876139 / 4294967296.0));
}

TEST_CASE("layouts: logarithmic coordinates keep the hole, the outer edge and the angles") {
    for (double theta = 0; theta < 1.6; theta += 0.1) {
        CHECK(logarithmic::place(shape, {0, theta}).norm() == doctest::Approx(shape.b).epsilon(1e-14));
        const Point<2> at_edge = logarithmic::place(shape, {logarithmic::edge(shape, theta), theta});
        CHECK(at_edge.maxCoeff() == doctest::Approx(shape.side).epsilon(1e-13));
        CHECK(std::atan2(at_edge[1], at_edge[0]) == doctest::Approx(theta).epsilon(1e-13));
    }
}
