#pragma once

#include "batra2008/section_2_ssph_basis.hpp"
#include "particles/local_system.hpp"
#include "particles/multi_index.hpp"
#include "particles/neighbourhood.hpp"
#include "particles/operators.hpp"
#include "particles/requirement.hpp"
#include "solvers/cholesky.hpp"

/// The second-order finite particle method in the plane and in space: a text of our own, section by section.
namespace fpm_in_space {

using particles::Column;
using particles::Derivatives;
using particles::Exponents;
using particles::Index;
using particles::Neighbourhood;
using particles::second_derivatives;
using particles::terms;

template <class Scalar>
using Table = batra2008::ssph_basis::Table<Scalar>;
template <class Scalar>
using Matrix = typename solvers::Cholesky<Scalar>::Matrix;

/// Section 1, the second-order finite particle method in one, two and three dimensions, beyond both papers.
///
/// Asprone et al. (2010) end with the remark that their method seemed complicated to extend to two and three
/// dimensions. This is an extension that is of second order at faces, edges and corners, too.
///
/// The paper's kernel K has no first and third moment, \eq{A41}. Such a K removes the terms of odd degree
/// from Taylor's expansion, so that what is left is the second derivative and a remainder of degree 4. In
/// space there are several second derivatives, and each gets a kernel of its own. The paper's K begins with
/// the constant, \f$C = 1 + \ldots\f$, and the matrix \eq{A43} that follows may vanish
/// (asprone2010::quality). Here each kernel begins with the monomial of its own derivative: then the matrix
/// is a Schur complement, which is definite wherever the monomials of degree 1 to 3 differ on the neighbours.
///
/// | symbol | code | meaning |
/// | --- | --- | --- |
/// | \f$r = (x_j - x_i)/h\f$ | `near.r` | offset of a neighbour, in units of h |
/// | \f$r^a,\ a!,\ \partial^a\f$ | `Exponents`, `factorial` | monomial, factorial and derivative of a multi-index |
/// | \f$p_1, p_2\f$ | `linear`, `quadratic` | monomials of degree 1 and 2 |
/// | \f$o = [p_1, p_3]\f$ | `odd` | those of degree 1 and 3 |
/// | \f$\langle f, g\rangle\f$ | `product` | sum over the neighbours, weighted by W V |
/// | \f$C_m, K_m\f$ | `corrections`, `kernels` | correction and kernel for the m-th second derivative |
///
/// All tables have a row for each monomial and a column for each neighbour. The order of monomials is that of
/// particles::monomials(): in the plane \f$\partial_{11}, \partial_{22}, \partial_{12}\f$.
///
/// The second derivatives are those of the SSPH basis of degree 3, \eq{B2.8}, if its expansion takes the value
/// at the particle as given: both solve for the same unknowns under the same conditions. The two papers of
/// this package meet here.
///
/// What this section claims, and what was measured: \claims{F-1}.
namespace second_order_fpm {

/// How many particles determine the derivatives: the particle itself, and a neighbour for each monomial of
/// degree 1 to 3.
template <int dim>
inline constexpr particles::Requirement required{"definite_fpm", terms<dim, 3>};

/// The monomials of Taylor's expansion up to degree 3, without the constant. \defeq{F1}
/// \f[ B(x_j) - B(x_i) = \sum_{1 \le |a| \le 3} \frac{r^a}{a!}\,h^{|a|}\,\partial^a B(x_i) + O(|x_j - x_i|^4)
///     \tag{F1} \f]
/// \return a row for each monomial
template <class Scalar, int dim>
Table<Scalar> monomials_of(const Neighbourhood<Scalar, dim>& near) {
    return batra2008::ssph_basis::H<dim, 3, Scalar>(near.r).bottomRows(terms<dim, 3> - 1);
}

/// \f$p_1\f$, the monomials of degree 1.
template <int dim, class Scalar>
Table<Scalar> linear(const Table<Scalar>& p) {
    return p.topRows(dim);
}

/// \f$p_2\f$, those of degree 2.
template <int dim, class Scalar>
Table<Scalar> quadratic(const Table<Scalar>& p) {
    return p.middleRows(dim, second_derivatives<dim>);
}

/// \f$o = [p_1, p_3]\f$, those of odd degree: 2 on a line, 6 in the plane, 13 in space.
template <int dim, class Scalar>
Table<Scalar> odd(const Table<Scalar>& p) {
    Table<Scalar> o(p.rows() - second_derivatives<dim>, p.cols());
    o << p.topRows(dim), p.bottomRows(o.rows() - dim);
    return o;
}

/// The products of two sets of functions over the neighbours. \defeq{F2}
/// \f[ \langle f_m, g_n\rangle = \sum_j f_m(r_j)\,g_n(r_j)\,W_j\,V_j \tag{F2} \f]
/// \param f, g a row for each function \param WV W times V of each neighbour
/// \return a row for each f, a column for each g
template <class Scalar>
Table<Scalar> product(const Table<Scalar>& f, const Table<Scalar>& g, const Column<Scalar>& WV) {
    return (f * WV.matrix().asDiagonal()).lazyProduct(g.transpose());
}

namespace detail {

/// Smallest pivot that counts, relative to the diagonal that it is left of: with a smaller one a second
/// derivative loses half of its digits.
inline constexpr double singular = 1e-10;

/// \param diagonal what the pivots are compared with
/// \throws particles::SingularNeighbourhood where a pivot vanishes beside it
template <class Scalar>
solvers::Cholesky<Scalar> factors(const Table<Scalar>& A, const Column<Scalar>& diagonal) {
    solvers::Cholesky<Scalar> factors{Matrix<Scalar>(A)};
    const Column<Scalar> pivots = factors.L().diagonal().array().square() / diagonal;
    if (!factors.succeeded() || !(pivots > singular).all())
        throw particles::SingularNeighbourhood(factors.succeeded() ? static_cast<double>(pivots.minCoeff())
                                                                   : 0);
    return factors;
}

}  // namespace detail

/// \f$G^{-1} \langle o, q_m\rangle\f$, the coefficients of the odd monomials that explain most of each \f$q_m\f$.
/// \return a row for each odd monomial, a column for each \f$q_m\f$
/// \throws particles::SingularNeighbourhood where the neighbours do not determine the odd monomials
template <class Scalar>
Table<Scalar> coefficients(const Table<Scalar>& q, const Table<Scalar>& o, const Column<Scalar>& WV) {
    const Table<Scalar> G = product(o, o, WV);
    const auto factors = detail::factors<Scalar>(G, G.diagonal().array());
    return particles::solved(factors, product(o, q, WV));
}

/// The corrections: the monomials of degree 2 less what the odd ones explain of them. \defeq{F3}
/// \f[ C_m = q_m - o^T G^{-1} \langle o, q_m\rangle, \qquad G = \langle o, o^T\rangle, \qquad q = p_2 \tag{F3} \f]
/// so that \f$\langle C_m, o\rangle = 0\f$. G is a Gram matrix; one factorisation serves all m.
/// \throws particles::SingularNeighbourhood where the neighbours do not determine the odd monomials
template <class Scalar>
Table<Scalar> corrections(const Table<Scalar>& q, const Table<Scalar>& o, const Column<Scalar>& WV) {
    return q - coefficients(q, o, WV).transpose() * o;
}

/// The kernels times the volumes, as \eq{A39}. \defeq{F4}
/// \f[ K_m = C_m\,W \tag{F4} \f]
template <class Scalar>
Table<Scalar> kernels(const Table<Scalar>& C, const Column<Scalar>& WV) {
    return C * WV.matrix().asDiagonal();
}

/// The second derivatives: the expansion projected on the kernels, whose terms of odd degree vanish.
/// \defeq{F5}
/// \f[ \sum_n \langle C_m, p_{2,n}\rangle \frac{\partial^{a_n} B(x_i)}{a_n!}
///     = \sum_j [B(x_j) - B(x_i)]\,K_m(x_j)\,V_j \tag{F5} \f]
/// The matrix is the Schur complement \f$\langle p_2, p_2\rangle - \langle p_2, o\rangle G^{-1} \langle o,
/// p_2\rangle\f$, symmetric and definite. The remainder is O(h⁴), over h²: second order, everywhere.
/// \param K kernels times volumes
/// \return weights on \f$B(x_j) - B(x_i)\f$ [1/h²], a row for each second derivative
/// \throws particles::SingularNeighbourhood where the neighbours do not determine them
template <int dim, class Scalar>
Table<Scalar> second(const Table<Scalar>& K, const Table<Scalar>& p2, const Column<Scalar>& WV) {
    const Table<Scalar> M = K.lazyProduct(p2.transpose());
    const auto factors = detail::factors<Scalar>(M, product(p2, p2, WV).diagonal().array());
    Table<Scalar> weights = particles::solved(factors, K);
    static constexpr auto a = particles::monomials<dim, 2>();
    for (Index n = 0; n < weights.rows(); ++n)
        weights.row(n) *= Scalar(particles::factorial<dim>(a[static_cast<std::size_t>(1 + dim + n)]));
    return weights;
}

/// The first derivatives: the expansion projected on \f$p_1 W\f$, which is \f$-\tfrac12 DW\f$ of the Gaussian,
/// with the second derivatives known. \defeq{F6}
/// \f[ \langle p_1, p_1^T\rangle\,DB(x_i) = \sum_j \Big\{B(x_j) - B(x_i)
///     - \sum_n \frac{r_j^{a_n}}{a_n!}\,\partial^{a_n} B(x_i)\Big\}\,p_1(r_j)\,W_j\,V_j \tag{F6} \f]
/// The remainder is O(h³), over h: second order, too.
/// \param D2 weights of the second derivatives
/// \return weights on \f$B(x_j) - B(x_i)\f$ [1/h], a row for each coordinate
template <int dim, class Scalar>
Table<Scalar> first(const Table<Scalar>& D2, const Table<Scalar>& p1, const Table<Scalar>& p2,
                    const Column<Scalar>& WV) {
    Table<Scalar> known = product(p1, p2, WV);
    static constexpr auto a = particles::monomials<dim, 2>();
    for (Index n = 0; n < known.cols(); ++n)
        known.col(n) /= Scalar(particles::factorial<dim>(a[static_cast<std::size_t>(1 + dim + n)]));
    const Table<Scalar> M = product(p1, p1, WV);
    const auto factors = detail::factors<Scalar>(M, M.diagonal().array());
    return particles::solved<solvers::Cholesky<Scalar>, Scalar>(
        factors, p1 * WV.matrix().asDiagonal() - known.lazyProduct(D2));
}

/// Both derivatives of the method, as particles::assemble() takes them. On a line this is the formulation
/// with \f$q = r^2\f$ in the place of the paper's constant.
/// \param near the particles in the support of \f$W_i\f$
/// \return weights on \f$B(x_j) - B(x_i)\f$ [1/h, 1/h²]
/// \throws particles::SingularNeighbourhood where the monomials of degree 1 to 3 are not independent on them
template <class Scalar, int dim>
Derivatives<Scalar, dim> derivatives(const Neighbourhood<Scalar, dim>& near) {
    const Column<Scalar> WV = near.W * near.V;
    const Table<Scalar> p = monomials_of(near), p1 = linear<dim>(p), p2 = quadratic<dim>(p);
    const Table<Scalar> D2 = second<dim>(kernels(corrections(p2, odd<dim>(p), WV), WV), p2, WV);
    return {first<dim>(D2, p1, p2, WV).transpose().array(), D2.transpose().array()};
}

}  // namespace second_order_fpm
}  // namespace fpm_in_space
