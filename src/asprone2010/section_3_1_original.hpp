#pragma once

#include <utility>

#include "asprone2010/section_2_classical_sph.hpp"

namespace asprone2010 {

/// Section 3.1, the original formulation (Gingold and Monaghan): the derivative is moved onto the kernel.
///
/// Inside the domain the boundary term of \eq{A6} is negligible and \eq{A7} is a fair approximation. Near the
/// boundary it is not. \eq{A10} is exact on constants, and on constants only: at an end, \eq{A11} gives
/// half the derivative for every δ.
///
/// Why it fails at the boundary: nothing binds the first moment \f$\sum_j w_j(x_j - x_i)\f$ of the weights of
/// DB, which must be one if a linear function is to be differentiated. With h = δ it is 0.998 inside, and
/// 0.499 at an end, where half of the kernel lies outside. Applied twice, the formulation finds a second
/// derivative of 0.193/δ in the function x, at an end.
///
/// | paper | code | meaning |
/// | --- | --- | --- |
/// | \f$DB(x_i)\f$ | `first_derivative` | approximation of the first derivative |
/// | \f$D^2B(x_i)\f$ | `second_derivative` | approximation of the second derivative |
/// | \f$n\f$ | −1, +1 | outward normal at the ends of Ω |
///
/// What this section claims, and what was measured: \claims{A-3.1}.
/// Its weights and their moments, on particles that you move: \ref live_stencil.
namespace original {

/// The first step applied to the derivative. \defeq{A5}
/// \f[ DB(x_i) \cong \int_\Omega DB(x)\,W_i(x)\,d\Omega \tag{5} \f]
inline double smoothed_derivative(const Function& DB, const CentredKernel& W_i) {
    return classical_sph::value(DB, W_i);
}

/// By parts, with the values at both ends of Ω. \defeq{A6}
/// \f[ DB(x_i) \cong \int_{\partial\Omega} B(x)\,W_i(x)\,n\,dS
///     - \int_\Omega B(x)\,DW_i(x)\,d\Omega \tag{6} \f]
inline double derivative_by_parts(const Function& B, const CentredKernel& W_i) {
    const auto& [a, b] = W_i.Omega;
    const double boundary = B(b) * W_i.W(b) - B(a) * W_i.W(a);
    return boundary - W_i.integral([&](double x) { return B(x) * W_i.DW(x); });
}

/// Without the boundary term, as far from the boundary. \defeq{A7}
/// \f[ DB(x_i) \cong -\int_\Omega B(x)\,DW_i(x)\,d\Omega \tag{7} \f]
inline double interior_derivative(const Function& B, const CentredKernel& W_i) {
    return -W_i.integral([&](double x) { return B(x) * W_i.DW(x); });
}

/// The same as a sum over particles. \defeq{A8}
/// \f[ DB(x_i) \cong -\sum_{j=1}^N B(x_j)\,DW_i(x_j)\,\Delta\Omega_j \tag{8} \f]
/// \return weights on \f$B(x_j)\f$ [1/h]
template <class Scalar>
Column<Scalar> interior_derivative(const Neighbourhood<Scalar>& near) {
    const auto& [r, W, DW, V] = near;
    return -DW * V;
}

/// The condition under which \eq{A7} is exact on constants; it holds where \f$W_i\f$ vanishes on the
/// boundary. \defeq{A9}
/// \f[ \int_\Omega DW_i = 0 \tag{9} \f]
/// \return the integral [1/length]; it equals \f$W_i\f$ at the last end of Ω minus \f$W_i\f$ at the first
inline double total_derivative(const CentredKernel& W_i) {
    return W_i.integral(W_i.DW);
}

/// With differences: exact on constants everywhere. \defeq{A10}
/// \f[ DB(x_i) \cong \int_\Omega [B(x_i) - B(x)]\,DW_i(x)\,d\Omega \tag{10} \f]
inline double first_derivative(const Function& B, const CentredKernel& W_i) {
    return W_i.integral([&](double x) { return (B(W_i.x) - B(x)) * W_i.DW(x); });
}

/// The same as a sum over particles: the first derivative of this formulation. \defeq{A11}
/// \f[ DB(x_i) \cong \sum_{j=1}^N [B(x_i) - B(x_j)]\,DW_i(x_j)\,\Delta\Omega_j \tag{11} \f]
/// \param near the particles in the support of \f$W_i\f$
/// \return weights on \f$B(x_j) - B(x_i)\f$ [1/h]
template <class Scalar>
Column<Scalar> first_derivative(const Neighbourhood<Scalar>& near) {
    const auto& [r, W, DW, V] = near;
    return -DW * V;
}

/// The second derivative: \eq{A11} with DB in the place of B. For all particles that is the product
/// \f$D^2 = D\,D\f$. \defeq{A12}
/// \f[ D^2B(x_i) \cong \sum_{j=1}^N [DB(x_i) - DB(x_j)]\,DW_i(x_j)\,\Delta\Omega_j \tag{12} \f]
/// \param D the operator of \eq{A11} for all particles
/// \param memory another operator, whose memory becomes the result's
template <class Scalar>
Operator<Scalar> second_derivative(const Operator<Scalar>& D, Operator<Scalar>&& memory = {}) {
    return product(D, D, std::move(memory));
}

}  // namespace original
}  // namespace asprone2010
