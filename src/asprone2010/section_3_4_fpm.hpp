#pragma once

#include <utility>

#include "asprone2010/section_3_1_original.hpp"

namespace asprone2010 {

/// Section 3.4, the finite particle method: Taylor's expansion projected on \f$W_i\f$ and \f$DW_i\f$.
///
/// Two projections of the first-order expansion give a linear system for the value and the derivative at
/// \f$x_i\f$.
///
/// Why the first derivative holds and the second does not: the expansion itself is projected, so that DB is
/// exact on linear functions, everywhere. Of a quadratic it leaves 0 inside and \f$0.600\,\delta B''\f$ at an
/// end, with h = δ, and less at each particle further in. Applied twice, it differentiates that, too: the
/// second moment of the weights, which must be one, is 1.000 inside and 0.526 at an end.
///
/// | paper | code | meaning |
/// | --- | --- | --- |
/// | \f$A\f$ | `matrix` | moments of \f$W_i\f$ and \f$DW_i\f$ |
/// | \f$e'_1, e'_2\f$ | `remainders` | remainders of the truncated expansion |
///
/// Departures from the print: \eq{A27}, \eq{A28}, \eq{A30} and \eq{A31} add the remainders to the projections
/// of B. Where a remainder is the projection of B minus that of its expansion, as in \eq{A14}, it is
/// subtracted; orders do not change. \eq{A32} stands without its middle lines, which factor the norms and the
/// powers of h out of A; the code computes the first line.
///
/// What this section claims, and what was measured: \claims{A-3.4}.
/// Its weights and their moments, on particles that you move: \ref live_stencil.
namespace fpm {

/// Expansion against \f$W_i\f$; the remainder \f$e'_1\f$ is the projection of B minus the left-hand side.
/// \defeq{A27}
/// \f[ B(x_i)\int_\Omega W_i\,d\Omega + DB(x_i)\int_\Omega (x-x_i)\,W_i\,d\Omega
///     = \int_\Omega B\,W_i\,d\Omega - e'_1 \tag{27} \f]
inline double first_remainder(const Function& B, double DB_i, const CentredKernel& W_i) {
    const double projected = W_i.integral([&](double x) { return B(x) * W_i.W(x); });
    return projected - B(W_i.x) * W_i.moment(0, W_i.W) - DB_i * W_i.moment(1, W_i.W);
}

/// Expansion against \f$DW_i\f$, likewise. \defeq{A28}
/// \f[ B(x_i)\int_\Omega DW_i\,d\Omega + DB(x_i)\int_\Omega (x-x_i)\,DW_i\,d\Omega
///     = \int_\Omega B\,DW_i\,d\Omega - e'_2 \tag{28} \f]
inline double second_remainder(const Function& B, double DB_i, const CentredKernel& W_i) {
    const double projected = W_i.integral([&](double x) { return B(x) * W_i.DW(x); });
    return projected - B(W_i.x) * W_i.moment(0, W_i.DW) - DB_i * W_i.moment(1, W_i.DW);
}

/// The matrix, by quadrature. \defeq{A29}
/// \f[ \begin{aligned}
///     A_{11} &= \int_\Omega W_i\,d\Omega, & A_{12} &= \int_\Omega (x-x_i)\,W_i\,d\Omega,
///     \\ A_{21} &= \int_\Omega DW_i\,d\Omega, & A_{22} &= \int_\Omega (x-x_i)\,DW_i\,d\Omega
///     \end{aligned} \tag{29} \f]
inline Eigen::Matrix2d matrix(const CentredKernel& W_i) {
    return Eigen::Matrix2d{{W_i.moment(0, W_i.W), W_i.moment(1, W_i.W)},
                           {W_i.moment(0, W_i.DW), W_i.moment(1, W_i.DW)}};
}

/// The matrix, as sums over particles.
template <class Scalar>
Eigen::Matrix<Scalar, 2, 2> matrix(const Neighbourhood<Scalar>& near) {
    const auto& [r, W, DW, V] = near;
    return Eigen::Matrix<Scalar, 2, 2>{{(W * V).sum(), (r * W * V).sum()},
                                       {(DW * V).sum(), (r * DW * V).sum()}};
}

/// Value and derivative from the system without remainders. \defeq{A30}
/// \f[ \begin{bmatrix} A_{11} & A_{12} \\ A_{21} & A_{22} \end{bmatrix}
///     \begin{bmatrix} B(x_i) \\ DB(x_i) \end{bmatrix}
///     = \begin{bmatrix} \int_\Omega B\,W_i\,d\Omega \\ \int_\Omega B\,DW_i\,d\Omega \end{bmatrix}
///     - \begin{bmatrix} e'_1 \\ e'_2 \end{bmatrix} \tag{30} \f]
/// \return \f$B(x_i)\f$ and \f$DB(x_i)\f$
inline Eigen::Vector2d value_and_derivative(const Function& B, const CentredKernel& W_i) {
    const Eigen::Vector2d projected{W_i.integral([&](double x) { return B(x) * W_i.W(x); }),
                                    W_i.integral([&](double x) { return B(x) * W_i.DW(x); })};
    return inverse(matrix(W_i)) * projected;
}

/// What \eq{A30} returns: weights on \f$B(x_j)\f$.
template <class Scalar>
struct ValueAndDerivative {
    Column<Scalar> value, first;  ///< in units of 1 and 1/h
};

/// \eq{A30} as sums over particles.
/// \param near the particles in the support of \f$W_i\f$
/// \throws SingularNeighbourhood where the particles do not determine the two unknowns
template <class Scalar>
ValueAndDerivative<Scalar> value_and_derivative(const Neighbourhood<Scalar>& near) {
    const auto& [r, W, DW, V] = near;
    const Eigen::Matrix<Scalar, 2, 2> A_inverse = inverse(matrix(near));
    return {(A_inverse(0, 0) * W + A_inverse(0, 1) * DW) * V,
            (A_inverse(1, 0) * W + A_inverse(1, 1) * DW) * V};
}

/// The first derivative of this formulation. The second row of \eq{A30} annihilates constants, so that its
/// weights serve differences as well.
/// \return weights on \f$B(x_j) - B(x_i)\f$ [1/h]
template <class Scalar>
Column<Scalar> first_derivative(const Neighbourhood<Scalar>& near) {
    return value_and_derivative(near).first;
}

/// Far from the boundary \f$A_{12} = A_{21} = 0\f$, and the two equations decouple. \defeq{A31}
/// \f[ \begin{bmatrix} B(x_i) \\ DB(x_i) \end{bmatrix}
///     = \begin{bmatrix} \int_\Omega B\,W_i\,d\Omega / A_{11}
///                       \\ \int_\Omega B\,DW_i\,d\Omega / A_{22} \end{bmatrix}
///     - \begin{bmatrix} e'_1/A_{11} \\ e'_2/A_{22} \end{bmatrix} \tag{31} \f]
inline Eigen::Vector2d interior_value_and_derivative(const Function& B, const CentredKernel& W_i) {
    const Eigen::Matrix2d A = matrix(W_i);
    return {W_i.integral([&](double x) { return B(x) * W_i.W(x); }) / A(0, 0),
            W_i.integral([&](double x) { return B(x) * W_i.DW(x); }) / A(1, 1)};
}

/// Error of \eq{A30} without remainders, computed minus exact: O(h²) for B everywhere, for DB O(h²) inside
/// and O(h) at the boundary. \defeq{A32}
/// \f[ \begin{bmatrix} A_{11} & A_{12} \\ A_{21} & A_{22} \end{bmatrix}^{-1}
///     \begin{bmatrix} e'_1 \\ e'_2 \end{bmatrix} = \begin{bmatrix} O(h^2) \\ O(h) \end{bmatrix} \tag{32} \f]
inline Eigen::Vector2d error(const Function& B, double DB_i, const CentredKernel& W_i) {
    return inverse(matrix(W_i)) *
           Eigen::Vector2d{first_remainder(B, DB_i, W_i), second_remainder(B, DB_i, W_i)};
}

/// The second derivative, the procedure reiterated: \f$D^2 = D\,D\f$ does not converge at the boundary.
/// \param D the operator of \eq{A30} for all particles
/// \param memory another operator, whose memory becomes the result's
template <class Scalar>
Operator<Scalar> second_derivative(const Operator<Scalar>& D, Operator<Scalar>&& memory = {}) {
    return product(D, D, std::move(memory));
}

}  // namespace fpm
}  // namespace asprone2010
