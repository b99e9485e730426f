#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "fpm_in_space/section_4_derivative_test.hpp"

namespace fpm_in_space {

/// Section 5, the static test in the plane and in space: Poisson's equation on the unit square and the unit
/// cube.
///
/// | symbol | code | meaning |
/// | --- | --- | --- |
/// | \f$u\f$ | `u` | unknown function, whose values at the particles are the unknowns |
/// | \f$f\f$ | `f` | source |
/// | \f$c\f$ | `reaction` | reaction: 0, or 1 with fluxes on all sides |
/// | \f$n\f$ | `outward` | normal of a side; where sides meet, the sum of their normals |
/// | \f$g\f$ | `Equation::given` | flux \f$\nabla u \cdot n\f$ into the body |
/// | \f$B\f$ | `derivative_test::Function` | exact solution, from which f and all that is given follow |
///
/// The first paper's Section 5.2 has a rod that is clamped at one end and free at the other. Here are a
/// membrane or a body that conducts heat, with values or with fluxes on its sides. The equation is imposed at
/// the particles inside, and a condition at each particle on a side. All derivatives are the formulation's
/// own.
///
/// Where a side with values meets a side with fluxes, the value holds. Where sides with fluxes meet, there is
/// one equation for two or three fluxes: we impose their sum, the flux along the sum of the normals. It
/// treats the sides alike, and it is exact for whatever the formulation differentiates exactly.
///
/// **What is found.** In the plane values and first derivatives are of second order at sides and corners,
/// too, on grids and on perturbed particles; stretched tenfold, the first derivatives come to 1.7 between
/// these numbers of particles. SSPH of degree 2 errs a tenth more: that its second derivatives are of first
/// order beside a side does little harm where the side has a condition of its own. On grids stretched
/// tenfold, with fluxes, SSPH of both degrees is useless up to 61² particles: its values err by 3 to 3·10⁴,
/// where those of FPM err by 0.13 at most, and with fluxes on all sides its derivatives do not show it. In
/// space the errors of values on perturbed particles fall more slowly than δ² up to 17³.
///
/// \image html fpm_in_space_figure_poisson.svg "Largest errors of values (left) and of first derivatives (right) against the particles along a side, in the plane (above) and in space (below). Fluxes are given on the sides x = 1, y = 1 and z = 1, values on the others. Medians are of 25 draws in the plane, of 5 in space."
///
/// What this section claims, and what was measured: \claims{F-5}.
namespace static_test {

using derivative_test::Function;
using particles::Cloud;
using particles::Column;
using particles::Exponents;
using particles::Index;
using particles::Offsets;
using particles::Point;
using particles::Range;
using particles::Smoothing;

/// What is given on the sides.
enum class Conditions {
    dirichlet,  ///< values on all sides
    mixed,      ///< fluxes on the sides x = 1, y = 1 and z = 1, values on the others
    neumann     ///< fluxes on all sides
};

/// dirichlet, mixed, neumann
std::vector<std::string> condition_names();

/// \throws base::InvalidInput for another name
Conditions conditions_named(std::string_view wanted);

/// c of \eq{F17}. Fluxes on all sides determine the solution up to a constant; the reaction determines that.
inline double reaction(Conditions conditions) {
    return conditions == Conditions::neumann ? 1 : 0;
}

/// The outward normal of the side that a place lies on; where sides meet, the sum of their normals; inside,
/// zero.
template <int dim>
Point<dim> outward(const Point<dim>& x) {
    return (x.array() == 1).template cast<double>() - (x.array() == 0).template cast<double>();
}

/// Whether a value is given at a place on the sides: where one of its sides has values.
/// \param n outward()
template <int dim>
bool has_value(Conditions conditions, const Point<dim>& n) {
    return conditions == Conditions::dirichlet || (conditions == Conditions::mixed && (n.array() < 0).any());
}

/// What the equations of a particle are made of. All weights are on the values at its neighbours: that on its
/// own value is minus the sum of the others.
template <int dim>
struct Row {
    std::vector<int> particle;   ///< its neighbours in increasing order, itself among them
    Index own = 0;               ///< its own place among them
    Column<double> laplacian;    ///< \f$\sum_a w^{aa}_j\f$ [1/length²]
    Offsets<double, dim> first;  ///< \f$w^a_j\f$, a column for each axis [1/length]
    double R = 0;                ///< quality number of the Laplacian, particles::quality(), in units of δ
};

/// An equation of the system: \f$\sum_j\f$ `weights`\f$_j\,u_j =\f$ `given`.
struct Equation {
    Column<double> weights;
    double given;
};

/// Poisson's equation with reaction at a particle inside, \f$\nabla\cdot\nabla u + f = c\,u\f$. \defeq{F17}
/// \f[ \sum_a \sum_j w^{aa}_j\,[u_j - u_i] - c\,u_i = -f(x_i) \tag{F17} \f]
template <int dim>
Equation balance(const Row<dim>& at, double c, double f) {
    Column<double> weights = at.laplacian;
    weights[at.own] -= c;
    return {weights, -f};
}

/// A given value at a particle on a side.
template <int dim>
Equation value(const Row<dim>& at, double u) {
    Column<double> weights = Column<double>::Zero(at.laplacian.size());
    weights[at.own] = 1;
    return {weights, u};
}

/// A given flux at a particle on a side. \defeq{F18}
/// \f[ \sum_a n_a \sum_j w^a_j\,[u_j - u_i] = g(x_i) \tag{F18} \f]
/// or, where a value is given, \f$u_i\f$ itself is.
template <int dim>
Equation flux(const Row<dim>& at, const Point<dim>& n, double g) {
    return {(at.first.matrix() * n).array(), g};
}

/// The equation of particle i: \eq{F17} inside, \eq{F18} on the sides. What is given follows from B.
template <int dim>
Equation equation_at(const Row<dim>& at, const Point<dim>& x, const std::type_identity_t<Function<dim>>& B,
                     Conditions conditions);

/// The rows of all particles, which serve all conditions.
template <int dim>
struct Rows {
    std::vector<Row<dim>> all;
    /// Those of the preconditioner of a large system; or none.
    std::vector<Row<dim>> nearest;
};

/// The rows of a formulation.
/// \param spacing δ of R: one for all particles, or one for each [length]
/// \throws base::InvalidInput for particles that do not fill the unit square or cube up to all of its sides
/// \throws base::FailedComputation as particles::assemble(), and where a Laplacian inside has an R above
///         batra2008::ssph_basis::most
template <int dim>
Rows<dim> rows(const Formulation<double, dim>& formulation, const Cloud<dim>& cloud,
               const Smoothing<double, dim>& smoothing, const Column<double>& spacing);

/// The values at the particles. A large system is solved by GMRES. Its preconditioner has few neighbours
/// inside, by ssph_with_value_given() of degree 2; within h of a side it has the rows themselves, since
/// fluxes and one-sided neighbourhoods by two formulations are not alike. Without them it fails in space.
/// \throws base::InvalidInput where B or a derivative is not finite
/// \throws base::FailedComputation where the system is singular
template <int dim>
Column<double> solution(const Rows<dim>& rows, const Cloud<dim>& cloud,
                        const std::type_identity_t<Function<dim>>& B, Conditions conditions);

/// What the test finds at a particle.
struct AtParticle {
    Index particle;
    double value, first;  ///< errors of the value and of the first derivatives, the largest of these
    double R;             ///< Row::R
};

/// The errors at each particle; the largest ones of a place are its errors. \defeq{F19}
/// \f[ \max_i |u_i - B(x_i)|, \qquad
///     \max_i \max_a \Big| \sum_j w^a_j\,[u_j - u_i] - \partial_a B(x_i) \Big| \tag{F19} \f]
template <int dim>
std::vector<AtParticle> errors(const Rows<dim>& rows, const Cloud<dim>& cloud,
                               const std::type_identity_t<Function<dim>>& B, const Column<double>& u);

/// The largest of each in a place, and the particle with the largest error of the value.
AtParticle largest(const std::vector<AtParticle>& all, const Range& place);

// Compiled once: section_5_static_test.cpp.
// Keywords cannot stand in parentheses. NOLINTBEGIN(bugprone-macro-parentheses)
#define FPM_IN_SPACE_STATIC_TEST(TEMPLATE, dim)                                                              \
    TEMPLATE Equation equation_at(const Row<dim>&, const Point<dim>&, const Function<dim>&, Conditions);     \
    TEMPLATE Rows<dim> rows(const Formulation<double, dim>&, const Cloud<dim>&,                              \
                            const Smoothing<double, dim>&, const Column<double>&);                           \
    TEMPLATE Column<double> solution(const Rows<dim>&, const Cloud<dim>&, const Function<dim>&, Conditions); \
    TEMPLATE std::vector<AtParticle> errors(const Rows<dim>&, const Cloud<dim>&, const Function<dim>&,       \
                                            const Column<double>&);
// NOLINTEND(bugprone-macro-parentheses)
FPM_IN_SPACE_STATIC_TEST(extern template, 2)
FPM_IN_SPACE_STATIC_TEST(extern template, 3)

}  // namespace static_test
}  // namespace fpm_in_space
