#pragma once

#include <Eigen/Core>
#include <cmath>
#include <string_view>
#include <type_traits>

#include "base/errors.hpp"
#include "base/pack.hpp"
#include "base/text.hpp"
#include "particles/points.hpp"

namespace particles {

using base::chosen;
using base::InvalidInput;
using base::Pack;
using base::shown;

/// The Gaussian, lowered so that it vanishes at the edge of its support, in λ = 1, 2 or 3 dimensions and for
/// h = 1:
/// \f[ W(s) = \frac{G}{\pi^{\lambda/2}}\left(e^{-|s|^2} - e^{-\rho^2}\right), \quad |s| \le \rho \f]
/// G makes the integral over the support one; it is computed in double precision for every scalar, the
/// exponentials in the scalar's own. The derivative jumps at the edge. \ingroup kernels
template <int dim = 1>
class TruncatedGaussian {
    static_assert(dim >= 1 && dim <= 3);

  public:
    static constexpr std::string_view name = "truncated_gaussian";

    /// \param rho scaling factor, the radius of the support in units of h
    /// \throws InvalidInput unless it is positive and finite
    explicit TruncatedGaussian(double rho) : rho_(rho), least_(std::exp(-rho * rho)) {
        if (!(std::isfinite(rho) && rho > 0))
            throw InvalidInput("the scaling factor must be positive and finite, got " + shown(rho));
        const double pi = std::acos(-1.0);
        factor_ = G() / std::pow(pi, dim / 2.0);
    }
    [[nodiscard]] double rho() const { return rho_; }

    /// Normalising constant: one over the integral of the function without it.
    [[nodiscard]] double G() const {
        const double sqrt_pi = std::sqrt(std::acos(-1.0));
        if constexpr (dim == 1) return 1 / (std::erf(rho_) - 2 * rho_ * least_ / sqrt_pi);
        if constexpr (dim == 2) return 1 / (1 - least_ - rho_ * rho_ * least_);
        return 1 / (std::erf(rho_) - (2 * rho_ + 4 * rho_ * rho_ * rho_ / 3) * least_ / sqrt_pi);
    }

    template <class Scalar>
    [[nodiscard]] Scalar support() const {
        return Scalar(rho_);
    }
    template <class Scalar>
    [[nodiscard]] Scalar W(const Scalar& s) const {
        using std::exp;
        return inside<Scalar>(s * s, factor_ * (exp(-s * s) - least<Scalar>()));
    }
    template <class Scalar>
    [[nodiscard]] Scalar DW(const Scalar& s) const {
        return DW(s, W(s));
    }
    /// The derivative from a known value, which saves an exponential.
    template <class Scalar>
    [[nodiscard]] Scalar DW(const Scalar& s, const Scalar& W) const {
        return inside<Scalar>(s * s, -2 * s * (W + edge<Scalar>()));
    }
    template <class Scalar>
    [[nodiscard]] Scalar D2W(const Scalar& s) const {
        return inside<Scalar>(s * s, (4 * s * s - 2) * (W(s) + edge<Scalar>()));
    }

    /// W at one squared distance \f$q = |s|^2\f$.
    [[nodiscard]] double at(double q) const { return inside<double>(q, factor_ * (std::exp(-q) - least_)); }

    /// W at squared distances, an array.
    template <class Distances>
    [[nodiscard]] auto at(const Eigen::ArrayBase<Distances>& q) const {
        using Scalar = typename Distances::Scalar;
        return (((-q).exp() - least<Scalar>()) * Scalar(factor_)).cwiseMax(Scalar(0)).eval();
    }

    /// The amount by which the Gaussian is lowered: dW/dq = −(W + edge), and ∂W/∂s = 2 s dW/dq.
    template <class Scalar = double>
    [[nodiscard]] Scalar edge() const {
        return factor_ * least<Scalar>();
    }

  private:
    /// A value inside the support, zero outside.
    template <class Scalar>
    [[nodiscard]] Scalar inside(const Scalar& q, const Scalar& value) const {
        return chosen(q < Scalar(rho_) * Scalar(rho_), value, Scalar(0));
    }

    /// \f$e^{-\rho^2}\f$, the least value of the Gaussian inside.
    template <class Scalar>
    [[nodiscard]] Scalar least() const {
        using std::exp;
        if constexpr (std::is_same_v<Scalar, double> || std::is_same_v<Scalar, Pack>)
            return least_;
        else
            return exp(-Scalar(rho_) * Scalar(rho_));
    }

    double rho_, least_, factor_ = 0;
};

/// Kernel values and gradients at offsets in units of h, for any real scalar.
/// \param s offsets (n × dim)
/// \param[out] W values (n)
/// \param[out] DW gradients \f$\partial W/\partial s\f$ (n × dim)
template <int dim, class Scalar>
void evaluate(const TruncatedGaussian<dim>& kernel, const Offsets<Scalar, dim>& s, Column<Scalar>& W,
              Offsets<Scalar, dim>& DW) {
    const Column<Scalar> q = squared_lengths(s);
    W = kernel.at(q);
    const Scalar edge = kernel.template edge<Scalar>(), end = Scalar(kernel.rho()) * Scalar(kernel.rho());
    DW = s.colwise() * (q < end).select(Scalar(-2) * (W + edge), Scalar(0)).eval();
}

}  // namespace particles
