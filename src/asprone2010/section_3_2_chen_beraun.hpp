#pragma once

#include "asprone2010/section_3_1_original.hpp"

namespace asprone2010 {

/// Section 3.2, Chen and Beraun: Taylor's expansion, weighted with the kernel and integrated.
///
/// The first-order expansion against \f$DW_i\f$ gives DB, the second-order one against \f$W_i\f$ gives D²B,
/// which takes DB from the former.
///
/// Why it holds inside and not at the boundary: the quotient \eq{A16} is exact on linear functions,
/// everywhere. Of a quadratic it leaves 0 inside and \f$0.585\,\delta B''\f$ at an end, with h = δ. \eq{A20}
/// divides that by δ: the second moment of its weights, \f$\sum_j w_j(x_j - x_i)^2/2\f$, which must be one,
/// is 1.000 inside and -0.072 at an end.
///
/// | paper | code | meaning |
/// | --- | --- | --- |
/// | \f$DB(x_i),\ D^2B(x_i)\f$ | `DB_i`, `D2B_i` | derivatives at the particle, exact or approximated |
/// | \f$e\f$ | `first_remainder`, `second_remainder` | remainders of the truncated expansion |
/// | \f$\|W_i\|_{L^1}\f$ | `W_i.norm(W_i.W)` | norm of the kernel |
///
/// Departures from the print: \eq{A14} has the error e on its right-hand side, so that DB is the quotient
/// *minus* e over the denominator; \eq{A15} and \eq{A19} print plus. Here both equations stand without e, as
/// they are used, and the equality signs of \eq{A15}, \eq{A19} and \eq{A20} are approximate. And the error of
/// \eq{A20} at the boundary is O(h) only if that of DB is O(h²): with DB from \eq{A16}, whose error O(h) is
/// divided by h, the error of D²B is a constant.
///
/// What this section claims, and what was measured: \claims{A-3.2}.
/// Its weights and their moments, on particles that you move: \ref live_stencil.
namespace chen_beraun {

/// Taylor's expansion to the first derivative. \defeq{A13}
/// \f[ B(x) = B(x_i) + (x - x_i)\,DB(x_i) + O(|x - x_i|^2) \tag{13} \f]
/// \param r offset \f$x - x_i\f$
inline double expansion(double B_i, double DB_i, double r) {
    return B_i + r * DB_i;
}

/// The expansion against \f$DW_i\f$: its remainder e, of size \f$\|DW_i\|_{L^1} O(h^2)\f$. \defeq{A14}
/// \f[ \int_\Omega B\,DW_i\,d\Omega = B(x_i)\int_\Omega DW_i\,d\Omega
///     + DB(x_i)\int_\Omega (x-x_i)\,DW_i\,d\Omega + e \tag{14} \f]
/// \param DB_i the exact derivative at \f$x_i\f$
inline double first_remainder(const Function& B, double DB_i, const CentredKernel& W_i) {
    const double projected = W_i.integral([&](double x) { return B(x) * W_i.DW(x); });
    return projected - B(W_i.x) * W_i.moment(0, W_i.DW) - DB_i * W_i.moment(1, W_i.DW);
}

/// Solved for the derivative, e neglected. \defeq{A15}
/// \f[ DB(x_i) \cong \frac{\int_\Omega [B(x) - B(x_i)]\,DW_i(x)\,d\Omega}
///                        {\int_\Omega (x - x_i)\,DW_i(x)\,d\Omega} \tag{15} \f]
inline double first_derivative(const Function& B, const CentredKernel& W_i) {
    const double projected = W_i.integral([&](double x) { return (B(x) - B(W_i.x)) * W_i.DW(x); });
    return projected / W_i.moment(1, W_i.DW);
}

/// First derivative: the static moment of \f$DW_i\f$ is the correction factor. \defeq{A16}
/// \f[ DB(x_i) \cong \frac{\sum_j [B(x_j) - B(x_i)]\,DW_i(x_j)\,\Delta\Omega_j}
///                        {\sum_j (x_j - x_i)\,DW_i(x_j)\,\Delta\Omega_j} \tag{16} \f]
/// \param near the particles in the support of \f$W_i\f$
/// \return weights on \f$B(x_j) - B(x_i)\f$ [1/h]
/// \throws SingularNeighbourhood where the static moment vanishes
template <class Scalar>
Column<Scalar> first_derivative(const Neighbourhood<Scalar>& near) {
    const auto& [r, W, DW, V] = near;
    return DW * V / nonzero_sum(r * DW * V);
}

/// Taylor's expansion to the second derivative. \defeq{A17}
/// \f[ B(x) = B(x_i) + (x-x_i)\,DB(x_i) + \tfrac12 (x-x_i)^2\,D^2B(x_i) + O(|x-x_i|^3) \tag{17} \f]
inline double expansion(double B_i, double DB_i, double D2B_i, double r) {
    return B_i + r * DB_i + r * r * D2B_i / 2;
}

/// The expansion against \f$W_i\f$: its remainder e, of size \f$\|W_i\|_{L^1} O(h^3)\f$. \defeq{A18}
/// \f[ \begin{aligned}
///     \int_\Omega B\,W_i\,d\Omega &= B(x_i)\int_\Omega W_i\,d\Omega
///     + DB(x_i)\int_\Omega (x-x_i)\,W_i\,d\Omega
///     \\ &+ \tfrac12 D^2B(x_i)\int_\Omega (x-x_i)^2\,W_i\,d\Omega + e
///     \end{aligned} \tag{18} \f]
inline double second_remainder(const Function& B, double DB_i, double D2B_i, const CentredKernel& W_i) {
    const auto& W = W_i.W;
    const double projected = W_i.integral([&](double x) { return B(x) * W(x); });
    return projected - B(W_i.x) * W_i.moment(0, W) - DB_i * W_i.moment(1, W) - D2B_i * W_i.moment(2, W) / 2;
}

/// Solved for the second derivative, e neglected. \defeq{A19}
/// \f[ D^2B(x_i) \cong \frac{\int_\Omega (B(x)-B(x_i))\,W_i(x)\,d\Omega
///                           - DB(x_i)\int_\Omega (x-x_i)\,W_i(x)\,d\Omega}
///                          {\frac12\int_\Omega (x-x_i)^2\,W_i(x)\,d\Omega} \tag{19} \f]
/// \param DB_i the first derivative at \f$x_i\f$, exact or from \eq{A15}
inline double second_derivative(const Function& B, double DB_i, const CentredKernel& W_i) {
    const double projected = W_i.integral([&](double x) { return (B(x) - B(W_i.x)) * W_i.W(x); });
    return (projected - DB_i * W_i.moment(1, W_i.W)) / (W_i.moment(2, W_i.W) / 2);
}

/// Second derivative, with any approximation of the first: its weights D make the term of DB one more weight
/// on each difference. Whoever knows DB exactly passes zeros and subtracts that term, which then is
/// \f$DB(x_i)\f$ times a number. \defeq{A20}
/// \f[ D^2B(x_i) \cong \frac{\sum_j (B(x_j)-B(x_i))\,W_i(x_j)\,\Delta\Omega_j
///                           - DB(x_i)\sum_j (x_j-x_i)\,W_i(x_j)\,\Delta\Omega_j}
///                          {\frac12\sum_j (x_j-x_i)^2\,W_i(x_j)\,\Delta\Omega_j} \tag{20} \f]
/// \param D weights of \f$DB(x_i)\f$ on \f$B(x_j) - B(x_i)\f$ [1/h]
/// \return weights on \f$B(x_j) - B(x_i)\f$ [1/h²]
/// \throws SingularNeighbourhood where the second moment vanishes
template <class Scalar>
Column<Scalar> second_derivative(const Neighbourhood<Scalar>& near, const Column<Scalar>& D) {
    const auto& [r, W, DW, V] = near;
    return (W * V - D * (r * W * V).sum()) / (nonzero_sum(r * r * W * V) / 2);
}

/// Both derivatives of the formulation: \eq{A16}, and \eq{A20} with DB from \eq{A16}.
template <class Scalar>
Derivatives<Scalar> derivatives(const Neighbourhood<Scalar>& near) {
    const Column<Scalar> D = first_derivative(near);
    return {D, second_derivative(near, D)};
}

}  // namespace chen_beraun
}  // namespace asprone2010
