#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <limits>

#include "base/vector_width.hpp"

namespace base {

/// The same quantity of several consecutive particles, one in each lane. As a scalar in place of double, it
/// evaluates a formula for all of them at once, in the wide registers of the processor. Compilers split the
/// operations where registers are narrower, so that every lane has the same bits on all processors.
///
/// A comparison has an answer for each lane; everywhere() and chosen() take the place of branches. A function
/// of the header cmath is found for every scalar where it is called without std::, as in
/// `using std::cos; cos(s)`.
struct Pack {
    static constexpr int lanes = numbers_in_register;
    using Vector [[gnu::vector_size(lanes * sizeof(double))]] = double;
    using Mask = decltype(Vector{} < Vector{});

    Vector values;

    Pack() = default;
    Pack(double for_all)
        : values(for_all - Vector{}) {}  // NOLINT(google-explicit-constructor): a number fills all lanes
    explicit Pack(const Vector& each) : values(each) {}

    /// The numbers that begin at an address, which need not be aligned.
    static Pack from(const double* first) {
        Pack loaded{};
        __builtin_memcpy(&loaded.values, first, sizeof(Vector));
        return loaded;
    }
    /// Fewer numbers, and zeros in the other lanes.
    static Pack from(const double* first, std::ptrdiff_t count) {
        Pack loaded(0.0);
        for (std::ptrdiff_t lane = 0; lane < count; ++lane) loaded.values[lane] = first[lane];
        return loaded;
    }
    /// Writes the first lanes to an address.
    void store(double* first, std::ptrdiff_t count = lanes) const {
        if (count == lanes)
            __builtin_memcpy(first, &values, sizeof(Vector));
        else
            for (std::ptrdiff_t lane = 0; lane < count; ++lane) first[lane] = values[lane];
    }
    [[nodiscard]] double operator[](int lane) const { return values[lane]; }

    Pack operator-() const { return Pack(-values); }
    Pack& operator+=(const Pack& b) { return *this = Pack(values + b.values); }
    Pack& operator-=(const Pack& b) { return *this = Pack(values - b.values); }
    Pack& operator*=(const Pack& b) { return *this = Pack(values * b.values); }
    Pack& operator/=(const Pack& b) { return *this = Pack(values / b.values); }
    friend Pack operator+(const Pack& a, const Pack& b) { return Pack(a.values + b.values); }
    friend Pack operator-(const Pack& a, const Pack& b) { return Pack(a.values - b.values); }
    friend Pack operator*(const Pack& a, const Pack& b) { return Pack(a.values * b.values); }
    friend Pack operator/(const Pack& a, const Pack& b) { return Pack(a.values / b.values); }
    friend Mask operator<(const Pack& a, const Pack& b) { return a.values < b.values; }
    friend Mask operator>(const Pack& a, const Pack& b) { return a.values > b.values; }

    /// A function of each lane, the same as of a double.
    [[nodiscard]] Pack each_lane(double (*function)(double)) const {
        Pack result{};
        for (int lane = 0; lane < lanes; ++lane) result.values[lane] = function(values[lane]);
        return result;
    }
    friend Pack sqrt(const Pack& a) { return a.each_lane(std::sqrt); }
    friend Pack cbrt(const Pack& a) { return a.each_lane(std::cbrt); }
    friend Pack sin(const Pack& a) { return a.each_lane(std::sin); }
    friend Pack cos(const Pack& a) { return a.each_lane(std::cos); }
    friend Pack tan(const Pack& a) { return a.each_lane(std::tan); }
    friend Pack asin(const Pack& a) { return a.each_lane(std::asin); }
    friend Pack acos(const Pack& a) { return a.each_lane(std::acos); }
    friend Pack atan(const Pack& a) { return a.each_lane(std::atan); }
    friend Pack sinh(const Pack& a) { return a.each_lane(std::sinh); }
    friend Pack cosh(const Pack& a) { return a.each_lane(std::cosh); }
    friend Pack tanh(const Pack& a) { return a.each_lane(std::tanh); }
    friend Pack asinh(const Pack& a) { return a.each_lane(std::asinh); }
    friend Pack acosh(const Pack& a) { return a.each_lane(std::acosh); }
    friend Pack atanh(const Pack& a) { return a.each_lane(std::atanh); }
    friend Pack expm1(const Pack& a) { return a.each_lane(std::expm1); }
    friend Pack log(const Pack& a) { return a.each_lane(std::log); }
    friend Pack log2(const Pack& a) { return a.each_lane(std::log2); }
    friend Pack log10(const Pack& a) { return a.each_lane(std::log10); }
    friend Pack log1p(const Pack& a) { return a.each_lane(std::log1p); }
    friend Pack erf(const Pack& a) { return a.each_lane(std::erf); }
    friend Pack erfc(const Pack& a) { return a.each_lane(std::erfc); }
    friend Pack tgamma(const Pack& a) { return a.each_lane(std::tgamma); }
    friend Pack floor(const Pack& a) { return a.each_lane(std::floor); }
    friend Pack ceil(const Pack& a) { return a.each_lane(std::ceil); }
    friend Pack round(const Pack& a) { return a.each_lane(std::round); }
    friend Pack trunc(const Pack& a) { return a.each_lane(std::trunc); }

    /// A function of two numbers, lane by lane.
    [[nodiscard]] Pack each_lane(const Pack& b, double (*function)(double, double)) const {
        Pack result{};
        for (int lane = 0; lane < lanes; ++lane) result.values[lane] = function(values[lane], b[lane]);
        return result;
    }
    friend Pack pow(const Pack& a, const Pack& b) { return a.each_lane(b, std::pow); }
    friend Pack atan2(const Pack& a, const Pack& b) { return a.each_lane(b, std::atan2); }
    friend Pack hypot(const Pack& a, const Pack& b) { return a.each_lane(b, std::hypot); }
    friend Pack fmod(const Pack& a, const Pack& b) { return a.each_lane(b, std::fmod); }

    // No wider scalar has the special functions of <cmath>, so that kernels cannot be made of them.
    friend void cyl_bessel_i(double order, const Pack& a) = delete;
    friend void cyl_bessel_j(double order, const Pack& a) = delete;
    friend void cyl_bessel_k(double order, const Pack& a) = delete;
    friend void cyl_neumann(double order, const Pack& a) = delete;
    friend void sph_bessel(unsigned order, const Pack& a) = delete;
    friend void sph_neumann(unsigned order, const Pack& a) = delete;
    friend void legendre(unsigned order, const Pack& a) = delete;
    friend void hermite(unsigned order, const Pack& a) = delete;
    friend void laguerre(unsigned order, const Pack& a) = delete;
    friend void expint(const Pack& a) = delete;
    friend void riemann_zeta(const Pack& a) = delete;
};

/// Does a comparison hold in every lane?
inline bool everywhere(bool holds) {
    return holds;
}
inline bool everywhere(const Pack::Mask& holds) {
    auto all = holds[0];
    for (int lane = 1; lane < Pack::lanes; ++lane) all &= holds[lane];
    return all != 0;
}

/// a where a comparison holds, b elsewhere.
template <class Scalar>
Scalar chosen(bool holds, const Scalar& a, const Scalar& b) {
    return holds ? a : b;
}
inline Pack chosen(const Pack::Mask& holds, const Pack& a, const Pack& b) {
    return Pack(holds ? a.values : b.values);
}

/// The least of the lanes, as a double.
template <class Scalar>
double least(const Scalar& number) {
    return static_cast<double>(number);
}
inline double least(const Pack& a) {
    double least_lane = a[0];
    for (int lane = 1; lane < Pack::lanes; ++lane)
        if (!(a[lane] >= least_lane)) least_lane = a[lane];
    return least_lane;
}

inline Pack abs(const Pack& a) {
    return chosen(a < 0, -a, a);
}
inline Pack max(const Pack& a, const Pack& b) {
    return chosen(a < b, b, a);
}
inline Pack min(const Pack& a, const Pack& b) {
    return chosen(b < a, b, a);
}
inline Pack exp(const Pack& a) {
    using Lanes = Eigen::Array<double, Pack::lanes, 1>;
    const Lanes all = Eigen::Map<const Lanes>(reinterpret_cast<const double*>(&a.values)).exp();
    return Pack::from(all.data());
}

}  // namespace base

namespace std {
template <>
struct numeric_limits<base::Pack> : numeric_limits<double> {};
}  // namespace std

namespace Eigen {
template <>
struct NumTraits<base::Pack> : NumTraits<double> {
    using Real = base::Pack;
    using NonInteger = base::Pack;
    using Nested = base::Pack;
    using Literal = base::Pack;
};
}  // namespace Eigen
