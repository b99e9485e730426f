#include "expressions/jet.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using expressions::Jet;

namespace {

bool same(const Jet<double>& a, const Jet<double>& b) {
    return a.value == b.value && a.first == b.first && a.second == b.second;
}

}  // namespace

TEST_CASE("jet: whole powers drop what a zero factor multiplies, also at x = 0") {
    const Jet<double> x{0, 1};
    CHECK(same(pow(x, {0}), {1, 0, 0}));
    CHECK(same(pow(x, {1}), {0, 1, 0}));
    CHECK(same(pow(x, {2}), {0, 0, 2}));
    CHECK(same(pow(x, {3}), {0, 0, 0}));
    CHECK(same(pow(Jet<double>{-2, 1}, {3}), {-8, 12, -12}));
    CHECK(same(pow(Jet<double>{-2, 1}, {-1}), {-0.5, -0.25, -0.25}));
    CHECK(same(Jet<double>{0} * pow(x, {0.5}), {0, 0, 0}));
    CHECK(pow(x, {0.5}).first == std::numeric_limits<double>::infinity());
}

TEST_CASE("jet: sum, difference, product and quotient of x^2 + 1 and 3 x at x = 2") {
    const Jet<double> a{5, 4, 2}, b{6, 3, 0};
    CHECK(same(a + b, {11, 7, 2}));
    CHECK(same(a - b, {-1, 1, 2}));
    CHECK(same(-a, {-5, -4, -2}));
    CHECK(same(a * b, {30, 39, 36}));
    const auto [value, first, second] = a / b;  // x/3 + 1/(3x)
    CHECK(std::abs(value - 5.0 / 6) < 1e-15);
    CHECK(std::abs(first - 0.25) < 1e-15);
    CHECK(std::abs(second - 1.0 / 12) < 1e-15);
}

TEST_CASE("jet: the chain rule for a function of t whose slope is not one, exp(2 t + 3 t^2/2) at t = 0") {
    CHECK(same(exp(Jet<double>{0, 2, 3}), {1, 2, 7}));
}

TEST_CASE("jet: hypot on a ray from the origin is the distance, which grows without curvature") {
    CHECK(same(hypot(Jet<double>{3, 3}, Jet<double>{4, 4}), {5, 5, 0}));
}

TEST_CASE("jet: hypot and atan2 of a point on a circle") {
    const Jet<double> x{0.6, -1.6, -2.4}, y{0.8, 1.2, -3.2};  // cos and sin of 2t, where 2t = atan2(0.8, 0.6)
    const auto r = hypot(x, y), angle = atan2(y, x);
    CHECK(std::abs(r.value - 1) < 1e-15);
    CHECK(std::abs(r.first) < 1e-15);
    CHECK(std::abs(r.second) < 1e-14);
    CHECK(angle.value == std::atan2(0.8, 0.6));
    CHECK(std::abs(angle.first - 2) < 1e-15);
    CHECK(std::abs(angle.second) < 1e-14);
}

TEST_CASE("jet: min and max take the derivatives along, those of the first where both are equal") {
    const Jet<double> a{1, 2, 3}, b{4, 5, 6}, c{1, 7, 8};
    CHECK(same(min(a, b), a));
    CHECK(same(min(b, a), a));
    CHECK(same(max(a, b), b));
    CHECK(same(max(b, a), b));
    CHECK(same(min(a, c), a));
    CHECK(same(max(c, a), c));
}
