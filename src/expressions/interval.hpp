#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <numbers>

#include "base/interval.hpp"
#include "expressions/jet.hpp"

namespace expressions {

/// The numbers from `lower` to `upper`. A function of an interval returns an interval that contains the
/// function's value at every number of its argument, exact or computed in floating point: bounds are rounded
/// outwards. Where the function is not defined on the whole argument, or its values exceed double precision,
/// the result is everything().
struct Interval : base::Interval {
    constexpr Interval() = default;
    constexpr explicit Interval(double number) : Interval(number, number) {}
    constexpr Interval(double from, double to) : base::Interval{from, to} {}

    friend bool operator==(const Interval& a, const Interval& b) = default;
};

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// All numbers: nothing is known.
constexpr Interval everything() {
    return {-infinity, infinity};
}
inline bool is_bounded(const Interval& a) {
    return std::isfinite(a.lower) && std::isfinite(a.upper);
}
inline bool contains(const Interval& a, double number) {
    return a.lower <= number && number <= a.upper;
}

/// The neighbours of a floating-point number.
inline double below(double number) {
    return std::nextafter(number, -infinity);
}
inline double above(double number) {
    return std::nextafter(number, infinity);
}

/// The interval between two bounds; everything if one of them is not finite.
inline Interval bounded(double lower, double upper) {
    const Interval a{lower, upper};
    return is_bounded(a) ? a : everything();
}
/// Bounds from functions of the C library, which may err by two units in the last place.
inline Interval widened(double lower, double upper) {
    return bounded(below(below(lower)), above(above(upper)));
}
/// The part of an interval between bounds that are known otherwise.
inline Interval clipped(const Interval& a, double lower, double upper) {
    return is_bounded(a) ? Interval{std::max(a.lower, lower), std::min(a.upper, upper)} : a;
}

inline Interval operator-(const Interval& a) {
    return {-a.upper, -a.lower};
}

/// The sum. An exact bound is not rounded: for x in [0, 1], the lower bound of 1 − x is 0.
inline Interval operator+(const Interval& a, const Interval& b) {
    const auto error = [](double p, double q, double sum) {
        const double rounded_q = sum - p;
        return (p - (sum - rounded_q)) + (q - rounded_q);
    };
    const double lower = a.lower + b.lower, upper = a.upper + b.upper;
    return bounded(error(a.lower, b.lower, lower) < 0 ? below(lower) : lower,
                   error(a.upper, b.upper, upper) > 0 ? above(upper) : upper);
}
inline Interval operator-(const Interval& a, const Interval& b) {
    return a + -b;
}

/// Size below which a product counts as inexact: its computed error may underflow to zero.
inline constexpr double smallest_exact = 1e-280;

/// The product. An exact bound is not rounded.
inline Interval operator*(const Interval& a, const Interval& b) {
    if (!is_bounded(a) || !is_bounded(b)) return everything();
    Interval product{infinity, -infinity};
    for (const double p : {a.lower, a.upper})
        for (const double q : {b.lower, b.upper}) {
            const double pq = p * q, error = std::fma(p, q, -pq);
            const bool tiny = p != 0 && q != 0 && std::abs(pq) < smallest_exact;
            product.lower = std::min(product.lower, error < 0 || tiny ? below(pq) : pq);
            product.upper = std::max(product.upper, error > 0 || tiny ? above(pq) : pq);
        }
    return bounded(product.lower, product.upper);
}

/// The quotient. An exact bound is not rounded.
inline Interval operator/(const Interval& a, const Interval& b) {
    if (!is_bounded(a) || !is_bounded(b) || contains(b, 0)) return everything();
    Interval quotient{infinity, -infinity};
    for (const double p : {a.lower, a.upper})
        for (const double q : {b.lower, b.upper}) {
            const double ratio = p / q;
            const bool exact = p == 0 || (std::fma(ratio, q, -p) == 0 && std::abs(p) > smallest_exact);
            quotient.lower = std::min(quotient.lower, exact ? ratio : below(ratio));
            quotient.upper = std::max(quotient.upper, exact ? ratio : above(ratio));
        }
    return bounded(quotient.lower, quotient.upper);
}

inline Interval square(const Interval& a) {
    return clipped(a * a, 0, infinity);
}

/// The bounds of an increasing function.
inline Interval increasing(const Interval& a, double (*f)(double)) {
    return is_bounded(a) ? widened(f(a.lower), f(a.upper)) : everything();
}

inline Interval exp(const Interval& a) {
    return clipped(increasing(a, std::exp), 0, infinity);
}
inline Interval log(const Interval& a) {
    return a.lower > 0 ? increasing(a, std::log) : everything();
}
inline Interval sqrt(const Interval& a) {
    return a.lower >= 0 ? clipped(increasing(a, std::sqrt), 0, infinity) : everything();
}

/// The power with a whole exponent. With a negative exponent the base must not contain 0; 0^0 has no value.
inline Interval whole_power(const Interval& a, double n) {
    if (n == 0 && a != Interval(0)) return Interval(1);
    if (n == 2) return square(a);
    if (n <= 0 && contains(a, 0)) return everything();
    const double first = std::pow(a.lower, n), last = std::pow(a.upper, n);
    const bool even = std::fmod(n, 2) == 0;
    const double least = even && contains(a, 0) ? 0 : std::min(first, last);
    const Interval power = widened(least, std::max(first, last));
    return even || a.lower >= 0 ? clipped(power, 0, infinity) : power;
}
/// The power with real exponents; the base must not be negative. Its logarithm p log a is linear in p and in
/// log a, so that the bounds lie at corners.
inline Interval real_power(const Interval& a, const Interval& p) {
    if (a.lower < 0 || (a.lower == 0 && p.lower <= 0)) return everything();
    const auto [least, largest] = std::minmax({std::pow(a.lower, p.lower), std::pow(a.lower, p.upper),
                                               std::pow(a.upper, p.lower), std::pow(a.upper, p.upper)});
    return clipped(widened(least, largest), 0, infinity);
}
inline Interval pow(const Interval& a, const Interval& p) {
    if (!is_bounded(a) || !is_bounded(p)) return everything();
    const bool whole = p.lower == p.upper && p.lower == std::round(p.lower);
    const Interval power = whole ? whole_power(a, p.lower) : real_power(a, p);
    return p.lower >= 0 && a.lower >= -1 && a.upper <= 1 ? clipped(power, -1, 1) : power;
}

/// Sine or cosine: it differs from its value in the middle by no more than its argument does, and stays
/// within ±1.
inline Interval wave(const Interval& a, double (*f)(double)) {
    if (!is_bounded(a)) return everything();
    const double middle = a.lower + (a.upper - a.lower) / 2;
    const double reach = std::max(middle - a.lower, a.upper - middle);
    const double slack = above(reach * (1 + 4e-16)) + 4e-16;
    return clipped(bounded(f(middle) - slack, f(middle) + slack), -1, 1);
}
inline Interval sin(const Interval& a) {
    return wave(a, std::sin);
}
inline Interval cos(const Interval& a) {
    return wave(a, std::cos);
}

/// The tangent, on one branch.
inline Interval tan(const Interval& a) {
    const auto branch = [](double x) { return std::round(x / std::numbers::pi); };
    const double rounding = std::max(std::abs(a.lower), std::abs(a.upper)) * 1e-15;
    return branch(a.lower - rounding) == branch(a.upper + rounding) ? increasing(a, std::tan) : everything();
}

inline Interval asin(const Interval& a) {
    return a.lower >= -1 && a.upper <= 1 ? increasing(a, std::asin) : everything();
}
inline Interval acos(const Interval& a) {
    return a.lower >= -1 && a.upper <= 1 ? widened(std::acos(a.upper), std::acos(a.lower)) : everything();
}
inline Interval atan(const Interval& a) {
    return increasing(a, std::atan);
}

/// The angle of the points (x, y) of a box, which must not touch the cut y = 0, x ≤ 0. Its bounds lie at
/// corners.
inline Interval atan2(const Interval& y, const Interval& x) {
    if (!is_bounded(x) || !is_bounded(y) || (contains(y, 0) && x.lower <= 0)) return everything();
    const auto [least, largest] = std::minmax({std::atan2(y.lower, x.lower), std::atan2(y.lower, x.upper),
                                               std::atan2(y.upper, x.lower), std::atan2(y.upper, x.upper)});
    return widened(least, largest);
}

inline Interval sinh(const Interval& a) {
    return increasing(a, std::sinh);
}
inline Interval cosh(const Interval& a) {
    const double first = std::cosh(a.lower), last = std::cosh(a.upper);
    const double least = contains(a, 0) ? 1 : std::min(first, last);
    return clipped(widened(least, std::max(first, last)), 1, infinity);
}
inline Interval tanh(const Interval& a) {
    return clipped(increasing(a, std::tanh), -1, 1);
}

/// The smaller of two. It has a kink where they are equal: derivatives are known only if one is smaller
/// everywhere.
inline Jet<Interval> min(const Jet<Interval>& a, const Jet<Interval>& b) {
    if (a.value.upper < b.value.lower) return a;
    if (b.value.upper < a.value.lower) return b;
    return {bounded(std::min(a.value.lower, b.value.lower), std::min(a.value.upper, b.value.upper)),
            everything(), everything()};
}
/// The larger of two. Derivatives are known only if one is larger everywhere.
inline Jet<Interval> max(const Jet<Interval>& a, const Jet<Interval>& b) {
    return -min(-a, -b);
}

}  // namespace expressions
