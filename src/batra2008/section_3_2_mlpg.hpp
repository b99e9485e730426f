#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "batra2008/bases_near.hpp"
#include "batra2008/section_3_1_collocation.hpp"
#include "particles/boundary.hpp"
#include "particles/region_rules.hpp"

namespace batra2008 {

/// Section 3.2, the meshless local Petrov–Galerkin method: a weak form over a disc around each particle.
/// "weak1" takes the derivatives of the trial solution from their own SSPH basis (Section 3.2.1), "weak2"
/// differentiates the basis of the values (Section 3.2.2).
///
/// | paper | code | meaning |
/// | --- | --- | --- |
/// | \f$\Omega_I\f$ | `Subdomain` | points in the disc \f$\|x - x_I\| \le \rho h_I\f$ and in Ω |
/// | \f$W^I\f$ | `W`, `DW` | test function \eq{B3.15}, with a scaling factor of its own, 1 |
/// | \f$\Gamma^I_u,\ \Gamma^I_t\f$ | `Subdomain::boundary` | the boundary within the disc, by component |
/// | \f$\alpha\f$ | `penalty` | penalty parameter of the given displacements |
/// | \f$M, N, R, T\f$ | `M_u`, `M_t`, `N`, `R`, `T` | below \eq{B3.20} and \eq{B3.24}; M by component |
/// | \f$n_G\f$ | `gauss` | Gauss points in the radial direction and along a boundary; 4 n_G in angle |
///
/// What the print leaves open: the 4 n_G angles share the part of the circle that sees Ω; the neighbours of a
/// Gauss point are those within ρh of that point, where h is the smoothing length of the particle that owns
/// the disc; weak2 does not differentiate h. On a side, each component is either displaced or loaded.
///
/// What this section claims, and what was measured: \claims{B-3.2}.
namespace mlpg {

/// The test function, and with its own scaling factor the kernel of Section 2. \defeq{B3.15}
/// \f[ W(\xi - x) = \begin{cases} \frac{G}{(h\sqrt\pi)^\lambda}\left(e^{-|\xi-x|^2/h^2} - e^{-\rho^2}\right)
///     & |\xi - x| \le \rho h
///     \\ 0 & |\xi - x| > \rho h \end{cases} \tag{3.15} \f]
/// \param offset \f$\xi - x\f$ \return [1/length to the dimension λ]
template <int dim>
double W(const particles::TruncatedGaussian<dim>& kernel, const Point<dim>& offset, double h) {
    return kernel.at(offset.squaredNorm() / (h * h)) / std::pow(h, dim);
}

/// Gradient of the test function with respect to ξ, inside its support. [1/length to the dimension + 1]
template <int dim>
Point<dim> DW(const particles::TruncatedGaussian<dim>& kernel, const Point<dim>& offset, double h) {
    return -2 / (h * h) * (W(kernel, offset, h) + kernel.edge() / std::pow(h, dim)) * offset;
}

/// The test function times the unit matrix, or the rows of this matrix for some components.
using TestMatrix = Eigen::DiagonalMatrix<double, 2>;

/// A quadrature point inside a subdomain.
struct InnerPoint {
    Point<2> x;
    double weight, W;
    Vector DW;

    [[nodiscard]] TestMatrix M() const { return {W, W}; }
};

/// A quadrature point on the boundary within a subdomain.
struct BoundaryPoint {
    Point<2> x;
    double weight, W;
    Vector n;
    std::array<bool, 2> displaced;

    /// M for the displaced components: with it, an integral over the boundary is one over \f$\Gamma^I_u\f$.
    [[nodiscard]] TestMatrix M_u() const { return {displaced[0] ? W : 0, displaced[1] ? W : 0}; }
    /// M for the loaded components: with it, an integral over the boundary is one over \f$\Gamma^I_t\f$.
    [[nodiscard]] TestMatrix M_t() const { return {displaced[0] ? 0 : W, displaced[1] ? 0 : W}; }
};

/// \f$\Omega_I\f$ with its test function, and the boundary within it.
struct Subdomain {
    std::vector<InnerPoint> inside;
    std::vector<BoundaryPoint> boundary;
};

/// \param x particle \param h its smoothing length \param test kernel of the test function \param gauss
///         \f$n_G\f$
inline Subdomain subdomain(const Problem& problem, const particles::Boundary& boundary, const Point<2>& x,
                           double h, const Kernel& test, Index gauss) {
    Subdomain Omega;
    const double reach = test.rho() * h;
    for (const auto& point : particles::polar_rule(boundary, x, reach, gauss, 4 * gauss))
        Omega.inside.push_back(
            {point.x, point.weight, W<2>(test, point.x - x, h), DW<2>(test, point.x - x, h)});
    for (const elastostatics::Side& side : problem.sides)
        for (const auto& point : particles::boundary_rule(side.curve, x, reach, gauss))
            Omega.boundary.push_back(
                {point.x, point.weight, W<2>(test, point.x - x, h), point.normal, side.displaced});
    return Omega;
}

/// Integral of a vector over a part of a subdomain.
/// \param f its value at a quadrature point
template <class QuadraturePoint, class Integrand>
Vector integral(const std::vector<QuadraturePoint>& points, const Integrand& f) {
    Vector sum = Vector::Zero();
    for (const QuadraturePoint& at : points) sum += at.weight * Vector(f(at));
    return sum;
}

/// The terms of an integral, which are added to a sum one after the other.
struct Terms {
    std::vector<Vector> terms;
};
inline Vector operator+(Vector sum, const Terms& more) {
    for (const Vector& term : more.terms) sum += term;
    return sum;
}
inline Vector operator*(double factor, const Terms& sum) {
    return factor * (Vector(Vector::Zero()) + sum);
}

/// Integral of M f over a part of a subdomain.
/// \param M the test function at a quadrature point
template <class QuadraturePoint, class Integrand>
Terms integral(const std::vector<QuadraturePoint>& points, TestMatrix (QuadraturePoint::*M)() const,
               const Integrand& f) {
    Terms sum;
    for (const QuadraturePoint& at : points) sum.terms.emplace_back((at.weight * (at.*M)()) * Vector(f(at)));
    return sum;
}

/// A smooth displacement with its strains and stresses.
struct Field {
    elastostatics::FieldOf<Vector> u;
    elastostatics::FieldOf<Strain> strain;
    elastostatics::FieldOf<Stress> stress;
    elastostatics::FieldOf<Eigen::Matrix<double, 3, 2>> stress_gradient;
};

/// Equilibrium and given displacements, weighted: zero for a solution. \defeq{B3.16}
/// \f[ \int_{\Omega_I}\sigma_{ij,j}\,W^I_i\,d\Omega - \alpha\int_{\Gamma^I_u}
///     (u_i - \bar u_i)\,W^I_i\,d\Gamma = 0 \tag{3.16} \f]
/// \param given \f$\bar u\f$ \param alpha penalty parameter
inline Vector weighted_residual(const Subdomain& Omega, const Field& field,
                                const elastostatics::FieldOf<Vector>& given, double alpha) {
    const auto divergence = [&](const InnerPoint& at) -> Vector {
        return elastostatics::imbalance(field.stress_gradient(at.x), Vector::Zero()) * at.W;
    };
    const auto gap = [&](const BoundaryPoint& at) -> Vector {
        return at.M_u() * (field.u(at.x) - given(at.x));
    };
    return integral(Omega.inside, divergence) - alpha * integral(Omega.boundary, gap);
}

/// \eq{B3.16} after the divergence theorem. \defeq{B3.17}
/// \f[ \int_{\partial\Omega_I}\sigma_{ij}\,n_j\,W^I_i\,d\Gamma
///     - \int_{\Omega_I}\sigma_{ij}\,W^I_{i,j}\,d\Omega
///     - \alpha\int_{\Gamma^I_u}(u_i - \bar u_i)\,W^I_i\,d\Gamma = 0 \tag{3.17} \f]
/// \param boundary_work the first integral, \eq{B3.18}
inline Vector after_divergence_theorem(const Vector& boundary_work, const Subdomain& Omega,
                                       const Field& field, const elastostatics::FieldOf<Vector>& given,
                                       double alpha) {
    const auto inner_work = [&](const InnerPoint& at) -> Vector {
        return elastostatics::traction(field.stress(at.x), at.DW);
    };
    const auto gap = [&](const BoundaryPoint& at) -> Vector {
        return at.M_u() * (field.u(at.x) - given(at.x));
    };
    return boundary_work - integral(Omega.inside, inner_work) - alpha * integral(Omega.boundary, gap);
}

/// Work of the tractions on the test function, which vanishes on the circle: the boundary of Ω is left.
/// \defeq{B3.18}
/// \f[ \int_{\partial\Omega_I}\sigma_{ij}\,n_j\,W^I_i\,d\Gamma
///     = \int_{\partial\Omega_I\cap\Gamma}\sigma_{ij}\,n_j\,W^I_i\,d\Gamma \tag{3.18} \f]
inline Vector boundary_work(const Subdomain& Omega, const Field& field) {
    return integral(Omega.boundary, [&](const BoundaryPoint& at) -> Vector {
        return elastostatics::traction(field.stress(at.x), at.n) * at.W;
    });
}

/// The weak form: its left-hand side minus its right-hand side for a given field. \defeq{B3.19}
/// \f[ \int_{\Omega_I}\sigma_{ij}\,W^I_{i,j}\,d\Omega + \alpha\int_{\Gamma^I_u}u_i\,W^I_i\,d\Gamma
///     - \int_{\Gamma^I_u}\sigma_{ij}\,n_j\,W^I_i\,d\Gamma
///     = \int_{\Gamma^I_t}\bar t_i\,W^I_i\,d\Gamma + \alpha\int_{\Gamma^I_u}\bar u_i\,W^I_i\,d\Gamma
///     \tag{3.19} \f]
inline Vector weak_form(const Subdomain& Omega, const Field& field, const elastostatics::Exact& given,
                        double alpha) {
    using elastostatics::traction;
    const auto inside = [&](const InnerPoint& at) { return traction(field.stress(at.x), at.DW); };
    const auto left = [&](const BoundaryPoint& at) -> Vector {
        return at.M_u() * (alpha * field.u(at.x) - traction(field.stress(at.x), at.n));
    };
    const auto right = [&](const BoundaryPoint& at) -> Vector {
        return at.M_t() * traction(given.stress(at.x), at.n) + at.M_u() * (alpha * given.u(at.x));
    };
    return integral(Omega.inside, inside) + integral(Omega.boundary, left) - integral(Omega.boundary, right);
}

/// The normal as a matrix, with which \f$N\sigma\f$ is the traction, below \eq{B3.20}.
inline Eigen::Matrix<double, 2, 3> N(const Vector& n) {
    return Eigen::Matrix<double, 2, 3>{{n[0], 0, n[1]}, {0, n[1], n[0]}};
}

/// L M for a test function with gradient DW, below \eq{B3.20}.
inline Eigen::Matrix<double, 3, 2> LM(const Vector& DW) {
    return elastostatics::L(DW);
}

/// The weak form \eq{B3.19} with matrices: its left-hand side minus its right-hand side for a given field.
/// \defeq{B3.20}
/// \f[ \int_{\Omega_I}(LM)^T D\,L u\,d\Omega + \alpha\int_{\Gamma^I_u}M u\,d\Gamma
///     - \int_{\Gamma^I_u}M N D\,L u\,d\Gamma
///     = \int_{\Gamma^I_t}M\bar t\,d\Gamma + \alpha\int_{\Gamma^I_u}M\bar u\,d\Gamma \tag{3.20} \f]
inline Vector matrix_form(const Subdomain& Omega, const Eigen::Matrix3d& D, const Field& field,
                          const elastostatics::Exact& given, double alpha) {
    const auto inside = [&](const InnerPoint& at) -> Vector {
        return LM(at.DW).transpose() * D * field.strain(at.x);
    };
    const auto left = [&](const BoundaryPoint& at) -> Vector {
        return alpha * at.M_u() * field.u(at.x) - at.M_u() * N(at.n) * D * field.strain(at.x);
    };
    const auto right = [&](const BoundaryPoint& at) -> Vector {
        return at.M_t() * N(at.n) * given.stress(at.x) + alpha * at.M_u() * given.u(at.x);
    };
    return integral(Omega.inside, inside) + integral(Omega.boundary, left) - integral(Omega.boundary, right);
}

/// The matrix R of the trial solution: \f$u = \sum_J R\,u_J\f$, the first half of \eq{B3.21}.
template <int m>
Block R(const ssph_basis::Basis<2, m>& basis) {
    return collocation::displacement(basis);
}

/// The entries of the matrix T: weights of the two first derivatives of a component.
struct GradientWeights {
    Column<double> by_x1, by_x2;
};

/// The trial solution's gradient from its own basis functions, which fill the matrix T. \defeq{B3.21}
/// \f[ u = \sum_J \begin{bmatrix} K_{1J} & 0 \\ 0 & K_{1J} \end{bmatrix} u_J = \sum_J R\,u_J, \qquad
///     L u = \sum_J \begin{bmatrix} K_{2J} & 0 \\ 0 & K_{3J} \\ K_{3J} & K_{2J} \end{bmatrix} u_J
///     = \sum_J T\,u_J \tag{3.21} \f]
template <int m>
GradientWeights own_gradient(const ssph_basis::Basis<2, m>& basis) {
    using ssph_basis::K;
    return {K<2>(basis), K<3>(basis)};
}

/// M times R, for each neighbour.
inline Block operator*(const TestMatrix& M, const Block& R) {
    const auto& m = M.diagonal();
    return {m[0] * R.K11, m[0] * R.K12, m[1] * R.K21, m[1] * R.K22};
}

/// A matrix times T, for each neighbour; the product is not yet computed.
struct Product {
    Eigen::Matrix<double, 2, 3> A;
    GradientWeights T;
};
inline Product operator*(const Eigen::Matrix<double, 2, 3>& A, const GradientWeights& T) {
    return {A, T};
}

/// A block less such a product, whose terms are added to a sum one after the other.
struct Difference {
    Block plus;
    Product minus;
};
inline Difference operator-(const Block& plus, const Product& minus) {
    return {plus, minus};
}

namespace detail {

/// Adds a block to a sum, times a weight.
inline void add(Block& sum, double weight, const Block& block) {
    sum.K11 += weight * block.K11;
    sum.K12 += weight * block.K12;
    sum.K21 += weight * block.K21;
    sum.K22 += weight * block.K22;
}
inline void add(Block& sum, double weight, const Product& product) {
    const Eigen::Matrix<double, 2, 3> A = weight * product.A;
    const auto& [K2, K3] = product.T;
    sum.K11 += A(0, 0) * K2 + A(0, 2) * K3;
    sum.K12 += A(0, 1) * K3 + A(0, 2) * K2;
    sum.K21 += A(1, 0) * K2 + A(1, 2) * K3;
    sum.K22 += A(1, 1) * K3 + A(1, 2) * K2;
}
inline void add(Block& sum, double weight, const Difference& blocks) {
    add(sum, weight, blocks.plus);
    add(sum, -weight, blocks.minus);
}

}  // namespace detail

/// The integral of a block over a part of a subdomain, as a rule that adds it to a sum point by point.
template <int m, class QuadraturePoint, class Integrand>
struct BlockIntegral {
    const std::vector<QuadraturePoint>& points;
    const ssph_basis::BasesNear<m>& near;
    Integrand f;

    void add_to(Block& sum) const {
        for (const QuadraturePoint& at : points) detail::add(sum, at.weight, f(at, near.basis_at(at.x)));
    }
};

/// \param near the particles whose basis functions may enter the equations of one particle
/// \param f value at a quadrature point, from the basis there
template <int m, class QuadraturePoint, class Integrand>
BlockIntegral<m, QuadraturePoint, Integrand> integral(const std::vector<QuadraturePoint>& points,
                                                      const ssph_basis::BasesNear<m>& near,
                                                      const Integrand& f) {
    return {points, near, f};
}

/// The sum of two integrals: a block over all particles that may enter.
template <int m, class... A, class... B>
Block operator+(const BlockIntegral<m, A...>& first, const BlockIntegral<m, B...>& second) {
    const Column<double> zero = Column<double>::Zero(static_cast<Index>(first.near.particle().size()));
    Block sum{zero, zero, zero, zero};
    first.add_to(sum);
    second.add_to(sum);
    return sum;
}

/// The system: two rows for each particle, on the boundary as inside. \defeq{B3.22}
/// \f[ \sum_{J=1}^{M} K'_{IJ}\,u_J = f_I \tag{3.22} \f]
/// \param near for each particle the neighbours J, in increasing order
/// \param Omega \f$\Omega_I\f$ by I
/// \param K \f$K'_{IJ}\f$ for all J by I and its subdomain, \eq{B3.23}
/// \param f \f$f_I\f$ by the subdomain, \eq{B3.24}
template <class SubdomainOf, class Stiffness, class Load>
System system(const std::vector<std::vector<int>>& near, const SubdomainOf& Omega, const Stiffness& K,
              const Load& f) {
    return assembled(near, [&](Index I) {
        const Subdomain Omega_I = Omega(I);
        return Equations{near[static_cast<std::size_t>(I)], K(I, Omega_I), f(Omega_I)};
    });
}

/// The points of \f$\Gamma^I_u\f$: those where the displacement of a component is given.
inline std::vector<BoundaryPoint> on_Gamma_u(const Subdomain& Omega) {
    std::vector<BoundaryPoint> points;
    std::copy_if(Omega.boundary.begin(), Omega.boundary.end(), std::back_inserter(points),
                 [](const BoundaryPoint& at) { return at.displaced[0] || at.displaced[1]; });
    return points;
}

/// The stiffness of a particle's subdomain, two rows. \defeq{B3.23}
/// \f[ K'_{IJ} = \int_{\Omega_I}(LM)^T D\,T\,d\Omega + \alpha\int_{\Gamma^I_u}M R\,d\Gamma
///     - \int_{\Gamma^I_u}M N D\,T\,d\Gamma \tag{3.23} \f]
/// \param T from a basis, \eq{B3.21} or \eq{B3.26}
/// \return a block over all particles of which the bases are made
template <int m, class GradientOf>
Block stiffness(const Subdomain& Omega, const Eigen::Matrix3d& D, double alpha,
                const ssph_basis::BasesNear<m>& near, const GradientOf& T) {
    return integral(Omega.inside, near,
                    [&](const InnerPoint& at, const auto& basis) {
                        return LM(at.DW).transpose() * D * T(basis);
                    }) +
           integral(on_Gamma_u(Omega), near, [&](const BoundaryPoint& at, const auto& basis) {
               return alpha * at.M_u() * R(basis) - at.M_u() * N(at.n) * D * T(basis);
           });
}

/// The load of a particle's subdomain; a body force adds its work. \defeq{B3.24}
/// \f[ f_I = \int_{\Gamma^I_t}M\bar t\,d\Gamma + \alpha\int_{\Gamma^I_u}M\bar u\,d\Gamma \tag{3.24} \f]
inline Vector load(const Subdomain& Omega, const elastostatics::Exact& given, double alpha) {
    const auto u = [&](const BoundaryPoint& at) { return given.u(at.x); };
    const auto t = [&](const BoundaryPoint& at) { return elastostatics::traction(given.stress(at.x), at.n); };
    const auto b = [&](const InnerPoint& at) { return given.b(at.x); };
    return alpha * integral(Omega.boundary, &BoundaryPoint::M_u, u) +
           integral(Omega.boundary, &BoundaryPoint::M_t, t) + integral(Omega.inside, &InnerPoint::M, b);
}

/// The derivatives of all basis functions. \defeq{B3.25}
/// \f[ \frac{\partial Q}{\partial x_\alpha} = \frac{\partial K}{\partial x_\alpha}\,F, \quad
///     \frac{\partial K}{\partial x_\alpha} = C^{-1}\left(\frac{\partial D}{\partial x_\alpha}
///     - \frac{\partial C}{\partial x_\alpha}K\right) \tag{3.25} \f]
/// \param axis α, from 0 \return a row for each entry of Q
template <int m>
ssph_basis::Table<double> DK(const ssph_basis::Basis<2, m>& basis, int axis) {
    ssph_basis::Table<double> all(basis.n, static_cast<Index>(basis.particle().size()));
    for (Index I = 1; I <= basis.n; ++I) all.row(I - 1) = basis.DK(I, axis).transpose();
    return all;
}

/// The gradient from the differentiated basis of the values. \defeq{B3.26}
/// \f[ L u = \sum_J \begin{bmatrix} (\partial K/\partial x_1)_{1J} & 0 \\ 0 & (\partial K/\partial x_2)_{1J}
///     \\ (\partial K/\partial x_2)_{1J} & (\partial K/\partial x_1)_{1J} \end{bmatrix} u_J = \sum_J T\,u_J
///            \tag{3.26} \f]
template <int m>
GradientWeights differentiated_gradient(const ssph_basis::Basis<2, m>& basis) {
    return {basis.DK(1, 0), basis.DK(1, 1)};
}

/// How the derivatives of the trial solution are obtained.
enum class Gradient {
    own_basis,      ///< weak1: K2 and K3
    differentiated  ///< weak2: K1 differentiated
};

/// The gradient of a method, \eq{B3.21} or \eq{B3.26}.
template <int m>
GradientWeights gradient(const ssph_basis::Basis<2, m>& basis, Gradient how) {
    return how == Gradient::own_basis ? own_gradient(basis) : differentiated_gradient(basis);
}

/// What the print leaves open in a weak form.
struct WeakForm {
    Gradient gradient = Gradient::own_basis;
    double penalty = 0;       ///< α [force/length³]
    double test_scaling = 1;  ///< ρ of the test function
    Index gauss = 10;         ///< \f$n_G\f$
};

/// The system \eq{B3.22} of a problem; if it is large, with linear elements.
/// \tparam m degree of the monomials, 1 to 3
/// \param h smoothing length of each particle [length]
/// \param small largest number of particles for which linear_elements() are left out
/// \throws base::InvalidInput as elastostatics::checked()
/// \throws base::FailedComputation as ssph_basis::require_quality(), and as ssph_basis::basis_at()
template <int m>
System system(Problem problem, const Cloud<2>& cloud, const Kernel& kernel, const Column<double>& h,
              const WeakForm& form, Index small = solvers::small_system / 2) {
    problem = elastostatics::checked(std::move(problem), cloud);
    const auto worst = ssph_basis::require_quality<m>(
        cloud, kernel, h, std::vector<int>(static_cast<std::size_t>(cloud.size()), 1));
    const particles::Boundary boundary(elastostatics::region(problem));
    const Eigen::Matrix3d D = elastostatics::D(problem.material);
    const Kernel test(form.test_scaling);
    std::vector<std::vector<int>> near(static_cast<std::size_t>(cloud.size()));
    base::for_each_index(cloud.size(), [&](Index I) {
        near[static_cast<std::size_t>(I)] =
            cloud.within(cloud.x().col(I), (kernel.rho() + test.rho()) * h[I]);
    });
    const auto Omega = [&](Index I) {
        return subdomain(problem, boundary, cloud.x().col(I), h[I], test, form.gauss);
    };
    const auto slopes =
        form.gradient == Gradient::differentiated ? ssph_basis::Slopes::known : ssph_basis::Slopes::none;
    const auto basis_near = [&](Index I) {
        return ssph_basis::BasesNear<m>(cloud, kernel, h[I], near[static_cast<std::size_t>(I)], slopes, h);
    };
    const auto T = [&](const auto& basis) { return gradient(basis, form.gradient); };
    System all = system(
        near, Omega,
        [&](Index I, const Subdomain& Omega_I) {
            return stiffness(Omega_I, D, form.penalty, basis_near(I), T);
        },
        [&](const Subdomain& Omega_I) { return load(Omega_I, problem.exact, form.penalty); });
    all.worst = worst;
    if (cloud.size() > small) all.elements = linear_elements(problem, cloud);
    return all;
}

}  // namespace mlpg
}  // namespace batra2008
