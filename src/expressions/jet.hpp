#pragma once

#include <cmath>

namespace expressions {

/// A value with its first two derivatives. Functions of jets apply the rules of differentiation, each written
/// once for double, long double, base::Quad and Interval.
template <class T>
struct Jet {
    T value, first = T(0), second = T(0);
};

template <class T>
bool is_zero(const T& number) {
    return number == T(0);
}

/// The product \f$a\,b\f$, which is zero if a factor is zero, even where the other is not finite: the second
/// derivative of \f$x^1\f$, \f$1 \cdot 0 \cdot x^{-1}\f$, is zero at x = 0, too.
template <class T>
T times(const T& a, const T& b) {
    return is_zero(a) || is_zero(b) ? T(0) : T(a * b);
}

template <class T>
T square(const T& a) {
    return a * a;
}

/// The chain rule \f$f(a)' = f'(a)\,a'\f$, \f$f(a)'' = f'(a)\,a'' + f''(a)\,a'^2\f$.
/// \param f, Df, D2f value and derivatives of the outer function at a
template <class T>
Jet<T> chain(const Jet<T>& a, const T& f, const T& Df, const T& D2f) {
    return {f, times(Df, a.first), times(Df, a.second) + times(D2f, square(a.first))};
}

template <class T>
Jet<T> operator-(const Jet<T>& a) {
    return {-a.value, -a.first, -a.second};
}
template <class T>
Jet<T> operator+(const Jet<T>& a, const Jet<T>& b) {
    return {a.value + b.value, a.first + b.first, a.second + b.second};
}
template <class T>
Jet<T> operator-(const Jet<T>& a, const Jet<T>& b) {
    return {a.value - b.value, a.first - b.first, a.second - b.second};
}

/// \f$(ab)' = a'b + ab'\f$, \f$(ab)'' = a''b + 2a'b' + ab''\f$.
template <class T>
Jet<T> operator*(const Jet<T>& a, const Jet<T>& b) {
    return {a.value * b.value, times(a.first, b.value) + times(a.value, b.first),
            times(a.second, b.value) + T(2) * times(a.first, b.first) + times(a.value, b.second)};
}

/// \f$q = a/b\f$: from \f$a = qb\f$, \f$q' = (a' - qb')/b\f$, \f$q'' = (a'' - 2q'b' - qb'')/b\f$.
template <class T>
Jet<T> operator/(const Jet<T>& a, const Jet<T>& b) {
    const T q = a.value / b.value;
    const T Dq = (a.first - times(q, b.first)) / b.value;
    return {q, Dq, (a.second - T(2) * times(Dq, b.first) - times(q, b.second)) / b.value};
}

template <class T>
Jet<T> exp(const Jet<T>& a) {
    using std::exp;
    const T f = exp(a.value);
    return chain(a, f, f, f);
}
template <class T>
Jet<T> log(const Jet<T>& a) {
    using std::log;
    const T inverse = T(1) / a.value;
    return chain<T>(a, log(a.value), inverse, -square(inverse));
}
template <class T>
Jet<T> sqrt(const Jet<T>& a) {
    using std::sqrt;
    const T f = sqrt(a.value), Df = T(1) / (T(2) * f);
    return chain<T>(a, f, Df, -Df / (T(2) * a.value));
}

/// For a constant exponent p, \f$(a^p)' = p\,a^{p-1}a'\f$, where the base may be zero or negative. Otherwise
/// \f$a^b = e^g\f$ with \f$g = b \log a\f$, hence \f$(a^b)'' = a^b(g'' + g'^2)\f$.
template <class T>
Jet<T> pow(const Jet<T>& a, const Jet<T>& b) {
    using std::pow;
    const T& p = b.value;
    if (is_zero(b.first) && is_zero(b.second))
        return chain<T>(a, pow(a.value, p), times<T>(p, pow(a.value, p - T(1))),
                        times<T>(p * (p - T(1)), pow(a.value, p - T(2))));
    const Jet<T> g = b * log(a);
    const T f = pow(a.value, p);
    return {f, times(f, g.first), times<T>(f, g.second + square(g.first))};
}

template <class T>
Jet<T> sin(const Jet<T>& a) {
    using std::cos, std::sin;
    const T f = sin(a.value);
    return chain<T>(a, f, cos(a.value), -f);
}
template <class T>
Jet<T> cos(const Jet<T>& a) {
    using std::cos, std::sin;
    const T f = cos(a.value);
    return chain<T>(a, f, -sin(a.value), -f);
}
template <class T>
Jet<T> tan(const Jet<T>& a) {
    using std::tan;
    const T f = tan(a.value), Df = T(1) + square(f);
    return chain<T>(a, f, Df, T(2) * f * Df);
}
template <class T>
Jet<T> asin(const Jet<T>& a) {
    using std::asin, std::sqrt;
    const T below_one = (T(1) - a.value) * (T(1) + a.value), Df = T(1) / sqrt(below_one);
    return chain<T>(a, asin(a.value), Df, a.value * Df / below_one);
}
template <class T>
Jet<T> acos(const Jet<T>& a) {
    using std::acos;
    const Jet<T> complement = -asin(a);
    return {acos(a.value), complement.first, complement.second};
}
template <class T>
Jet<T> atan(const Jet<T>& a) {
    using std::atan;
    const T Df = T(1) / (T(1) + square(a.value));
    return chain<T>(a, atan(a.value), Df, -T(2) * a.value * square(Df));
}
template <class T>
Jet<T> sinh(const Jet<T>& a) {
    using std::cosh, std::sinh;
    const T f = sinh(a.value);
    return chain<T>(a, f, cosh(a.value), f);
}
template <class T>
Jet<T> cosh(const Jet<T>& a) {
    using std::cosh, std::sinh;
    const T f = cosh(a.value);
    return chain<T>(a, f, sinh(a.value), f);
}
template <class T>
Jet<T> tanh(const Jet<T>& a) {
    using std::tanh;
    const T f = tanh(a.value), Df = (T(1) - f) * (T(1) + f);
    return chain<T>(a, f, Df, -T(2) * f * Df);
}

/// The distance \f$h = \sqrt{a^2 + b^2}\f$: \f$hh' = aa' + bb'\f$, hence
/// \f$hh'' = aa'' + a'^2 + bb'' + b'^2 - h'^2\f$.
template <class T>
Jet<T> hypot(const Jet<T>& a, const Jet<T>& b) {
    using std::sqrt;
    const T h = sqrt(square(a.value) + square(b.value));
    const T Dh = (times(a.value, a.first) + times(b.value, b.first)) / h;
    return {h, Dh,
            (times(a.value, a.second) + square(a.first) + times(b.value, b.second) + square(b.first) -
             square(Dh)) /
                h};
}

/// The angle \f$\theta\f$ of the point (x, y): \f$\theta' = q/r^2\f$ with \f$q = xy' - yx'\f$ and
/// \f$r^2 = x^2 + y^2\f$, hence \f$\theta'' = (q' - \theta'\,(r^2)')/r^2\f$.
template <class T>
Jet<T> atan2(const Jet<T>& y, const Jet<T>& x) {
    using std::atan2;
    const T r2 = square(x.value) + square(y.value);
    const T first = (times(x.value, y.first) - times(y.value, x.first)) / r2;
    const T Dr2 = T(2) * (times(x.value, x.first) + times(y.value, y.first));
    return {atan2(y.value, x.value), first,
            (times(x.value, y.second) - times(y.value, x.second) - times(first, Dr2)) / r2};
}

/// The smaller of two: where they are equal, the first.
template <class T>
Jet<T> min(const Jet<T>& a, const Jet<T>& b) {
    return b.value < a.value ? b : a;
}

/// The larger of two: where they are equal, the first.
template <class T>
Jet<T> max(const Jet<T>& a, const Jet<T>& b) {
    return a.value < b.value ? b : a;
}

}  // namespace expressions
