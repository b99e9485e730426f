#pragma once

#include <cmath>

#include "base/errors.hpp"
#include "base/text.hpp"

namespace particles {

using base::InvalidInput;
using base::shown;

/// The Gaussian, lowered so that it vanishes at the edge of its support, in λ = 1, 2 or 3 dimensions and for
/// h = 1:
/// \f[ W(s) = \frac{G}{\pi^{\lambda/2}}\left(e^{-|s|^2} - e^{-\rho^2}\right), \quad |s| \le \rho \f]
/// G makes the integral over the support one. Evaluated in \f$q = |s|^2\f$, inside the support only.
template <int dim>
class TruncatedGaussian {
    static_assert(dim >= 1 && dim <= 3);

  public:
    /// \param rho scaling factor, the radius of the support in units of h
    /// \throws InvalidInput unless it is positive and finite
    explicit TruncatedGaussian(double rho) : rho_(rho), edge_(std::exp(-rho * rho)) {
        if (!(std::isfinite(rho) && rho > 0))
            throw InvalidInput("the scaling factor must be positive and finite, got " + shown(rho));
        const double pi = std::acos(-1.0);
        factor_ = G() / std::pow(pi, dim / 2.0);
    }
    [[nodiscard]] double rho() const { return rho_; }

    /// Normalising constant: one over the integral of the function without it.
    [[nodiscard]] double G() const {
        const double sqrt_pi = std::sqrt(std::acos(-1.0));
        if constexpr (dim == 1) return 1 / (std::erf(rho_) - 2 * rho_ * edge_ / sqrt_pi);
        if constexpr (dim == 2) return 1 / (1 - edge_ - rho_ * rho_ * edge_);
        return 1 / (std::erf(rho_) - (2 * rho_ + 4 * rho_ * rho_ * rho_ / 3) * edge_ / sqrt_pi);
    }

    /// W at squared distances q, an Eigen array; zero beyond the edge.
    template <class Distances>
    [[nodiscard]] auto W(const Distances& q) const {
        return (((-q).exp() - edge_) * factor_).cwiseMax(0).eval();
    }

    /// The amount by which the Gaussian is lowered: dW/dq = −(W + edge), and ∂W/∂s = 2 s dW/dq.
    [[nodiscard]] double edge() const { return factor_ * edge_; }

    /// W at one squared distance.
    [[nodiscard]] double at(double q) const {
        return q < rho_ * rho_ ? factor_ * (std::exp(-q) - edge_) : 0.0;
    }

  private:
    double rho_, edge_, factor_ = 0;
};

}  // namespace particles
