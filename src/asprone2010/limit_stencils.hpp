#pragma once

#include <cmath>

#include "asprone2010/section_5_numerical_tests.hpp"
#include "base/text.hpp"

namespace asprone2010 {

/// Beyond the print: the rows of D and D² on particles at equal distances, and what follows from them.
///
/// Let the particles lie at equal distances δ. In units of δ a row of D or D² then has the same weights for
/// every δ; it depends only on how far its particle lies from the end. Such a row is a limit stencil. Three
/// things follow from its weights, none of them fitted: the **leading error** of every formulation with its
/// exact constant, the **round-off** that limits every precision, and the **symbol**, which gives the
/// frequencies of an infinite line.
///
/// | in the formulas | code | meaning |
/// | --- | --- | --- |
/// | \f$w_j, r_j\f$ | `Stencil` | weights and offsets of a row, in units of δ |
/// | \f$m_k\f$ | `moment` | its k-th moment |
/// | \f$d\f$ | `derivative` | 1 for D, 2 for D² |
///
/// **Leading errors.** Taylor's expansion of B about the particle turns the error of a row into a sum over
/// the derivatives of B,
/// \f[ \sum_j w_j\,[B(x_j) - B(x_i)] - B^{(d)}(x_i) = \sum_{k \ge 1} \Big(\frac{m_k}{k!} - \delta_{kd}\Big)\,\delta^{\,k-d}\,B^{(k)}(x_i),
///     \qquad m_k = \sum_j w_j\,r_j^k, \f]
/// where w and r are in units of δ, and B and its derivatives are in the unit of x. The first term that does
/// not vanish is the leading error: its power of δ is the order, its factor is the constant. The program
/// `constants` writes all of them to constants.csv, beside what eˣ shows in quadruple precision; the program
/// `stencil` explains a single row. At the end, the second derivative by Chen and Beraun has an error that
/// does not fall with δ, modified FPM is of first order and second-order FPM of second. Where D is applied
/// twice, the error at the end grows like 1/δ; for FPM it tends to a constant. Far from the ends too, the
/// original formulation and both RKPMs have an error of order zero: sums over particles replace integrals of
/// a Gaussian only up to \f$e^{-\pi^2 h^2/\delta^2}\f$, so that a larger smoothing length makes it vanish.
///
/// **Map of orders** (orders.csv). For D and D² the statements of the paper hold for every kernel and nearly
/// every h/δ with which a formulation can be computed, on uniform and on perturbed particles: orders 2 and 2
/// for second-order FPM, 2 and 1 for modified FPM (and SSPH), 1 and 0 for Chen–Beraun and FPM applied twice,
/// 0 and −1 for the original formulation and RKPM. There are two exceptions, both on perturbed particles:
/// second-order FPM with the narrowest Gaussian, and modified FPM with large smoothing lengths. Which h can
/// be computed depends on the kernel. Its support must reach three particles for second-order FPM (h > 1.5 δ
/// for a support of 2h, h > δ for 3h), and two for the others that solve for both derivatives. For u the
/// statements hold less widely. At equal distances second-order and modified FPM keep order 2, and
/// Chen–Beraun order 1. Where D is applied twice, u has no order beyond h = 1.5 δ: its system is nearly
/// singular, and singular in the crossed squares.
///
/// \image html asprone2010_figure_orders.svg "Observed orders of the errors of DB, D²B and u: formulations, in each the five kernels, against h/δ."
///
/// **Precision** (precision.csv). Truncation falls like \f$\delta^p\f$ and round-off grows like
/// \f$\delta^{-2}\f$, so that each precision has a best error. The comments of the table have the errors that
/// the stencil predicts, and its rows those that are measured. The prediction takes every rounding at its
/// worst; the measured round-off is smaller, by less than a factor of five.
///
/// \image html asprone2010_figure_precision.svg "Errors of D²B in double, long double and quadruple precision, with predictions."
///
/// **Draws** (draws.csv). On perturbed particles the error is a random number; the figure has its
/// distribution over 1000 draws.
///
/// \image html asprone2010_figure_draws.svg "Distribution of the errors of D²B and u over 1000 draws of 160 perturbed particles."
namespace limit_stencils {

/// A row of an operator on particles at distances of one, particle i at r = 0.
template <class Scalar>
struct Stencil {
    Column<Scalar> r;  ///< offsets \f$(x_j - x_i)/\delta\f$
    Column<Scalar> w;  ///< weights on \f$B(x_j) - B(x_i)\f$ [\f$\delta^{-d}\f$]
};

/// Row i of an operator.
/// \param spacing δ [length]
/// \param derivative 1 or 2, the order of the derivative that the operator approximates
template <class Scalar>
Stencil<Scalar> row(const Operator<Scalar>& D, const Line<Scalar>& line, Index i, const Scalar& spacing,
                    int derivative) {
    const Index size = D.outerIndexPtr()[i + 1] - D.outerIndexPtr()[i];
    Stencil<Scalar> stencil{Column<Scalar>(size), Column<Scalar>(size)};
    Index k = 0;
    for (typename Operator<Scalar>::InnerIterator entry(D, i); entry; ++entry, ++k) {
        stencil.r[k] = (line.x()[entry.col()] - line.x()[i]) / spacing;
        stencil.w[k] = entry.value() * (derivative == 1 ? spacing : spacing * spacing);
    }
    return stencil;
}

/// \f$m_k = \sum_j w_j r_j^k\f$.
template <class Scalar>
Scalar moment(const Stencil<Scalar>& stencil, int k) {
    Scalar m_k(0);
    for (Index j = 0; j < stencil.r.size(); ++j) {
        Scalar term = stencil.w[j];
        for (int n = 0; n < k; ++n) term *= stencil.r[j];
        m_k += term;
    }
    return m_k;
}

/// \f$\sum_j |w_j|\,|r_j|^k\f$: the size against which a moment vanishes or not.
template <class Scalar>
Scalar absolute_moment(const Stencil<Scalar>& stencil, int k) {
    return moment(Stencil<Scalar>{stencil.r.abs(), stencil.w.abs()}, k);
}

/// How many particles at distances of δ the support of a kernel holds on one side.
/// \throws base::InvalidInput unless that is between 1 and 100: the cost of a stencil grows with its third
/// power
inline Index reach_in_spacings(const numerical_tests::Discretisation& how) {
    const double reach = std::ceil(support<double>(how.kernel) * how.smoothing);
    if (!(reach > 0 && reach <= 100))
        throw base::InvalidInput("h/delta of " + base::shown(how.smoothing) +
                                 " gives stencils that reach over " + base::shown(reach) +
                                 " spacings, not over 1 to 100; take another --smoothing");
    return static_cast<Index>(reach);
}

/// The first particle, counted from the end, whose rows do not feel the end, not even where an operator is
/// applied twice.
inline Index first_interior(const numerical_tests::Discretisation& how) {
    return 2 * reach_in_spacings(how);
}

/// The right end of a long line: particles at distances of δ, the last one at x = 1, as many as the rows of
/// the last particles can feel.
/// \param from_end the rows asked for are those of the last particle and of this many before it
template <class Scalar>
numerical_tests::Particles<Scalar> right_end(const numerical_tests::Discretisation& how, Index from_end,
                                             const Scalar& spacing) {
    const Index N = from_end + 3 * reach_in_spacings(how) + 2;
    Column<Scalar> x(N);
    for (Index j = 0; j < N; ++j) x[j] = 1 - Scalar(N - 1 - j) * spacing;
    return numerical_tests::discretise<Scalar>(how, x);
}

/// The limit stencil of a formulation near the right end of a line.
/// \param from_end how many particles before the last one \param derivative 1 for D, 2 for D²
/// \throws base::FailedComputation where the neighbourhood has too few particles
template <class Scalar>
Stencil<Scalar> near_end(const Formulation<Scalar>& formulation, const numerical_tests::Discretisation& how,
                         Index from_end, int derivative, const Scalar& spacing = Scalar(1)) {
    const auto [line, smoothing] = right_end<Scalar>(how, from_end, spacing);
    const auto [D, D2] = formulation.operators(line, smoothing);
    return row<Scalar>(derivative == 1 ? D : D2, line, line.size() - 1 - from_end, spacing, derivative);
}

// Compiled once: see formulations.hpp.
extern template Stencil<double> near_end(const Formulation<double>&, const numerical_tests::Discretisation&,
                                         Index, int, const double&);

}  // namespace limit_stencils
}  // namespace asprone2010
