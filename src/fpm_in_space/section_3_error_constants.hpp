#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "asprone2010/leading_error.hpp"
#include "base/errors.hpp"
#include "base/text.hpp"
#include "fpm_in_space/formulations.hpp"
#include "particles/kernels.hpp"

namespace fpm_in_space {

/// Section 3, error constants: the limits of the errors that Section 4 measures, exactly.
///
/// Let the particles be a lattice at distances δ that fills the plane or space, or the half, the quarter or
/// the eighth of it on one side of one, two or three coordinates, and let h be a multiple of δ. In units of δ
/// the particle at the origin then has the same weights for every δ: they are a limit stencil, as on a line
/// (asprone2010::limit_stencils). The moments of a stencil are the constants of its error, of which none is
/// fitted. In space an error has several constants, one for each derivative of B in its leading term.
///
/// | in the formulas | code | meaning |
/// | --- | --- | --- |
/// | \f$w_j, r_j\f$ | `Stencil` | weights and offsets of a row, in units of δ |
/// | \f$a, b\f$ | `MultiIndex` | the derivative that a row approximates, and one in its error |
/// | \f$m_b\f$ | `moment` | moment of a row |
/// | \f$p, C_{ab}\f$ | `LeadingError` | exponent and constants of the leading error |
/// | \f$\lambda, \theta\f$ | `symbol` | eigenvalue and phases of a wave |
///
/// **What the constants say** (constants.csv, for the Gaussian with h = δ). Both derivatives of the
/// second-order FPM have exponent 2 at faces, edges and corners as inside. The largest constant is that of
/// \f$\partial^4 B/\partial x_1^4\f$ in the second derivative across the boundary. It is more than four times
/// the one inside, with the other sign, and to six digits that of the method at the end of a line: edges and
/// corners make it no worse. SSPH of degree 2 has exponent 1 there. SSPH of degree 3 has nearly the same
/// constants of second derivatives at corners, and others inside; its first derivatives have exponent 3, and
/// 4 inside. The second-order FPM that Section 2 extends word by word has exponent 2, too, but its constants
/// across an edge of the plane are thousands of times as large, and across a face in space hundreds of
/// times.
///
/// \image html fpm_in_space_figure_constants.svg "Sums of the absolute constants by place and derivative: from the stencils, and as exponentials show them."
///
/// **Where they come from.** The Gaussian in the plane or in space is a product of Gaussians on lines. Where
/// the value at the particle is one of the unknowns, as in SSPH of degree m, a monomial of degree m + 1
/// therefore leaves a product of the orthogonal polynomials \f$P_n\f$ of a line or, across a boundary, of
/// half a line:
/// \f[ C_{ab} = -\frac{1}{b!} \prod_k P_{b_k}^{(a_k)}(0), \qquad |b| = m + 1 \f]
/// The second-order FPM takes the value as given, and the constants of its second derivatives are, in
/// general, no such products. Inside they have a closed form in the sums of the Gaussian over a line, which
/// is not that on a line.
///
/// **The symbol** (symbol.csv). On an infinite lattice the Laplacian turns waves into multiples of
/// themselves. Long waves have the right frequency; short ones are too slow, along the diagonal more than
/// along the axes. No wave has the frequency zero, but with SSPH some nearly have: with h = 2δ, values that
/// alternate from particle to particle in both directions have less than a millionth of the exact
/// eigenvalue, since a fit that need not meet the value at the particle smooths them away. With the
/// second-order FPM they have more than a hundredth of it. Inside, SSPH of degree 2 and 3 have the same
/// second derivatives.
///
/// \image html fpm_in_space_figure_symbol.svg "Frequencies of waves over the exact ones: along an axis, along the diagonal, and in the plane of phases."
///
/// What this section claims, and what was measured: \claims{F-3}.
namespace error_constants {

using base::shown;
using particles::Column;
using particles::Derivatives;
using particles::Exponents;
using particles::Index;
using particles::Kernel;
using particles::Neighbourhood;
using particles::Offsets;
using particles::Point;
using particles::Points;

/// A multi-index as an argument, whose dimension another argument says.
template <int dim>
using MultiIndex = std::type_identity_t<Exponents<dim>>;

/// A lattice of particles at distances of one, with equal volumes, seen from its particle at the origin.
template <int dim>
struct Lattice {
    Kernel<dim> kernel{};
    double smoothing = 1;  ///< h/δ
    int bounded = 0;       ///< how many coordinates are nowhere negative
};

/// How many particles the support of the kernel holds on one side.
/// \throws base::InvalidInput unless that is between 1 and 30: the cost grows with its third power
template <int dim>
Index reach_in_spacings(const Lattice<dim>& lattice) {
    const double reach = std::ceil(particles::support<double>(lattice.kernel) * lattice.smoothing);
    if (!(reach > 0 && reach <= 30))
        throw base::InvalidInput("h/delta of " + shown(lattice.smoothing) +
                                 " gives stencils that reach over " + shown(reach) +
                                 " spacings, not over 1 to 30; take another --smoothing");
    return static_cast<Index>(reach);
}

/// The particles within reach of the one at the origin, itself included. The Gaussian is cut as in double
/// precision, so that every scalar sees the same particles.
template <int dim>
Points<dim> within_reach(const Lattice<dim>& lattice) {
    const Index most = reach_in_spacings(lattice), side = 2 * most + 1;
    const double reach = particles::reach<double>(lattice.kernel) * lattice.smoothing;
    Points<dim> x(dim, dim == 2 ? side * side : side * side * side);
    Index count = 0;
    for (Index j = 0; j < x.cols(); ++j) {
        Point<dim> at;
        for (Index axis = 0, rest = j; axis < dim; ++axis, rest /= side)
            at[axis] = static_cast<double>(rest % side - most);
        if (at.norm() < reach && (at.head(lattice.bounded).array() >= 0).all()) x.col(count++) = at;
    }
    return x.leftCols(count);
}

/// What the particle at the origin sees.
template <class Scalar, int dim>
Neighbourhood<Scalar, dim> neighbourhood(const Lattice<dim>& lattice) {
    const Scalar per_h = 1 / Scalar(lattice.smoothing);
    Neighbourhood<Scalar, dim> near;
    near.r = within_reach(lattice).transpose().array().template cast<Scalar>() * per_h;
    near.V = Column<Scalar>::Constant(near.r.rows(), dim == 2 ? per_h * per_h : per_h * per_h * per_h);
    particles::evaluate(lattice.kernel, near.r, near.W, near.DW);
    return near;
}

/// A row of an operator, its particle at r = 0.
template <class Scalar, int dim>
struct Stencil {
    Offsets<Scalar, dim> r;  ///< offsets \f$(x_j - x_i)/\delta\f$
    Column<Scalar> w;        ///< weights on \f$B(x_j) - B(x_i)\f$ [\f$\delta^{-|a|}\f$]
};

/// The rows of all first and second derivatives.
template <class Scalar, int dim>
struct Rows {
    Offsets<Scalar, dim> r;      ///< offsets \f$(x_j - x_i)/\delta\f$
    Derivatives<Scalar, dim> w;  ///< weights on \f$B(x_j) - B(x_i)\f$ [1/δ, 1/δ²]
};

namespace detail {

/// \throws base::FailedComputation where the neighbours are too few, or do not determine the weights
template <class Scalar, int dim>
Rows<Scalar, dim> determined_rows(const Formulation<Scalar, dim>& formulation, const Lattice<dim>& lattice) {
    const auto near = neighbourhood<Scalar>(lattice);
    if (near.W.size() < formulation.particles)
        throw base::FailedComputation("needs " + std::to_string(formulation.particles));
    const auto w = formulation.weights(near);
    const Scalar h(lattice.smoothing);
    return {near.r * h, {w.first / h, w.second / (h * h)}};
}

/// "try --smoothing 1.6": the least h/δ in steps of a tenth of it with which the weights are determined.
template <class Scalar, int dim>
std::string remedy(const Formulation<Scalar, dim>& formulation, Lattice<dim> lattice) {
    const double two_particles = 1 / particles::support<double>(lattice.kernel);
    for (double wanted = std::max(lattice.smoothing, two_particles);; wanted *= 1.1) {
        const double digit = std::pow(10, std::floor(std::log10(wanted)) - 1);
        lattice.smoothing = std::stod(shown(std::ceil(wanted / digit) * digit));
        try {
            static_cast<void>(determined_rows(formulation, lattice));
            return "try --smoothing " + shown(lattice.smoothing);
        } catch (const base::FailedComputation&) {
        } catch (const base::InvalidInput&) {  // the support is as large as it can be
            return "take another kernel";
        }
    }
}

}  // namespace detail

/// The limit stencils of a formulation at a place of a lattice. In units of δ they are the same for every δ.
/// \throws base::FailedComputation where the neighbours are too few or do not determine the weights, with a
///         remedy
template <class Scalar, int dim>
Rows<Scalar, dim> limit_stencils(const Formulation<Scalar, dim>& formulation, const Lattice<dim>& lattice) {
    try {
        return detail::determined_rows(formulation, lattice);
    } catch (const base::FailedComputation& failed) {
        const Index count = within_reach(lattice).cols();
        throw base::FailedComputation(std::string(formulation.name) + ", " + place<dim>(lattice.bounded) +
                                      ": a particle has " + std::to_string(count) +
                                      (count == 1 ? " neighbour within " : " neighbours within ") +
                                      shown(particles::support<double>(lattice.kernel), 3) + "h, " +
                                      failed.what() + "; " + detail::remedy(formulation, lattice));
    }
}

/// The row of \f$\partial^a\f$, |a| = 1 or 2.
template <class Scalar, int dim>
Stencil<Scalar, dim> row(const Rows<Scalar, dim>& rows, const MultiIndex<dim>& a) {
    static constexpr auto known = particles::monomials<dim, 2>();
    const Index k = std::find(known.begin(), known.end(), a) - known.begin() - 1;
    if (k < dim) return {rows.r, rows.w.first.col(k)};
    return {rows.r, rows.w.second.col(k - dim)};
}

/// The row of the Laplacian.
template <class Scalar, int dim>
Stencil<Scalar, dim> laplacian(const Rows<Scalar, dim>& rows) {
    return {rows.r, rows.w.second.template leftCols<dim>().rowwise().sum()};
}

/// The derivatives of order 1 and 2 that symmetry leaves different from one another at a place: one for those
/// that differ by an exchange of bounded coordinates, or of unbounded ones.
template <int dim>
std::vector<Exponents<dim>> different_derivatives(int bounded) {
    std::vector<Exponents<dim>> all;
    for (const Exponents<dim>& a : particles::monomials<dim, 2>())
        if (particles::order<dim>(a) > 0 && std::is_sorted(a.begin(), a.begin() + bounded, std::greater{}) &&
            std::is_sorted(a.begin() + bounded, a.end(), std::greater{}))
            all.push_back(a);
    return all;
}

/// The multi-indices of a degree, in the order 11, 12, 22 of their derivatives.
template <int dim>
std::vector<Exponents<dim>> of_degree(int degree) {
    std::vector<Exponents<dim>> all;
    for (int first = degree; first >= 0; --first) {
        if constexpr (dim == 2) all.push_back({first, degree - first});
        if constexpr (dim == 3)
            for (int second = degree - first; second >= 0; --second)
                all.push_back({first, second, degree - first - second});
    }
    return all;
}

/// \f$r^b\f$ of each offset.
template <class Scalar, int dim>
Column<Scalar> monomial(const Offsets<Scalar, dim>& r, const MultiIndex<dim>& b) {
    Column<Scalar> product = Column<Scalar>::Ones(r.rows());
    for (int axis = 0; axis < dim; ++axis)
        for (int k = 0; k < b[static_cast<std::size_t>(axis)]; ++k) product *= r.col(axis);
    return product;
}

/// \f$m_b = \sum_j w_j\,r_j^b\f$.
template <class Scalar, int dim>
Scalar moment(const Stencil<Scalar, dim>& stencil, const MultiIndex<dim>& b) {
    return (stencil.w * monomial(stencil.r, b)).sum();
}

/// \f$(-1)^{|b| - |c|} \binom{b}{c}\f$, zero unless c ≤ b.
template <int dim>
int signed_binomial(const Exponents<dim>& b, const Exponents<dim>& c) {
    int product = 1;
    for (std::size_t axis = 0; axis < dim; ++axis)
        for (int k = 0; k < c[axis]; ++k) product = product * (b[axis] - k) / (k + 1);
    return (particles::order<dim>(b) - particles::order<dim>(c)) % 2 == 0 ? product : -product;
}

/// The factor of \f$\delta^{|b|-|a|}\,\partial^b B\f$ in the error of a row of \f$\partial^a\f$. From
/// Taylor's expansion of B. \defeq{F10}
/// \f[ \sum_j w_j\,[B(x_j) - B(x_i)] - \partial^a B(x_i)
///     = \sum_{|b| \ge 1} \Big(\frac{m_b}{b!} - \delta_{ab}\Big)\,\delta^{|b|-|a|}\,\partial^b B(x_i)
///     \tag{F10} \f]
template <class Scalar, int dim>
Scalar taylor_coefficient(const Stencil<Scalar, dim>& stencil, const MultiIndex<dim>& a,
                          const MultiIndex<dim>& b) {
    return moment(stencil, b) / particles::factorial<dim>(b) - (a == b ? 1 : 0);
}

/// The first terms of the error that do not vanish, \f$\delta^p \sum_b C_{ab}\,\partial^b B(x_i)\f$.
template <class Scalar, int dim>
struct LeadingError {
    int exponent;                   ///< p
    std::vector<Exponents<dim>> b;  ///< all of degree |a| + p
    Column<Scalar> C;               ///< the constant of each b
};

/// The leading error of a row: of the lowest degree whose Taylor coefficients do not all vanish.
/// \defeq{F11}
/// \f[ C_{ab} = \frac{m_b}{b!} - \delta_{ab}, \qquad |b| = |a| + p \tag{F11} \f]
/// \param a derivative that the row approximates
/// \throws base::FailedComputation where all coefficients up to degree 8 vanish
template <class Scalar, int dim>
LeadingError<Scalar, dim> leading_error(const Stencil<Scalar, dim>& stencil, const MultiIndex<dim>& a) {
    using std::sqrt;
    const Scalar negligible = sqrt(std::numeric_limits<Scalar>::epsilon());
    for (int degree = 1; degree <= 8; ++degree) {
        const auto b = of_degree<dim>(degree);
        Column<Scalar> C(static_cast<Index>(b.size()));
        for (Index k = 0; k < C.size(); ++k)
            C[k] = taylor_coefficient(stencil, a, b[static_cast<std::size_t>(k)]);
        if ((C.abs() > negligible).any()) return {degree - particles::order<dim>(a), b, C};
    }
    throw base::FailedComputation("no term of the error's expansion up to degree 8 stands out");
}

/// The error of a row for \f$B = e^{c \cdot (x - x_i)}\f$, whose derivatives at \f$x_i\f$ are
/// \f$\partial^b B = c^b\f$, over \f$\delta^p\f$.
/// \f[ \delta^{-p} \Big( \delta^{-|a|} \sum_j w_j\,[e^{\delta\,c \cdot r_j} - 1] - c^a \Big) \f]
template <class Scalar, int dim>
Scalar scaled_error(const Stencil<Scalar, dim>& stencil, const MultiIndex<dim>& a, const MultiIndex<dim>& c,
                    const Scalar& spacing, int exponent) {
    using std::pow;
    Column<Scalar> phase = Column<Scalar>::Zero(stencil.w.size());  // c · r
    Scalar exact(1);
    for (std::size_t k = 0; k < dim; ++k) {
        phase += stencil.r.col(static_cast<Index>(k)) * Scalar(c[k]);
        exact *= pow(Scalar(c[k]), a[k]);
    }
    const Scalar sum = (stencil.w * ((phase * spacing).exp() - 1)).sum();
    return (sum * pow(spacing, -particles::order<dim>(a)) - exact) * pow(spacing, -exponent);
}

/// The leading error for \f$B = e^{c \cdot (x - x_i)}\f$ as it shows: the scaled error at six spacings,
/// extrapolated to δ = 0. \defeq{F12}
/// \f[ P(c) = \lim_{\delta \to 0} \delta^{-p} \Big( \delta^{-|a|} \sum_j w_j\,[e^{\delta\,c \cdot r_j} - 1]
///     - c^a \Big) = \sum_{|b| = |a| + p} C_{ab}\,c^b \tag{F12} \f]
template <class Scalar, int dim>
Scalar measured_error(const Stencil<Scalar, dim>& stencil, const MultiIndex<dim>& a, const MultiIndex<dim>& c,
                      int exponent) {
    using std::ldexp;
    const Scalar coarsest = ldexp(Scalar(1), -6) / (particles::order<dim>(a) + exponent);
    std::array<Scalar, 6> values;
    for (int k = 0; k < 6; ++k)
        values[static_cast<std::size_t>(k)] =
            scaled_error(stencil, a, c, Scalar(ldexp(coarsest, -k)), exponent);
    return asprone2010::limit_stencils::extrapolated(values);
}

/// The constants as exponentials show them. P is homogeneous, so that its mixed differences from zero, with
/// steps of one, are its derivatives:
/// \f[ b!\,C_{ab} = \sum_{c \le b} (-1)^{|b| - |c|} \binom{b}{c}\,P(c) \f]
/// With leading_error() they share nothing but the weights.
/// \param exponent p of leading_error() \return the constant of each b of degree |a| + p
template <class Scalar, int dim>
Column<Scalar> measured_constants(const Stencil<Scalar, dim>& stencil, const MultiIndex<dim>& a,
                                  int exponent) {
    const int degree = particles::order<dim>(a) + exponent;
    std::map<Exponents<dim>, Scalar> P;
    for (int up_to = 1; up_to <= degree; ++up_to)
        for (const auto& c : of_degree<dim>(up_to)) P[c] = measured_error(stencil, a, c, exponent);

    const auto b = of_degree<dim>(degree);
    Column<Scalar> C = Column<Scalar>::Zero(static_cast<Index>(b.size()));
    for (Index k = 0; k < C.size(); ++k) {
        const auto& b_k = b[static_cast<std::size_t>(k)];
        for (const auto& [c, P_c] : P) C[k] += signed_binomial<dim>(b_k, c) * P_c;
        C[k] /= particles::factorial<dim>(b_k);
    }
    return C;
}

/// \f$\sum_j |w_j|\f$, the factor by which a row multiplies the largest error of the values of B, over
/// \f$\delta^{-|a|}\f$.
template <class Scalar, int dim>
Scalar amplification(const Stencil<Scalar, dim>& stencil) {
    return stencil.w.abs().sum();
}

/// The symbol of a row on an infinite lattice: the eigenvalue, times \f$\delta^{|a|}\f$, of a wave that
/// advances by \f$\theta_k\f$ radians from one particle to the next along axis k. For the Laplacian the exact
/// one is \f$-|\theta|^2\f$. Its imaginary part vanishes, since the row is even.
/// \defeq{F13}
/// \f[ \lambda(\theta) = \sum_j w_j\,(\cos\theta \cdot r_j - 1) \tag{F13} \f]
template <class Scalar, int dim>
Scalar symbol(const Stencil<Scalar, dim>& stencil, const Point<dim, Scalar>& theta) {
    return (stencil.w * ((stencil.r.matrix() * theta).array().cos() - 1)).sum();
}

// Compiled once, in section_3_error_constants.cpp.
extern template Rows<base::Quad, 2> limit_stencils(const Formulation<base::Quad, 2>&, const Lattice<2>&);
extern template LeadingError<base::Quad, 2> leading_error(const Stencil<base::Quad, 2>&,
                                                          const MultiIndex<2>&);
extern template Column<base::Quad> measured_constants(const Stencil<base::Quad, 2>&, const MultiIndex<2>&,
                                                      int);
extern template Rows<base::Quad, 3> limit_stencils(const Formulation<base::Quad, 3>&, const Lattice<3>&);
extern template LeadingError<base::Quad, 3> leading_error(const Stencil<base::Quad, 3>&,
                                                          const MultiIndex<3>&);
extern template Column<base::Quad> measured_constants(const Stencil<base::Quad, 3>&, const MultiIndex<3>&,
                                                      int);

}  // namespace error_constants
}  // namespace fpm_in_space
