#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/choose.hpp"
#include "base/text.hpp"
#include "particles/boundary_particles.hpp"
#include "particles/cloud.hpp"
#include "particles/quality.hpp"
#include "particles/region.hpp"
#include "particles/region_check.hpp"
#include "particles/truncated_gaussian.hpp"
#include "solvers/sparse.hpp"

namespace batra2008 {

using particles::Cloud;
using particles::Column;
using particles::Index;
using particles::Point;
using particles::Points;

/// A displacement or a traction [length, force/area].
using Vector = Eigen::Vector2d;
/// Stresses \f$[\sigma_{11}, \sigma_{22}, \sigma_{12}]\f$ [force/area].
using Stress = Eigen::Vector3d;
/// Strains \f$[\varepsilon_{11}, \varepsilon_{22}, 2\varepsilon_{12}]\f$.
using Strain = Eigen::Vector3d;

/// Section 3, plane elastostatics, common to the three methods: equilibrium, boundary conditions, Hooke's
/// law.
///
/// | paper | code | meaning |
/// | --- | --- | --- |
/// | \f$u,\ \sigma,\ \varepsilon\f$ | `u`, `stress`, `strain` | displacement, stress, strain |
/// | \f$E,\ \nu\f$ | `Material::E`, `Material::nu` | Young's modulus, Poisson's ratio |
/// | \f$E_0,\ \nu_0\f$ | `E0(material)`, `nu0(material)` | their plane equivalents |
/// | \f$\Gamma_u,\ \Gamma_t\f$ | `Side::displaced` | where a component of u, or of the traction, is given |
/// | \f$\bar u,\ \bar t\f$ | `Problem::exact` | given values, from an exact solution |
///
/// In the print each boundary carries either displacements or tractions. Here each component of a side
/// carries one of the two, as the symmetry planes of Section 4.2 require. The body force b, zero in the
/// paper, is kept: a manufactured solution has one.
namespace elastostatics {

/// The residual of equilibrium. \defeq{B3.1}
/// \f[ \sigma_{ij,j} + b_i = 0 \tag{3.1} \f]
/// \param stress_gradient derivatives of the three stresses, by \f$x_1\f$ in the first column and by
///         \f$x_2\f$ in the second
/// \param b body force [force/volume]
inline Vector imbalance(const Eigen::Matrix<double, 3, 2>& stress_gradient, const Vector& b) {
    const auto& s = stress_gradient;
    return Vector(s(0, 0) + s(2, 1), s(2, 0) + s(1, 1)) + b;
}

/// The traction on a surface, below \eq{B3.2}. \defeq{B3.2}
/// \f[ u_i = \bar u_i\ \text{on}\ \Gamma_u,
///     \qquad t_i \equiv \sigma_{ij}\,n_j = \bar t_i\ \text{on}\ \Gamma_t \tag{3.2} \f]
inline Vector traction(const Stress& sigma, const Vector& n) {
    return {sigma[0] * n[0] + sigma[2] * n[1], sigma[2] * n[0] + sigma[1] * n[1]};
}

/// Hooke's law. \defeq{B3.3}
/// \f[ \sigma = D\,\varepsilon \tag{3.3} \f]
inline Stress stress(const Eigen::Matrix3d& D, const Strain& strain) {
    return D * strain;
}

/// The matrix of elastic constants. \defeq{B3.4}
/// \f[ D = \frac{E_0}{1-\nu_0^2}
///     \begin{bmatrix} 1 & \nu_0 & 0 \\ \nu_0 & 1 & 0 \\ 0 & 0 & \frac{1-\nu_0}{2} \end{bmatrix} \tag{3.4} \f]
inline Eigen::Matrix3d D(double E0, double nu0) {
    return E0 / (1 - nu0 * nu0) * Eigen::Matrix3d{{1, nu0, 0}, {nu0, 1, 0}, {0, 0, (1 - nu0) / 2}};
}

/// Which components vanish in the third direction.
enum class Plane { stress, strain };

/// \throws base::InvalidInput for another name
inline Plane plane_named(std::string_view wanted) {
    return base::choose<Plane>("plane", wanted, {{"stress", Plane::stress}, {"strain", Plane::strain}});
}

/// An isotropic linear elastic material.
struct Material {
    double E;   ///< Young's modulus [force/area]
    double nu;  ///< Poisson's ratio
    Plane plane = Plane::stress;
};

/// \throws base::InvalidInput unless E > 0 and −1 < ν ≤ 1/2, all finite; in plane strain ν must stay off 1/2
///         by 10⁻¹², since stresses are strains over 1 − 2ν
inline Material checked(const Material& material) {
    const auto& [E, nu, plane] = material;
    if (!(std::isfinite(E) && E > 0))
        throw base::InvalidInput("Young's modulus must be positive and finite, got " + base::shown(E));
    if (!(nu > -1 && nu <= 0.5))
        throw base::InvalidInput("Poisson's ratio must lie above -1 and be at most 0.5, got " +
                                 base::shown(nu));
    if (plane == Plane::strain && nu > 0.5 - 1e-12)
        throw base::InvalidInput(
            "Poisson's ratio of " + base::shown(nu, 17) +
            " is too near to 0.5 for plane strain, whose stresses are strains over 1 - 2 nu; "
            "take at most 0.499999999999, or plane stress");
    return material;
}

/// The plane equivalent of Young's modulus. \defeq{B3.5}
/// \f[ E_0 = \frac{E}{1-\nu^2},\ \nu_0 = \frac{\nu}{1-\nu}\ \text{(plane strain)}, \qquad
///     E_0 = E,\ \nu_0 = \nu\ \text{(plane stress)} \tag{3.5} \f]
inline double E0(const Material& material) {
    const auto& [E, nu, plane] = material;
    return plane == Plane::strain ? E / (1 - nu * nu) : E;
}

/// The plane equivalent of Poisson's ratio, \eq{B3.5}.
inline double nu0(const Material& material) {
    const auto& [E, nu, plane] = material;
    return plane == Plane::strain ? nu / (1 - nu) : nu;
}

/// \eq{B3.4} of a material.
inline Eigen::Matrix3d D(const Material& material) {
    return D(E0(material), nu0(material));
}

/// \eq{B3.3} of a material.
inline Stress stress(const Material& material, const Strain& strain) {
    return stress(D(material), strain);
}

inline Eigen::Matrix<double, 3, 2> L(const Vector& g);

/// Strains of a displacement. \defeq{B3.6}
/// \f[ \varepsilon = L\,u \tag{3.6} \f]
/// \param gradient \f$\partial u_i/\partial x_\alpha\f$ in row i and column α
inline Strain strain(const Eigen::Matrix2d& gradient) {
    return L(gradient.row(0)).col(0) + L(gradient.row(1)).col(1);
}

/// The operator of strain, applied to a function with gradient g: column i holds the strains of a
/// displacement by this function along \f$x_i\f$. \defeq{B3.7}
/// \f[ L = \begin{bmatrix} \partial/\partial x_1 & 0 \\ 0 & \partial/\partial x_2
///                         \\ \partial/\partial x_2 & \partial/\partial x_1 \end{bmatrix} \tag{3.7} \f]
inline Eigen::Matrix<double, 3, 2> L(const Vector& g) {
    return Eigen::Matrix<double, 3, 2>{{g[0], 0}, {0, g[1]}, {g[1], g[0]}};
}

/// A function of the place.
template <class Value>
using FieldOf = std::function<Value(const Point<2>&)>;

/// A known solution: it gives the boundary values and the body force, and is the reference for errors.
struct Exact {
    FieldOf<Vector> u;
    FieldOf<Stress> stress;
    FieldOf<Vector> b = [](const Point<2>&) { return Vector(Vector::Zero()); };
};

/// A part of the boundary. Of each component, either the displacement or the traction is given on it.
struct Side {
    particles::Curve curve;
    std::array<bool, 2> displaced = {false, false};  ///< whether the displacement is given
};

/// One scalar condition at a boundary particle: a component of the displacement, or of the traction on a
/// plane with normal n.
struct Condition {
    bool displacement;
    Index component;
    Vector n = Vector::Zero();
};

/// The two conditions at a corner; the print leaves the choice open.
struct Corner {
    Point<2> at;
    std::array<Condition, 2> conditions;
};

/// A boundary-value problem.
struct Problem {
    Material material;
    std::vector<Side> sides;      ///< in any order
    std::vector<Corner> corners;  ///< chosen conditions; see conditions_at() for other corners
    Exact exact;
    double size;  ///< a length of the body, beside which 1e-8 of it does not count
};

/// The region that a problem's sides enclose.
inline particles::Region region(const Problem& problem) {
    particles::Region curves;
    for (const Side& side : problem.sides) curves.push_back(side.curve);
    return curves;
}

/// A problem that its particles can solve: with the body to the left of each side.
/// \throws base::InvalidInput as particles::checked() for the boundary and particles::check_particles(), for
///         a material without meaning, and for a corner at which no sides meet
inline Problem checked(Problem problem, const Cloud<2>& cloud) {
    problem.material = checked(problem.material);
    const particles::Region boundary = particles::checked(region(problem), problem.size);
    for (std::size_t k = 0; k < boundary.size(); ++k) problem.sides[k].curve = boundary[k];
    for (const Corner& corner : problem.corners)
        if (std::none_of(boundary.begin(), boundary.end(), [&](const particles::Curve& curve) {
                return particles::lies_at_end(curve, corner.at, problem.size);
            }))
            throw base::InvalidInput("no sides meet at the corner " + particles::shown_point(corner.at));
    particles::check_particles(cloud, boundary, problem.size);
    return problem;
}

/// The two conditions at a boundary particle; none inside. Where sides meet without a chosen condition, the
/// displacement of a component is given if any of the sides gives it; otherwise its traction is that of the
/// side whose normal is nearer to its axis.
inline std::vector<Condition> conditions_at(const Problem& problem, const Point<2>& x) {
    for (const Corner& corner : problem.corners)
        if ((corner.at - x).norm() <= particles::negligible * problem.size)
            return {corner.conditions.begin(), corner.conditions.end()};
    std::vector<Condition> both;
    for (const Side& side : problem.sides) {
        if (!particles::lies_on(side.curve, x, problem.size)) continue;
        const Vector n = particles::normal_at(side.curve, x);
        const bool first = both.empty();
        for (std::size_t i = 0; i < 2; ++i) {
            const auto component = static_cast<Index>(i);
            const Condition here{side.displaced[i], component, n};
            if (first)
                both.push_back(here);
            else if (!both[i].displacement &&
                     (here.displacement || std::abs(n[component]) > std::abs(both[i].n[component])))
                both[i] = here;
        }
    }
    return both;
}

/// The given value of a condition, from the exact solution.
inline double value(const Problem& problem, const Condition& condition, const Point<2>& x) {
    return condition.displacement ? problem.exact.u(x)[condition.component]
                                  : traction(problem.exact.stress(x), condition.n)[condition.component];
}

}  // namespace elastostatics

using elastostatics::Problem;
using Kernel = particles::TruncatedGaussian<2>;
/// A sparse matrix, stored by rows; the unknowns \f$u_1, u_2\f$ of a particle are neighbours.
using Matrix = solvers::SparseRows;

/// A linear system with two equations for each particle.
struct System {
    Matrix A;
    Eigen::VectorXd b;
    solvers::Elements elements{};  ///< linear_elements() of the same problem, if it is large
    particles::WorstRow worst{};   ///< of the derivatives at the particles
};

/// The displacements \f$u_1, u_2\f$ of each particle. [length]
/// \param system is changed; Eigen would copy the matrix of a value, moved or not
/// \throws base::FailedComputation as solvers::solve_sparse()
inline Eigen::VectorXd solved(System&& system) {
    return solvers::solve_sparse(std::move(system.A), std::move(system.b), std::move(system.elements));
}

}  // namespace batra2008
