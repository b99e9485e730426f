#pragma once

#include "asprone2010/section_3_3_rkpm.hpp"
#include "asprone2010/section_3_5_modified_fpm.hpp"

namespace asprone2010 {

/// Section 4, the novel second-order FPM: the modified FPM with a kernel whose first and third moments vanish.
///
/// The projection is that of Section 3.5, the correction of the kernel that of Section 3.3 with other exponents: a cubic
/// without its quadratic term. Inside, where the odd moments of \f$W_i\f$ vanish by themselves, a quadratic polynomial
/// would leave two conditions that say the same; the cubic does not.
///
/// | paper | code | meaning |
/// | --- | --- | --- |
/// | \f$a, b, c\f$ | `c[2], c[1], c[0]` | coefficients of the correction polynomial |
/// | \f$K_i,\ DK_i\f$ | `K_i.W`, `K_i.DW` | corrected kernel and its derivative |
/// | \f$e'''_1, e'''_2\f$ | `modified_fpm::first_remainder(…, K_i)` … | what the truncated expansion leaves |
///
/// Departures from the print: far from the boundary \f$K_i\f$ is \f$W_i\f$ divided by its discrete integral, which on the
/// uniform lattice with h = δ is 1.0001 and not 1. The factor cancels in \eq{A43}.
/// \eq{A44} stands without its middle lines, in which the norms and the powers of h are taken out of A; the inverse
/// is written with A in the place of the constants C.
///
/// What this section claims, and what was measured: \claims{A-4}.
namespace second_order_fpm {

/// The corrected kernel, for the integral forms; its coefficients a, b, c follow from \eq{A41}. \defeq{A39}
/// \f[ K_i(x) = C_i(x) \cdot W_i(x) \tag{39} \f]
/// The polynomial has the exponents 0, 1 and 3 of the scaled offset. \defeq{A40}
/// \f[ C_i(x) = a\Big(\frac{x-x_i}{h}\Big)^3 + b\,\frac{x-x_i}{h} + c \tag{40} \f]
inline CentredKernel corrected(const CentredKernel& W_i) {
    return rkpm::corrected<0, 1, 3>(W_i);
}

/// The three moments that the coefficients a, b, c are determined by; of \f$K_i\f$ they must be 1, 0 and 0. \defeq{A41}
/// \f[ \int_\Omega K_i\,d\Omega = 1, \qquad \int_\Omega (x-x_i)\,K_i\,d\Omega = 0, \qquad
///     \int_\Omega (x-x_i)^3\,K_i\,d\Omega = 0 \tag{41} \f]
/// \return the moments of order 0, 1 and 3 [1, length, length³]
inline Eigen::Vector3d imposed_moments(const CentredKernel& K_i) {
    return {K_i.moment(0, K_i.W), K_i.moment(1, K_i.W), K_i.moment(3, K_i.W)};
}

/// The corrected kernel at the particles, the conditions imposed on the sums. \defeq{A42}
/// \f[ \sum_j K_i(x_j)\,\Delta\Omega_j = 1, \qquad \sum_j (x_j-x_i)\,K_i(x_j)\,\Delta\Omega_j = 0, \qquad
///     \sum_j (x_j-x_i)^3\,K_i(x_j)\,\Delta\Omega_j = 0 \tag{42} \f]
/// \throws SingularNeighbourhood where the particles do not determine a, b and c
template <class Scalar>
Neighbourhood<Scalar> corrected(const Neighbourhood<Scalar>& near) {
    return rkpm::corrected<0, 1, 3>(near);
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

/// Error of \eq{A43} without remainders, computed minus exact: O(h²) for both derivatives, everywhere. \defeq{A44}
/// \f[ \begin{bmatrix} 0 & A_{12} \\ A_{21} & A_{22} \end{bmatrix}^{-1}
///     \begin{bmatrix} e'''_1 \\ e'''_2 \end{bmatrix}
///     = \begin{bmatrix} -\dfrac{A_{22}}{A_{12}A_{21}} & \dfrac{1}{A_{21}} \\[2ex] \dfrac{1}{A_{12}} & 0 \end{bmatrix}
///       \begin{bmatrix} e'''_1 \\ e'''_2 \end{bmatrix} = \begin{bmatrix} O(h^2) \\ O(h^2) \end{bmatrix} \tag{44} \f]
/// \param K_i the corrected kernel
inline Eigen::Vector2d error(const Function& B, double DB_i, double D2B_i, const CentredKernel& K_i) {
    const Eigen::Matrix2d A = modified_fpm::matrix(K_i);
    const double e_1 = modified_fpm::first_remainder(B, DB_i, D2B_i, K_i);
    const double e_2 = modified_fpm::second_remainder(B, DB_i, D2B_i, K_i);
    return {-A(1, 1) / (A(0, 1) * A(1, 0)) * e_1 + e_2 / A(1, 0), e_1 / A(0, 1)};
}

}  // namespace second_order_fpm
}  // namespace asprone2010
