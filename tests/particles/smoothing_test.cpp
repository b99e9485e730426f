#include "particles/smoothing.hpp"

#include <doctest/doctest.h>
#include <cmath>
#include <limits>
#include <type_traits>

using namespace particles;

TEST_CASE("smoothing: a smoothing length must be positive and finite") {
    for (const double h : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
        CHECK_THROWS_AS(Smoothing<double>(Gaussian{}, h), InvalidInput);
    CHECK_THROWS_AS(Smoothing<double>(Gaussian{}, Column<double>::Zero(3)), InvalidInput);
    CHECK_THROWS_WITH_AS(Smoothing<double>(Gaussian{}, Column<double>()), "there is no smoothing length",
                         InvalidInput);
}

TEST_CASE("smoothing: its scalar and dimension follow from its kernel and lengths") {
    const Column<double> each{{1, 2, 3}};
    static_assert(std::is_same_v<decltype(Smoothing(Gaussian{}, 0.1)), Smoothing<double, 1>>);
    static_assert(std::is_same_v<decltype(Smoothing(CubicSpline<2>{}, 0.1L)), Smoothing<long double, 2>>);
    static_assert(
        std::is_same_v<decltype(Smoothing(TruncatedGaussian<3>(3), 2 * each)), Smoothing<double, 3>>);
    CHECK(Smoothing(WendlandC2<2>{}, 2 * each).h(1) == 4);
}

TEST_CASE("smoothing: lengths given as a ratio to spacings keep the ratio, and so do their multiples") {
    const Column<double> spacing{{0.1, 0.2}};
    const Smoothing<> smoothing(Gaussian{}, spacing, 1.5);
    CHECK(smoothing.h(1) == 1.5 * 0.2);
    CHECK(smoothing.ratio() == 1.5);
    CHECK(smoothing.times(2).ratio() == 3);
    CHECK(smoothing.times(2).h(0) == 2 * smoothing.h(0));
    CHECK_FALSE(Smoothing<>(Gaussian{}, spacing).ratio());
    CHECK_NOTHROW(smoothing.require_lengths_of(2));
    CHECK_THROWS_WITH_AS(smoothing.require_lengths_of(3),
                         "3 particles need as many smoothing lengths, or one, got 2", InvalidInput);
    CHECK_NOTHROW(Smoothing<>(Gaussian{}, 0.1).require_lengths_of(3));
}

TEST_CASE("smoothing: the reach is the support but for a hundred-millionth, of each particle in its own h") {
    const Smoothing<double, 3> one(CubicSpline<3>{}, 0.5);
    CHECK_FALSE(one.is_local());
    CHECK(one.h(7) == 0.5);
    CHECK(one.reach() < 1);
    CHECK(one.reach() > 1 - 1e-7);
    const Smoothing<double, 2> each(TruncatedGaussian<2>(3), Column<double>{{1, 4, 2}});
    CHECK(each.is_local());
    CHECK(each.h() == 4);
    CHECK(each.h(2) == 2);
    CHECK(each.reach(0) < each.reach(2));
    CHECK(each.reach(1) == each.reach());
}
