#pragma once

#include <utility>
#include <vector>

#include "batra2008/basis_at.hpp"
#include "batra2008/linear_elements.hpp"
#include "batra2008/section_3_elastostatics.hpp"

namespace batra2008 {

/// Two rows of the system: a 2 × 2 block for each neighbour, by which its displacement enters.
struct Block {
    Column<double> K11, K12, K21, K22;
};

/// The two equations of a particle: its neighbours in increasing order, their blocks, and the right-hand
/// side.
struct Equations {
    std::vector<int> particle;
    Block K;
    Vector f;
};

/// The system \f$\sum_J K'_{IJ}\,u_J = f_I\f$.
/// \param near for each particle the neighbours that may enter its equations, in increasing order
/// \param equations those of particle I
template <class EquationsOf>
System assembled(const std::vector<std::vector<int>>& near, const EquationsOf& equations) {
    const auto N = static_cast<Index>(near.size());
    System system{solvers::rows_in_blocks(near, 2), Eigen::VectorXd(2 * N)};
    base::for_each_index(N, [&](Index I) {
        const auto [particle, K, f] = equations(I);
        solvers::set_row(system.A, 2 * I, particle, K.K11, K.K12);
        solvers::set_row(system.A, 2 * I + 1, particle, K.K21, K.K22);
        system.b.segment<2>(2 * I) = f;
    });
    return system;
}

/// Section 3.1, collocation of the strong form: "strong".
///
/// | paper | code | meaning |
/// | --- | --- | --- |
/// | \f$K_{1J}, \ldots, K_{6J}\f$ | `K<1>` … `K<6>` | SSPH basis at the particle \f$x_I\f$ itself |
/// | | `Basis` | that basis, or other weights that have the same \f$K_{1J}, \ldots, K_{6J}\f$ |
/// | \f$K'_{IJ}\f$ | `Block` | two rows of the system, a 2 × 2 block for each neighbour |
///
/// Departures from the print: entry (2, 2) of the matrix below \eq{B3.14} has ν0 n2 K3J; \eq{B3.3} and the
/// symmetry of the stress require n2 K3J, and with the entry as printed the traction of linear displacements
/// is wrong by half (\claim{B-3.1-traction}). The body force is zero there and kept here.
///
/// What this section claims, and what was measured: \claims{B-3.1}.
namespace collocation {

using ssph_basis::K;

/// Equilibrium in displacements, divided by \f$E_0/(1-\nu_0^2)\f$. \defeq{B3.8}
/// \f[ \begin{aligned}
///     \left(\frac{\partial^2}{\partial x_1^2} + \frac{1-\nu_0}{2}\frac{\partial^2}{\partial x_2^2}\right)u_1
///         + \frac{1+\nu_0}{2}\frac{\partial^2}{\partial x_1\partial x_2}\,u_2 &= 0
///     \\ \frac{1+\nu_0}{2}\frac{\partial^2}{\partial x_1\partial x_2}\,u_1
///         + \left(\frac{1-\nu_0}{2}\frac{\partial^2}{\partial x_1^2}
///         + \frac{\partial^2}{\partial x_2^2}\right)u_2 &= 0
///     \end{aligned} \tag{3.8} \f]
/// \param D2u second derivatives by \f$x_1x_1,\ x_2x_2,\ x_1x_2\f$, a row for each component of u
inline Vector equilibrium(double nu0, const Eigen::Matrix<double, 2, 3>& D2u) {
    return {D2u(0, 0) + (1 - nu0) / 2 * D2u(0, 1) + (1 + nu0) / 2 * D2u(1, 2),
            (1 + nu0) / 2 * D2u(0, 2) + (1 - nu0) / 2 * D2u(1, 0) + D2u(1, 1)};
}

/// An entry of Q from the values at the particles. \defeq{B3.9}
/// \f[ Q_I(x) = \sum_{J=1}^{M} K_{IJ}\,F_J, \quad I = 1, \ldots, 6 \tag{3.9} \f]
template <int m>
double Q(const ssph_basis::Basis<2, m>& basis, Index I, const Eigen::VectorXd& F) {
    return (basis.row(I) * F(basis.particle()).array()).sum();
}

/// The second derivatives. \defeq{B3.10}
/// \f[ \frac{\partial^2 f}{\partial x_1^2} = \sum_J 2K_{4J} F_J, \quad \frac{\partial^2 f}{\partial x_2^2}
///     = \sum_J 2K_{5J} F_J, \quad
///     \frac{\partial^2 f}{\partial x_1\partial x_2} = \sum_J K_{6J} F_J \tag{3.10} \f]
/// \return a column of weights for each of the three
template <int m>
Eigen::Array<double, Eigen::Dynamic, 3> second_derivatives(const ssph_basis::Basis<2, m>& basis) {
    Eigen::Array<double, Eigen::Dynamic, 3> weights(static_cast<Index>(basis.particle().size()), 3);
    weights << 2 * K<4>(basis), 2 * K<5>(basis), K<6>(basis);
    return weights;
}

/// The left-hand sides of two rows for given displacements. \defeq{B3.11}
/// \f[ \begin{aligned}
///     \sum_J \left[2K_{4J} + (1-\nu_0)K_{5J}\right]u_1^J + \frac{1+\nu_0}{2}\sum_J K_{6J}\,u_2^J &= 0
///     \\ \frac{1+\nu_0}{2}\sum_J K_{6J}\,u_1^J + \sum_J \left[(1-\nu_0)K_{4J} + 2K_{5J}\right]u_2^J &= 0
///     \end{aligned} \tag{3.11} \f]
inline Vector sums(const Block& block, const Column<double>& u1, const Column<double>& u2) {
    return {(block.K11 * u1 + block.K12 * u2).sum(), (block.K21 * u1 + block.K22 * u2).sum()};
}

/// \eq{B3.8} at a particle. \defeq{B3.12}
/// \f[ \sum_{J=1}^{M} K'_{IJ}\,u_J = 0, \quad
///     K'_{IJ} = \begin{bmatrix} 2K_{4J} + (1-\nu_0)K_{5J} & \frac{1+\nu_0}{2}K_{6J}
///         \\ \frac{1+\nu_0}{2}K_{6J} & (1-\nu_0)K_{4J} + 2K_{5J} \end{bmatrix} \tag{3.12} \f]
template <class Basis>
Block equilibrium(const Basis& basis, double nu0) {
    const Column<double> K4 = K<4>(basis), K5 = K<5>(basis), mixed = (1 + nu0) / 2 * K<6>(basis);
    return {2 * K4 + (1 - nu0) * K5, mixed, mixed, (1 - nu0) * K4 + 2 * K5};
}

/// The displacement at a particle where it is given: the basis has no Kronecker property. \defeq{B3.13}
/// \f[ \sum_J K'_{IJ}\,u_J = \bar u_I,
///     \quad K'_{IJ} = \begin{bmatrix} K_{1J} & 0 \\ 0 & K_{1J} \end{bmatrix} \tag{3.13} \f]
template <class Basis>
Block displacement(const Basis& basis) {
    const Column<double> K1 = K<1>(basis), zero = Column<double>::Zero(K1.size());
    return {K1, zero, zero, K1};
}

/// The traction on a plane with normal n. \defeq{B3.14}
/// \f[ \sum_J K'_{IJ}\,u_J = \bar t_I, \quad
///     K'_{IJ} = \frac{E_0}{1-\nu_0^2}\begin{bmatrix}
///         n_1 K_{2J} + \frac{1-\nu_0}{2}n_2 K_{3J} & \nu_0 n_1 K_{3J} + \frac{1-\nu_0}{2}n_2 K_{2J}
///         \\ \nu_0 n_2 K_{2J} + \frac{1-\nu_0}{2}n_1 K_{3J} & n_2 K_{3J} + \frac{1-\nu_0}{2}n_1 K_{2J}
///         \end{bmatrix} \tag{3.14} \f]
template <class Basis>
Block traction(const Basis& basis, const elastostatics::Material& material, const Vector& n) {
    const Column<double> K2 = K<2>(basis), K3 = K<3>(basis);
    const double nu0 = elastostatics::nu0(material);
    const double factor = elastostatics::E0(material) / (1 - nu0 * nu0), shear = (1 - nu0) / 2;
    return {factor * (n[0] * K2 + shear * n[1] * K3), factor * (nu0 * n[0] * K3 + shear * n[1] * K2),
            factor * (nu0 * n[1] * K2 + shear * n[0] * K3), factor * (n[1] * K3 + shear * n[0] * K2)};
}

/// The equations of a particle: equilibrium inside; on the boundary, the two conditions there.
template <class Basis>
Equations equations_at(const Problem& problem, const Point<2>& x, const Basis& basis) {
    const double nu0 = elastostatics::nu0(problem.material);
    const double modulus = elastostatics::E0(problem.material) / (1 - nu0 * nu0);
    const std::vector<elastostatics::Condition> conditions = elastostatics::conditions_at(problem, x);
    if (conditions.empty()) return {basis.particle(), equilibrium(basis, nu0), -problem.exact.b(x) / modulus};
    const auto block = [&](const elastostatics::Condition& condition) {
        return condition.displacement ? displacement(basis) : traction(basis, problem.material, condition.n);
    };
    const auto row = [&](const elastostatics::Condition& condition) {
        const auto [K11, K12, K21, K22] = block(condition);
        return condition.component == 0 ? std::pair(K11, K12) : std::pair(K21, K22);
    };
    const auto &first = conditions[0], &second = conditions[1];
    const auto [K11, K12] = row(first);
    const auto [K21, K22] = row(second);
    return {basis.particle(),
            {K11, K12, K21, K22},
            {elastostatics::value(problem, first, x), elastostatics::value(problem, second, x)}};
}

/// The system with equations on given neighbours.
/// \param near for each particle its neighbours, in increasing order
/// \param basis_at a function of a particle's number: its basis on these neighbours
template <class BasisAt>
System system_on(const std::vector<std::vector<int>>& near, const Problem& problem, const Cloud<2>& cloud,
                 const BasisAt& basis_at) {
    return assembled(near, [&](Index I) { return equations_at(problem, cloud.x().col(I), basis_at(I)); });
}

/// The order of the highest derivative in the equations of each particle: equilibrium has the second, a
/// traction the first.
inline std::vector<int> highest_derivatives(const Problem& problem, const Cloud<2>& cloud) {
    std::vector<int> order;
    for (Index I = 0; I < cloud.size(); ++I)
        order.push_back(elastostatics::conditions_at(problem, cloud.x().col(I)).empty() ? 2 : 1);
    return order;
}

/// The system with the SSPH basis on given neighbours.
/// \tparam m degree of the monomials, 2 or 3
/// \param h smoothing length of each particle [length]
/// \throws base::FailedComputation as ssph_basis::basis_at()
template <int m>
System system_on(const std::vector<std::vector<int>>& near, const Problem& problem, const Cloud<2>& cloud,
                 const Kernel& kernel, const Column<double>& h) {
    static_assert(m >= 2, "equilibrium has second derivatives");
    return system_on(near, problem, cloud, [&](Index I) {
        return ssph_basis::basis_at<m>(cloud, kernel, Point<2>(cloud.x().col(I)), h[I],
                                       near[static_cast<std::size_t>(I)], ssph_basis::Slopes::none);
    });
}

/// The system; if it is large, with linear elements.
/// \tparam m degree of the monomials, 2 or 3
/// \param h smoothing length of each particle [length]
/// \param small largest number of particles for which the elements are left out
/// \throws base::InvalidInput as elastostatics::checked()
/// \throws base::FailedComputation as ssph_basis::require_quality()
template <int m>
System system(Problem problem, const Cloud<2>& cloud, const Kernel& kernel, const Column<double>& h,
              Index small = solvers::small_system / 2) {
    problem = elastostatics::checked(std::move(problem), cloud);
    const auto worst = ssph_basis::require_quality<m>(cloud, kernel, h, highest_derivatives(problem, cloud));
    std::vector<std::vector<int>> near(static_cast<std::size_t>(cloud.size()));
    base::for_each_index(cloud.size(), [&](Index I) {
        near[static_cast<std::size_t>(I)] = cloud.within(cloud.x().col(I), kernel.rho() * h[I]);
    });
    System system = system_on<m>(near, problem, cloud, kernel, h);
    system.worst = worst;
    if (cloud.size() > small) system.elements = linear_elements(problem, cloud);
    return system;
}

}  // namespace collocation
}  // namespace batra2008
