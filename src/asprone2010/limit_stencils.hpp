#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "asprone2010/section_5_numerical_tests.hpp"
#include "base/text.hpp"

namespace asprone2010 {

/// Beyond the print: the exact leading error of every formulation, from its stencils on a lattice.
///
/// On particles at equal distances δ a row of D or D² has the same weights for every δ, but for the factor δ⁻¹ or δ⁻²; it depends
/// only on how far the particle lies from the end. Taylor's expansion of B about the particle makes the row's error a sum over the
/// derivatives of B,
/// \f[ \sum_j w_j\,[B(x_j) - B(x_i)] - B^{(d)}(x_i) = \sum_{k \ge 1} \Big(\frac{m_k}{k!} - \delta_{kd}\Big)\,\delta^{\,k-d}\,B^{(k)}(x_i),
///     \qquad m_k = \sum_j w_j\,r_j^k, \f]
/// with weights and offsets r in units of δ. The first term that does not vanish is the leading error: its power of δ is the order,
/// its factor the constant. Nothing is fitted. The programs `constants` and `stencil` print them; `constants` beside what eˣ shows
/// at its right end in quadruple precision.
///
/// | in the formulas | code | meaning |
/// | --- | --- | --- |
/// | \f$w_j, r_j\f$ | `Stencil` | a row's weights and offsets, in units of δ |
/// | \f$m_k\f$ | `moment` | its k-th moment |
/// | \f$d\f$ | `derivative` | 1 for D, 2 for D² |
///
/// **Constants** (data/asprone2010/constants.csv). In the second derivative of eˣ at x = 1, with the paper's kernel and h = δ,
/// Chen–Beraun errs by −1.07176 e = −2.91335 on however many particles; modified FPM by −1.01366 e δ, second-order FPM by
/// −0.919921 e δ². With operators applied twice the error at the end grows like 1/δ; for FPM it tends to −0.47441 e. Also far from
/// the ends the original formulation and both RKPMs have an error of order zero, 0.4 % of the second derivative and for second-order
/// RKPM 3.9 %: sums over particles replace integrals of a Gaussian only up to \f$e^{-\pi^2 h^2/\delta^2}\f$, so that a wider
/// smoothing length makes it vanish (at h = 2δ it is below 1e-13).
///
/// **Map of orders** (orders.csv): observed between 161, 321 and 641 particles; of perturbed ones, medians over five draws. For D and D²
/// the paper's statements hold for every kernel and every h/δ with which a formulation can be computed, at equal distances and
/// perturbed: orders 2 and 2 for second-order FPM, 2 and 1 for modified FPM (and SSPH), 1 and 0 for Chen–Beraun and FPM applied twice, 0 and −1 for
/// the original formulation and RKPM. Two places depart: second-order FPM with a Gaussian of h = 0.6 δ on perturbed particles has order 0.7 in D, and
/// modified FPM loses its order on perturbed particles for h beyond 3 δ. Which h can be computed depends on the kernel: its
/// support must reach three particles for second-order FPM (h > 1.5 δ for a support of 2h, h > δ for 3h), two for the others that solve
/// for both derivatives. For u the statements hold less widely. Second-order and modified FPM keep order 2, and Chen–Beraun order 1,
/// at equal distances; where D is applied twice, u beyond h = 1.5 δ has no order: its system is nearly singular, and singular
/// in the white squares.
///
/// \image html asprone2010_figure_orders.svg "Observed orders of the errors of DB, D²B and u: formulations, in each the five kernels, against h/δ."
///
/// **Precision** (precision.csv). Truncation falls like \f$\delta^p\f$ and round-off grows like \f$\delta^{-2}\f$, so that each
/// precision has a best error. For second-order FPM the stencil predicts 1.9e-7 near 5 000 particles in double, 4.2e-9 near 35 000 in long double
/// and 1.8e-16 near 1.7e8 in quadruple precision; the least measured are 1.8e-7 and 2.8e-9, at 10 000 and 30 000. Round-off stays below the
/// prediction, which takes every rounding at its worst, and above a fifth of it.
///
/// \image html asprone2010_figure_precision.svg "Errors of D²B in double, long double and quadruple precision, with predictions."
///
/// **Draws** (draws.csv). On perturbed particles the error is a random number; the figure has its distribution over 1000 draws.
///
/// \image html asprone2010_figure_draws.svg "Distribution of the errors of D²B and u over 1000 draws of 160 perturbed particles."
namespace limit_stencils {

/// A row of an operator on a lattice of spacing one, particle i at r = 0.
template <class Scalar>
struct Stencil {
    Column<Scalar> r,
        w;  ///< offsets, and weights on \f$B(x_j) - B(x_i)\f$, in units of δ and \f$\delta^{-d}\f$
};

/// Row i of an operator.
/// \param unit spacing δ in which the stencil is written [length]
/// \param derivative 1 or 2, what the operator approximates
template <class Scalar>
Stencil<Scalar> row(const Operator<Scalar>& D, const Line<Scalar>& line, Index i, const Scalar& unit,
                    int derivative) {
    const Index size = D.outerIndexPtr()[i + 1] - D.outerIndexPtr()[i];
    Stencil<Scalar> of{Column<Scalar>(size), Column<Scalar>(size)};
    Index k = 0;
    for (typename Operator<Scalar>::InnerIterator entry(D, i); entry; ++entry, ++k) {
        of.r[k] = (line.x()[entry.col()] - line.x()[i]) / unit;
        of.w[k] = entry.value() * (derivative == 1 ? unit : unit * unit);
    }
    return of;
}

/// \f$m_k = \sum_j w_j r_j^k\f$.
template <class Scalar>
Scalar moment(const Stencil<Scalar>& of, int k) {
    Scalar sum(0);
    for (Index j = 0; j < of.r.size(); ++j) {
        Scalar power = of.w[j];
        for (int n = 0; n < k; ++n) power *= of.r[j];
        sum += power;
    }
    return sum;
}

/// \f$\sum_j |w_j|\,|r_j|^k\f$: against it, a moment vanishes or does not.
template <class Scalar>
Scalar absolute_moment(const Stencil<Scalar>& of, int k) {
    const Stencil<Scalar> absolute{of.r.abs(), of.w.abs()};
    return moment(absolute, k);
}

/// \f$m_k/k! - \delta_{kd}\f$: the factor of \f$\delta^{k-d} B^{(k)}\f$ in the error.
template <class Scalar>
Scalar taylor_coefficient(const Stencil<Scalar>& of, int k, int derivative) {
    Scalar factorial(1);
    for (int n = 2; n <= k; ++n) factorial *= n;
    return moment(of, k) / factorial - (k == derivative ? 1 : 0);
}

/// \f$\sum_j |w_j|\f$: by how much, times \f$\delta^{-d}\f$, errors in the values of B grow.
template <class Scalar>
Scalar amplification(const Stencil<Scalar>& of) {
    return of.w.abs().sum();
}

/// The first term of the error that does not vanish: \f$C\,\delta^p\,B^{(p+d)}(x_i)\f$.
template <class Scalar>
struct LeadingError {
    int exponent;     ///< p
    Scalar constant;  ///< C
};

/// \param derivative 1 or 2
/// \throws base::FailedComputation where the first twelve terms vanish to round-off
template <class Scalar>
LeadingError<Scalar> leading_error(const Stencil<Scalar>& of, int derivative) {
    using std::abs, std::sqrt;
    const Scalar negligible = sqrt(std::numeric_limits<Scalar>::epsilon());
    for (int k = 1; k <= 12; ++k) {
        const Scalar size = absolute_moment(of, k);
        const Scalar coefficient = taylor_coefficient(of, k, derivative);
        if (abs(coefficient) > negligible * (size > 1 ? Scalar(1) : size))
            return {k - derivative, coefficient};
    }
    throw base::FailedComputation("no term of the error's expansion up to the twelfth derivative stands out");
}

/// Number of particles, at spacing δ, that a kernel reaches on one side.
/// \throws base::InvalidInput unless that is positive and at most 100: stencils cost its third power
template <class Scalar>
Index reach_in_spacings(const numerical_tests::Discretisation& how) {
    const double reach = std::ceil(support<double>(how.kernel) * how.smoothing);
    if (!(reach > 0 && reach <= 100))
        throw base::InvalidInput("h/delta of " + base::shown(how.smoothing) +
                                 " gives stencils that reach over " + base::shown(reach) +
                                 " spacings, not over 1 to 100; take another --smoothing");
    return static_cast<Index>(reach);
}

/// The first particle, counted from the end, whose rows do not feel the end, though an operator be applied twice.
template <class Scalar>
Index first_interior(const numerical_tests::Discretisation& how) {
    return 2 * reach_in_spacings<Scalar>(how);
}

/// The right end of a lattice: as many particles at spacing δ, the last one at x = 1, as the rows of the outermost
/// `rows` particles can feel.
template <class Scalar>
numerical_tests::Particles<Scalar> right_end(const numerical_tests::Discretisation& how, Index rows,
                                             const Scalar& spacing) {
    const Index N = rows + 3 * reach_in_spacings<Scalar>(how) + 2;
    Column<Scalar> x(N);
    for (Index j = 0; j < N; ++j) x[j] = 1 - Scalar(N - 1 - j) * spacing;
    return numerical_tests::discretise<Scalar>(how, x);
}

/// The symbol of D² on the infinite lattice: \f$\lambda(\theta) = \sum_j w_j\,(\cos\theta r_j - 1)\f$, the eigenvalue times δ² of a
/// wave with θ radians from a particle to the next. The exact one is −θ². Its imaginary part vanishes, since stencils inside are even.
template <class Scalar>
Scalar symbol(const Stencil<Scalar>& of, const Scalar& theta) {
    return (of.w * ((theta * of.r).cos() - 1)).sum();
}

/// The frequencies that the symbol gives to the N − 2 waves that vanish at both ends of a line of N particles,
/// \f$\omega_n = \sqrt{-\lambda(\theta_n)}/\delta\f$ with \f$\theta_n = \pi n\,\delta\f$ and \f$\delta = 1/(N-1)\f$, in increasing order.
/// Where λ is positive the frequency counts as zero.
inline std::vector<double> symbol_frequencies(const Formulation<double>& formulation,
                                              const numerical_tests::Discretisation& how, Index N) {
    const Index rows = first_interior<double>(how);
    const auto [line, smoothing] = right_end<double>(how, rows, 1.0);
    const auto operators = formulation.operators(line, smoothing);
    const auto inside = row<double>(operators.D2, line, line.size() - 1 - rows, 1.0, 2);
    const auto intervals = static_cast<double>(N - 1);
    std::vector<double> frequencies;
    for (Index n = 1; n + 1 < N; ++n) {
        const double theta = std::numbers::pi * static_cast<double>(n) / intervals;
        frequencies.push_back(std::sqrt(std::max(-symbol(inside, theta), 0.0)) * intervals);
    }
    std::sort(frequencies.begin(), frequencies.end());
    return frequencies;
}

}  // namespace limit_stencils
}  // namespace asprone2010
