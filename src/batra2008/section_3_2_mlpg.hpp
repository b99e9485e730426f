#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "batra2008/section_3_1_collocation.hpp"

namespace batra2008 {

/// Section 3.2, the meshless local Petrov–Galerkin method: a weak form over a disc around each particle. "weak1" takes the
/// derivatives of the trial solution from their own SSPH basis (Section 3.2.1), "weak2" differentiates the basis of the values
/// (Section 3.2.2).
///
/// | paper | code | meaning |
/// | --- | --- | --- |
/// | \f$\Omega_I\f$ | `Subdomain` | the part of the disc \f$\|x - x_I\| \le \rho h_I\f$ that lies in Ω, as quadrature points |
/// | \f$W^I\f$ | `W`, `DW` | test function \eq{B3.15}, with a scaling factor of its own, 1 |
/// | \f$\Gamma^I_u,\ \Gamma^I_t\f$ | `Subdomain::boundary` | the boundary within the disc |
/// | \f$\alpha\f$ | `penalty` | penalty parameter of the given displacements |
/// | \f$M, N, R, T\f$ | `M`, `N`, `R`, `T` | below \eq{B3.20} and \eq{B3.24} |
/// | \f$n_G\f$ | `gauss` | Gauss points in the radial direction and along a boundary; 4 n_G in angle |
///
/// What the print leaves open: the 4 n_G angles share the part of the circle that sees Ω; the neighbours of a Gauss point
/// are those within ρh of that point, where h is the smoothing length of the particle that owns the disc; h is not differentiated in
/// weak2. Each component of a side is displaced or loaded for itself.
///
/// What this section claims, and what was measured: \claims{B-3.2}.
namespace mlpg {

/// The test function, and with its own scaling factor the kernel of Section 2. \defeq{B3.15}
/// \f[ W(\xi - x) = \begin{cases} \frac{G}{(h\sqrt\pi)^\lambda}\left(e^{-|\xi-x|^2/h^2} - e^{-\rho^2}\right) & |\xi - x| \le \rho h
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

/// A quadrature point inside a subdomain.
struct InnerPoint {
    Point<2> x;
    double weight, W;
    Vector DW;
};

/// A quadrature point on the boundary within a subdomain.
struct BoundaryPoint {
    Point<2> x;
    double weight, W;
    Vector n;
    std::array<bool, 2> displaced;
};

/// \f$\Omega_I\f$ with its test function, and the boundary within it.
struct Subdomain {
    std::vector<InnerPoint> inside;
    std::vector<BoundaryPoint> boundary;
};

/// \param x particle \param h its smoothing length \param test kernel of the test function \param gauss \f$n_G\f$
inline Subdomain subdomain(const Problem& problem, const particles::Region& region, const Point<2>& x,
                           double h, const Kernel& test, Index gauss) {
    Subdomain of;
    const double reach = test.rho() * h;
    for (const auto& point : particles::polar_rule(region, x, reach, gauss, 4 * gauss))
        of.inside.push_back({point.x, point.weight, W<2>(test, point.x - x, h), DW<2>(test, point.x - x, h)});
    for (const elastostatics::Side& side : problem.sides)
        for (const auto& point : particles::boundary_rule(side.curve, x, reach, gauss))
            of.boundary.push_back(
                {point.x, point.weight, W<2>(test, point.x - x, h), point.normal, side.displaced});
    return of;
}

/// A smooth displacement with all that the integral forms ask of it.
struct Field {
    elastostatics::FieldOf<Vector> u;
    elastostatics::FieldOf<Stress> stress;
    elastostatics::FieldOf<Eigen::Matrix<double, 3, 2>> stress_gradient;
};

/// Sum of a term over the displaced boundary, component by component.
template <class Term>
Vector over_displaced(const Subdomain& Omega, const Term& term) {
    Vector sum = Vector::Zero();
    for (const BoundaryPoint& at : Omega.boundary)
        for (std::size_t i = 0; i < 2; ++i)
            if (at.displaced[i])
                sum[static_cast<Index>(i)] += at.weight * at.W * term(at)[static_cast<Index>(i)];
    return sum;
}

/// Equilibrium and given displacements, weighted: zero for a solution. \defeq{B3.16}
/// \f[ \int_{\Omega_I}\sigma_{ij,j}\,W^I_i\,d\Omega - \alpha\int_{\Gamma^I_u}(u_i - \bar u_i)\,W^I_i\,d\Gamma = 0 \tag{3.16} \f]
/// \param given \f$\bar u\f$
inline Vector weighted_residual(const Subdomain& Omega, const Field& of,
                                const elastostatics::FieldOf<Vector>& given, double penalty) {
    Vector sum = Vector::Zero();
    for (const InnerPoint& at : Omega.inside)
        sum += at.weight * at.W * elastostatics::imbalance(of.stress_gradient(at.x), Vector::Zero());
    return sum - penalty * over_displaced(Omega,
                                          [&](const auto& at) -> Vector { return of.u(at.x) - given(at.x); });
}

/// Work of the tractions on the test function: it vanishes on the circle, which leaves the boundary of Ω. \defeq{B3.18}
/// \f[ \int_{\partial\Omega_I}\sigma_{ij}\,n_j\,W^I_i\,d\Gamma = \int_{\partial\Omega_I\cap\Gamma}\sigma_{ij}\,n_j\,W^I_i\,d\Gamma \tag{3.18} \f]
inline Vector boundary_work(const Subdomain& Omega, const Field& of) {
    Vector sum = Vector::Zero();
    for (const BoundaryPoint& at : Omega.boundary)
        sum += at.weight * at.W * elastostatics::traction(of.stress(at.x), at.n);
    return sum;
}

/// \eq{B3.16} after the divergence theorem. \defeq{B3.17}
/// \f[ \int_{\partial\Omega_I}\sigma_{ij}\,n_j\,W^I_i\,d\Gamma - \int_{\Omega_I}\sigma_{ij}\,W^I_{i,j}\,d\Omega
///     - \alpha\int_{\Gamma^I_u}(u_i - \bar u_i)\,W^I_i\,d\Gamma = 0 \tag{3.17} \f]
inline Vector after_divergence_theorem(const Subdomain& Omega, const Field& of,
                                       const elastostatics::FieldOf<Vector>& given, double penalty) {
    Vector sum = boundary_work(Omega, of);
    for (const InnerPoint& at : Omega.inside)
        sum -= at.weight * elastostatics::traction(of.stress(at.x), at.DW);
    return sum - penalty * over_displaced(Omega,
                                          [&](const auto& at) -> Vector { return of.u(at.x) - given(at.x); });
}

/// The weak form: its left-hand side minus its right-hand side for a given field. \defeq{B3.19}
/// \f[ \int_{\Omega_I}\sigma_{ij}\,W^I_{i,j}\,d\Omega + \alpha\int_{\Gamma^I_u}u_i\,W^I_i\,d\Gamma - \int_{\Gamma^I_u}\sigma_{ij}\,n_j\,W^I_i\,d\Gamma
///     = \int_{\Gamma^I_t}\bar t_i\,W^I_i\,d\Gamma + \alpha\int_{\Gamma^I_u}\bar u_i\,W^I_i\,d\Gamma \tag{3.19} \f]
inline Vector weak_form(const Subdomain& Omega, const Field& of, const elastostatics::Exact& given,
                        double penalty) {
    Vector sum = Vector::Zero();
    for (const InnerPoint& at : Omega.inside)
        sum += at.weight * elastostatics::traction(of.stress(at.x), at.DW);
    for (const BoundaryPoint& at : Omega.boundary) {
        const Vector own = elastostatics::traction(of.stress(at.x), at.n);
        const Vector load = elastostatics::traction(given.stress(at.x), at.n);
        for (Index i = 0; i < 2; ++i)
            sum[i] -= at.weight * at.W * (at.displaced[static_cast<std::size_t>(i)] ? own : load)[i];
    }
    return sum + penalty * over_displaced(
                               Omega, [&](const auto& at) -> Vector { return of.u(at.x) - given.u(at.x); });
}

/// The normal as a matrix, with which \f$N\sigma\f$ is the traction, below \eq{B3.20}.
inline Eigen::Matrix<double, 2, 3> N(const Vector& n) {
    return Eigen::Matrix<double, 2, 3>{{n[0], 0, n[1]}, {0, n[1], n[0]}};
}

/// What stands left of the strains in the area integral of the matrix form: M is the test function times the unit matrix, so that
/// L M follows from its gradient. \defeq{B3.20}
/// \f[ \int_{\Omega_I}(LM)^T D\,L u\,d\Omega + \alpha\int_{\Gamma^I_u}M u\,d\Gamma - \int_{\Gamma^I_u}M N D\,L u\,d\Gamma
///     = \int_{\Gamma^I_t}M\bar t\,d\Gamma + \alpha\int_{\Gamma^I_u}M\bar u\,d\Gamma \tag{3.20} \f]
inline Eigen::Matrix<double, 2, 3> LM_T_D(const Vector& DW, const Eigen::Matrix3d& D) {
    return elastostatics::L(DW).transpose() * D;
}

/// How the trial solution's derivatives are had.
enum class Gradient {
    own_basis,      ///< weak1: K2 and K3
    differentiated  ///< weak2: K1 differentiated
};

/// Weights of the two first derivatives of a component.
struct GradientWeights {
    Column<double> by_x1, by_x2;
};

/// The gradient from its own basis functions, which fill the matrix T. \defeq{B3.21}
/// \f[ u = \sum_J \begin{bmatrix} K_{1J} & 0 \\ 0 & K_{1J} \end{bmatrix} u_J = \sum_J R\,u_J, \qquad
///     L u = \sum_J \begin{bmatrix} K_{2J} & 0 \\ 0 & K_{3J} \\ K_{3J} & K_{2J} \end{bmatrix} u_J = \sum_J T\,u_J \tag{3.21} \f]
template <int m>
GradientWeights own_gradient(const ssph_basis::Basis<2, m>& basis) {
    return {basis.K(1), basis.K(2)};
}

/// The derivatives of all basis functions. \defeq{B3.25}
/// \f[ \frac{\partial Q}{\partial x_\alpha} = \frac{\partial K}{\partial x_\alpha}\,F, \quad
///     \frac{\partial K}{\partial x_\alpha} = C^{-1}\left(\frac{\partial D}{\partial x_\alpha} - \frac{\partial C}{\partial x_\alpha}K\right) \tag{3.25} \f]
/// \return a column for each entry of Q
template <int m>
Eigen::Array<double, Eigen::Dynamic, ssph_basis::terms<2, m>> differentiated(
    const ssph_basis::Basis<2, m>& basis, int axis) {
    constexpr int n = ssph_basis::terms<2, m>;
    Eigen::Array<double, Eigen::Dynamic, n> all(static_cast<Index>(basis.particle().size()), n);
    for (Index I = 0; I < n; ++I) all.col(I) = basis.differentiated(I, axis);
    return all;
}

/// The gradient from the differentiated basis of the values. \defeq{B3.26}
/// \f[ L u = \sum_J \begin{bmatrix} (\partial K/\partial x_1)_{1J} & 0 \\ 0 & (\partial K/\partial x_2)_{1J}
///     \\ (\partial K/\partial x_2)_{1J} & (\partial K/\partial x_1)_{1J} \end{bmatrix} u_J = \sum_J T\,u_J \tag{3.26} \f]
template <int m>
GradientWeights differentiated_gradient(const ssph_basis::Basis<2, m>& basis) {
    return {basis.differentiated(0, 0), basis.differentiated(0, 1)};
}

template <int m>
GradientWeights gradient(const ssph_basis::Basis<2, m>& basis, Gradient how) {
    return how == Gradient::own_basis ? own_gradient(basis) : differentiated_gradient(basis);
}

/// A matrix of two rows times T, for each neighbour.
inline collocation::Block times_T(const Eigen::Matrix<double, 2, 3>& A, const GradientWeights& T) {
    const auto& [K2, K3] = T;
    return {A(0, 0) * K2 + A(0, 2) * K3, A(0, 1) * K3 + A(0, 2) * K2, A(1, 0) * K2 + A(1, 2) * K3,
            A(1, 1) * K3 + A(1, 2) * K2};
}

/// What the print leaves to choose of a weak form.
struct WeakForm {
    Gradient gradient = Gradient::own_basis;
    double penalty = 0;       ///< α [force/length³]
    double test_scaling = 1;  ///< ρ of the test function
    Index gauss = 10;         ///< \f$n_G\f$
};

namespace detail {

/// The two rows of a particle while they are summed: a place for each particle that may enter.
struct Rows {
    explicit Rows(const std::vector<int>& among)
        : particle(among), sum(collocation::Block{zero(), zero(), zero(), zero()}) {}

    void add(const std::vector<int>& near, double weight, const collocation::Block& block) {
        std::size_t place = 0;
        for (std::size_t j = 0; j < near.size(); ++j, ++place) {
            while (particle[place] != near[j]) ++place;
            const auto to = static_cast<Index>(place), from = static_cast<Index>(j);
            sum.K11[to] += weight * block.K11[from];
            sum.K12[to] += weight * block.K12[from];
            sum.K21[to] += weight * block.K21[from];
            sum.K22[to] += weight * block.K22[from];
        }
    }
    [[nodiscard]] Column<double> zero() const {
        return Column<double>::Zero(static_cast<Index>(particle.size()));
    }

    const std::vector<int>& particle;
    collocation::Block sum;
};

}  // namespace detail

/// The stiffness of a particle's subdomain, two rows. \defeq{B3.23}
/// \f[ K'_{IJ} = \int_{\Omega_I}(LM)^T D\,T\,d\Omega + \alpha\int_{\Gamma^I_u}M R\,d\Gamma - \int_{\Gamma^I_u}M N D\,T\,d\Gamma \tag{3.23} \f]
/// \param among the particles that the basis may need, in increasing order
/// \return a block over them
template <int m>
collocation::Block stiffness(const Problem& problem, const Cloud<2>& cloud, const Kernel& kernel,
                             const WeakForm& form, const Subdomain& Omega, double h,
                             const std::vector<int>& among) {
    const Eigen::Matrix3d D = elastostatics::D(problem.material);
    detail::Rows rows(among);
    for (const InnerPoint& at : Omega.inside) {
        const auto basis = ssph_basis::basis_at<m>(cloud, kernel, at.x, h, among);
        rows.add(basis.particle(), at.weight, times_T(LM_T_D(at.DW, D), gradient(basis, form.gradient)));
    }
    for (const BoundaryPoint& at : Omega.boundary) {
        if (!at.displaced[0] && !at.displaced[1]) continue;
        const auto basis = ssph_basis::basis_at<m>(cloud, kernel, at.x, h, among);
        const Eigen::DiagonalMatrix<double, 2> given(at.displaced[0] ? at.W : 0, at.displaced[1] ? at.W : 0);
        collocation::Block R = collocation::displacement(basis);
        R.K11 *= form.penalty * given.diagonal()[0];
        R.K22 *= form.penalty * given.diagonal()[1];
        rows.add(basis.particle(), at.weight, R);
        rows.add(basis.particle(), -at.weight, times_T(given * N(at.n) * D, gradient(basis, form.gradient)));
    }
    return rows.sum;
}

/// The load of a particle's subdomain; a body force adds its own work. \defeq{B3.24}
/// \f[ f_I = \int_{\Gamma^I_t}M\bar t\,d\Gamma + \alpha\int_{\Gamma^I_u}M\bar u\,d\Gamma \tag{3.24} \f]
inline Vector load(const Problem& problem, const WeakForm& form, const Subdomain& Omega) {
    Vector f = form.penalty * over_displaced(Omega, [&](const auto& at) { return problem.exact.u(at.x); });
    for (const BoundaryPoint& at : Omega.boundary) {
        const Vector t = elastostatics::traction(problem.exact.stress(at.x), at.n);
        for (Index i = 0; i < 2; ++i)
            if (!at.displaced[static_cast<std::size_t>(i)]) f[i] += at.weight * at.W * t[i];
    }
    for (const InnerPoint& at : Omega.inside) f += at.weight * at.W * problem.exact.b(at.x);
    return f;
}

/// The system: two rows for each particle, on the boundary as inside. \defeq{B3.22}
/// \f[ \sum_{J=1}^{M} K'_{IJ}\,u_J = f_I \tag{3.22} \f]
/// \tparam m degree of the monomials, 1 to 3
/// \throws base::FailedComputation as ssph_basis::basis_at()
template <int m>
System system(const Problem& problem, const Cloud<2>& cloud, const Kernel& kernel, const WeakForm& form) {
    const particles::Region region = elastostatics::region(problem);
    const Kernel test(form.test_scaling);
    std::vector<std::vector<int>> near(static_cast<std::size_t>(cloud.size()));
    base::for_each_index(cloud.size(), [&](Index I) {
        near[static_cast<std::size_t>(I)] =
            cloud.within(cloud.x().col(I), (kernel.rho() + test.rho()) * cloud.h()[I]);
    });
    System of{solvers::rows_in_pairs(near), Eigen::VectorXd(2 * cloud.size())};
    base::for_each_index(cloud.size(), [&](Index I) {
        const std::vector<int>& among = near[static_cast<std::size_t>(I)];
        const double h = cloud.h()[I];
        const Subdomain Omega = subdomain(problem, region, cloud.x().col(I), h, test, form.gauss);
        const collocation::Block rows = stiffness<m>(problem, cloud, kernel, form, Omega, h, among);
        solvers::set_row(of.A, 2 * I, among, rows.K11, rows.K12);
        solvers::set_row(of.A, 2 * I + 1, among, rows.K21, rows.K22);
        of.b.segment<2>(2 * I) = load(problem, form, Omega);
    });
    return of;
}

}  // namespace mlpg
}  // namespace batra2008
