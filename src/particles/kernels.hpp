#pragma once

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

#include "base/choose.hpp"
#include "base/errors.hpp"
#include "base/pack.hpp"

namespace particles {

using base::chosen;
using base::InvalidInput;
using base::Pack;

/// \defgroup kernels Kernels A kernel is written in the scaled offset s = (x − x_i)/h, in one dimension and
/// for h = 1: \f$W_i(x) = W(s)/h\f$, \f$DW_i(x) = W'(s)/h^2\f$, \f$D^2W_i(x) = W''(s)/h^3\f$. Each has unit
/// integral, is even, and vanishes for |s| ≥ support(); the Gaussian is negligible there. The scalar may be
/// any real type, or a Pack.
/// @{

namespace detail {

/// \f$\max(a, 0)^n\f$, with which splines are written without case distinctions.
template <int n, class Scalar>
Scalar truncated_power(const Scalar& a) {
    const Scalar positive = chosen(a > 0, a, Scalar(0));
    Scalar power(1);
    for (int k = 0; k < n; ++k) power *= positive;
    return power;
}

template <class Scalar>
Scalar sign(const Scalar& s) {
    return chosen(s > 0, Scalar(1), chosen(s < 0, Scalar(-1), Scalar(0)));
}

/// \f$1/\sqrt\pi\f$. It is a function because the order in which template variables are initialised is not
/// defined.
template <class Scalar>
Scalar inverse_sqrt_pi() {
    if constexpr (std::is_floating_point_v<Scalar>)
        return std::numbers::inv_sqrtpi_v<Scalar>;
    else if constexpr (std::is_same_v<Scalar, Pack>)
        return std::numbers::inv_sqrtpi;
    else {
        using std::atan, std::sqrt;
        static const Scalar value = 1 / sqrt(4 * atan(Scalar(1)));
        return value;
    }
}

}  // namespace detail

/// \f$W(s) = e^{-s^2}/\sqrt{\pi}\f$, the first paper's kernel. It has no compact support and is cut where
/// \f$e^{-s^2}\f$ falls below the scalar's epsilon, at s ≈ 6.0 in double precision.
struct Gaussian {
    static constexpr std::string_view name = "gaussian";

    template <class Scalar>
    static Scalar support() {
        using std::log, std::sqrt;
        return sqrt(-log(std::numeric_limits<Scalar>::epsilon()));
    }
    template <class Scalar>
    static Scalar W(const Scalar& s) {
        using std::exp;
        return exp(-s * s) * detail::inverse_sqrt_pi<Scalar>();
    }
    template <class Scalar>
    static Scalar DW(const Scalar& s) {
        return DW(s, W(s));
    }
    /// The derivative from a known value, which saves an exponential.
    template <class Scalar>
    static Scalar DW(const Scalar& s, const Scalar& W) {
        return -2 * s * W;
    }
    template <class Scalar>
    static Scalar D2W(const Scalar& s) {
        return (4 * s * s - 2) * W(s);
    }
};

/// Cubic B-spline \f$W(s) = \frac16[(2-|s|)_+^3 - 4(1-|s|)_+^3]\f$, two continuous derivatives, support 2h.
struct CubicSpline {
    static constexpr std::string_view name = "cubic_spline";

    template <class Scalar>
    static Scalar support() {
        return Scalar(2);
    }
    template <class Scalar>
    static Scalar W(const Scalar& s) {
        using std::abs, detail::truncated_power;
        const Scalar q = abs(s);
        return (truncated_power<3>(2 - q) - 4 * truncated_power<3>(1 - q)) / 6;
    }
    template <class Scalar>
    static Scalar DW(const Scalar& s) {
        using std::abs, detail::truncated_power, detail::sign;
        const Scalar q = abs(s);
        return -sign(s) * (truncated_power<2>(2 - q) - 4 * truncated_power<2>(1 - q)) / 2;
    }
    template <class Scalar>
    static Scalar D2W(const Scalar& s) {
        using std::abs, detail::truncated_power;
        const Scalar q = abs(s);
        return truncated_power<1>(2 - q) - 4 * truncated_power<1>(1 - q);
    }
};

/// Quintic B-spline, four continuous derivatives, support 3h.
/// \f[ W(s) = \tfrac1{120}\big[(3-|s|)_+^5 - 6(2-|s|)_+^5 + 15(1-|s|)_+^5\big] \f]
struct QuinticSpline {
    static constexpr std::string_view name = "quintic_spline";

    template <class Scalar>
    static Scalar support() {
        return Scalar(3);
    }
    template <class Scalar>
    static Scalar W(const Scalar& s) {
        return combination<5>(s) / 120;
    }
    template <class Scalar>
    static Scalar DW(const Scalar& s) {
        return -detail::sign(s) * combination<4>(s) / 24;
    }
    template <class Scalar>
    static Scalar D2W(const Scalar& s) {
        return combination<3>(s) / 6;
    }

  private:
    template <int n, class Scalar>
    static Scalar combination(const Scalar& s) {
        using std::abs, detail::truncated_power;
        const Scalar q = abs(s);
        return truncated_power<n>(3 - q) - 6 * truncated_power<n>(2 - q) + 15 * truncated_power<n>(1 - q);
    }
};

/// Wendland's C² function of one dimension, \f$W(s) = \frac58(1-q)_+^3(1+3q)\f$ with q = |s|/2, support 2h.
struct WendlandC2 {
    static constexpr std::string_view name = "wendland_c2";

    template <class Scalar>
    static Scalar support() {
        return Scalar(2);
    }
    template <class Scalar>
    static Scalar W(const Scalar& s) {
        using std::abs, detail::truncated_power;
        const Scalar q = abs(s) / 2;
        return 5 * truncated_power<3>(1 - q) * (1 + 3 * q) / 8;
    }
    template <class Scalar>
    static Scalar DW(const Scalar& s) {
        using std::abs, detail::truncated_power;
        const Scalar q = abs(s) / 2;
        return -15 * detail::sign(s) * q * truncated_power<2>(1 - q) / 4;
    }
    template <class Scalar>
    static Scalar D2W(const Scalar& s) {
        using std::abs, detail::truncated_power;
        const Scalar q = abs(s) / 2;
        return -15 * truncated_power<1>(1 - q) * (1 - 3 * q) / 8;
    }
};

/// Wendland's C⁴ function of one dimension, \f$W(s) = \frac34(1-q)_+^5(1+5q+8q^2)\f$ with q = |s|/2, support
/// 2h.
struct WendlandC4 {
    static constexpr std::string_view name = "wendland_c4";

    template <class Scalar>
    static Scalar support() {
        return Scalar(2);
    }
    template <class Scalar>
    static Scalar W(const Scalar& s) {
        using std::abs, detail::truncated_power;
        const Scalar q = abs(s) / 2;
        return 3 * truncated_power<5>(1 - q) * (1 + 5 * q + 8 * q * q) / 4;
    }
    template <class Scalar>
    static Scalar DW(const Scalar& s) {
        using std::abs, detail::truncated_power;
        const Scalar q = abs(s) / 2;
        return -21 * detail::sign(s) * q * (1 + 4 * q) * truncated_power<4>(1 - q) / 4;
    }
    template <class Scalar>
    static Scalar D2W(const Scalar& s) {
        using std::abs, detail::truncated_power;
        const Scalar q = abs(s) / 2;
        return -21 * truncated_power<3>(1 - q) * (1 + 3 * q - 24 * q * q) / 8;
    }
};

/// Any of the kernels, chosen at run time.
using Kernel = std::variant<Gaussian, CubicSpline, QuinticSpline, WendlandC2, WendlandC4>;

/// @}

/// Calls `visit(kernel)` for each kernel.
template <class Visitor, std::size_t k = 0>
void for_each_kernel(const Visitor& visit) {
    if constexpr (k < std::variant_size_v<Kernel>) {
        visit(Kernel(std::in_place_index<k>));
        for_each_kernel<Visitor, k + 1>(visit);
    }
}

inline std::string name(const Kernel& kernel) {
    return std::visit([](const auto& W) { return std::string(W.name); }, kernel);
}

/// Radius of the support in units of h.
template <class Scalar>
Scalar support(const Kernel& kernel) {
    return std::visit([](const auto& W) { return W.template support<Scalar>(); }, kernel);
}

/// \throws InvalidInput for a name that no kernel has
inline Kernel kernel_named(std::string_view wanted) {
    std::vector<std::pair<std::string, Kernel>> known;
    for_each_kernel([&](const Kernel& kernel) { known.emplace_back(name(kernel), kernel); });
    return base::choose("kernel", wanted, known);
}

}  // namespace particles
