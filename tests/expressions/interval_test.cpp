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
    Bounds (*bounds)(const Interval&);
    double (*value)(double);
};

const std::vector<Case>& cases() {
    static const std::vector<Case> all{
        {"sin", interval::sin, std::sin},
        {"cos", interval::cos, std::cos},
        {"tan", interval::tan, std::tan},
        {"asin", interval::asin, std::asin},
        {"acos", interval::acos, std::acos},
        {"atan", interval::atan, std::atan},
        {"sinh", interval::sinh, std::sinh},
        {"cosh", interval::cosh, std::cosh},
        {"tanh", interval::tanh, std::tanh},
        {"exp", interval::exp, std::exp},
        {"log", interval::log, std::log},
        {"square", [](const Interval& a) { return interval::power(a, 2); }, [](double x) { return x * x; }},
        {"cube", [](const Interval& a) { return interval::power(a, 3); }, [](double x) { return x * x * x; }},
        {"inverse", [](const Interval& a) { return interval::power(a, -1); }, [](double x) { return 1 / x; }},
        {"inverse square", [](const Interval& a) { return interval::power(a, -2); },
         [](double x) { return 1 / (x * x); }},
        {"root", [](const Interval& a) { return interval::power(a, 0.5); }, std::sqrt}};
    return all;
}

bool holds(const Bounds& bounds, double value) {
    return bounds && bounds->lower <= value && value <= bounds->upper;
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
            const Bounds found = bounds({lower, lower + width});
            if (!found) continue;
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
        const Bounds narrow = bounds({0.3, 0.3 + 1e-9});
        REQUIRE(narrow);
        CHECK(narrow->upper - narrow->lower < 1e-7);
        CHECK(holds(narrow, value(0.3)));
    }
}

TEST_CASE("interval: none where a function has a pole or is not real") {
    CHECK_FALSE(interval::power({-1, 1}, -1));
    CHECK_FALSE(interval::power({0, 1}, -2));
    CHECK_FALSE(interval::power({0, 1}, -0.5));
    CHECK_FALSE(interval::power({-1e-300, 1}, 0.5));
    CHECK_FALSE(interval::log({0, 1}));
    CHECK_FALSE(interval::tan({1.5, 1.6}));
    CHECK_FALSE(interval::tan({-2, 3}));
    CHECK_FALSE(interval::asin({0.5, 1.1}));
    CHECK_FALSE(interval::acos({-1.1, 0}));
    CHECK_FALSE(interval::exp({0, 1000}));
    CHECK_FALSE(interval::power({0, 1}, Interval{1, 2}));
    CHECK_FALSE(interval::times({1e200, 1e201}, {1e200, 1e201}));
    CHECK_FALSE(interval::plus({1e308, 1.7e308}, {1e308, 1.7e308}));
}

TEST_CASE("interval: sums and products are rounded outwards, and left alone where they are exact") {
    const Bounds inexact = interval::plus({0.1, 0.1}, {0.2, 0.2});
    REQUIRE(inexact);
    CHECK(inexact->lower < inexact->upper);
    CHECK(holds(inexact, 0.1 + 0.2));
    const Bounds exact = interval::plus({1, 1}, interval::minus({0.5, 1}));
    REQUIRE(exact);
    CHECK(exact->lower == 0);
    CHECK(exact->upper == 0.5);
    const Bounds product = interval::times({-3, 2}, {-1, 4});
    REQUIRE(product);
    CHECK(product->lower == -12);
    CHECK(product->upper == 8);
}
