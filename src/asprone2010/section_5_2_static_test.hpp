#pragma once

#include <cmath>
#include <utility>

#include "asprone2010/section_5_numerical_tests.hpp"
#include "base/smooth.hpp"
#include "solvers/banded.hpp"

namespace asprone2010 {

/// Section 5.2, the static test: an elastic rod of unit length and stiffness under a body load. Figure 2.
///
/// | paper | code | meaning |
/// | --- | --- | --- |
/// | \f$u\f$ | `u`, `displacement` | axial displacement |
/// | \f$f = e^x\f$ | `right_hand_side` | body load, \f$-u''\f$ of the exact solution |
/// | \f$u(0) = u'(1) = 0\f$ | first and last row of `system` | clamped and traction-free end |
///
/// Equation \eq{A45} is imposed at the inner particles, the displacement at the first particle and the
/// derivative at the last one, with the formulation's own operators. The print does not say how.
///
/// \image html asprone2010_figure_2.svg "Infinity norm of the error of the displacement, on uniform and on perturbed particles."
///
/// Beyond the print: the condition of the system grows with N². Solved once in double precision, the
/// second-order formulation has an error of 1.3e-8 with 10⁴ particles, eight times the error of its
/// discretisation, and of 5e-5 with 10⁶. Corrections for the residual, formed through differences, reduce the
/// error to that of the discretisation up to 10⁵ particles, and to 3e-12 with 10⁶ (\ref displacement).
///
/// \image html asprone2010_figure_scale.svg "Error of the displacement on long lines, solved once and corrected."
///
/// What this section claims, and what was measured: \claims{A-5.2}.
/// The figure of a displacement, kernel and smoothing length of yours: \ref live_figure_2.
namespace static_test {

using base::Smooth;

/// The paper's case: f = eˣ, u(0) = u′(1) = 0, so that \f$u = -e^x + ex + 1\f$.
template <class Scalar = double>
Smooth<Scalar> exponential_load() {
    using std::exp;
    const Scalar e = exp(Scalar(1));
    return {[e](const Scalar& x) -> Scalar { return -exp(x) + e * x + 1; },
            [e](const Scalar& x) -> Scalar { return -exp(x) + e; },
            [](const Scalar& x) -> Scalar { return -exp(x); }};
}

/// Equilibrium at the inner particles, between one row for each end. \defeq{A45}
/// \f[ -u'' = f \tag{45} \f]
/// The matrix has one row for each particle, and right_hand_side() the number that belongs to it:
///
/// | row | of the matrix | on the right |
/// | --- | --- | --- |
/// | 1 | of the identity: \f$u(x_1)\f$ | displacement of the first particle |
/// | i = 2 … N − 1 | of −D²: \f$-D^2u(x_i)\f$ | load \f$f(x_i)\f$ |
/// | N | of D: \f$Du(x_N)\f$ | derivative at the last particle |
///
/// \param D2 second derivative at N particles [1/length²]. The caller moves it in: the system takes over its
///        memory, and D² is not stored twice
/// \param D first derivative, of which the last row is taken [1/length]
template <class Scalar>
Operator<Scalar> system(Operator<Scalar>&& D2, const Operator<Scalar>& D) {
    const Operator<Scalar> u = particles::identity<Scalar>(D2.rows());
    return particles::first_inner_last(u, particles::minus(std::move(D2)), D);
}

/// The right-hand side that belongs to system(): the first displacement, the load, the last derivative.
/// \param exact the displacement u with its derivatives: it defines the load and the end values
template <class Scalar>
Column<Scalar> right_hand_side(const Line<Scalar>& line, const Smooth<Scalar>& exact) {
    const Index N = line.size();
    Column<Scalar> f = -line.x().unaryExpr(exact.D2f);
    f[0] = exact.f(line.x()[0]);
    f[N - 1] = exact.Df(line.x()[N - 1]);
    return f;
}

/// Residual \f$f - A u\f$ of given displacements. Its sums are formed through differences \f$u_j - u_i\f$,
/// which are exact.
/// \param A of system()
template <class Scalar>
Column<Scalar> residual(const Operator<Scalar>& A, const Column<Scalar>& f, const Column<Scalar>& u) {
    Column<Scalar> rest = f - particles::apply(A, u);
    rest[0] = f[0] - u[0];
    return rest;
}

/// Largest number of corrections in \ref displacement().
inline constexpr int most_corrections = 10;

/// Displacements at the particles.
///
/// The condition of the system grows with N², and its stored diagonal entries are rounded: one solution in
/// double precision has an error of 1e-8 for N = 1e4 and of 1e-4 for N = 1e6. Solutions for the residual
/// correct it, as long as each correction is less than half as large as the one before. The remaining error
/// is that of the discretisation, down to 1e-12.
/// \param operators D, of which the last row is imposed, and D²; their memory becomes the system's
/// \param corrections largest number of corrections
/// \throws base::FailedComputation where the system is singular
template <class Scalar>
Column<Scalar> displacement(particles::Operators<Scalar>&& operators, const Line<Scalar>& line,
                            const Smooth<Scalar>& exact, int corrections = most_corrections) {
    const Operator<Scalar> A = system(std::move(operators.D2), operators.D);
    const Column<Scalar> f = right_hand_side(line, exact);
    const solvers::BandedFactors<Scalar> factors(A);
    factors.require_regular();  // small corrections would not reveal a singular system
    Column<Scalar> u = factors.solve(f);
    Scalar last = u.abs().maxCoeff();
    for (int k = 0; k < corrections; ++k) {
        const Column<Scalar> correction = factors.solve(residual(A, f, u));
        const Scalar size = correction.abs().maxCoeff();
        if (!(size < last / 2)) break;
        u += correction;
        last = size;
    }
    return u;
}

// Compiled once: see formulations.hpp.
extern template Column<double> displacement(particles::Operators<double>&&, const Line<double>&,
                                            const Smooth<double>&, int);
extern template Column<long double> displacement(particles::Operators<long double>&&,
                                                 const Line<long double>&, const Smooth<long double>&, int);

/// Infinity norm of the displacement's error.
template <class Scalar>
Scalar error(particles::Operators<Scalar>&& operators, const Line<Scalar>& line, const Smooth<Scalar>& exact,
             int corrections = most_corrections) {
    const Column<Scalar> u = displacement(std::move(operators), line, exact, corrections);
    return numerical_tests::distance<Scalar>(u, line.x().unaryExpr(exact.f));
}

/// D² of a formulation, and D of another one, which is imposed at the last particle.
template <class Scalar>
particles::Operators<Scalar> operators(const Formulation<Scalar>& formulation, const Formulation<Scalar>& end,
                                       const numerical_tests::Particles<Scalar>& discrete) {
    const auto& [line, smoothing] = discrete;
    particles::Operators<Scalar> own = formulation.operators(line, smoothing);
    if (&end != &formulation) own.D = end.operators(line, smoothing).D;
    return own;
}

/// The error of a formulation.
/// \param end the formulation whose first derivative is imposed at the last particle
template <class Scalar>
Scalar error(const Formulation<Scalar>& formulation, const Formulation<Scalar>& end,
             const numerical_tests::Particles<Scalar>& discrete, const Smooth<Scalar>& exact,
             int corrections = most_corrections) {
    return error(operators(formulation, end, discrete), discrete.line, exact, corrections);
}

/// The same with the formulation's own derivative at the last particle, our choice.
template <class Scalar>
Scalar error(const Formulation<Scalar>& formulation, const numerical_tests::Particles<Scalar>& discrete,
             const Smooth<Scalar>& exact) {
    return error(formulation, formulation, discrete, exact);
}

}  // namespace static_test
}  // namespace asprone2010
