#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <numbers>
#include <optional>

/// Bounds of a function over a range of its argument, rounded outwards.
namespace expressions {

/// The numbers from lower to upper.
struct Interval {
    double lower, upper;
};

/// The values that a function takes over an interval lie in the result; none where the function is not defined all over the
/// interval, or not bounded by numbers.
using Bounds = std::optional<Interval>;

namespace interval {

inline double below(double number) {
    return std::nextafter(number, -std::numeric_limits<double>::infinity());
}
inline double above(double number) {
    return std::nextafter(number, std::numeric_limits<double>::infinity());
}

inline Bounds finite(double lower, double upper) {
    if (!std::isfinite(lower) || !std::isfinite(upper)) return {};
    return Interval{lower, upper};
}

/// Room for the round-off of the C library's functions, two units in the last place.
inline Bounds widened(double lower, double upper) {
    return finite(below(below(lower)), above(above(upper)));
}

inline Interval minus(const Interval& a) {
    return {-a.upper, -a.lower};
}

/// The sum; exact where the sum of two bounds is, so that 1 − x begins at 0 and not before.
inline Bounds plus(const Interval& a, const Interval& b) {
    const auto error = [](double p, double q, double sum) {
        const double of_q = sum - p;
        return (p - (sum - of_q)) + (q - of_q);
    };
    const double lower = a.lower + b.lower, upper = a.upper + b.upper;
    return finite(error(a.lower, b.lower, lower) < 0 ? below(lower) : lower,
                  error(a.upper, b.upper, upper) > 0 ? above(upper) : upper);
}

/// The product; exact where the product of two bounds is.
inline Bounds times(const Interval& a, const Interval& b) {
    double lower = std::numeric_limits<double>::infinity(), upper = -lower;
    for (const double p : {a.lower, a.upper})
        for (const double q : {b.lower, b.upper}) {
            const double product = p * q, error = std::fma(p, q, -product);
            lower = std::min(lower, error < 0 ? below(product) : product);
            upper = std::max(upper, error > 0 ? above(product) : product);
        }
    return finite(lower, upper);
}

/// A function that increases.
inline Bounds increasing(const Interval& a, double (*f)(double)) {
    return widened(f(a.lower), f(a.upper));
}

/// A power with a constant exponent. A negative base needs a whole exponent, and a negative exponent a base without zero.
inline Bounds power(const Interval& a, double exponent) {
    const bool whole = exponent == std::round(exponent);
    if (a.lower < 0 && !whole) return {};
    if (exponent < 0 && a.lower <= 0 && a.upper >= 0) return {};
    const double first = std::pow(a.lower, exponent), last = std::pow(a.upper, exponent);
    const bool even = whole && std::fmod(exponent, 2) == 0;
    Bounds bounds = widened(std::min(first, last), std::max(first, last));
    if (!bounds) return {};
    if (even && a.lower < 0 && a.upper > 0) bounds->lower = 0;
    if (even || a.lower >= 0) bounds->lower = std::max(bounds->lower, 0.0);
    return bounds;
}

inline Bounds exp(const Interval& a) {
    Bounds bounds = increasing(a, std::exp);
    if (bounds) bounds->lower = std::max(bounds->lower, 0.0);
    return bounds;
}

inline Bounds log(const Interval& a) {
    if (a.lower <= 0) return {};
    return increasing(a, std::log);
}

/// A power with any exponent, of a positive base.
inline Bounds power(const Interval& a, const Interval& exponent) {
    const Bounds logarithm = log(a);
    const Bounds product = logarithm ? times(*logarithm, exponent) : Bounds();
    return product ? exp(*product) : Bounds();
}

/// Sine or cosine: from its value in the middle it departs no farther than its argument, and it stays within 1.
inline Bounds wave(const Interval& a, double (*f)(double)) {
    const double middle = a.lower + (a.upper - a.lower) / 2;
    const double reach = std::max(middle - a.lower, a.upper - middle);
    const double slack = above(reach * (1 + 4e-16)) + 4e-16;
    return finite(std::max(f(middle) - slack, -1.0), std::min(f(middle) + slack, 1.0));
}
inline Bounds sin(const Interval& a) {
    return wave(a, std::sin);
}
inline Bounds cos(const Interval& a) {
    return wave(a, std::cos);
}

/// The tangent, on one of its branches.
inline Bounds tan(const Interval& a) {
    const auto branch = [](double x) { return std::round(x / std::numbers::pi); };
    const double near = std::max(std::abs(a.lower), std::abs(a.upper)) * 1e-15;
    if (branch(a.lower - near) != branch(a.upper + near)) return {};
    return increasing(a, std::tan);
}

inline Bounds asin(const Interval& a) {
    if (a.lower < -1 || a.upper > 1) return {};
    return increasing(a, std::asin);
}
inline Bounds acos(const Interval& a) {
    if (a.lower < -1 || a.upper > 1) return {};
    return widened(std::acos(a.upper), std::acos(a.lower));
}
inline Bounds atan(const Interval& a) {
    return increasing(a, std::atan);
}

inline Bounds sinh(const Interval& a) {
    return increasing(a, std::sinh);
}
inline Bounds cosh(const Interval& a) {
    const double first = std::cosh(a.lower), last = std::cosh(a.upper);
    const double least = a.lower <= 0 && a.upper >= 0 ? 1 : std::min(first, last);
    Bounds bounds = widened(least, std::max(first, last));
    if (bounds) bounds->lower = std::max(bounds->lower, 1.0);
    return bounds;
}
inline Bounds tanh(const Interval& a) {
    return increasing(a, std::tanh);
}

}  // namespace interval
}  // namespace expressions
