#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <numbers>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "base/choose.hpp"
#include "base/errors.hpp"
#include "base/pack.hpp"
#include "particles/points.hpp"
#include "particles/truncated_gaussian.hpp"

namespace particles {

using base::chosen;
using base::InvalidInput;
using base::Pack;

/// \defgroup kernels Kernels A kernel is written in the scaled offset s = (x − x_i)/h, and for h = 1. On a
/// line s has a sign: \f$W_i(x) = W(s)/h\f$, \f$DW_i(x) = W'(s)/h^2\f$, \f$D^2W_i(x) = W''(s)/h^3\f$. In
/// `dim` = λ = 2 or 3 dimensions s is the length of the offset: \f$W_i(x) = W(s)/h^\lambda\f$, and W' is the
/// slope along the radius. Each kernel has unit integral, is even, and vanishes for |s| ≥ support(); the
/// Gaussian is negligible there. The scalar may be any real type, or a Pack.
/// @{

namespace detail {

template <int n, class Scalar>
Scalar power(const Scalar& a) {
    Scalar product(1);
    for (int k = 0; k < n; ++k) product *= a;
    return product;
}

/// \f$\max(a, 0)^n\f$, with which splines are written without case distinctions.
template <int n, class Scalar>
Scalar truncated_power(const Scalar& a) {
    return power<n>(chosen(a > 0, a, Scalar(0)));
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

struct Fraction {
    int numerator, denominator;
};

/// A function times what makes its integral one: nothing on a line, a fraction over π in the plane and in
/// space.
template <int dim, class Scalar>
Scalar normalised(const Scalar& shape, Fraction plane, Fraction space) {
    static_assert(dim >= 1 && dim <= 3);
    if constexpr (dim == 1) return shape;
    const auto [numerator, denominator] = dim == 2 ? plane : space;
    return shape * (Scalar(numerator) / denominator * power<2>(inverse_sqrt_pi<Scalar>()));
}

}  // namespace detail

/// \f$W(s) = e^{-s^2}/\pi^{\lambda/2}\f$. It has no compact support and is cut where
/// \f$e^{-s^2}\f$ falls below the scalar's epsilon, at s ≈ 6.0 in double precision.
template <int dim = 1>
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
        return exp(-s * s) * detail::power<dim>(detail::inverse_sqrt_pi<Scalar>());
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

/// Cubic B-spline \f$W(s) = \frac16[(2-|s|)_+^3 - 4(1-|s|)_+^3]\f$, two continuous derivatives, support 2h;
/// times \f$\frac{15}{7\pi}\f$ in the plane and \f$\frac3{2\pi}\f$ in space.
template <int dim = 1>
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
        return normalised<Scalar>((truncated_power<3>(2 - q) - 4 * truncated_power<3>(1 - q)) / 6);
    }
    template <class Scalar>
    static Scalar DW(const Scalar& s) {
        using std::abs, detail::truncated_power, detail::sign;
        const Scalar q = abs(s);
        return normalised<Scalar>(-sign(s) * (truncated_power<2>(2 - q) - 4 * truncated_power<2>(1 - q)) / 2);
    }
    template <class Scalar>
    static Scalar D2W(const Scalar& s) {
        using std::abs, detail::truncated_power;
        const Scalar q = abs(s);
        return normalised<Scalar>(truncated_power<1>(2 - q) - 4 * truncated_power<1>(1 - q));
    }

  private:
    template <class Scalar>
    static Scalar normalised(const Scalar& shape) {
        return detail::normalised<dim>(shape, {15, 7}, {3, 2});
    }
};

/// Quintic B-spline, four continuous derivatives, support 3h; times \f$\frac{420}{239\pi}\f$ in the plane and
/// \f$\frac1\pi\f$ in space.
/// \f[ W(s) = \tfrac1{120}\big[(3-|s|)_+^5 - 6(2-|s|)_+^5 + 15(1-|s|)_+^5\big] \f]
template <int dim = 1>
struct QuinticSpline {
    static constexpr std::string_view name = "quintic_spline";

    template <class Scalar>
    static Scalar support() {
        return Scalar(3);
    }
    template <class Scalar>
    static Scalar W(const Scalar& s) {
        return normalised<Scalar>(combination<5>(s) / 120);
    }
    template <class Scalar>
    static Scalar DW(const Scalar& s) {
        return normalised<Scalar>(-detail::sign(s) * combination<4>(s) / 24);
    }
    template <class Scalar>
    static Scalar D2W(const Scalar& s) {
        return normalised<Scalar>(combination<3>(s) / 6);
    }

  private:
    template <int n, class Scalar>
    static Scalar combination(const Scalar& s) {
        using std::abs, detail::truncated_power;
        const Scalar q = abs(s);
        return truncated_power<n>(3 - q) - 6 * truncated_power<n>(2 - q) + 15 * truncated_power<n>(1 - q);
    }
    template <class Scalar>
    static Scalar normalised(const Scalar& shape) {
        return detail::normalised<dim>(shape, {420, 239}, {1, 1});
    }
};

/// Wendland's C² function with q = |s|/2, support 2h: \f$W(s) = \frac58(1-q)_+^3(1+3q)\f$ on a line;
/// \f$(1-q)_+^4(1+4q)\f$, times \f$\frac7{4\pi}\f$ in the plane and \f$\frac{21}{16\pi}\f$ in space.
///
/// Wendland (1995), Piecewise polynomial, positive definite and compactly supported radial functions of
/// minimal degree, Adv. Comput. Math. 4, 389–396. Factors as in Dehnen and Aly (2012), Improving convergence
/// in smoothed particle hydrodynamics simulations without pairing instability, Mon. Not. R. Astron. Soc. 425,
/// 1068–1082.
template <int dim = 1>
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
        if constexpr (dim == 1) return 5 * truncated_power<3>(1 - q) * (1 + 3 * q) / 8;
        return normalised<Scalar>(truncated_power<4>(1 - q) * (1 + 4 * q));
    }
    template <class Scalar>
    static Scalar DW(const Scalar& s) {
        using std::abs, detail::truncated_power;
        const Scalar q = abs(s) / 2;
        if constexpr (dim == 1) return -15 * detail::sign(s) * q * truncated_power<2>(1 - q) / 4;
        return normalised<Scalar>(-10 * detail::sign(s) * q * truncated_power<3>(1 - q));
    }
    template <class Scalar>
    static Scalar D2W(const Scalar& s) {
        using std::abs, detail::truncated_power;
        const Scalar q = abs(s) / 2;
        if constexpr (dim == 1) return -15 * truncated_power<1>(1 - q) * (1 - 3 * q) / 8;
        return normalised<Scalar>(-5 * truncated_power<2>(1 - q) * (1 - 4 * q));
    }

  private:
    template <class Scalar>
    static Scalar normalised(const Scalar& shape) {
        return detail::normalised<dim>(shape, {7, 4}, {21, 16});
    }
};

/// Wendland's C⁴ function with q = |s|/2, support 2h: \f$W(s) = \frac34(1-q)_+^5(1+5q+8q^2)\f$ on a line;
/// \f$(1-q)_+^6(1+6q+\frac{35}3q^2)\f$, times \f$\frac9{4\pi}\f$ in the plane and
/// \f$\frac{495}{256\pi}\f$ in space. Sources as for WendlandC2.
template <int dim = 1>
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
        if constexpr (dim == 1) return 3 * truncated_power<5>(1 - q) * (1 + 5 * q + 8 * q * q) / 4;
        return normalised<Scalar>(truncated_power<6>(1 - q) * (3 + 18 * q + 35 * q * q) / 3);
    }
    template <class Scalar>
    static Scalar DW(const Scalar& s) {
        using std::abs, detail::truncated_power;
        const Scalar q = abs(s) / 2;
        if constexpr (dim == 1)
            return -21 * detail::sign(s) * q * (1 + 4 * q) * truncated_power<4>(1 - q) / 4;
        return normalised<Scalar>(-28 * detail::sign(s) * q * (1 + 5 * q) * truncated_power<5>(1 - q) / 3);
    }
    template <class Scalar>
    static Scalar D2W(const Scalar& s) {
        using std::abs, detail::truncated_power;
        const Scalar q = abs(s) / 2;
        if constexpr (dim == 1) return -21 * truncated_power<3>(1 - q) * (1 + 3 * q - 24 * q * q) / 8;
        return normalised<Scalar>(-14 * truncated_power<4>(1 - q) * (1 + 4 * q - 35 * q * q) / 3);
    }

  private:
    template <class Scalar>
    static Scalar normalised(const Scalar& shape) {
        return detail::normalised<dim>(shape, {9, 4}, {495, 256});
    }
};

/// Any of the kernels, chosen at run time.
template <int dim = 1>
using Kernel = std::variant<Gaussian<dim>, CubicSpline<dim>, QuinticSpline<dim>, WendlandC2<dim>,
                            WendlandC4<dim>, TruncatedGaussian<dim>>;

/// Calls `visit(kernel)` for each kernel that needs no number: all but TruncatedGaussian.
template <int dim = 1, class Visitor>
void for_each_kernel(const Visitor& visit) {
    const std::initializer_list<Kernel<dim>> all{Gaussian<dim>{}, CubicSpline<dim>{}, QuinticSpline<dim>{},
                                                 WendlandC2<dim>{}, WendlandC4<dim>{}};
    for (const Kernel<dim>& kernel : all) visit(kernel);
}

template <int dim>
std::string name(const Kernel<dim>& kernel) {
    return std::visit([](const auto& W) { return std::string(W.name); }, kernel);
}

/// Radius of the support in units of h.
template <class Scalar, int dim>
Scalar support(const Kernel<dim>& kernel) {
    return std::visit([](const auto& W) { return W.template support<Scalar>(); }, kernel);
}

template <class Scalar, template <int> class OneKernel, int dim>
Scalar support(const OneKernel<dim>& kernel) {
    return kernel.template support<Scalar>();
}

/// Distance within which particles are neighbours, in units of h: the radius of the support, less a fraction
/// √ε or 1e-8, whichever is smaller. A particle on the very edge has no weight, and round-off must not decide
/// whether it counts as a neighbour.
/// \param kernel a Kernel, or one of the kernels itself
template <class Scalar, class AnyKernel>
Scalar reach(const AnyKernel& kernel) {
    using std::sqrt;
    const Scalar edge = std::min(Scalar(1e-8), Scalar(sqrt(std::numeric_limits<Scalar>::epsilon())));
    return support<Scalar>(kernel) * (1 - edge);
}

/// One of the kernels that need no number.
/// \throws InvalidInput for a name that none of them has
template <int dim = 1>
Kernel<dim> kernel_named(std::string_view wanted) {
    std::vector<std::pair<std::string, Kernel<dim>>> known;
    for_each_kernel<dim>([&](const Kernel<dim>& kernel) { known.emplace_back(name(kernel), kernel); });
    return base::choose("kernel", wanted, known);
}

namespace detail {

/// DW at an offset, from the known W where that saves an exponential.
template <class AnyKernel, class Scalar>
Scalar derivative(const AnyKernel& kernel, const Scalar& s, const Scalar& W) {
    if constexpr (requires { kernel.DW(s, W); })
        return kernel.DW(s, W);
    else
        return kernel.DW(s);
}

}  // namespace detail

/// Kernel values and gradients at offsets in units of h, for any real scalar. The gradient at s = 0 is zero.
/// \f[ W = W(|s|), \quad \frac{\partial W}{\partial s} = W'(|s|)\,\frac{s}{|s|} \f]
/// \param s offsets (n × dim)
/// \param[out] W values (n)
/// \param[out] DW gradients \f$\partial W/\partial s\f$ (n × dim)
template <template <int> class AnyKernel, int dim, class Scalar>
void evaluate(const AnyKernel<dim>& kernel, const Offsets<Scalar, dim>& s, Column<Scalar>& W,
              Offsets<Scalar, dim>& DW) {
    const auto value = [&](const Scalar& q) { return kernel.W(q); };
    const auto slope = [&](const Scalar& q, const Scalar& W_q) { return detail::derivative(kernel, q, W_q); };
    if constexpr (dim == 1) {
        W = s.unaryExpr(value);
        DW = s.binaryExpr(W, slope);
    } else {
        const Column<Scalar> q = squared_lengths(s).sqrt();
        W = q.unaryExpr(value);
        DW = s.colwise() * (q > 0).select(q.binaryExpr(W, slope) / q, Scalar(0));
    }
}

/// The same for any kernel.
template <int dim, class Scalar>
void evaluate(const Kernel<dim>& kernel, const Offsets<Scalar, dim>& s, Column<Scalar>& W,
              Offsets<Scalar, dim>& DW) {
    std::visit([&](const auto& one) { evaluate(one, s, W, DW); }, kernel);
}

/// @}

// Compiled once for each dimension, in kernels.cpp.
extern template void evaluate(const Kernel<1>&, const Offsets<double, 1>&, Column<double>&,
                              Offsets<double, 1>&);
extern template void evaluate(const Kernel<2>&, const Offsets<double, 2>&, Column<double>&,
                              Offsets<double, 2>&);
extern template void evaluate(const Kernel<3>&, const Offsets<double, 3>&, Column<double>&,
                              Offsets<double, 3>&);

}  // namespace particles
