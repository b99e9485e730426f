#include "expressions/interval.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

using namespace expressions;

namespace {

/// Functions of one argument, with their bounds.
struct Case {
    std::string name;
    Interval (*bounds)(const Interval&);
    double (*value)(double);
};

const std::vector<Case>& cases() {
    static const std::vector<Case> all{
        {"sin", expressions::sin, std::sin},
        {"cos", expressions::cos, std::cos},
        {"tan", expressions::tan, std::tan},
        {"asin", expressions::asin, std::asin},
        {"acos", expressions::acos, std::acos},
        {"atan", expressions::atan, std::atan},
        {"sinh", expressions::sinh, std::sinh},
        {"cosh", expressions::cosh, std::cosh},
        {"tanh", expressions::tanh, std::tanh},
        {"exp", expressions::exp, std::exp},
        {"log", expressions::log, std::log},
        {"square", [](const Interval& a) { return pow(a, Interval(2)); }, [](double x) { return x * x; }},
        {"cube", [](const Interval& a) { return pow(a, Interval(3)); }, [](double x) { return x * x * x; }},
        {"inverse", [](const Interval& a) { return pow(a, Interval(-1)); }, [](double x) { return 1 / x; }},
        {"inverse square", [](const Interval& a) { return pow(a, Interval(-2)); },
         [](double x) { return 1 / (x * x); }},
        {"square root", expressions::sqrt, std::sqrt},
        {"root", [](const Interval& a) { return pow(a, Interval(0.5)); }, std::sqrt}};
    return all;
}

bool holds(const Interval& bounds, double value) {
    return is_bounded(bounds) && contains(bounds, value);
}

}  // namespace

TEST_CASE("interval: every value of a function lies within its bounds, where it is defined all over") {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(-4, 4), part(0, 1);
    for (const auto& [name, bounds, value] : cases()) {
        const std::string tried = name;  // clang++ 14 captures no bindings
        CAPTURE(tried);
        int bounded = 0;
        for (int k = 0; k < 2000; ++k) {
            const double lower = place(random), width = std::pow(part(random), 4);
            const Interval found = bounds({lower, lower + width});
            if (!is_bounded(found)) continue;
            ++bounded;
            for (int s = 0; s <= 20; ++s) {
                const double x = std::min(lower + width * s / 20, lower + width);
                REQUIRE(holds(found, value(x)));
            }
        }
        CHECK(bounded > 200);
    }
}

TEST_CASE("interval: bounds shrink with the interval, so that bisection decides") {
    for (const auto& [name, bounds, value] : cases()) {
        const std::string tried = name;  // clang++ 14 captures no bindings
        CAPTURE(tried);
        const Interval narrow = bounds({0.3, 0.3 + 1e-9});
        REQUIRE(is_bounded(narrow));
        CHECK(narrow.upper - narrow.lower < 1e-7);
        CHECK(holds(narrow, value(0.3)));
    }
}

TEST_CASE("interval: everything where a function has a pole or is not real") {
    const std::vector<Interval> unbounded{
        pow({-1, 1}, Interval(-1)),
        pow({0, 1}, Interval(-2)),
        pow({0, 1}, Interval(-0.5)),
        pow({-1e-300, 1}, Interval(0.5)),
        pow(Interval(0), Interval(0)),
        pow({0, 1}, {0, 2}),
        pow({0, 1}, {-1, 2}),
        Interval(1) / Interval(-1, 1),
        Interval(0) / Interval(0, 1),
        sqrt(Interval(-1e-300, 1)),
        log({0, 1}),
        tan({1.5, 1.6}),
        tan({-2, 3}),
        asin({0.5, 1.1}),
        acos({-1.1, 0}),
        exp({0, 1000}),
        atan2({-1, 1}, {-1, 2}),
        atan2({0, 1}, {-1, -0.5}),
        atan2({-1, 1}, {0, 1}),
        Interval(1e200, 1e201) * Interval(1e200, 1e201),
        Interval(1e308, 1.7e308) + Interval(1e308, 1.7e308),
    };
    for (const Interval& a : unbounded) {
        CAPTURE(&a - unbounded.data());
        CHECK(a == everything());
    }
}

TEST_CASE("interval: of everything, every function is everything") {
    const Interval all = everything(), one(1);
    for (const auto& [name, bounds, value] : cases()) {
        const std::string tried = name;  // clang++ 14 captures no bindings
        CAPTURE(tried);
        CHECK(bounds(all) == all);
    }
    for (const Interval& a : {-all, all + one, one - all, Interval(0) * all, all * one, one / all,
                              Interval(0) / all, all / one, sqrt(all), square(all), pow(one, all),
                              pow(all, one), pow(all, Interval(0)), atan2(all, one), atan2(one, all)})
        CHECK(a == all);
}

TEST_CASE(
    "interval: sums, products and quotients are rounded outwards, and left alone where they are exact") {
    for (const auto& [bounds, value] :
         {std::pair(Interval(0.1) + Interval(0.2), 0.1 + 0.2),
          std::pair(Interval(0.1) * Interval(0.1), 0.1 * 0.1), std::pair(Interval(1) / Interval(3), 1.0 / 3),
          std::pair(Interval(1e-200) * Interval(1e-200), 0.0),
          std::pair(Interval(1e-200) / Interval(1e200), 0.0)}) {
        CHECK(bounds.lower < bounds.upper);
        CHECK(holds(bounds, value));
    }
    CHECK(Interval(1) - Interval(0.5, 1) == Interval(0, 0.5));
    CHECK(Interval(-3, 2) * Interval(-1, 4) == Interval(-12, 8));
    CHECK(Interval(-3, 2) / Interval(0.5, 4) == Interval(-6, 4));
    CHECK(square(Interval(-2, 1)) == Interval(0, 4));
    CHECK(pow(Interval(-2, 1), Interval(2)) == Interval(0, 4));
    CHECK(pow(Interval(-2, 1), Interval(0)) == Interval(1));
    CHECK(pow(Interval(-1, 1), Interval(3)) == Interval(-1, 1));
}

TEST_CASE("interval: operations on two arguments hold every value, with random arguments") {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> place(-3, 3), part(0, 1);
    const auto drawn = [&] {
        const double lower = place(random);
        return Interval(lower, lower + std::pow(part(random), 3));
    };
    const auto check = [](const Interval& bounds, double value) {
        return !is_bounded(bounds) || contains(bounds, value);
    };
    int bounded = 0;
    for (int k = 0; k < 5000; ++k) {
        const Interval a = drawn(), b = drawn();
        bounded += is_bounded(pow(a, b)) && is_bounded(atan2(a, b)) && is_bounded(a / b) ? 1 : 0;
        for (int s = 0; s < 10; ++s) {
            const double p = std::min(a.lower + part(random) * (a.upper - a.lower), a.upper),
                         q = std::min(b.lower + part(random) * (b.upper - b.lower), b.upper);
            REQUIRE(holds(a + b, p + q));
            REQUIRE(holds(a - b, p - q));
            REQUIRE(holds(a * b, p * q));
            REQUIRE(check(a / b, p / q));
            REQUIRE(check(pow(a, b), std::pow(p, q)));
            REQUIRE(check(atan2(a, b), std::atan2(p, q)));
            REQUIRE(holds(min({a}, {b}).value, std::min(p, q)));
            REQUIRE(holds(max({a}, {b}).value, std::max(p, q)));
        }
    }
    CHECK(bounded > 500);
}

TEST_CASE("interval: the derivatives of min and max are known where one argument is the smaller all over") {
    const Jet<Interval> a{{0, 1}, {2, 3}, {4, 5}}, b{{1.5, 2}, {6, 7}, {8, 9}}, c{{1, 2}, {6, 7}, {8, 9}};
    CHECK(min(a, b).first == a.first);
    CHECK(max(a, b).second == b.second);
    CHECK(min(b, a).first == a.first);
    CHECK(min(a, c).first == everything());
    CHECK(max(c, a).second == everything());
}
