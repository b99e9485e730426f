#pragma once

#include "asprone2010/section_3_4_fpm.hpp"

namespace asprone2010 {

/// Section 3.5, the modified finite particle method: both derivatives at once, from known values.
///
/// Where \f$B(x_i)\f$ is known, the two projections of the second-order expansion determine DB and D²B.
///
/// Why it is of first order at the boundary: the system gives both derivatives of a quadratic, everywhere.
/// The next moment of the weights of D²B, \f$\sum_j w_j(x_j - x_i)^3/6\f$, vanishes inside by symmetry and is
/// \f$1.014\,\delta\f$ at an end, with h = δ.
///
/// | paper | code | meaning |
/// | --- | --- | --- |
/// | \f$A\f$ | `matrix` | first moments and half second moments of \f$W_i\f$ and \f$DW_i\f$ |
/// | \f$e''_1, e''_2\f$ | `first_remainder`, `second_remainder` | remainders of the truncated expansion |
///
/// Departures from the print: the remainders are subtracted, as in Section 3.4. \eq{A38} stands without its
/// middle lines, which factor the norms and the powers of h out of A; the code computes the first line.
///
/// What this section claims, and what was measured: \claims{A-3.5}.
/// Its weights and their moments, on particles that you move: \ref live_stencil.
namespace modified_fpm {

/// Expansion against \f$W_i\f$; returns the remainder \f$e''_1\f$. \defeq{A33}
/// \f[ \begin{aligned}
///     DB(x_i)\int_\Omega (x-x_i)\,W_i\,d\Omega &+ \tfrac12 D^2B(x_i)\int_\Omega (x-x_i)^2\,W_i\,d\Omega
///     \\ &= \int_\Omega [B(x)-B(x_i)]\,W_i\,d\Omega - e''_1
///     \end{aligned} \tag{33} \f]
inline double first_remainder(const Function& B, double DB_i, double D2B_i, const CentredKernel& W_i) {
    const double projected = W_i.integral([&](double x) { return (B(x) - B(W_i.x)) * W_i.W(x); });
    return projected - DB_i * W_i.moment(1, W_i.W) - D2B_i * W_i.moment(2, W_i.W) / 2;
}

/// Expansion against \f$DW_i\f$; returns the remainder \f$e''_2\f$. \defeq{A34}
/// \f[ \begin{aligned}
///     DB(x_i)\int_\Omega (x-x_i)\,DW_i\,d\Omega &+ \tfrac12 D^2B(x_i)\int_\Omega (x-x_i)^2\,DW_i\,d\Omega
///     \\ &= \int_\Omega [B(x)-B(x_i)]\,DW_i\,d\Omega - e''_2
///     \end{aligned} \tag{34} \f]
inline double second_remainder(const Function& B, double DB_i, double D2B_i, const CentredKernel& W_i) {
    const double projected = W_i.integral([&](double x) { return (B(x) - B(W_i.x)) * W_i.DW(x); });
    return projected - DB_i * W_i.moment(1, W_i.DW) - D2B_i * W_i.moment(2, W_i.DW) / 2;
}

/// The matrix, by quadrature. \defeq{A35}
/// \f[ \begin{aligned}
///     A_{11} &= \int_\Omega (x-x_i)\,W_i\,d\Omega, & A_{12} &= \tfrac12\int_\Omega (x-x_i)^2\,W_i\,d\Omega,
///     \\ A_{21} &= \int_\Omega (x-x_i)\,DW_i\,d\Omega,
///     & A_{22} &= \tfrac12\int_\Omega (x-x_i)^2\,DW_i\,d\Omega
///     \end{aligned} \tag{35} \f]
inline Eigen::Matrix2d matrix(const CentredKernel& W_i) {
    return Eigen::Matrix2d{{W_i.moment(1, W_i.W), W_i.moment(2, W_i.W) / 2},
                           {W_i.moment(1, W_i.DW), W_i.moment(2, W_i.DW) / 2}};
}

/// The matrix, as sums over particles.
template <class Scalar>
Eigen::Matrix<Scalar, 2, 2> matrix(const Neighbourhood<Scalar>& near) {
    const auto& [r, W, DW, V] = near;
    return Eigen::Matrix<Scalar, 2, 2>{{(r * W * V).sum(), (r * r * W * V).sum() / 2},
                                       {(r * DW * V).sum(), (r * r * DW * V).sum() / 2}};
}

/// Both derivatives from the system without remainders. \defeq{A36}
/// \f[ \begin{bmatrix} A_{11} & A_{12} \\ A_{21} & A_{22} \end{bmatrix}
///     \begin{bmatrix} DB(x_i) \\ D^2B(x_i) \end{bmatrix}
///     = \begin{bmatrix} \int_\Omega [B(x)-B(x_i)]\,W_i\,d\Omega \\ \int_\Omega [B(x)-B(x_i)]\,DW_i\,d\Omega
///       \end{bmatrix} - \begin{bmatrix} e''_1 \\ e''_2 \end{bmatrix} \tag{36} \f]
/// \return \f$DB(x_i)\f$ and \f$D^2B(x_i)\f$
inline Eigen::Vector2d derivatives(const Function& B, const CentredKernel& W_i) {
    const Eigen::Vector2d projected{W_i.integral([&](double x) { return (B(x) - B(W_i.x)) * W_i.W(x); }),
                                    W_i.integral([&](double x) { return (B(x) - B(W_i.x)) * W_i.DW(x); })};
    return inverse(matrix(W_i)) * projected;
}

/// \eq{A36} as sums over particles: both derivatives of this formulation.
/// \param near the particles in the support of \f$W_i\f$
/// \return weights on \f$B(x_j) - B(x_i)\f$ [1/h, 1/h²]
/// \throws SingularNeighbourhood where the particles do not determine the two unknowns
template <class Scalar>
Derivatives<Scalar> derivatives(const Neighbourhood<Scalar>& near) {
    const auto& [r, W, DW, V] = near;
    const Eigen::Matrix<Scalar, 2, 2> A_inverse = inverse(matrix(near));
    return {(A_inverse(0, 0) * W + A_inverse(0, 1) * DW) * V,
            (A_inverse(1, 0) * W + A_inverse(1, 1) * DW) * V};
}

/// Far from the boundary \f$A_{11} = A_{22} = 0\f$, and the two equations decouple. \defeq{A37}
/// \f[ \begin{bmatrix} DB(x_i) \\ D^2B(x_i) \end{bmatrix}
///     = \begin{bmatrix} \int_\Omega [B(x)-B(x_i)]\,DW_i\,d\Omega / A_{21}
///                       \\ \int_\Omega [B(x)-B(x_i)]\,W_i\,d\Omega / A_{12} \end{bmatrix}
///     - \begin{bmatrix} e''_2/A_{21} \\ e''_1/A_{12} \end{bmatrix} \tag{37} \f]
inline Eigen::Vector2d interior_derivatives(const Function& B, const CentredKernel& W_i) {
    const Eigen::Matrix2d A = matrix(W_i);
    return {W_i.integral([&](double x) { return (B(x) - B(W_i.x)) * W_i.DW(x); }) / A(1, 0),
            W_i.integral([&](double x) { return (B(x) - B(W_i.x)) * W_i.W(x); }) / A(0, 1)};
}

/// Error of \eq{A36} without remainders, computed minus exact: at the boundary O(h²) for DB and O(h) for D²B,
/// inside O(h²) for both. \defeq{A38}
/// \f[ \begin{bmatrix} A_{11} & A_{12} \\ A_{21} & A_{22} \end{bmatrix}^{-1}
///     \begin{bmatrix} e''_1 \\ e''_2 \end{bmatrix}
///     = \begin{bmatrix} O(h^2) \\ O(h) \end{bmatrix} \tag{38} \f]
inline Eigen::Vector2d error(const Function& B, double DB_i, double D2B_i, const CentredKernel& W_i) {
    return inverse(matrix(W_i)) *
           Eigen::Vector2d{first_remainder(B, DB_i, D2B_i, W_i), second_remainder(B, DB_i, D2B_i, W_i)};
}

}  // namespace modified_fpm
}  // namespace asprone2010
