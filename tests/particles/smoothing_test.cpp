#include "particles/smoothing.hpp"

#include <doctest/doctest.h>
#include <cmath>
#include <limits>

using namespace particles;

TEST_CASE("smoothing: a smoothing length must be positive and finite") {
    for (const double h : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
        CHECK_THROWS_AS(Smoothing<double>(Gaussian{}, h), InvalidInput);
    CHECK_THROWS_AS(Smoothing<double>(Gaussian{}, Column<double>::Zero(3)), InvalidInput);
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
