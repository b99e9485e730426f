#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <variant>

#include "base/errors.hpp"
#include "base/interval.hpp"
#include "base/text.hpp"
#include "particles/kernels.hpp"
#include "particles/quadrature.hpp"

namespace particles {

using base::Interval;
using base::InvalidInput;
using base::shown;

/// A real function of the position.
using Function = std::function<double(double)>;

/// The kernel \f$W_i\f$ of a particle as a function of x, for the integral forms: its values, its derivative,
/// and integrals over the domain Ω. Lengths have the unit of x; in the discrete forms their unit is h (see
/// Neighbourhood).
struct CentredKernel {
    double x;        ///< the particle's position \f$x_i\f$
    double h;        ///< smoothing length
    double support;  ///< radius of the support in units of h
    Interval Omega;  ///< the domain
    Function W;      ///< \f$W_i(x)\f$ [1/length]
    Function DW;     ///< \f$DW_i(x)\f$ [1/length²]

    /// \f$\int_\Omega f\,d\Omega\f$ of a function that vanishes outside the support of \f$W_i\f$:
    /// Gauss–Legendre between the knots \f$x_i + kh\f$, where the splines change their polynomial.
    /// \throws InvalidInput for a result that is not finite
    [[nodiscard]] double integral(const Function& f) const {
        double sum = 0;
        const int pieces = static_cast<int>(std::ceil(support));
        for (int k = -pieces; k < pieces; ++k) {
            const double from = std::max(x + std::max<double>(k, -support) * h, Omega.lower);
            const double to = std::min(x + std::min<double>(k + 1, support) * h, Omega.upper);
            if (from < to) sum += particles::integral(f, from, to);
        }
        if (!std::isfinite(sum)) throw InvalidInput("the integral around x = " + shown(x) + " is not finite");
        return sum;
    }

    /// Moment \f$\int_\Omega (x - x_i)^k f(x)\,d\Omega\f$ of a function, usually W or DW.
    [[nodiscard]] double moment(int k, const Function& f) const {
        return integral([&](double at) { return std::pow(at - x, k) * f(at); });
    }

    /// \f$\|f\|_{L^1} = \int_\Omega |f|\,d\Omega\f$.
    [[nodiscard]] double norm(const Function& f) const {
        return integral([&](double at) { return std::abs(f(at)); });
    }
};

/// The kernel of smoothing length h centred at x_i, on the domain Ω.
inline CentredKernel centred(const Kernel<>& kernel, double x_i, double h, Interval Omega) {
    return std::visit(
        [&](const auto& W) {
            return CentredKernel{x_i,
                                 h,
                                 W.template support<double>(),
                                 Omega,
                                 [=](double x) { return W.W((x - x_i) / h) / h; },
                                 [=](double x) { return W.DW((x - x_i) / h) / (h * h); }};
        },
        kernel);
}

}  // namespace particles
