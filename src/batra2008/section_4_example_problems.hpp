#pragma once

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "base/choose.hpp"
#include "batra2008/section_3_2_mlpg.hpp"

namespace batra2008 {

/// Section 4, what both example problems share: the three methods by their names, the solution as a field, and its error.
///
/// | paper | code | meaning |
/// | --- | --- | --- |
/// | strong, weak1, weak2 | `Method` | collocation \eq{B3.12}; weak form with \eq{B3.21}; weak form with \eq{B3.26} |
/// | \f$\rho\f$ | `scaling` | scaling factor of the kernel of the SSPH basis |
/// | \f$m\f$ | `degree` | degree of the complete monomials |
/// | \f$E\f$ | `Errors` | relative error norm \eq{B4.4}, in two readings |
///
/// The displacement of a solution is the SSPH field \f$\sum_J K_{1J}u_J\f$, not the unknowns \f$u_J\f$: the basis has no Kronecker
/// property. At a place that is no particle the smoothing length is that of the nearest particle; the print is silent.
namespace example_problems {

enum class Method { strong, weak1, weak2 };

inline std::string name(Method method) {
    return method == Method::strong ? "strong" : method == Method::weak1 ? "weak1" : "weak2";
}

/// \throws base::InvalidInput for another name
inline Method method_named(std::string_view wanted) {
    return base::choose<Method>(
        "method", wanted, {{"strong", Method::strong}, {"weak1", Method::weak1}, {"weak2", Method::weak2}});
}

/// How a problem is solved.
struct Discretisation {
    Method method = Method::strong;
    double scaling = 3;       ///< ρ of the basis
    int degree = 2;           ///< m
    double penalty = 0;       ///< α [force/length³]; for the weak forms
    double test_scaling = 1;  ///< ρ of the test function
    Index gauss = 10;         ///< \f$n_G\f$
};

/// The unknowns, and the cloud and method that make them a field.
struct Solution {
    Discretisation how;
    elastostatics::Material material;
    Eigen::VectorXd u;  ///< \f$u_1, u_2\f$ of each particle [length]
};

/// The linear system of a method.
/// \throws base::InvalidInput for a degree that the method cannot use
System system(const Problem& problem, const Cloud<2>& cloud, const Discretisation& how);

/// \throws base::InvalidInput, base::FailedComputation where the problem cannot be solved so
Solution solve(const Problem& problem, const Cloud<2>& cloud, const Discretisation& how);

/// Displacement and stress at a place.
struct State {
    Vector u;
    Stress stress;
};

/// The solution at any place of the body; the stress by the method's own first derivatives.
State state_at(const Cloud<2>& cloud, const Solution& of, const Point<2>& x);

/// A point of the background mesh with its share of the area.
struct MeshPoint {
    Point<2> x;
    double weight;
};

/// Gauss points of a background mesh, triangles with 13 points each: nx × ny squares of a unit square, each cut in two, and
/// mapped onto the body. The mesh serves the error norm alone.
/// \param map from the unit square \param area factor by which the map enlarges areas there
std::vector<MeshPoint> background_mesh(Index nx, Index ny, const elastostatics::FieldOf<Point<2>>& map,
                                       const elastostatics::FieldOf<double>& area);

/// log10 of the relative error norm, in two readings of the print.
struct Errors {
    double log_dn;  ///< difference of the norms, as printed
    double log_nd;  ///< norm of the difference
};

/// Relative error norm of the displacements. As printed it is a difference of norms, which may vanish by accident; the norm of the
/// difference is given beside it. \defeq{B4.4}
/// \f[ E = \frac{\left|\sqrt{\int_\Omega u^T u\,d\Omega} - \sqrt{\int_\Omega \bar u^T\bar u\,d\Omega}\right|}{\sqrt{\int_\Omega \bar u^T\bar u\,d\Omega}}
///     \tag{4.4} \f]
/// \param computed \f$u\f$ \param exact \f$\bar u\f$
inline Errors errors(const std::vector<MeshPoint>& mesh, const std::vector<Vector>& computed,
                     const elastostatics::FieldOf<Vector>& exact) {
    double of_computed = 0, of_exact = 0, of_difference = 0;
    for (std::size_t k = 0; k < mesh.size(); ++k) {
        const Vector u = exact(mesh[k].x);
        of_computed += mesh[k].weight * computed[k].squaredNorm();
        of_exact += mesh[k].weight * u.squaredNorm();
        of_difference += mesh[k].weight * (computed[k] - u).squaredNorm();
    }
    const double norm = std::sqrt(of_exact);
    return {std::log10(std::abs(std::sqrt(of_computed) - norm) / norm),
            std::log10(std::sqrt(of_difference) / norm)};
}

/// The same for a solution, evaluated in parallel.
Errors errors(const std::vector<MeshPoint>& mesh, const Cloud<2>& cloud, const Solution& solution,
              const Problem& problem);

}  // namespace example_problems
}  // namespace batra2008
