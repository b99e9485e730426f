#pragma once

#include <array>
#include <cmath>

#include "asprone2010/section_3_3_rkpm.hpp"
#include "asprone2010/section_3_5_modified_fpm.hpp"

namespace asprone2010 {

/// Section 4, the novel second-order FPM: the modified FPM with a kernel whose first and third moments
/// vanish.
///
/// The projection is that of Section 3.5. The correction of the kernel is that of Section 3.3 with other
/// exponents: a cubic without quadratic term. A quadratic polynomial would not do: inside, the odd moments of
/// \f$W_i\f$ vanish, and two of the conditions would be the same.
///
/// Why it is of second order everywhere: the third moment of the weights of D²B, which the modified FPM
/// leaves as \f$1.014\,\delta\f$ at an end, is made zero, on half a neighbourhood too. The fourth is left,
/// \f$0.126\,\delta^2\f$ inside and \f$-0.920\,\delta^2\f$ at an end, with h = δ.
///
/// | paper | code | meaning |
/// | --- | --- | --- |
/// | \f$C_i,\ dC_i/ds\f$ | `correction`, `correction_derivative` | correction polynomial |
/// | \f$a, b, c\f$ | `a, b, c` | its coefficients |
/// | \f$K_i,\ DK_i\f$ | `K_i.W`, `K_i.DW` | corrected kernel and its derivative |
/// | \f$e'''_1, e'''_2\f$ | `modified_fpm::first_remainder(…, K_i)` … | the remainders |
///
/// Departures from the print: far from the boundary \f$K_i\f$ is \f$W_i\f$ divided by its discrete integral,
/// which on the uniform lattice with h = δ is 1.0001 and not 1. The factor cancels in \eq{A43}. \eq{A44}
/// stands without its middle lines, which factor the norms and the powers of h out of A; the inverse has the
/// entries of A in the place of the constants C.
///
/// What this section claims, and what was measured: \claims{A-4}.
/// Its weights and their moments, on particles that you move: \ref live_stencil.
namespace second_order_fpm {

/// The corrected kernel, for the integral forms. \defeq{A39}
/// \f[ K_i(x) = C_i(x) \cdot W_i(x) \tag{39} \f]
/// \param C_i the correction polynomial, a function of the scaled offset
/// \param DC_i its derivative
template <class Polynomial, class Slope>
CentredKernel corrected(const CentredKernel& W_i, const Polynomial& C_i, const Slope& DC_i) {
    const auto s = [W_i](double x) { return (x - W_i.x) / W_i.h; };
    CentredKernel K_i = W_i;
    K_i.W = [=](double x) { return C_i(s(x)) * W_i.W(x); };
    K_i.DW = [=](double x) { return DC_i(s(x)) / W_i.h * W_i.W(x) + C_i(s(x)) * W_i.DW(x); };
    return K_i;
}

/// The coefficients of \eq{A40}.
template <class Scalar>
struct Coefficients {
    Scalar a, b, c;
};

/// The correction polynomial, a cubic of the scaled offset without quadratic term. \defeq{A40}
/// \f[ C_i(x) = a\Big(\frac{x-x_i}{h}\Big)^3 + b\,\frac{x-x_i}{h} + c \tag{40} \f]
/// \param s scaled offset \f$(x - x_i)/h\f$, a number or a column
template <class Scalar, class Offset>
Offset correction(const Coefficients<Scalar>& coefficients, const Offset& s) {
    const auto& [a, b, c] = coefficients;
    return c + b * s + a * (s * s * s);
}

/// \f$dC_i/ds\f$, the derivative of \eq{A40}.
template <class Scalar, class Offset>
Offset correction_derivative(const Coefficients<Scalar>& coefficients, const Offset& s) {
    const auto& [a, b, c] = coefficients;
    return b + 3 * a * (s * s);
}

/// The three moments that determine the coefficients a, b, c: of \f$K_i\f$ they must be 1, 0 and 0.
/// \defeq{A41}
/// \f[ \int_\Omega K_i\,d\Omega = 1, \qquad \int_\Omega (x-x_i)\,K_i\,d\Omega = 0, \qquad
///     \int_\Omega (x-x_i)^3\,K_i\,d\Omega = 0 \tag{41} \f]
/// \return the moments of order 0, 1 and 3 [1, length, length³]
inline Eigen::Vector3d imposed_moments(const CentredKernel& K_i) {
    return {K_i.moment(0, K_i.W), K_i.moment(1, K_i.W), K_i.moment(3, K_i.W)};
}

/// The coefficients with which \eq{A41}, or \eq{A42}, holds:
/// \f[ \begin{bmatrix} m_0 & m_1 & m_3 \\ m_1 & m_2 & m_4 \\ m_3 & m_4 & m_6 \end{bmatrix}
///     \begin{bmatrix} c \\ b \\ a \end{bmatrix} = \begin{bmatrix} 1 \\ 0 \\ 0 \end{bmatrix} \f]
/// \param m moments of \f$W_i\f$ of order 0 to 6, in units of h
/// \throws SingularNeighbourhood where the particles do not determine a, b and c
template <class Scalar>
Coefficients<Scalar> coefficients(const std::array<Scalar, 7>& m) {
    const Eigen::Matrix<Scalar, 3, 3> M{{m[0], m[1], m[3]}, {m[1], m[2], m[4]}, {m[3], m[4], m[6]}};
    const Eigen::Matrix<Scalar, 3, 1> cba = inverse(M).col(0);
    return {cba[2], cba[1], cba[0]};
}

/// \eq{A39} with the coefficients that follow from \eq{A41}.
inline CentredKernel corrected(const CentredKernel& W_i) {
    std::array<double, 7> m{};
    for (int k = 0; k <= 6; ++k) m[static_cast<std::size_t>(k)] = W_i.moment(k, W_i.W) / std::pow(W_i.h, k);
    const Coefficients<double> abc = coefficients(m);
    return corrected(
        W_i, [abc](double s) { return correction(abc, s); },
        [abc](double s) { return correction_derivative(abc, s); });
}

/// The corrected kernel at the particles, the conditions imposed on the sums.
///
/// The neighbourhood's own sums give a, b and c, which give \f$C_i\f$ and its derivative at each particle. K
/// takes the place of W, and DK by the product rule that of DW: what returns is a neighbourhood like any
/// other. \defeq{A42}
/// \f[ \sum_j K_i(x_j)\,\Delta\Omega_j = 1, \qquad \sum_j (x_j-x_i)\,K_i(x_j)\,\Delta\Omega_j = 0, \qquad
///     \sum_j (x_j-x_i)^3\,K_i(x_j)\,\Delta\Omega_j = 0 \tag{42} \f]
/// \throws SingularNeighbourhood where the particles do not determine a, b and c
template <class Scalar>
Neighbourhood<Scalar> corrected(const Neighbourhood<Scalar>& near) {
    const auto& [r, W, DW, V] = near;
    const Coefficients<Scalar> abc = coefficients(rkpm::moments<6>(near));
    const Column<Scalar> C = correction(abc, r), DC = correction_derivative(abc, r);
    return {r, C * W, DC * W + C * DW, V};
}

/// Both derivatives: the modified FPM's system with \f$K_i\f$ and \f$DK_i\f$. \defeq{A43}
/// \f[ \begin{bmatrix} A_{11} & A_{12} \\ A_{21} & A_{22} \end{bmatrix}
///     \begin{bmatrix} DB(x_i) \\ D^2B(x_i) \end{bmatrix}
///     = \begin{bmatrix} \int_\Omega [B(x)-B(x_i)]\,K_i\,d\Omega \\ \int_\Omega [B(x)-B(x_i)]\,DK_i\,d\Omega
///       \end{bmatrix} - \begin{bmatrix} e'''_1 \\ e'''_2 \end{bmatrix} \tag{43} \f]
/// \param K_i the corrected kernel
/// \return \f$DB(x_i)\f$ and \f$D^2B(x_i)\f$
inline Eigen::Vector2d derivatives(const Function& B, const CentredKernel& K_i) {
    return modified_fpm::derivatives(B, K_i);
}

/// \eq{A43} as sums over particles: both derivatives of this formulation.
/// \param near the particles in the support of \f$W_i\f$
/// \return weights on \f$B(x_j) - B(x_i)\f$ [1/h, 1/h²]
/// \throws SingularNeighbourhood where the particles do not determine K or the two unknowns
template <class Scalar>
Derivatives<Scalar> derivatives(const Neighbourhood<Scalar>& near) {
    return modified_fpm::derivatives(corrected(near));
}

/// Error of \eq{A43} without remainders, computed minus exact: O(h²) for both derivatives, everywhere.
/// \defeq{A44}
/// \f[ \begin{bmatrix} 0 & A_{12} \\ A_{21} & A_{22} \end{bmatrix}^{-1}
///     \begin{bmatrix} e'''_1 \\ e'''_2 \end{bmatrix}
///     = \begin{bmatrix} -\dfrac{A_{22}}{A_{12}A_{21}} & \dfrac{1}{A_{21}}
///                       \\[2ex] \dfrac{1}{A_{12}} & 0 \end{bmatrix}
///       \begin{bmatrix} e'''_1 \\ e'''_2 \end{bmatrix}
///     = \begin{bmatrix} O(h^2) \\ O(h^2) \end{bmatrix} \tag{44} \f]
/// \param K_i the corrected kernel
inline Eigen::Vector2d error(const Function& B, double DB_i, double D2B_i, const CentredKernel& K_i) {
    const Eigen::Matrix2d A = modified_fpm::matrix(K_i);
    const double e_1 = modified_fpm::first_remainder(B, DB_i, D2B_i, K_i);
    const double e_2 = modified_fpm::second_remainder(B, DB_i, D2B_i, K_i);
    return {-A(1, 1) / (A(0, 1) * A(1, 0)) * e_1 + e_2 / A(1, 0), e_1 / A(0, 1)};
}

}  // namespace second_order_fpm
}  // namespace asprone2010
