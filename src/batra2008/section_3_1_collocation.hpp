#pragma once

#include <utility>
#include <vector>

#include "batra2008/section_3_elastostatics.hpp"
#include "particles/operators.hpp"
#include "solvers/sparse.hpp"

namespace batra2008 {

using elastostatics::Problem;
using particles::Cloud;
using Kernel = particles::TruncatedGaussian<2>;
/// A sparse matrix, row by row; the unknowns \f$u_1, u_2\f$ of a particle stand side by side.
using Matrix = particles::Operator<double>;

/// A linear system of two equations for each particle.
struct System {
    Matrix A;
    Eigen::VectorXd b;
    Matrix
        nearest{};  ///< the same equations on the nearest particles, as solvers::iterated() needs them; or no rows
};

/// The displacements \f$u_1, u_2\f$ of each particle. [length]
/// \throws base::FailedComputation as solvers::solve_sparse()
inline Eigen::VectorXd solved(System of) {
    return solvers::solve_sparse(of.A, std::move(of.b), of.nearest);
}

/// Section 3.1, collocation of the strong form: "strong".
///
/// | paper | code | meaning |
/// | --- | --- | --- |
/// | \f$K_{1J}, \ldots, K_{6J}\f$ | `K(0)` … `K(5)` | SSPH basis at the particle \f$x_I\f$ itself |
/// | \f$K'_{IJ}\f$ | `Block` | two rows of the system, a 2 × 2 block for each neighbour |
///
/// Departures from the print: entry (2, 2) of the matrix below \eq{B3.14} has ν0 n2 K3J; \eq{B3.3} and the symmetry of the stress
/// ask for n2 K3J, and with the entry as printed the plate's error is a hundred times as large (\claim{B-3.1-printed-traction}). The body force is zero there and kept here.
///
/// What this section claims, and what was measured: \claims{B-3.1}.
namespace collocation {

/// Two rows of the system: for each neighbour, how its displacement enters.
struct Block {
    Column<double> K11, K12, K21, K22;
};

/// Equilibrium in displacements, divided by \f$E_0/(1-\nu_0^2)\f$. \defeq{B3.8}
/// \f[ \begin{aligned}
///     \left(\frac{\partial^2}{\partial x_1^2} + \frac{1-\nu_0}{2}\frac{\partial^2}{\partial x_2^2}\right)u_1
///         + \frac{1+\nu_0}{2}\frac{\partial^2}{\partial x_1\partial x_2}\,u_2 &= 0
///     \\ \frac{1+\nu_0}{2}\frac{\partial^2}{\partial x_1\partial x_2}\,u_1
///         + \left(\frac{1-\nu_0}{2}\frac{\partial^2}{\partial x_1^2} + \frac{\partial^2}{\partial x_2^2}\right)u_2 &= 0
///     \end{aligned} \tag{3.8} \f]
/// \param D2u second derivatives by \f$x_1x_1,\ x_2x_2,\ x_1x_2\f$, a row for each component of u
inline Vector equilibrium(double nu0, const Eigen::Matrix<double, 2, 3>& D2u) {
    return {D2u(0, 0) + (1 - nu0) / 2 * D2u(0, 1) + (1 + nu0) / 2 * D2u(1, 2),
            (1 + nu0) / 2 * D2u(0, 2) + (1 - nu0) / 2 * D2u(1, 0) + D2u(1, 1)};
}

/// An entry of Q from values at the particles. \defeq{B3.9}
/// \f[ Q_I(x) = \sum_{J=1}^{M} K_{IJ}\,F_J, \quad I = 1, \ldots, 6 \tag{3.9} \f]
template <int m>
double Q(const ssph_basis::Basis<2, m>& basis, Index I, const Eigen::VectorXd& F) {
    return (basis.K(I) * F(basis.particle()).array()).sum();
}

/// The second derivatives. \defeq{B3.10}
/// \f[ \frac{\partial^2 f}{\partial x_1^2} = \sum_J 2K_{4J} F_J, \quad \frac{\partial^2 f}{\partial x_2^2} = \sum_J 2K_{5J} F_J, \quad
///     \frac{\partial^2 f}{\partial x_1\partial x_2} = \sum_J K_{6J} F_J \tag{3.10} \f]
/// \return weights of the three, a column each
template <int m>
Eigen::Array<double, Eigen::Dynamic, 3> second_derivatives(const ssph_basis::Basis<2, m>& basis) {
    Eigen::Array<double, Eigen::Dynamic, 3> weights(static_cast<Index>(basis.particle().size()), 3);
    weights << 2 * basis.K(3), 2 * basis.K(4), basis.K(5);
    return weights;
}

/// \eq{B3.8} at a particle. \defeq{B3.12}
/// \f[ \sum_{J=1}^{M} K'_{IJ}\,u_J = 0, \quad
///     K'_{IJ} = \begin{bmatrix} 2K_{4J} + (1-\nu_0)K_{5J} & \frac{1+\nu_0}{2}K_{6J}
///                               \\ \frac{1+\nu_0}{2}K_{6J} & (1-\nu_0)K_{4J} + 2K_{5J} \end{bmatrix} \tag{3.12} \f]
template <int m>
Block equilibrium(const ssph_basis::Basis<2, m>& basis, double nu0) {
    const Column<double> K4 = basis.K(3), K5 = basis.K(4), K6 = basis.K(5);
    const Column<double> mixed = (1 + nu0) / 2 * K6;
    return {2 * K4 + (1 - nu0) * K5, mixed, mixed, (1 - nu0) * K4 + 2 * K5};
}

/// What a block says of given displacements: the two sums. \defeq{B3.11}
/// \f[ \begin{aligned}
///     \sum_J \left[2K_{4J} + (1-\nu_0)K_{5J}\right]u_1^J + \frac{1+\nu_0}{2}\sum_J K_{6J}\,u_2^J &= 0
///     \\ \frac{1+\nu_0}{2}\sum_J K_{6J}\,u_1^J + \sum_J \left[(1-\nu_0)K_{4J} + 2K_{5J}\right]u_2^J &= 0
///     \end{aligned} \tag{3.11} \f]
inline Vector sums(const Block& block, const Column<double>& u1, const Column<double>& u2) {
    return {(block.K11 * u1 + block.K12 * u2).sum(), (block.K21 * u1 + block.K22 * u2).sum()};
}

/// The displacement at a particle where it is given: the basis has no Kronecker property. \defeq{B3.13}
/// \f[ \sum_J K'_{IJ}\,u_J = \bar u_I, \quad K'_{IJ} = \begin{bmatrix} K_{1J} & 0 \\ 0 & K_{1J} \end{bmatrix} \tag{3.13} \f]
template <int m>
Block displacement(const ssph_basis::Basis<2, m>& basis) {
    const Column<double> K1 = basis.K(0), none = Column<double>::Zero(K1.size());
    return {K1, none, none, K1};
}

/// The traction on a plane with normal n. \defeq{B3.14}
/// \f[ \sum_J K'_{IJ}\,u_J = \bar t_I, \quad
///     K'_{IJ} = \frac{E_0}{1-\nu_0^2}\begin{bmatrix}
///         n_1 K_{2J} + \frac{1-\nu_0}{2}n_2 K_{3J} & \nu_0 n_1 K_{3J} + \frac{1-\nu_0}{2}n_2 K_{2J}
///         \\ \nu_0 n_2 K_{2J} + \frac{1-\nu_0}{2}n_1 K_{3J} & n_2 K_{3J} + \frac{1-\nu_0}{2}n_1 K_{2J} \end{bmatrix} \tag{3.14} \f]
template <int m>
Block traction(const ssph_basis::Basis<2, m>& basis, const elastostatics::Material& material,
               const Vector& n) {
    const Column<double> K2 = basis.K(1), K3 = basis.K(2);
    const double nu0 = elastostatics::nu0(material);
    const double factor = elastostatics::E0(material) / (1 - nu0 * nu0), shear = (1 - nu0) / 2;
    return {factor * (n[0] * K2 + shear * n[1] * K3), factor * (nu0 * n[0] * K3 + shear * n[1] * K2),
            factor * (nu0 * n[1] * K2 + shear * n[0] * K3), factor * (n[1] * K3 + shear * n[0] * K2)};
}

/// The equations: equilibrium at the inner particles, two conditions at each boundary particle.
/// \tparam m degree of the monomials, 2 or 3
/// \param near the particles that come into question for the rows of each, in increasing order
/// \throws base::FailedComputation as ssph_basis::basis_at()
template <int m>
System equations(const Problem& problem, const Cloud<2>& cloud, const Kernel& kernel,
                 const std::vector<std::vector<int>>& near) {
    static_assert(m >= 2, "equilibrium has second derivatives");
    const double nu0 = elastostatics::nu0(problem.material);
    const double modulus = elastostatics::E0(problem.material) / (1 - nu0 * nu0);
    System of{solvers::rows_in_pairs(near), Eigen::VectorXd(2 * cloud.size())};
    base::for_each_index(cloud.size(), [&](Index I) {
        const Point<2> x = cloud.x().col(I);
        const auto basis =
            ssph_basis::basis_at<m>(cloud, kernel, x, cloud.h()[I], near[static_cast<std::size_t>(I)]);
        const std::vector<elastostatics::Condition> conditions = elastostatics::conditions_at(problem, x);
        if (conditions.empty()) {
            const Block rows = equilibrium(basis, nu0);
            of.b.segment<2>(2 * I) = -problem.exact.b(x) / modulus;
            solvers::set_row(of.A, 2 * I, basis.particle(), rows.K11, rows.K12);
            solvers::set_row(of.A, 2 * I + 1, basis.particle(), rows.K21, rows.K22);
        }
        for (std::size_t row = 0; row < conditions.size(); ++row) {
            const elastostatics::Condition& condition = conditions[row];
            const Block rows =
                condition.displacement ? displacement(basis) : traction(basis, problem.material, condition.n);
            const Index at = 2 * I + static_cast<Index>(row);
            of.b[at] = elastostatics::value(problem, condition, x);
            if (condition.component == 0)
                solvers::set_row(of.A, at, basis.particle(), rows.K11, rows.K12);
            else
                solvers::set_row(of.A, at, basis.particle(), rows.K21, rows.K22);
        }
    });
    return of;
}

/// The nearest particles, twice as many as there are monomials or a few more, and fewer in a cloud so large that the factors of their
/// equations must be small; the whole support where it is not larger, or where fewer do not determine the monomials.
/// \return in increasing order
template <int m>
std::vector<int> nearest(const Cloud<2>& cloud, const Kernel& kernel, Index I) {
    constexpr std::size_t n = ssph_basis::terms<2, m>;
    const std::size_t enough = cloud.size() > 200000 ? n + 3 : 2 * n + 1;
    const Point<2> x = cloud.x().col(I);
    const double h = cloud.h()[I];
    for (double rho = 1.5; rho < kernel.rho(); rho *= 1.1) {
        std::vector<int> among = cloud.within(x, rho * h);
        if (among.size() >= enough && ssph_basis::determined<m>(cloud, kernel, x, h, among)) return among;
    }
    return cloud.within(x, kernel.rho() * h);
}

/// The system; a large one with the same equations on the nearest particles, by the same kernel.
/// \tparam m degree of the monomials, 2 or 3
/// \param small so many particles, or fewer, are solved faster without those equations
/// \throws base::FailedComputation as ssph_basis::basis_at()
template <int m>
System system(const Problem& problem, const Cloud<2>& cloud, const Kernel& kernel, Index small = 2000) {
    std::vector<std::vector<int>> near(static_cast<std::size_t>(cloud.size()));
    base::for_each_index(cloud.size(), [&](Index I) {
        near[static_cast<std::size_t>(I)] = cloud.within(cloud.x().col(I), kernel.rho() * cloud.h()[I]);
    });
    System of = equations<m>(problem, cloud, kernel, near);
    if (cloud.size() <= small) return of;
    base::for_each_index(cloud.size(),
                         [&](Index I) { near[static_cast<std::size_t>(I)] = nearest<m>(cloud, kernel, I); });
    of.nearest = equations<m>(problem, cloud, kernel, near).A;
    return of;
}

}  // namespace collocation
}  // namespace batra2008
