#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "asprone2010/limit_stencils.hpp"

namespace asprone2010::limit_stencils {

/// The factor of \f$\delta^{k-d} B^{(k)}\f$ in the error of a row.
/// \f[ \frac{m_k}{k!} - \delta_{kd} \f]
template <class Scalar>
Scalar taylor_coefficient(const Stencil<Scalar>& stencil, int k, int derivative) {
    Scalar factorial(1);
    for (int n = 2; n <= k; ++n) factorial *= n;
    return moment(stencil, k) / factorial - (k == derivative ? 1 : 0);
}

/// The first term of the error that does not vanish, \f$C\,\delta^p\,B^{(p+d)}(x_i)\f$.
template <class Scalar>
struct LeadingError {
    int exponent;     ///< p
    Scalar constant;  ///< C
};

/// The leading error of a row: the first of its Taylor coefficients that is larger than round-off.
/// \param derivative 1 for a row of D, 2 for a row of D²
/// \throws base::FailedComputation where the first twelve coefficients vanish
template <class Scalar>
LeadingError<Scalar> leading_error(const Stencil<Scalar>& stencil, int derivative) {
    using std::abs, std::sqrt;
    const Scalar negligible = sqrt(std::numeric_limits<Scalar>::epsilon());
    for (int k = 1; k <= 12; ++k) {
        const Scalar size = absolute_moment(stencil, k);
        const Scalar coefficient = taylor_coefficient(stencil, k, derivative);
        if (abs(coefficient) > negligible * (size > 1 ? Scalar(1) : size))
            return {k - derivative, coefficient};
    }
    throw base::FailedComputation("no term of the error's expansion up to the twelfth derivative stands out");
}

/// The error of a row for \f$B = e^{x - x_i}\f$, whose derivatives at \f$x_i\f$ are all one, over
/// \f$\delta^p\f$: it tends to the constant C of the leading error as δ vanishes.
/// \f[ \delta^{-p} \Big( \delta^{-d} \sum_j w_j\,[e^{\delta r_j} - 1] - 1 \Big) \f]
template <class Scalar>
Scalar scaled_error(const Stencil<Scalar>& stencil, int derivative, const Scalar& spacing, int exponent) {
    using std::pow;
    const auto& [r, w] = stencil;
    const Scalar sum = (w * ((r * spacing).exp() - 1)).sum();
    return (sum * pow(spacing, -derivative) - 1) * pow(spacing, -exponent);
}

/// Romberg's extrapolation to δ = 0 of a function with an expansion in powers of δ.
/// \f[ T_{k,l} = T_{k,l-1} + \frac{T_{k,l-1} - T_{k-1,l-1}}{2^l - 1} \f]
/// \param values \f$T_{k,0}\f$, the function at spacings of which each is half of the one before
template <class Scalar, std::size_t count>
Scalar extrapolated(std::array<Scalar, count> values) {
    using std::ldexp;
    for (std::size_t level = 1; level < count; ++level)
        for (std::size_t k = count - 1; k >= level; --k)
            values[k] += (values[k] - values[k - 1]) / (ldexp(Scalar(1), static_cast<int>(level)) - 1);
    return values.back();
}

/// The constant of the leading error as \f$e^x\f$ shows it: the scaled error on six lines of particles,
/// extrapolated to δ = 0. It shares with leading_error() only the operators, which are assembled for each
/// spacing anew.
/// \param exponent p of leading_error()
template <class Scalar>
Scalar measured_constant(const Formulation<Scalar>& formulation, const numerical_tests::Discretisation& how,
                         Index from_end, int derivative, int exponent) {
    using std::ldexp;
    const int coarsest = exponent > 2 ? -6 : -10;  // round-off covers a high power of a small spacing
    std::array<Scalar, 6> values;
    for (int k = 0; k < 6; ++k) {
        const Scalar spacing = ldexp(Scalar(1), coarsest - k);
        values[static_cast<std::size_t>(k)] = scaled_error(
            near_end(formulation, how, from_end, derivative, spacing), derivative, spacing, exponent);
    }
    return extrapolated(values);
}

}  // namespace asprone2010::limit_stencils
