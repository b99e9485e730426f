#pragma once

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/text.hpp"
#include "particles/cloud.hpp"
#include "particles/local_system.hpp"
#include "solvers/cholesky.hpp"

/// Batra and Zhang (2008), section by section.
namespace batra2008 {

using particles::Column;
using particles::Index;
using particles::Point;
using particles::Points;
using particles::Surroundings;

/// Section 2, the SSPH basis: Taylor's expansion around a place x, fitted to the values at the particles near it.
///
/// The unknowns are the derivatives of f at x, the data are the values at the particles, and the kernel weighs them. What
/// results is a set of basis functions for f and a set of its own for each derivative: none is differentiated.
///
/// | paper | code | meaning |
/// | --- | --- | --- |
/// | \f$x,\ \xi^{g(j)}\f$ | `x`, `particle` | the place, and the particles in the kernel's support |
/// | \f$P(\xi, x)\f$ | `P`, a row of `H` | monomials of the offset |
/// | \f$Q(x)\f$ | `Q` | derivatives \f$\partial^a f/a!\f$ in the order of the monomials |
/// | \f$W\f$ | `W` | kernel \eq{B3.15}; only its values enter |
/// | \f$H, C, D\f$ | `H`, `C`, `D` | H and D are kept transposed, a row for each particle |
/// | \f$K_{IJ}\f$ | `K(I)` | basis functions for the I-th entry of Q, one weight per particle J; I counts from 0 |
/// | \f$m\f$ | `m` | degree up to which monomials are complete, 1, 2 or 3 |
///
/// The code serves one, two and three dimensions. Offsets are \f$s = (\xi - x)/h\f$, in units of the smoothing length: the condition of C
/// then depends neither on h nor on the unit of length.
///
/// Departures from the print: below \eq{B2.10} the product of the one-dimensional determinant runs over n1, n, n3; it must be n1, n2, n3.
/// Enough particles do not make C non-singular: in two dimensions particles on a conic (a circle, say) leave it singular for
/// m = 2, and a particle at a distance of ρh exactly has no weight.
///
/// What this section claims, and what was measured: \claims{B-2}.
namespace ssph_basis {

/// Number of monomials of degree m or less in so many dimensions.
template <int dim, int m>
inline constexpr int terms = dim == 1   ? m + 1
                             : dim == 2 ? (m + 1) * (m + 2) / 2
                                        : (m + 1) * (m + 2) * (m + 3) / 6;

/// A row for each particle of a support, a column for each monomial. The number of columns is no part of the type, nor are the sizes
/// of the matrix of the fit: all dimensions and degrees then share their types, and compile in half of the time.
template <class Scalar>
using Table = Eigen::Array<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

/// The matrix of the fit, and its right-hand sides; at most 20 monomials, those of degree 3 in space.
template <class Scalar>
using Matrix = typename solvers::Cholesky<Scalar>::Matrix;
template <class Scalar>
using Vector = typename solvers::Cholesky<Scalar>::Vector;

/// Exponents of a monomial, one for each coordinate.
template <int dim>
using Exponents = std::array<int, dim>;

/// The monomials in the order of \eq{B2.3}: by degree; the pure powers of a degree come first.
template <int dim, int m>
constexpr std::array<Exponents<dim>, terms<dim, m>> monomials() {
    std::array<Exponents<dim>, terms<dim, m>> all{};
    std::size_t count = 1;
    for (int degree = 1; degree <= m; ++degree) {
        for (std::size_t axis = 0; axis < dim; ++axis) all[count++][axis] = degree;
        if constexpr (dim == 2)
            for (int first = degree - 1; first > 0; --first) all[count++] = {first, degree - first};
        if constexpr (dim == 3)
            for (std::size_t axis = 0; axis < 3; ++axis)  // 12, 23, 31
                for (int first = degree - 1; first > 0; --first) {
                    all[count][axis] = first;
                    all[count++][(axis + 1) % 3] = degree - first;
                }
        if constexpr (dim == 3)
            if (degree == 3) all[count++] = {1, 1, 1};
    }
    return all;
}

/// a! of a monomial's exponents a, the factor between \f$\partial^a f\f$ and the entry of Q.
template <int dim>
constexpr int factorial(const Exponents<dim>& a) {
    int product = 1;
    for (const int exponent : a)
        for (int k = 2; k <= exponent; ++k) product *= k;
    return product;
}

/// Degree of a monomial, the order of the derivative that belongs to it.
template <int dim>
constexpr int order(const Exponents<dim>& a) {
    int sum = 0;
    for (const int exponent : a) sum += exponent;
    return sum;
}

namespace detail {

/// Index of the monomial with one factor of a coordinate less; −1 where it has none.
template <int dim, int m>
constexpr int lowered(int monomial, int axis) {
    constexpr auto all = monomials<dim, m>();
    Exponents<dim> wanted = all[static_cast<std::size_t>(monomial)];
    if (wanted[static_cast<std::size_t>(axis)] == 0) return -1;
    --wanted[static_cast<std::size_t>(axis)];
    for (int k = 0; k < terms<dim, m>; ++k)
        if (all[static_cast<std::size_t>(k)] == wanted) return k;
    return -1;
}

/// First coordinate that a monomial contains.
template <int dim, int m>
constexpr int leading(int monomial) {
    constexpr auto all = monomials<dim, m>();
    int axis = 0;
    while (axis < dim - 1 && all[static_cast<std::size_t>(monomial)][static_cast<std::size_t>(axis)] == 0)
        ++axis;
    return axis;
}

/// Calls `visit` with the compile-time numbers 0 … n − 1.
template <int n, class Visit>
constexpr void unrolled(const Visit& visit) {
    [&]<int... k>(std::integer_sequence<int, k...>) {
        (visit(std::integral_constant<int, k>{}), ...);
    }
    (std::make_integer_sequence<int, n>{});
}

}  // namespace detail

/// Taylor's expansion, the k-th power of the directional derivative multiplied out. \defeq{B2.1}
/// \f[ f(\xi) = \sum_{k=0}^{m} \frac{1}{k!}\left[\sum_\alpha (\xi_\alpha - x_\alpha)\frac{\partial}{\partial x_\alpha}\right]^k f(x)
///     = \sum_{|a| \le m} \frac{(\xi - x)^a}{a!}\,\partial^a f(x) \tag{2.1} \f]
/// \param derivative \f$\partial^a f(x)\f$ by exponents a
/// \param offset \f$\xi - x\f$
template <int dim, int m>
double taylor(const std::function<double(const Exponents<dim>&)>& derivative, const Point<dim>& offset) {
    double f = 0;
    for (const Exponents<dim>& a : monomials<dim, m>()) {
        double power = 1;
        for (std::size_t axis = 0; axis < dim; ++axis)
            power *= std::pow(offset[static_cast<Index>(axis)], a[axis]);
        f += power / factorial<dim>(a) * derivative(a);
    }
    return f;
}

/// The monomials of many offsets: the matrix H of \eq{B2.6}, transposed. A row is the P of a particle, its entries in the
/// order that stands below \eq{B2.3}; each column is an earlier one times a coordinate. \defeq{B2.6}
/// \f[ H = \left[P^T(\xi^{g(1)}, x),\ \ldots,\ P^T(\xi^{g(N)}, x)\right], \quad
///     W = \operatorname{diag}\!\left(W(\xi^{g(j)}, x)\right), \quad
///     F^{(x)} = \left[f(\xi^{g(1)}),\ \ldots,\ f(\xi^{g(N)})\right]^T \tag{2.6} \f]
/// \param s offsets, a row for each particle
template <int dim, int m, class Scalar>
Table<Scalar> H(const Eigen::Array<Scalar, Eigen::Dynamic, dim>& s) {
    Table<Scalar> all(s.rows(), terms<dim, m>);
    all.col(0).setOnes();
    detail::unrolled<terms<dim, m> - 1>([&](auto before) {
        constexpr int k = before + 1, axis = detail::leading<dim, m>(k),
                      lower = detail::lowered<dim, m>(k, axis);
        all.col(k) = all.col(lower) * s.col(axis);
    });
    return all;
}

/// The expansion as a product. \defeq{B2.2}
/// \f[ f(\xi) = P(\xi, x)\,Q(x) \tag{2.2} \f]
template <int n>
double value(const Eigen::Array<double, 1, n>& P, const Eigen::Matrix<double, n, 1>& Q) {
    return P.matrix() * Q;
}

/// The unknowns: f and its derivatives at x, each divided by the factorials of its exponents. \defeq{B2.3}
/// \f[ Q = \left[f,\ \frac{\partial f}{\partial x_1},\ \frac{\partial f}{\partial x_2},\ \frac{\partial f}{\partial x_3},
///     \ \frac12\frac{\partial^2 f}{\partial x_1^2},\ \frac12\frac{\partial^2 f}{\partial x_2^2},\ \frac12\frac{\partial^2 f}{\partial x_3^2},
///     \ \frac{\partial^2 f}{\partial x_1 \partial x_2},\ \frac{\partial^2 f}{\partial x_2 \partial x_3},
///     \ \frac{\partial^2 f}{\partial x_1 \partial x_3}\right]^T \tag{2.3} \f]
template <int dim, int m>
Eigen::Matrix<double, terms<dim, m>, 1> Q(const std::function<double(const Exponents<dim>&)>& derivative) {
    Eigen::Matrix<double, terms<dim, m>, 1> all;
    Index k = 0;
    for (const Exponents<dim>& a : monomials<dim, m>()) all[k++] = derivative(a) / factorial<dim>(a);
    return all;
}

/// What one particle says of Q: the expansion \eq{B2.2} at it, times its kernel value and its monomials. \defeq{B2.4}
/// \f[ f(\xi)\,W\,P^T = \left[P^T\,W\,P\right] Q \tag{2.4} \f]
/// \return the matrix in brackets
template <int n>
Eigen::Matrix<double, n, n> outer_product(const Eigen::Array<double, 1, n>& P, double W) {
    return P.matrix().transpose() * W * P.matrix();
}

/// The sum over the particles of the support, which no volumes weigh. \defeq{B2.5}
/// \f[ \sum_{j=1}^{N} f(\xi^{g(j)})\,W\,P^T = \sum_{j=1}^{N} \left[P^T\,W\,P\right] Q \tag{2.5} \f]
/// \return the matrix on the right, term by term
template <int n>
Eigen::Matrix<double, n, n> summed(const Eigen::Array<double, Eigen::Dynamic, n>& H,
                                   const Column<double>& W) {
    Eigen::Matrix<double, n, n> sum = Eigen::Matrix<double, n, n>::Zero();
    for (Index j = 0; j < W.size(); ++j) sum += outer_product<n>(H.row(j), W[j]);
    return sum;
}

/// The same as a product of matrices. \defeq{B2.7}
/// \f[ H\,W\,F^{(x)} = H\,W\,H^T\,Q(x) \tag{2.7} \f]
/// \return both sides for given values and a given Q
template <int n>
std::array<Eigen::Matrix<double, n, 1>, 2> both_sides(const Eigen::Array<double, Eigen::Dynamic, n>& H,
                                                      const Column<double>& W, const Column<double>& F,
                                                      const Eigen::Matrix<double, n, 1>& Q) {
    const auto HT = H.matrix();
    return {HT.transpose() * (W * F).matrix(), HT.transpose() * (W.matrix().asDiagonal() * (HT * Q))};
}

/// The weighted monomials, transposed as H is. \defeq{B2.8}
/// \f[ C\,Q = D\,F^{(x)}, \quad C = H\,W\,H^T, \quad D = H\,W \tag{2.8} \f]
template <class Scalar>
Table<Scalar> D(const Table<Scalar>& H, const Column<Scalar>& W) {
    return H.colwise() * W;
}

/// The symmetric matrix of the fit: no derivative of the kernel enters. Only the lower half is computed. \defeq{B2.9}
/// \f[ C = \left[W(g(1))\,P^T(g(1)),\ \ldots,\ W(g(N))\,P^T(g(N))\right]
///     \begin{bmatrix} P(g(1)) \\ \vdots \\ P(g(N)) \end{bmatrix} \tag{2.9} \f]
template <class Scalar>
Matrix<Scalar> C(const Table<Scalar>& D, const Table<Scalar>& H) {
    const Index n = H.cols();
    Matrix<Scalar> lower(n, n);
    for (Index I = 0; I < n; ++I)
        for (Index J = 0; J <= I; ++J) lower(I, J) = (D.col(J) * H.col(I)).sum();
    return lower.template selfadjointView<Eigen::Lower>();
}

/// The determinant of C by Binet and Cauchy: a sum of squares over all choices of n particles, positive unless every choice is
/// degenerate. For small supports: the number of choices grows fast. \defeq{B2.10}
/// \f[ \det C = \sum_{n_1 < \cdots < n_n} \prod_k W(g(n_k))
///     \left(\det\begin{bmatrix} P(g(n_1)) \\ \vdots \\ P(g(n_n)) \end{bmatrix}\right)^2 \tag{2.10} \f]
template <int n>
double determinant(const Eigen::Array<double, Eigen::Dynamic, n>& H, const Column<double>& W) {
    double sum = 0;
    std::array<Index, n> chosen;
    const std::function<void(std::size_t, Index)> choose = [&](std::size_t count, Index first) {
        if (count == n) {
            Eigen::Matrix<double, n, n> rows;
            double weight = 1;
            for (std::size_t k = 0; k < n; ++k) {
                rows.row(static_cast<Index>(k)) = H.row(chosen[k]).matrix();
                weight *= W[chosen[k]];
            }
            sum += weight * std::pow(rows.determinant(), 2);
            return;
        }
        for (Index j = first; j < W.size(); ++j) {
            chosen[count] = j;
            choose(count + 1, j + 1);
        }
    };
    choose(0, 0);
    return sum;
}

/// The basis functions at a place, one set for each entry of Q.
/// \tparam dim dimension of space, 1 to 3
/// \tparam m degree of the complete monomials, 1 to 3
template <int dim, int m, class Scalar = double>
class Basis {
  public:
    static constexpr int n = terms<dim, m>;

    /// \param near the particles in the kernel's support around the place
    /// \param h smoothing length [length]
    /// \throws particles::SingularNeighbourhood where the particles do not determine the monomials: they are too few, or all
    ///         lie on a curve (a surface) that a polynomial of degree m describes
    Basis(Surroundings<dim, Scalar> near, Scalar h)
        : near_(std::move(near)),
          h_(h),
          H_(H<dim, m, Scalar>(near_.s)),
          D_(D<Scalar>(H_, near_.W)),
          C_(C<Scalar>(D_, H_)),
          factors_(C_) {
        // A pivot that vanishes against its diagonal entry belongs to a monomial that the earlier ones give as well.
        const auto pivots = factors_.L().diagonal().array().square();
        const Scalar least = (pivots / C_.diagonal().array()).minCoeff();
        if (!factors_.succeeded() || !(least > singular))
            throw particles::SingularNeighbourhood(least > 0 ? static_cast<double>(least) : 0);
    }

    [[nodiscard]] const std::vector<int>& particle() const { return near_.particle; }

    /// A row of K, the weights on the values at the particles that give an entry of Q. \defeq{B2.11}
    /// \f[ Q(x) = C^{-1} D\,F^{(x)} = K^{(x)} F^{(x)} \tag{2.11} \f]
    /// \param I entry of Q, counted from 0 \return weights [1/length to the order of the derivative]
    [[nodiscard]] Column<Scalar> K(Index I) const {
        return near_.W * sum(factors_.solve(Vector<Scalar>::Unit(n, I)) / unit(I));
    }

    /// All rows of K at once, \eq{B2.11}: a column here for each entry of Q, by substitution with the triangular factors of C
    /// for all particles together.
    [[nodiscard]] Table<Scalar> K() const {
        const auto& L = factors_.L();
        Table<Scalar> all = D_;
        for (Index I = 0; I < n; ++I) {
            for (Index J = 0; J < I; ++J) all.col(I) -= L(I, J) * all.col(J);
            all.col(I) *= 1 / L(I, I);
        }
        for (Index I = n - 1; I >= 0; --I) {
            for (Index J = I + 1; J < n; ++J) all.col(I) -= L(J, I) * all.col(J);
            all.col(I) *= 1 / L(I, I);
        }
        for (Index I = 1; I < n; ++I) all.col(I) *= 1 / unit(I);
        return all;
    }

    /// The derivative of a row of K with respect to the place, exactly; h stays. From \f$C\,K = D\f$ follows
    /// \f$\partial K = C^{-1}(\partial D - \partial C\,K)\f$: \eq{B3.25} for all of Q, \eq{B2.16} for the values alone. H changes by
    /// H S with a matrix S: in D and in the right factor of C that is the same change, and cancels; the left factor leaves a row of S.
    /// \return weights [1/length to the order of the derivative + 1]
    [[nodiscard]] Column<Scalar> differentiated(Index I, int axis) const {
        const Column<Scalar>& W = near_.W;
        const Column<Scalar> dW = 2 * near_.s.col(axis) * (W + near_.edge);
        const Vector<Scalar> a = factors_.solve(Vector<Scalar>::Unit(n, I));
        const Column<Scalar> p = sum(a);
        const Vector<Scalar> dC_a =
            row_of_S(I, axis) + H_.matrix().transpose().lazyProduct((dW * p).matrix());
        return (dW * p - W * sum(factors_.solve(dC_a))) / (unit(I) * h_);
    }

    /// Condition number of C in the 2-norm.
    [[nodiscard]] Scalar condition() const {
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixX<Scalar>> spectrum(C_, Eigen::EigenvaluesOnly);
        return spectrum.eigenvalues()[n - 1] / spectrum.eigenvalues()[0];
    }

    /// The matrix of the fit, \eq{B2.9}.
    [[nodiscard]] const Matrix<Scalar>& matrix() const { return C_; }

  private:
    /// Below, half of the digits of a second derivative are lost.
    static constexpr double singular = 1e-10;

    /// \f$P\,a\f$ for each particle.
    [[nodiscard]] auto sum(const Vector<Scalar>& a) const {
        return H_.matrix().lazyProduct(a).array().eval();
    }
    [[nodiscard]] Scalar unit(Index I) const {
        Scalar power(1);
        for (int k = 0; k < order<dim>(monomials<dim, m>()[static_cast<std::size_t>(I)]); ++k) power *= h_;
        return power;
    }

    /// Row I of S in \f$\partial H = H S\f$, in units of h: with the place a monomial of the offset changes by minus its exponent times
    /// the monomial with one factor less.
    [[nodiscard]] static Vector<Scalar> row_of_S(Index I, int axis) {
        Vector<Scalar> row = Vector<Scalar>::Zero(n);
        for (int k = 1; k < n; ++k)
            if (lower_[static_cast<std::size_t>(axis)][static_cast<std::size_t>(k)] == I)
                row[k] = -exponent(k, axis);
        return row;
    }
    static constexpr int exponent(int monomial, int axis) {
        return monomials<dim, m>()[static_cast<std::size_t>(monomial)][static_cast<std::size_t>(axis)];
    }
    static constexpr auto lower_ = [] {
        std::array<std::array<int, n>, dim> table{};
        for (int axis = 0; axis < dim; ++axis)
            for (int k = 0; k < n; ++k)
                table[static_cast<std::size_t>(axis)][static_cast<std::size_t>(k)] =
                    detail::lowered<dim, m>(k, axis);
        return table;
    }();

    Surroundings<dim, Scalar> near_;
    Scalar h_;
    Table<Scalar> H_, D_;
    Matrix<Scalar> C_;
    solvers::Cholesky<Scalar> factors_;
};

/// The matrix that spreads the particles of a support among all M. \defeq{B2.12}
/// \f[ S_{j\,g(j)} = 1, \quad S\,S^T = I_N \tag{2.12} \f]
inline Eigen::SparseMatrix<double> selection(const std::vector<int>& particle, Index M) {
    Eigen::SparseMatrix<double> S(static_cast<Index>(particle.size()), M);
    std::vector<Eigen::Triplet<double>> ones;
    for (std::size_t j = 0; j < particle.size(); ++j)
        ones.emplace_back(static_cast<int>(j), particle[j], 1.0);
    S.setFromTriplets(ones.begin(), ones.end());
    return S;
}

/// The same estimate with the values of all particles, of which S picks. \defeq{B2.13}
/// \f[ Q = \left(K^{(x)} S\right)\left(S^T F^{(x)}\right) \tag{2.13} \f]
inline double through_selection(const Column<double>& K_I, const Eigen::SparseMatrix<double>& S,
                                const Column<double>& F_x) {
    return (K_I.matrix().transpose() * S) * (S.transpose() * F_x.matrix());
}

/// A row of K for all M particles: zero for those beyond the support. \defeq{B2.14}
/// \f[ Q(x) = K(\xi, x)\,F(\xi), \quad K = K^{(x)} S \tag{2.14} \f]
inline Column<double> spread(const Column<double>& K_I, const Eigen::SparseMatrix<double>& S) {
    return S.transpose() * K_I.matrix();
}

/// The weights of a derivative: a row of K times the factorials that \eq{B2.3} takes out. \defeq{B2.15}
/// \f[ \partial^a f(x) = a!\,\sum_J K_{IJ} F_J: \quad f = \sum_J K_{1J} F_J, \quad
///     \frac{\partial f}{\partial x_1} = \sum_J K_{2J} F_J, \quad \frac{\partial^2 f}{\partial x_1^2} = \sum_J 2 K_{5J} F_J \tag{2.15} \f]
template <int dim, int m, class Scalar>
Column<Scalar> derivative(const Basis<dim, m, Scalar>& basis, Index I) {
    return factorial<dim>(monomials<dim, m>()[static_cast<std::size_t>(I)]) * basis.K(I);
}

/// The other way to a derivative, that of finite elements: differentiate the basis function of the values. \defeq{B2.16}
/// \f[ \frac{\partial f}{\partial x_\alpha} = \sum_J \frac{\partial N_J}{\partial x_\alpha} F_J, \quad N_J = K_{1J} \tag{2.16} \f]
template <int dim, int m, class Scalar>
Column<Scalar> differentiated_value(const Basis<dim, m, Scalar>& basis, int axis) {
    return basis.differentiated(0, axis);
}

/// Would these particles of a cloud determine the monomials?
/// \param among the particles that come into question
template <int m, int dim>
bool determined(const particles::Cloud<dim>& cloud, const particles::TruncatedGaussian<dim>& kernel,
                const Point<dim>& x, double h, const std::vector<int>& among) {
    try {
        const Basis<dim, m> basis(particles::surroundings(cloud, kernel, x, h, among), h);
        return true;
    } catch (const particles::SingularNeighbourhood&) {
        return false;
    }
}

/// "ssph_basis: at (0.1, 0.2) there are 5 particles within 2h = 0.1, and 6 monomials of degree 2"
template <int dim, int m>
[[noreturn]] void refuse(const particles::Cloud<dim>& cloud, double rho, const Point<dim>& x, double h,
                         std::size_t found, const std::string& why) {
    constexpr int n = terms<dim, m>;
    std::string remedy = "take at least " + std::to_string(n) + " particles";
    if (cloud.size() >= n) {
        Column<double> distance = (cloud.x().colwise() - x).colwise().norm().transpose();
        std::nth_element(distance.begin(), distance.begin() + (n - 1), distance.end());
        const double enough = std::floor(10 * distance[n - 1] / h * (1 + 1e-6) + 1);
        remedy = "take other particles";
        for (int more = 0; more < 50; ++more) {
            const double scaling = (std::max(enough, std::ceil(10 * rho + 5)) + more) / 10;
            const particles::TruncatedGaussian<dim> larger(scaling);
            if (!determined<m>(cloud, larger, x, h, cloud.around(x, scaling * h))) continue;
            remedy = "try --scaling " + base::shown(scaling);
            break;
        }
    }
    throw base::FailedComputation("ssph_basis: at " + particles::shown_point(x) + " there are " +
                                  std::to_string(found) + " particles within " + base::shown(rho) +
                                  "h = " + base::shown(rho * h, 3) + " for the " + std::to_string(n) +
                                  " monomials of degree " + std::to_string(m) + why + "; " + remedy);
}

/// The basis at any place of a cloud.
/// \param among the particles that come into question
/// \throws base::FailedComputation naming the place, its particles, the monomials and a remedy where they do not suffice
template <int m, int dim>
Basis<dim, m> basis_at(const particles::Cloud<dim>& cloud, const particles::TruncatedGaussian<dim>& kernel,
                       const Point<dim>& x, double h, const std::vector<int>& among) {
    Surroundings<dim> near = particles::surroundings(cloud, kernel, x, h, among);
    const std::size_t found = near.particle.size();
    if (found < static_cast<std::size_t>(terms<dim, m>)) refuse<dim, m>(cloud, kernel.rho(), x, h, found, "");
    try {
        return Basis<dim, m>(std::move(near), h);
    } catch (const particles::SingularNeighbourhood& singular) {
        refuse<dim, m>(cloud, kernel.rho(), x, h, found,
                       std::string(", which they do not determine: ") + singular.what());
    }
}

/// The same, found in the cloud.
template <int m, int dim>
Basis<dim, m> basis_at(const particles::Cloud<dim>& cloud, const particles::TruncatedGaussian<dim>& kernel,
                       const Point<dim>& x, double h) {
    return basis_at<m>(cloud, kernel, x, h, cloud.around(x, kernel.rho() * h));
}

}  // namespace ssph_basis
}  // namespace batra2008
