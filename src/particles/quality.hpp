#pragma once

#include <cmath>
#include <string>

#include "base/errors.hpp"
#include "base/index.hpp"
#include "base/parallel.hpp"
#include "particles/cloud.hpp"
#include "particles/line.hpp"
#include "particles/operators.hpp"
#include "particles/points.hpp"

namespace particles {

using base::for_each_index;
using base::Index;
using base::InvalidInput;

/// The quality number of a row, the factor in the bound of its error; small is good. It needs no solution and
/// serves every formulation in every dimension.
///
/// Let the row approximate \f$\partial^a B(x_i)\f$ of order k = |a|, exactly for polynomials up to degree
/// m ≥ k. What is left of Taylor's expansion about \f$x_i\f$ is its remainder, so that
/// \f[ \Big|\sum_j w_j\,[B(x_j) - B(x_i)] - \partial^a B(x_i)\Big| \le R\,\delta^{\,m+1-k}\,\max|B^{(m+1)}|,
///     \qquad R = \sum_j |w_j|\,\frac{|r_j|^{m+1}}{(m+1)!} \f]
/// with w and r in units of δ, and the maximum over the segments from \f$x_i\f$ to the \f$x_j\f$ of the
/// derivative along them. Where m < k, the bound is that of the sum alone.
/// \param w weights on \f$B(x_j) - B(x_i)\f$ \param r offsets \f$x_j - x_i\f$
/// \param exact m, the degree up to which polynomials are differentiated exactly
/// \return R, in the units of w and r
template <class Scalar, int dim>
Scalar quality(const Column<Scalar>& w, const Offsets<Scalar, dim>& r, int exact) {
    using std::sqrt;
    const Column<Scalar> distance = squared_lengths<Scalar, dim>(r).sqrt();
    Column<Scalar> term = w.abs();
    for (int k = 1; k <= exact + 1; ++k) term *= distance / Scalar(k);
    return term.sum();
}

/// The quality number of each row of an operator, as above.
/// \param points the line or cloud of the operator
/// \param derivative k, the order of the derivative that the operator approximates
/// \param spacing δ: one for all particles, or one for each [length]
/// \return R of each particle, without unit
/// \throws InvalidInput unless each particle has a row, and there is one spacing, or one for each particle
template <class Scalar, class Points>
Column<Scalar> quality(const Operator<Scalar>& D, const Points& points, int derivative, int exact,
                       const Column<Scalar>& spacing) {
    const Index N = points.size();
    if (D.rows() != N || D.cols() != N)
        throw InvalidInput("an operator of " + std::to_string(D.rows()) + " rows is not that of " +
                           std::to_string(N) + " particles");
    if (spacing.size() != 1 && spacing.size() != N)
        throw InvalidInput(std::to_string(N) + " particles need as many spacings, or one, got " +
                           std::to_string(spacing.size()));
    Column<Scalar> R(N);
    for_each_index(N, [&](Index i) {
        const Scalar& delta = spacing[spacing.size() == 1 ? 0 : i];
        R[i] = Scalar(0);
        for (typename Operator<Scalar>::InnerIterator entry(D, i); entry; ++entry) {
            using std::abs;
            const Scalar r = distance(points, i, entry.col()) / delta;
            Scalar term = abs(entry.value());
            for (int k = 1; k <= exact + 1; ++k) term *= r / Scalar(k);
            R[i] += term;
        }
        for (int k = 0; k < derivative; ++k) R[i] *= delta;
    });
    return R;
}

/// \f$\sum_j |w_j|\f$ of each row, by which round-off of B is multiplied: \f$DB(x_i) = \sum_j w_j\,[B(x_j) -
/// B(x_i)]\f$. [as the weights]
template <class Scalar>
Column<Scalar> absolute_sums(const Operator<Scalar>& D) {
    Column<Scalar> sums(D.rows());
    for_each_index(D.rows(), [&](Index i) {
        using std::abs;
        sums[i] = Scalar(0);
        for (typename Operator<Scalar>::InnerIterator entry(D, i); entry; ++entry)
            sums[i] += abs(entry.value());
    });
    return sums;
}

/// The row that may err most.
struct WorstRow {
    double R = 0;
    Index particle = 0;
    int derivative = 0;  ///< k, the order of the derivative that the row approximates
};

}  // namespace particles
