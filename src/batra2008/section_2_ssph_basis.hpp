#pragma once

#include <Eigen/LU>
#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/errors.hpp"
#include "particles/local_system.hpp"
#include "particles/moments.hpp"
#include "particles/multi_index.hpp"
#include "particles/neighbourhood.hpp"
#include "particles/operators.hpp"
#include "solvers/cholesky.hpp"
#include "solvers/condition.hpp"

/// Batra and Zhang (2008), section by section.
namespace batra2008 {

using particles::Column;
using particles::Index;
using particles::Point;
using particles::Points;

/// Section 2, the SSPH basis: a Taylor expansion around a place x, fitted to the values at the particles near
/// x.
///
/// The unknowns are the derivatives of f at x, the data are the values at the particles, and the kernel
/// weighs the data. The fit gives one set of basis functions for f and another for each derivative; none is
/// found by differentiation.
///
/// | paper | code | meaning |
/// | --- | --- | --- |
/// | \f$x,\ \xi^{g(j)}\f$ | `x`, `particle` | the place, and the particles in the kernel's support |
/// | \f$P(\xi, x)\f$ | `P`, a column of `H` | monomials of the offset |
/// | \f$Q(x)\f$ | `Q` | derivatives \f$\partial^a f/a!\f$ in the order of the monomials |
/// | \f$W\f$ | `W`, `diagonal(W)` | kernel \eq{B3.15}; only its values enter |
/// | \f$H, C, D\f$ | `H`, `C`, `D` | matrices of the fit; H and D have a column for each particle |
/// | \f$K_{IJ}\f$ | `K<I>(basis)` | basis functions for the I-th entry of Q, one weight for each particle J |
/// | \f$m\f$ | `m` | degree up to which the monomials are complete: 1, 2 or 3 |
///
/// The code serves one, two and three dimensions. Offsets are \f$s = (\xi - x)/h\f$, in units of the
/// smoothing length: the condition of C then depends neither on h nor on the unit of length. The order of
/// \eq{B2.3} is that of particles::monomials().
///
/// Departures from the print: below \eq{B2.10} the product of the one-dimensional determinant runs over n1,
/// n, n3; it must be n1, n2, n3. Enough particles alone do not make C regular: in two dimensions, particles
/// on a conic (a circle, say) leave it singular for m = 2, and a particle at a distance of exactly ρh has no
/// weight.
///
/// What this section claims, and what was measured: \claims{B-2}.
/// On particles that you move: \ref live_plane.
namespace ssph_basis {

using particles::Exponents;
using particles::factorial;
using particles::monomials;
using particles::Neighbourhood;
using particles::order;
using particles::terms;

/// A row for each monomial, a column for each particle of a support: H, D and K.
using particles::Table;

/// The matrix C of the fit, an entry of Q for each monomial, and the monomials of one offset. There are at
/// most 20 monomials, those of degree 3 in space.
template <class Scalar>
using Matrix = typename solvers::Cholesky<Scalar>::Matrix;
template <class Scalar>
using Vector = typename solvers::Cholesky<Scalar>::Vector;
template <class Scalar>
using RowVector = Eigen::Matrix<Scalar, 1, Eigen::Dynamic, Eigen::RowMajor, 1, 20>;

/// The derivatives of a function at a place, by their exponents.
template <int dim>
using Derivatives = std::function<double(const Exponents<dim>&)>;

namespace detail {

/// A value for each monomial, in their order.
template <int dim, int m, class Value>
Vector<double> for_each_monomial(const Value& value) {
    Vector<double> all(terms<dim, m>);
    Index I = 0;
    for (const Exponents<dim>& a : monomials<dim, m>()) all[I++] = value(a);
    return all;
}

/// Sum of a term over 0 … N − 1.
template <class Term>
auto sum(Index N, const Term& term) {
    auto total = term(0);
    for (Index j = 1; j < N; ++j) total += term(j);
    return total;
}

/// Sum of a term over all increasing choices of n numbers out of 0 … N − 1.
template <class Term>
double sum_over_choices(Index N, Index n, const Term& term) {
    std::vector<Index> chosen(static_cast<std::size_t>(n));
    std::iota(chosen.begin(), chosen.end(), 0);
    double sum = 0;
    for (Index k = N < n ? -1 : 0; k >= 0;) {
        sum += term(chosen);
        for (k = n - 1; k >= 0 && chosen[static_cast<std::size_t>(k)] == N - n + k;) --k;
        if (k >= 0) std::iota(chosen.begin() + k, chosen.end(), chosen[static_cast<std::size_t>(k)] + 1);
    }
    return sum;
}

}  // namespace detail

/// \f$s^a\f$, a monomial of an offset.
template <int dim>
double power(const Point<dim>& s, const Exponents<dim>& a) {
    double product = 1;
    for (std::size_t axis = 0; axis < dim; ++axis) product *= std::pow(s[static_cast<Index>(axis)], a[axis]);
    return product;
}

/// Taylor's expansion, with the k-th power of the directional derivative multiplied out. \defeq{B2.1}
/// \f[ f(\xi) = \sum_{k=0}^{m} \frac{1}{k!}\left[\sum_\alpha (\xi_\alpha
///     - x_\alpha)\frac{\partial}{\partial x_\alpha}\right]^k f(x)
///     = \sum_{|a| \le m} \frac{(\xi - x)^a}{a!}\,\partial^a f(x) \tag{2.1} \f]
/// \param D \f$\partial^a f(x)\f$ by exponents a
/// \param s offset \f$\xi - x\f$
template <int dim, int m>
double taylor(const Derivatives<dim>& D, const Point<dim>& s) {
    const auto term = [&](const Exponents<dim>& a) { return power<dim>(s, a) / factorial<dim>(a) * D(a); };
    return detail::for_each_monomial<dim, m>(term).sum();
}

/// The expansion as a product. \defeq{B2.2}
/// \f[ f(\xi) = P(\xi, x)\,Q(x) \tag{2.2} \f]
template <class Scalar>
Scalar value(const RowVector<Scalar>& P, const Vector<Scalar>& Q) {
    return P * Q;
}

/// The unknowns: f and its derivatives at x, each divided by the factorials of its exponents. \defeq{B2.3}
/// \f[ Q = \left[f,\ \frac{\partial f}{\partial x_1},\ \frac{\partial f}{\partial x_2},
///     \ \frac{\partial f}{\partial x_3},
///     \ \frac12\frac{\partial^2 f}{\partial x_1^2},\ \frac12\frac{\partial^2 f}{\partial x_2^2},
///     \ \frac12\frac{\partial^2 f}{\partial x_3^2},
///     \ \frac{\partial^2 f}{\partial x_1 \partial x_2},\ \frac{\partial^2 f}{\partial x_2 \partial x_3},
///     \ \frac{\partial^2 f}{\partial x_1 \partial x_3}\right]^T \tag{2.3} \f]
template <int dim, int m>
Vector<double> Q(const Derivatives<dim>& D) {
    return detail::for_each_monomial<dim, m>(
        [&](const Exponents<dim>& a) { return D(a) / factorial<dim>(a); });
}

/// The monomials of an offset, in the order of \eq{B2.3}, below which they stand.
template <int dim, int m>
RowVector<double> P(const Point<dim>& s) {
    return detail::for_each_monomial<dim, m>([&](const Exponents<dim>& a) { return power<dim>(s, a); })
        .transpose();
}

/// One particle's equation for Q: the expansion \eq{B2.2} at it, times its kernel value and its monomials.
/// \defeq{B2.4}
/// \f[ f(\xi)\,W\,P^T = \left[P^T\,W\,P\right] Q \tag{2.4} \f]
/// \return the matrix in brackets
template <class Scalar>
Matrix<Scalar> outer_product(const RowVector<Scalar>& P, const Scalar& W) {
    return P.transpose() * W * P;
}

/// The sum over the particles of the support; no volumes weigh it. \defeq{B2.5}
/// \f[ \sum_{j=1}^{N} f(\xi^{g(j)})\,W\,P^T = \sum_{j=1}^{N} \left[P^T\,W\,P\right] Q \tag{2.5} \f]
/// \param H the particles' monomials, \eq{B2.6}
/// \return the matrix on the right, summed term by term
template <class Scalar>
Matrix<Scalar> summed(const Table<Scalar>& H, const Column<Scalar>& W) {
    return detail::sum(W.size(), [&](Index j) { return outer_product<Scalar>(H.col(j).transpose(), W[j]); });
}

/// The monomials of many offsets, a column for each particle; each row is an earlier one times a coordinate.
/// \defeq{B2.6}
/// \f[ \begin{aligned}
///     H &= \left[P^T(\xi^{g(1)}, x),\ \ldots,\ P^T(\xi^{g(N)}, x)\right],
///     \\ W &= \operatorname{diag}\!\left(W(\xi^{g(j)}, x)\right),
///     \\ F^{(x)} &= \left[f(\xi^{g(1)}),\ \ldots,\ f(\xi^{g(N)})\right]^T
///     \end{aligned} \tag{2.6} \f]
/// \param s offsets, a row for each particle
template <int dim, int m, class Scalar>
Table<Scalar> H(const Eigen::Array<Scalar, Eigen::Dynamic, dim>& s) {
    static constexpr auto factors = particles::factors_of_monomials<dim, m>();
    Table<Scalar> all(terms<dim, m>, s.rows());
    all.row(0).setOnes();
    for (Index k = 1; k < all.rows(); ++k) {
        const auto [lower, axis] = factors[static_cast<std::size_t>(k)];
        all.row(k).array() =
            all.row(static_cast<Index>(lower)).array() * s.col(static_cast<Index>(axis)).transpose();
    }
    return all;
}

/// The matrix W of \eq{B2.6}.
template <class Scalar>
auto diagonal(const Column<Scalar>& W) {
    return W.matrix().asDiagonal();
}

/// The same as a product of matrices. \defeq{B2.7}
/// \f[ H\,W\,F^{(x)} = H\,W\,H^T\,Q(x) \tag{2.7} \f]
/// \return both sides for given values and a given Q
template <class Scalar>
std::array<Vector<Scalar>, 2> both_sides(const Table<Scalar>& H, const Column<Scalar>& W,
                                         const Column<Scalar>& F, const Vector<Scalar>& Q) {
    return {H * diagonal(W) * F.matrix(), H * diagonal(W) * H.transpose() * Q};
}

/// The weighted monomials. \defeq{B2.8}
/// \f[ C\,Q = D\,F^{(x)}, \quad C = H\,W\,H^T, \quad D = H\,W \tag{2.8} \f]
template <class Scalar>
Table<Scalar> D(const Table<Scalar>& H, const Column<Scalar>& W) {
    return H * diagonal(W);
}

/// The symmetric matrix of the fit \eq{B2.8}: no derivative of the kernel enters. One half is computed.
/// \defeq{B2.9}
/// \f[ C = \left[W(g(1))\,P^T(g(1)),\ \ldots,\ W(g(N))\,P^T(g(N))\right]
///     \begin{bmatrix} P(g(1)) \\ \vdots \\ P(g(N)) \end{bmatrix} \tag{2.9} \f]
template <class Scalar>
Matrix<Scalar> C(const Table<Scalar>& D, const Table<Scalar>& H) {
    Matrix<Scalar> half(H.rows(), H.rows());
    half.template triangularView<Eigen::Upper>() = D.lazyProduct(H.transpose());
    return half.template selfadjointView<Eigen::Upper>();
}

/// The determinant of C by Binet and Cauchy: a sum of squares over all choices of n particles, positive
/// unless every choice is degenerate. For small supports: the number of choices grows fast. \defeq{B2.10}
/// \f[ \det C = \sum_{n_1 < \cdots < n_n} \prod_k W(g(n_k))
///     \left(\det\begin{bmatrix} P(g(n_1)) \\ \vdots \\ P(g(n_n)) \end{bmatrix}\right)^2 \tag{2.10} \f]
template <class Scalar>
Scalar determinant(const Table<Scalar>& H, const Column<Scalar>& W) {
    return detail::sum_over_choices(W.size(), H.rows(), [&](const std::vector<Index>& g) {
        return W(g).prod() * std::pow(Matrix<Scalar>(H(Eigen::all, g)).determinant(), 2);
    });
}

/// The basis functions at a place, one set for each entry of Q. Neither H nor D is stored: an entry of C is a
/// moment of the particles, since the product of two monomials is a monomial, and a basis function is W times
/// a polynomial, whose coefficients are a row of \f$C^{-1}\f$.
/// \tparam dim dimension of space, 1 to 3
/// \tparam m degree of the complete monomials, 1 to 3
template <int dim, int m, class Scalar = double>
class Basis {
  public:
    static constexpr int n = terms<dim, m>;

    /// \param near what the place sees of the particles in the kernel's support
    /// \param particle their numbers \param h smoothing length [length]
    /// \throws particles::SingularNeighbourhood if the particles do not determine the monomials: they are too
    ///         few, or all lie on a curve (a surface) that a polynomial of degree m describes
    Basis(Neighbourhood<Scalar, dim> near, std::vector<int> particle, Scalar h);

    [[nodiscard]] const std::vector<int>& particle() const { return particle_; }
    /// Offsets of the particles, in units of h.
    [[nodiscard]] const particles::Offsets<Scalar, dim>& r() const { return near_.r; }
    [[nodiscard]] Table<Scalar> K() const;
    [[nodiscard]] Column<Scalar> row(Index I) const;
    [[nodiscard]] Column<Scalar> DK(Index I, int axis) const;

    /// The matrix of the fit, \eq{B2.9}.
    [[nodiscard]] const auto& matrix() const { return C_; }

  private:
    using Factors = solvers::Cholesky<Scalar, n>;
    using Coefficients = typename Factors::Vector;

    /// Smallest pivot of C, relative to the diagonal: with a smaller one a second derivative loses half of
    /// its digits.
    static constexpr double singular = 1e-10;
    /// Smallest sum of W whose inverse, over the smallest pivot, does not overflow.
    static constexpr double least_sum = 1e-150;

    /// \f$P\,a\f$ for each particle, times a factor of each.
    [[nodiscard]] Column<Scalar> P_times(const Coefficients& a, const Column<Scalar>& factor) const {
        return particles::polynomial<dim, m>(a, near_.r, factor);
    }
    /// h to the order of the derivative in an entry of Q.
    [[nodiscard]] Scalar unit(Index I) const {
        Scalar power(1);
        for (int k = 0; k < order<dim>(monomials<dim, m>()[static_cast<std::size_t>(I - 1)]); ++k)
            power *= h_;
        return power;
    }

    /// The column of \f$C^{-1}\f$ that belongs to an entry of Q.
    [[nodiscard]] Coefficients C_inverse(Index I) const { return factors_.solve(Coefficients::Unit(I - 1)); }
    [[nodiscard]] static Coefficients T(Index I, int axis);

    Neighbourhood<Scalar, dim> near_;
    std::vector<int> particle_;
    Scalar h_;
    typename Factors::Matrix C_;
    Factors factors_;
};

template <int dim, int m, class Scalar>
Basis<dim, m, Scalar>::Basis(Neighbourhood<Scalar, dim> near, std::vector<int> particle, Scalar h)
    : near_(std::move(near)),
      particle_(std::move(particle)),
      h_(h),
      C_(particles::moment_matrix<dim, m>(near_.r, near_.W)),
      factors_(C_) {
    if (!(C_(0, 0) > least_sum)) throw particles::SingularNeighbourhood("the kernel's values underflow");
    // A pivot that vanishes beside its diagonal entry belongs to a monomial that the earlier ones determine.
    if (!(factors_.pivots().array() > singular * C_.diagonal().array()).all())
        throw particles::SingularNeighbourhood(solvers::reciprocal_condition(C_.template cast<double>()));
}

/// The basis functions: the weights on the values at the particles that give Q. \defeq{B2.11}
/// \f[ Q(x) = C^{-1} D\,F^{(x)} = K^{(x)} F^{(x)} \tag{2.11} \f]
/// \return a row for each entry of Q [1/length to the order of its derivative]
template <int dim, int m, class Scalar>
Table<Scalar> Basis<dim, m, Scalar>::K() const {
    auto inverse = factors_.solve(Factors::Matrix::Identity());
    for (Index I = 1; I <= n; ++I) inverse.row(I - 1) /= unit(I);
    return particles::polynomials<dim, m>(inverse, near_.r, near_.W);
}

/// A row of K, \eq{B2.11}, from one solution with C: \f$K_{IJ} = W_J\,P_J\,C^{-1} e_I\f$, since C is
/// symmetric.
/// \param I entry of Q, from 1 to n as in the print
/// \return weights [1/length to the order of the derivative]
template <int dim, int m, class Scalar>
Column<Scalar> Basis<dim, m, Scalar>::row(Index I) const {
    return P_times(C_inverse(I) / unit(I), near_.W);
}

/// Column I of the matrix T in \f$\partial H = T\,H\f$, in units of h: as the place moves, a monomial of the
/// offset changes by minus its exponent times the monomial with one factor fewer.
template <int dim, int m, class Scalar>
auto Basis<dim, m, Scalar>::T(Index I, int axis) -> Coefficients {
    static constexpr auto lowered = [] {
        std::array<std::array<int, n>, dim> table{};
        for (int along = 0; along < dim; ++along)
            for (int k = 0; k < n; ++k)
                table[static_cast<std::size_t>(along)][static_cast<std::size_t>(k)] =
                    particles::lowered<dim, m>(k, along);
        return table;
    }();
    static constexpr auto exponents = monomials<dim, m>();
    const auto coordinate = static_cast<std::size_t>(axis);
    Coefficients column = Coefficients::Zero();
    for (std::size_t k = 1; k < n; ++k)
        if (lowered[coordinate][k] == I - 1) column[static_cast<Index>(k)] = -exponents[k][coordinate];
    return column;
}

/// The exact derivative of a row of K with respect to the place; h is constant. From \f$C\,K = D\f$ follows
/// \f$\partial K = C^{-1}(\partial D - \partial C\,K)\f$: \eq{B3.25} for all of Q, \eq{B2.16} for the values
/// alone. H changes by T H: in D and in the left factor of C this change is the same and cancels; in the
/// right factor it leaves a column of T.
/// \param I entry of Q, from 1 to n \param axis coordinate, from 0
/// \return weights [1/length to the order of the derivative + 1]
template <int dim, int m, class Scalar>
Column<Scalar> Basis<dim, m, Scalar>::DK(Index I, int axis) const {
    if (near_.DW.rows() == 0)
        throw base::InvalidInput("this SSPH basis was made without the kernel's gradient");
    const Column<Scalar> DW = -near_.DW.col(axis);  // with respect to the place, not to the particle
    const Column<Scalar> DW_p = P_times(C_inverse(I), DW);
    const auto H_DW_p = particles::moments<dim, m>(near_.r, DW_p);
    const Coefficients DC_a = T(I, axis) + Coefficients(H_DW_p.data());
    return (DW_p - P_times(factors_.solve(DC_a), near_.W)) / (unit(I) * h_);
}

/// \f$K_{IJ}\f$, a row of \eq{B2.11}: `K<4>(basis)` is \f$K_{4J}\f$.
template <int I, int dim, int m, class Scalar>
Column<Scalar> K(const Basis<dim, m, Scalar>& basis) {
    static_assert(1 <= I && I <= terms<dim, m>);
    return basis.row(I);
}

/// The matrix that spreads the particles of a support among all M. \defeq{B2.12}
/// \f[ S_{j\,g(j)} = 1, \quad S\,S^T = I_N \tag{2.12} \f]
template <class Scalar = double>
Eigen::SparseMatrix<Scalar> selection(const std::vector<int>& particle, Index M) {
    Eigen::SparseMatrix<Scalar> S(static_cast<Index>(particle.size()), M);
    std::vector<Eigen::Triplet<Scalar>> ones;
    for (std::size_t j = 0; j < particle.size(); ++j)
        ones.emplace_back(static_cast<int>(j), particle[j], Scalar(1));
    S.setFromTriplets(ones.begin(), ones.end());
    return S;
}

/// The same estimate from the values of all particles, from which S picks. \defeq{B2.13}
/// \f[ Q = \left(K^{(x)} S\right)\left(S^T F^{(x)}\right) \tag{2.13} \f]
template <class Scalar>
Scalar through_selection(const Column<Scalar>& K_I, const Eigen::SparseMatrix<Scalar>& S,
                         const Column<Scalar>& F_x) {
    return (K_I.matrix().transpose() * S) * (S.transpose() * F_x.matrix());
}

/// A row of K for all M particles: zero for those beyond the support. \defeq{B2.14}
/// \f[ Q(x) = K(\xi, x)\,F(\xi), \quad K = K^{(x)} S \tag{2.14} \f]
template <class Scalar>
Column<Scalar> spread(const Column<Scalar>& K_I, const Eigen::SparseMatrix<Scalar>& S) {
    return S.transpose() * K_I.matrix();
}

/// The weights of a derivative: a row of K times the factorials that \eq{B2.3} takes out. \defeq{B2.15}
/// \f[ \partial^a f(x) = a!\,\sum_J K_{IJ} F_J: \quad f = \sum_J K_{1J} F_J, \quad
///     \frac{\partial f}{\partial x_1} = \sum_J K_{2J} F_J, \quad \frac{\partial^2 f}{\partial x_1^2}
///     = \sum_J 2 K_{5J} F_J \tag{2.15} \f]
/// \param a exponents, whose monomial is the I-th
template <int dim, int m, class Scalar>
Column<Scalar> derivative(const Basis<dim, m, Scalar>& basis, const std::type_identity_t<Exponents<dim>>& a) {
    static constexpr auto all = monomials<dim, m>();
    const Index I = std::find(all.begin(), all.end(), a) - all.begin() + 1;
    return factorial<dim>(a) * basis.row(I);
}

/// The first and second derivatives at a particle, as particles::assemble() takes them. The weights of a
/// derivative sum to zero, so that they serve differences as well.
/// \return weights on \f$f(\xi_j) - f(x)\f$ in units of 1/h and 1/h²
template <int m, int dim, class Scalar>
particles::Derivatives<Scalar, dim> derivatives(const Neighbourhood<Scalar, dim>& near) {
    static_assert(m >= 2, "second derivatives need monomials of degree 2 or 3");
    const Basis<dim, m, Scalar> basis(near, {}, Scalar(1));
    const auto count = near.W.size();
    particles::Derivatives<Scalar, dim> all{particles::Offsets<Scalar, dim>(count, dim),
                                            {count, particles::second_derivatives<dim>}};
    for (int k = 0; k < dim; ++k) all.first.col(k) = basis.row(2 + k);
    for (Index k = 0; k < particles::second_derivatives<dim>; ++k)
        all.second.col(k) = factorial<dim>(monomials<dim, 2>()[static_cast<std::size_t>(1 + dim + k)]) *
                            basis.row(2 + dim + k);
    return all;
}

/// The other way to a derivative, that of finite elements: differentiate the basis function of the values.
/// \defeq{B2.16}
/// \f[ \frac{\partial f}{\partial x_\alpha} = \sum_J \frac{\partial N_J}{\partial x_\alpha} F_J, \quad N_J
///     = K_{1J} \tag{2.16} \f]
/// \param axis coordinate, from 0
template <int dim, int m, class Scalar>
Column<Scalar> differentiated_value(const Basis<dim, m, Scalar>& basis, int axis) {
    return basis.DK(1, axis);
}

}  // namespace ssph_basis
}  // namespace batra2008
