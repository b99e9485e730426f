#include "particles/cloud.hpp"

#include <doctest/doctest.h>
#include <algorithm>

#include "tests/support/clouds.hpp"
#include "tests/support/relative.hpp"

using namespace particles;

namespace {

template <int dim, class Check>
void for_every_kind(const Check& check) {
    for (const auto& [kind, x] : support::all_kinds<dim>(343)) {
        const auto& tried = kind;  // clang++ 14 captures no bindings
        CAPTURE(tried);
        CAPTURE(dim);
        check(x);
    }
}

template <int dim>
std::vector<int> within_by_brute_force(const Points<dim>& x, const Point<dim>& place, double reach) {
    std::vector<int> all;
    for (Index j = 0; j < x.cols(); ++j)
        if ((x.col(j) - place).squaredNorm() < reach * reach) all.push_back(static_cast<int>(j));
    return all;
}

/// The first of the particles at the least distance. \param but one that does not count
template <int dim>
Index nearest_by_brute_force(const Points<dim>& x, const Point<dim>& place, Index but = -1) {
    Index closest = but == 0 ? 1 : 0;
    for (Index j = closest; j < x.cols(); ++j)
        if (j != but && (x.col(j) - place).squaredNorm() < (x.col(closest) - place).squaredNorm())
            closest = j;
    return closest;
}

template <int dim>
double size_of(const Points<dim>& x) {
    return (x.rowwise().maxCoeff() - x.rowwise().minCoeff()).maxCoeff();
}

template <int dim>
void check_within() {
    for_every_kind<dim>([](const Points<dim>& x) {
        const Cloud<dim> cloud(x);
        CHECK(cloud.x() == x);
        CHECK(cloud.size() == x.cols());
        for (Index j = 0; j < x.cols(); j += 17)
            for (const double reach : {1e-6, 0.1, 1.0 / 3, 2.0})
                REQUIRE(cloud.within(x.col(j), reach * size_of(x)) ==
                        within_by_brute_force<dim>(x, x.col(j), reach * size_of(x)));
    });
}

template <int dim>
void check_nearest() {
    for_every_kind<dim>([](const Points<dim>& x) {
        const Cloud<dim> cloud(x);
        support::Draws draw(11);
        for (Index j = 0; j < x.cols(); ++j) {
            const Point<dim> beside =
                x.col(j) + size_of(x) * std::pow(10, 4 * draw()) * draw.template point<dim>();
            const Point<dim> between = (x.col(j) + x.col((j + 1) % x.cols())) / 2;  // of a grid: ties
            REQUIRE(cloud.nearest(x.col(j)) == j);
            REQUIRE(cloud.nearest(beside) == nearest_by_brute_force(x, beside));
            REQUIRE(cloud.nearest(between) == nearest_by_brute_force(x, between));
        }
    });
}

template <int dim>
void check_smoothing_lengths() {
    for_every_kind<dim>([](const Points<dim>& x) {
        const Cloud<dim> cloud(x);
        REQUIRE(cloud.apart().size() == x.cols());
        for (Index j = 0; j < x.cols(); ++j) {
            const Index other = nearest_by_brute_force<dim>(x, x.col(j), j);
            REQUIRE(cloud.apart()[j] == support::relative((x.col(j) - x.col(other)).norm(), 1e-15));
        }
    });
}

}  // namespace

TEST_CASE("cloud: the particles within reach are those of brute force, in increasing order") {
    check_within<1>();
    check_within<2>();
    check_within<3>();
}

TEST_CASE("cloud: the nearest particle is that of brute force, of several the first") {
    check_nearest<1>();
    check_nearest<2>();
    check_nearest<3>();
    const Cloud<2> square(Points<2>{{1, 1, 0, 0}, {1, 0, 1, 0}});
    CHECK(square.nearest({0.5, 0.5}) == 0);
    CHECK(square.nearest({0.5, 0}) == 1);
    CHECK(square.nearest({-7, 0.5}) == 2);
}

TEST_CASE("cloud: the smoothing length is the distance to the nearest other particle") {
    check_smoothing_lengths<1>();
    check_smoothing_lengths<2>();
    check_smoothing_lengths<3>();
}

TEST_CASE("cloud: particles that coincide are named with their place, in the plane and in space") {
    CHECK_THROWS_WITH_AS(Cloud<2>(Points<2>{{0, 0.5, 1, 0.5}, {0, 0.25, 0, 0.25}}),
                         "particles 1 and 3 coincide at (0.5, 0.25)", InvalidInput);
    CHECK_THROWS_WITH_AS(Cloud<1>(Points<1>{{2, 2}}), "particles 0 and 1 coincide at (2)", InvalidInput);
    Points<3> x = support::random_points<3>(500, 2);
    x.col(431) = x.col(77);
    CHECK_THROWS_WITH_AS(Cloud<3>{x}, doctest::Contains("particles 77 and 431 coincide at (0."),
                         InvalidInput);
    CHECK_THROWS_WITH_AS(Cloud<2>(Points<2>(Points<2>::Constant(2, 1000000, 0.5))),
                         "particles 0 and 1 coincide at (0.5, 0.5)", InvalidInput);
    x.col(431)[2] += 1e-13;
    CHECK(Cloud<3>(x).apart()[431] == support::relative(1e-13, 1e-2));
}

TEST_CASE("cloud: a position that is not finite is refused with its particle") {
    for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
        Points<2> x = support::random_points<2>(10, 2);
        x(1, 6) = bad;
        CHECK_THROWS_WITH_AS(Cloud<2>{x}, "particle 6 is not at a finite position", InvalidInput);
    }
}

TEST_CASE("cloud: positions whose distances overflow are refused with their particle") {
    Points<2> x = support::random_points<2>(10, 2);
    x(0, 4) = 1e200;
    CHECK_THROWS_WITH_AS(Cloud<2>{x}, doctest::Contains("particle 4 is too far away, at (1e+200, 0."),
                         InvalidInput);
    x(0, 4) = 1e149;
    CHECK(Cloud<2>(x).apart()[4] == support::relative(1e149, 1e-15));
}

TEST_CASE("cloud: fewer than two particles are refused with their number") {
    CHECK_THROWS_WITH_AS(Cloud<2>(Points<2>(Point<2>(1, 2))), "a cloud needs at least 2 particles, got 1",
                         InvalidInput);
    CHECK_THROWS_WITH_AS(Cloud<3>(Points<3>(3, 0)), "a cloud needs at least 2 particles, got 0",
                         InvalidInput);
    CHECK(Cloud<2>(Points<2>{{0, 3}, {0, 4}}).apart()[1] == 5);
}
