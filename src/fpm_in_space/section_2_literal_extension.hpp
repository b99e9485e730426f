#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

#include "base/quad.hpp"
#include "fpm_in_space/section_1_second_order_fpm.hpp"

namespace fpm_in_space {

/// Section 2, why it looked complicated: the formulations of the first paper, extended word by word.
///
/// The modified FPM of the paper projects Taylor's expansion of degree 2 on W and DW, \eq{A36}: two kernels
/// for two unknowns. In d dimensions there are d + d(d + 1)/2 unknowns, and W and DW are d + 1 kernels.
/// Something must be added, and the paper does not say what.
///
/// Two answers keep to its words. One multiplies W by as many functions q as there are second derivatives:
/// the constant of the paper, and the harmonic polynomials of degree 2, which the constant lacks, \eq{F7}
/// (`literal_modified_fpm`). The other takes the first and the second derivatives of W, \eq{F8}
/// (`literal_fpm_by_derivatives`). The second-order FPM corrects the kernels of the first answer as the paper
/// corrects its one, \eq{F9} (`literal_second_order_fpm`).
///
/// None of the three is of use. On a grid \eq{F9} is of second order, but the errors of its second
/// derivatives at edges are thousands of times those of Section 1 in the plane, and hundreds of times in
/// space. On perturbed particles the matrices of \eq{F7} and \eq{F9} come near singular ones at the sides,
/// and a few particles have errors of any size. The second derivatives of \eq{F8} are of first order, and a
/// membrane on perturbed particles has eigenvalues of the wrong sign. The matrices are neither Gram matrices
/// nor Schur complements of one: nothing keeps them away from singular ones. The table literal.csv has the
/// errors of all three by place, beside those of Section 1.
///
/// | symbol | code | meaning |
/// | --- | --- | --- |
/// | \f$r^a/a!\f$ | `taylor` | terms of the expansion of degree 1 and 2 |
/// | \f$q\f$ | `constant_and_harmonic` | what multiplies W |
/// | \f$\varphi_m\f$ | `kernels` | the kernels on which the expansion is projected, times volumes |
///
/// Functions of degree 3 at most are polynomials, as in Section 1. Other tables have a row for each function
/// and a column for each neighbour.
///
/// What this section claims, and what was measured: \claims{F-2}.
namespace literal_extension {

using second_order_fpm::corrections;
using second_order_fpm::kernels;
using second_order_fpm::moments;
using second_order_fpm::monomials_of;
using second_order_fpm::polynomials;
using second_order_fpm::quadratic;

/// How many derivatives of order 1 and 2 there are: 2 on a line, 5 in the plane, 9 in space.
template <int dim>
inline constexpr int unknowns = terms<dim, 2> - 1;

/// The terms of Taylor's expansion up to degree 2, \f$r^a/a!\f$, without the constant.
/// \return a row for each derivative
template <class Scalar, int dim>
Table<Scalar> taylor(const Neighbourhood<Scalar, dim>& near) {
    Table<Scalar> all = monomials_of(near).middleRows(1, unknowns<dim>);
    static constexpr auto a = particles::monomials<dim, 2>();
    for (Index n = 0; n < all.rows(); ++n)
        all.row(n) /= Scalar(particles::factorial<dim>(a[static_cast<std::size_t>(1 + n)]));
    return all;
}

/// As many functions of degree 2 as there are second derivatives: the constant in the place of the sum of
/// squares, the differences of squares, and the products. In the plane they are 1, x² − y² and xy.
/// \return a polynomial for each function
template <class Scalar, int dim>
Table<Scalar> constant_and_harmonic() {
    const Table<Scalar> p2 = polynomials<Scalar, dim>(quadratic<dim>);
    Table<Scalar> q = p2;
    q.row(0).setUnit(0);
    for (Index axis = 1; axis < dim; ++axis) q.row(axis) = p2.row(axis - 1) - p2.row(axis);
    return q;
}

/// The matrix of the expansion projected on kernels \f$\varphi_m\f$, one for each unknown, as \eq{A35},
/// \f[ A_{mn} = \sum_j \varphi_m(x_j)\,\frac{r_j^{a_n}}{a_n!}\,V_j \f]
/// \param kernels kernels times volumes
template <class Scalar, int dim>
Table<Scalar> matrix(const Table<Scalar>& kernels, const Neighbourhood<Scalar, dim>& near) {
    return kernels.lazyProduct(taylor(near).transpose());
}

namespace detail {

/// Inverse of a matrix without symmetry, by elimination with a choice of rows; for matrices of 9 rows,
/// Eigen's factors take long to compile.
/// \throws particles::SingularNeighbourhood where the reciprocal condition number (1-norm) is below 100 ε
template <class Scalar>
Table<Scalar> inverse(const Table<Scalar>& A) {
    const Index n = A.rows();
    Table<Scalar> left = A, right = Table<Scalar>::Identity(n, n);
    for (Index k = 0; k < n; ++k) {
        Index pivot = 0;
        left.col(k).tail(n - k).cwiseAbs().maxCoeff(&pivot);
        left.row(k).swap(left.row(k + pivot));
        right.row(k).swap(right.row(k + pivot));
        right.row(k) /= left(k, k);
        left.row(k) /= Scalar(left(k, k));
        for (Index i = 0; i < n; ++i) {
            if (i == k) continue;
            right.row(i) -= left(i, k) * right.row(k);
            left.row(i) -= Scalar(left(i, k)) * left.row(k);
        }
    }
    const auto norm = [](const Table<Scalar>& M) { return M.cwiseAbs().colwise().sum().maxCoeff(); };
    const Scalar reciprocal_condition = 1 / (norm(A) * norm(right));
    if (!(reciprocal_condition > 100 * std::numeric_limits<Scalar>::epsilon()))
        throw particles::SingularNeighbourhood(static_cast<double>(reciprocal_condition));
    return right;
}

}  // namespace detail

/// All derivatives at once from the projected expansion, as \eq{A36},
/// \f[ \sum_n A_{mn}\,\partial^{a_n} B(x_i) = \sum_j [B(x_j) - B(x_i)]\,\varphi_m(x_j)\,V_j \f]
/// \param kernels kernels times volumes
/// \return weights on \f$B(x_j) - B(x_i)\f$ [1/h, 1/h²]
/// \throws particles::SingularNeighbourhood where the neighbours do not determine the derivatives
template <class Scalar, int dim>
Derivatives<Scalar, dim> projected(const Table<Scalar>& kernels, const Neighbourhood<Scalar, dim>& near) {
    const Table<Scalar> weights = detail::inverse(matrix(kernels, near)).lazyProduct(kernels);
    return {weights.topRows(dim).transpose().array(),
            weights.bottomRows(second_derivatives<dim>).transpose().array()};
}

/// The kernels of the modified FPM, with the gradient of W as the paper has it. \defeq{F7}
/// \f[ \varphi = \{q\,W,\ DW\}, \qquad q = \{1,\ r_1^2 - r_2^2,\ \ldots,\ r_1 r_2,\ \ldots\} \tag{F7} \f]
/// On a line they are the paper's W and DW, \eq{A36}.
/// \return kernels times volumes
template <class Scalar, int dim>
Table<Scalar> harmonic_kernels(const Neighbourhood<Scalar, dim>& near) {
    const auto& [r, W, DW, V] = near;
    Table<Scalar> all(unknowns<dim>, W.size());
    all << kernels<dim>(constant_and_harmonic<Scalar, dim>(), r, W), DW.matrix().transpose();
    return all * V.matrix().asDiagonal();
}

/// The kernels of the other reading: all derivatives of the Gaussian W of order 1 and 2. \defeq{F8}
/// \f[ \varphi = \{DW,\ D^2W\}, \qquad \partial_{kl} W = (4\,r_k r_l - 2\,\delta_{kl})\,W \tag{F8} \f]
/// With another kernel W they are not its derivatives, but still kernels.
/// \return kernels times volumes
template <class Scalar, int dim>
Table<Scalar> kernel_derivatives(const Neighbourhood<Scalar, dim>& near) {
    const auto& [r, W, DW, V] = near;
    Table<Scalar> hessian = Scalar(4) * monomials_of(near)(quadratic<dim>, Eigen::all);
    hessian.topRows(dim).array() -= Scalar(2);
    Table<Scalar> all(unknowns<dim>, W.size());
    all << DW.matrix().transpose(), hessian * W.matrix().asDiagonal();
    return all * V.matrix().asDiagonal();
}

/// The derivative of polynomials by a coordinate, \f$\partial_k r^a = a_k\,r^{a - e_k}\f$.
template <int dim, class Scalar>
Table<Scalar> derivative(const Table<Scalar>& f, int axis) {
    static constexpr auto monomials = particles::monomials<dim, 3>();
    Table<Scalar> Df = Table<Scalar>::Zero(f.rows(), f.cols());
    for (std::size_t k = 0; k < monomials.size(); ++k) {
        Exponents<dim> a = monomials[k];
        const int power = a[static_cast<std::size_t>(axis)]--;
        const auto lowered = std::find(monomials.begin(), monomials.end(), a) - monomials.begin();
        if (power > 0) Df.col(lowered) += Scalar(power) * f.col(static_cast<Index>(k));
    }
    return Df;
}

/// The kernels of the second-order FPM: those of \eq{F7}, corrected as \eq{A39} to \eq{A42}. \defeq{F9}
/// \f[ \varphi = \{K,\ DK_1\}, \qquad K_m = C_m\,W, \qquad \langle C_m, o\rangle = 0, \qquad
///     DK_1 = DC_1\,W + C_1\,DW \tag{F9} \f]
/// \f$C_1\f$, which begins with the constant, is the paper's correction but for a factor, and \f$DK_1\f$ the
/// gradient of its kernel. On a line this is the paper's \eq{A43}.
/// \return kernels times volumes
/// \throws particles::SingularNeighbourhood where the neighbours do not determine the odd monomials
template <class Scalar, int dim>
Table<Scalar> corrected_kernels(const Neighbourhood<Scalar, dim>& near) {
    const auto& [r, W, DW, V] = near;
    const Table<Scalar> C = corrections<dim>(constant_and_harmonic<Scalar, dim>(), moments(near)),
                        C_1 = C.topRows(1);
    Table<Scalar> all(unknowns<dim>, W.size());
    all.topRows(C.rows()) = kernels<dim>(C, r, W);
    for (int axis = 0; axis < dim; ++axis)
        all.row(C.rows() + axis) = kernels<dim>(derivative<dim>(C_1, axis), r, W) +
                                   kernels<dim>(C_1, r, Column<Scalar>(DW.col(axis)));
    return all * V.matrix().asDiagonal();
}

/// The modified FPM, \eq{F7}. Errors as for projected().
template <class Scalar, int dim>
Derivatives<Scalar, dim> modified(const Neighbourhood<Scalar, dim>& near) {
    return projected(harmonic_kernels(near), near);
}

/// The modified FPM with the kernel's derivatives, \eq{F8}. Errors as for projected().
template <class Scalar, int dim>
Derivatives<Scalar, dim> modified_by_derivatives(const Neighbourhood<Scalar, dim>& near) {
    return projected(kernel_derivatives(near), near);
}

/// The second-order FPM, \eq{F9}. Errors as for projected(), and where the neighbours do not determine the
/// odd monomials.
template <class Scalar, int dim>
Derivatives<Scalar, dim> second_order(const Neighbourhood<Scalar, dim>& near) {
    return projected(corrected_kernels(near), near);
}

// Compiled once, in section_2_literal_extension.cpp.
extern template Derivatives<double, 1> modified(const Neighbourhood<double, 1>&);
extern template Derivatives<double, 1> modified_by_derivatives(const Neighbourhood<double, 1>&);
extern template Derivatives<double, 1> second_order(const Neighbourhood<double, 1>&);
extern template Derivatives<double, 2> modified(const Neighbourhood<double, 2>&);
extern template Derivatives<double, 2> modified_by_derivatives(const Neighbourhood<double, 2>&);
extern template Derivatives<double, 2> second_order(const Neighbourhood<double, 2>&);
extern template Derivatives<double, 3> modified(const Neighbourhood<double, 3>&);
extern template Derivatives<double, 3> modified_by_derivatives(const Neighbourhood<double, 3>&);
extern template Derivatives<double, 3> second_order(const Neighbourhood<double, 3>&);
extern template Derivatives<base::Quad, 2> modified(const Neighbourhood<base::Quad, 2>&);
extern template Derivatives<base::Quad, 2> modified_by_derivatives(const Neighbourhood<base::Quad, 2>&);
extern template Derivatives<base::Quad, 2> second_order(const Neighbourhood<base::Quad, 2>&);
extern template Derivatives<base::Quad, 3> modified(const Neighbourhood<base::Quad, 3>&);
extern template Derivatives<base::Quad, 3> modified_by_derivatives(const Neighbourhood<base::Quad, 3>&);
extern template Derivatives<base::Quad, 3> second_order(const Neighbourhood<base::Quad, 3>&);
extern template Table<double> harmonic_kernels(const Neighbourhood<double, 1>&);
extern template Table<double> kernel_derivatives(const Neighbourhood<double, 1>&);
extern template Table<double> corrected_kernels(const Neighbourhood<double, 1>&);
extern template Table<double> harmonic_kernels(const Neighbourhood<double, 2>&);
extern template Table<double> kernel_derivatives(const Neighbourhood<double, 2>&);
extern template Table<double> corrected_kernels(const Neighbourhood<double, 2>&);
extern template Table<double> harmonic_kernels(const Neighbourhood<double, 3>&);
extern template Table<double> kernel_derivatives(const Neighbourhood<double, 3>&);
extern template Table<double> corrected_kernels(const Neighbourhood<double, 3>&);

}  // namespace literal_extension
}  // namespace fpm_in_space
