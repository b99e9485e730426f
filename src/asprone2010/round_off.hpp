#pragma once

#include <cmath>

#include "asprone2010/leading_error.hpp"

namespace asprone2010::limit_stencils {

/// The factor by which an operator multiplies the largest error of the values of B, over \f$\delta^{-d}\f$.
/// \f[ \sum_j |w_j| \f]
template <class Scalar>
Scalar amplification(const Stencil<Scalar>& stencil) {
    return stencil.w.abs().sum();
}

/// The error of \f$D^2B\f$ for B = eˣ at the end x = 1, where B and its derivatives are e: the truncation of
/// the formulation, and the round-off of a scalar with the distance ε from 1 to the next number.
struct ErrorModel {
    double exponent;       ///< p of the leading error
    double constant;       ///< \f$e\,|C|\f$ of the leading error
    double amplification;  ///< \f$e \sum_j |w_j|\f$

    /// \f[ e\,|C|\,\delta^p \f]
    [[nodiscard]] double truncation(double spacing) const { return constant * std::pow(spacing, exponent); }

    /// Each value is rounded by ε/2 of its size e at most.
    /// \f[ \frac{\varepsilon}{2}\, \frac{e \sum_j |w_j|}{\delta^2} \f]
    [[nodiscard]] double round_off(double spacing, double epsilon) const {
        return amplification * epsilon / 2 / (spacing * spacing);
    }

    /// The spacing at which the sum of both is least: p times the truncation is twice the round-off.
    /// \f[ \delta = \Big( \frac{\varepsilon \sum_j |w_j|}{p\,|C|} \Big)^{1/(p+2)} \f]
    [[nodiscard]] double best_spacing(double epsilon) const {
        return std::pow(amplification * epsilon / (exponent * constant), 1 / (exponent + 2));
    }
};

/// The model of a formulation, from its limit stencil at the end.
template <class Scalar>
ErrorModel error_model(const Formulation<Scalar>& formulation,
                       const numerical_tests::Discretisation& how = {}) {
    const Stencil<Scalar> end = near_end(formulation, how, 0, 2);
    const auto [exponent, constant] = leading_error(end, 2);
    const double e = std::exp(1.0);
    return {static_cast<double>(exponent), e * std::abs(static_cast<double>(constant)),
            e * static_cast<double>(amplification(end))};
}

}  // namespace asprone2010::limit_stencils
