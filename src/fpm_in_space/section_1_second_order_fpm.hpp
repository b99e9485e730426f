#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "base/quad.hpp"
#include "batra2008/section_2_ssph_basis.hpp"
#include "particles/local_system.hpp"
#include "particles/moments.hpp"
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

/// The radius, in units of h, at which tables and bodies lower the Gaussian to zero.
template <int dim>
inline constexpr double cut = dim == 2 ? 3.5 : 3;

template <class Scalar>
using Table = particles::Table<Scalar>;
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
/// is a Schur complement, which is definite wherever the monomials of degree 1 to 3 are linearly independent
/// on the neighbours. Programs and tables call the method `definite_fpm`.
///
/// | symbol | code | meaning |
/// | --- | --- | --- |
/// | \f$r = (x_j - x_i)/h\f$ | `near.r` | offset of a neighbour, in units of h |
/// | \f$r^a,\ a!,\ \partial^a\f$ | `Exponents`, `factorial` | monomial, factorial, derivative |
/// | \f$p\f$ | `monomials_of` | the monomials up to degree 3 at the neighbours |
/// | \f$p_1, p_2\f$ | `linear`, `quadratic` | those of degree 1 and 2 |
/// | \f$o = [p_1, p_3]\f$ | `odd` | those of degree 1 and 3 |
/// | \f$\langle f, g\rangle\f$ | `product`, `moments` | sum over the neighbours, weighted by W V |
/// | \f$C_m, K_m\f$ | `corrections`, `kernels` | correction and kernel for the m-th second derivative |
///
/// All functions are polynomials: rows of coefficients of the monomials, in the order of
/// particles::monomials(), for second derivatives in the plane \f$\partial_{11}, \partial_{22},
/// \partial_{12}\f$. Whatever is summed over the neighbours then follows from the products of the monomials,
/// which are summed once.
///
/// The second derivatives are those of the SSPH basis of degree 3, \eq{B2.8}, if its expansion takes the
/// value at the particle as given: both solve for the same unknowns under the same conditions. The two papers
/// of this package meet here.
///
/// What this section claims, and what was measured: \claims{F-1}.
/// On particles that you move: \ref live_plane.
namespace second_order_fpm {

/// How many particles determine the derivatives: the particle itself, and a neighbour for each monomial of
/// degree 1 to 3.
template <int dim>
inline constexpr particles::Requirement required{"definite_fpm", terms<dim, 3>};

/// The monomials of Taylor's expansion up to degree 3; that of degree 0 has the value at the particle itself.
/// \defeq{F1}
/// \f[ B(x_j) - B(x_i) = \sum_{1 \le |a| \le 3} \frac{r^a}{a!}\,h^{|a|}\,\partial^a B(x_i) + O(|x_j - x_i|^4)
///     \tag{F1} \f]
/// \return p, a row for each monomial, a column for each neighbour
template <class Scalar, int dim>
Table<Scalar> monomials_of(const Neighbourhood<Scalar, dim>& near) {
    return batra2008::ssph_basis::H<dim, 3, Scalar>(near.r);
}

namespace detail {

/// The places of the monomials of some degrees among those up to degree 3.
template <int dim, int count>
constexpr std::array<int, count> of_degrees(int one, int other) {
    std::array<int, count> places{};
    std::size_t found = 0;
    constexpr auto all = particles::monomials<dim, 3>();
    for (std::size_t k = 0; k < all.size(); ++k)
        if (const int degree = particles::order<dim>(all[k]); degree == one || degree == other)
            places[found++] = static_cast<int>(k);
    return places;
}

}  // namespace detail

/// \f$p_1\f$: places of the monomials of degree 1.
template <int dim>
inline constexpr auto linear = detail::of_degrees<dim, dim>(1, 1);

/// \f$p_2\f$: places of those of degree 2.
template <int dim>
inline constexpr auto quadratic = detail::of_degrees<dim, second_derivatives<dim>>(2, 2);

/// \f$o = [p_1, p_3]\f$: places of those of odd degree, 2 on a line, 6 in the plane, 13 in space.
template <int dim>
inline constexpr auto odd = detail::of_degrees<dim, terms<dim, 3> - 1 - second_derivatives<dim>>(1, 3);

/// Monomials as polynomials. \param places of the monomials
template <class Scalar, int dim, std::size_t count>
Table<Scalar> polynomials(const std::array<int, count>& places) {
    Table<Scalar> all = Table<Scalar>::Zero(static_cast<Index>(count), terms<dim, 3>);
    for (std::size_t k = 0; k < count; ++k) all(static_cast<Index>(k), places[k]) = Scalar(1);
    return all;
}

/// The products of the monomials over the neighbours, \f$\langle p, p^T\rangle\f$: the matrix \eq{B2.9} of
/// SSPH with W V in the place of W.
template <class Scalar, int dim>
Matrix<Scalar> moments(const Neighbourhood<Scalar, dim>& near) {
    return particles::moment_matrix<dim, 3>(near.r, Column<Scalar>(near.W * near.V));
}

/// The products of two sets of functions over the neighbours. \defeq{F2}
/// \f[ \langle f_m, g_n\rangle = \sum_j f_m(r_j)\,g_n(r_j)\,W_j\,V_j \tag{F2} \f]
/// \param f, g a row for each function \param moments products of the monomials
/// \return a row for each f, a column for each g
template <class Scalar>
Table<Scalar> product(const Table<Scalar>& f, const Table<Scalar>& g, const Matrix<Scalar>& moments) {
    return Table<Scalar>(f.lazyProduct(moments)).lazyProduct(g.transpose());
}

namespace detail {

/// Smallest pivot that counts, relative to the diagonal that it is left of: with a smaller one a derivative
/// loses ten of its sixteen digits.
inline constexpr double singular = 1e-10;

/// \param diagonal what the pivots are compared with
/// \throws particles::SingularNeighbourhood where a pivot vanishes beside it
template <class Scalar>
solvers::Cholesky<Scalar> factors(const Matrix<Scalar>& A, const Column<Scalar>& diagonal) {
    solvers::Cholesky<Scalar> factors(A);
    if (!(factors.pivots().array() > singular * diagonal).all())
        throw particles::SingularNeighbourhood(
            std::string("the monomials of degree 1 to 3 are not independent on them"));
    return factors;
}

/// The factorials of the derivatives of order 2, \f$a_n!\f$.
template <int dim, class Scalar>
Column<Scalar> factorials() {
    static constexpr auto all = particles::monomials<dim, 2>();
    Column<Scalar> each(second_derivatives<dim>);
    for (std::size_t n = 0; n < second_derivatives<dim>; ++n)
        each[static_cast<Index>(n)] = Scalar(particles::factorial<dim>(all[1 + dim + n]));
    return each;
}

}  // namespace detail

/// The corrections: the monomials of degree 2 less what the odd ones explain of them. \defeq{F3}
/// \f[ C_m = q_m - o^T G^{-1} \langle o, q_m\rangle, \qquad G = \langle o, o^T\rangle, \qquad q = p_2
///     \tag{F3} \f]
/// so that \f$\langle C_m, o\rangle = 0\f$. G is a Gram matrix; one factorisation serves all m.
/// \param q a row for each function \param moments products of the monomials
/// \return a row for each of them
/// \throws particles::SingularNeighbourhood where the neighbours do not determine the odd monomials
template <int dim, class Scalar>
Table<Scalar> corrections(const Table<Scalar>& q, const Matrix<Scalar>& moments) {
    const Matrix<Scalar> G = moments(odd<dim>, odd<dim>);
    const auto factors = detail::factors<Scalar>(G, G.diagonal().array());
    const Table<Scalar> o_q = Table<Scalar>(moments(odd<dim>, Eigen::all)).lazyProduct(q.transpose());
    Table<Scalar> C = q;
    C(Eigen::all, odd<dim>) -= factors.solve(o_q).transpose();
    return C;
}

/// The kernels at the neighbours, times the volumes, as \eq{A39}. \defeq{F4}
/// \f[ K_m = C_m\,W \tag{F4} \f]
/// \param C a row for each polynomial \param r offsets of the neighbours \param WV W times V of each
/// \return a row for each polynomial, a column for each neighbour
template <int dim, class Scalar>
Table<Scalar> kernels(const Table<Scalar>& C, const particles::Offsets<Scalar, dim>& r,
                      const Column<Scalar>& WV) {
    return particles::polynomials<dim, 3>(C, r, WV);
}

/// The second derivatives: the expansion projected on the kernels, whose terms of odd degree vanish.
/// \defeq{F5}
/// \f[ \sum_n \langle C_m, p_{2,n}\rangle \frac{\partial^{a_n} B(x_i)}{a_n!}
///     = \sum_j [B(x_j) - B(x_i)]\,K_m(x_j)\,V_j \tag{F5} \f]
/// with derivatives in units of h. The matrix is the Schur complement
/// \f$\langle p_2, p_2\rangle - \langle p_2, o\rangle G^{-1} \langle o, p_2\rangle\f$, symmetric and
/// definite. The remainder is O(h⁴), over h²: second order, everywhere.
/// \param C corrections() \param moments products of the monomials
/// \return polynomials whose kernels are the weights on \f$B(x_j) - B(x_i)\f$ [1/h²], a row for each second
///         derivative
/// \throws particles::SingularNeighbourhood where the neighbours do not determine them
template <int dim, class Scalar>
Table<Scalar> second(const Table<Scalar>& C, const Matrix<Scalar>& moments) {
    const Table<Scalar> to_p2 = moments(Eigen::all, quadratic<dim>);
    const auto factors =
        detail::factors<Scalar>(C.lazyProduct(to_p2), moments.diagonal()(quadratic<dim>).array());
    return detail::factorials<dim, Scalar>().matrix().asDiagonal() * factors.solve(C);
}

/// The first derivatives: the expansion projected on \f$p_1 W\f$, which is \f$-\tfrac12 DW\f$ of the
/// Gaussian, with the second derivatives known. \defeq{F6}
/// \f[ \langle p_1, p_1^T\rangle\,DB(x_i) = \sum_j \Big\{B(x_j) - B(x_i)
///     - \sum_n \frac{r_j^{a_n}}{a_n!}\,\partial^{a_n} B(x_i)\Big\}\,p_1(r_j)\,W_j\,V_j \tag{F6} \f]
/// with derivatives in units of h. The remainder is O(h³), over h: second order, too.
/// \param D2 polynomials of the second derivatives \param moments products of the monomials
/// \return polynomials whose kernels are the weights on \f$B(x_j) - B(x_i)\f$ [1/h], a row for each
///         coordinate
/// \throws particles::SingularNeighbourhood where the neighbours do not determine them
template <int dim, class Scalar>
Table<Scalar> first(const Table<Scalar>& D2, const Matrix<Scalar>& moments) {
    const Matrix<Scalar> M = moments(linear<dim>, linear<dim>);
    const auto factors = detail::factors<Scalar>(M, M.diagonal().array());
    const Table<Scalar> known = moments(linear<dim>, quadratic<dim>) *
                                detail::factorials<dim, Scalar>().inverse().matrix().asDiagonal();
    return factors.solve(polynomials<Scalar, dim>(linear<dim>) - known.lazyProduct(D2));
}

/// Both derivatives of the method, as particles::assemble() takes them. On a line this is the formulation
/// with \f$q = r^2\f$ in the place of the paper's constant.
/// \param near the particles in the support of \f$W_i\f$
/// \return weights on \f$B(x_j) - B(x_i)\f$ [1/h, 1/h²]
/// \throws particles::SingularNeighbourhood where the monomials of degree 1 to 3 are not independent on them
template <class Scalar, int dim>
Derivatives<Scalar, dim> derivatives(const Neighbourhood<Scalar, dim>& near) {
    const Column<Scalar> WV = near.W * near.V;
    const Table<Scalar> p2 = polynomials<Scalar, dim>(quadratic<dim>);
    const Matrix<Scalar> products = moments(near);
    const Table<Scalar> D2 = second<dim>(corrections<dim>(p2, products), products),
                        D = first<dim>(D2, products);
    return {kernels<dim>(D, near.r, WV).transpose().array(),
            kernels<dim>(D2, near.r, WV).transpose().array()};
}

// Compiled once, in section_1_second_order_fpm.cpp.
extern template Derivatives<double, 1> derivatives(const Neighbourhood<double, 1>&);
extern template Derivatives<double, 2> derivatives(const Neighbourhood<double, 2>&);
extern template Derivatives<double, 3> derivatives(const Neighbourhood<double, 3>&);
extern template Derivatives<long double, 1> derivatives(const Neighbourhood<long double, 1>&);
extern template Derivatives<base::Quad, 1> derivatives(const Neighbourhood<base::Quad, 1>&);
extern template Derivatives<base::Quad, 2> derivatives(const Neighbourhood<base::Quad, 2>&);
extern template Derivatives<base::Quad, 3> derivatives(const Neighbourhood<base::Quad, 3>&);

}  // namespace second_order_fpm
}  // namespace fpm_in_space
