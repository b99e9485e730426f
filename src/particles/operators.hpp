#pragma once

#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "particles/local_system.hpp"
#include "particles/neighbourhood.hpp"
#include "particles/parallel.hpp"

namespace particles {

/// A discrete derivative: row i holds the weights with which particle i sums the values at its neighbours.
/// [1/length^k for the k-th derivative]
template <class Scalar = double>
using Operator = Eigen::SparseMatrix<Scalar, Eigen::RowMajor>;

/// The first and second derivative operators of a formulation.
template <class Scalar = double>
struct Operators {
    Operator<Scalar> D, D2;
};

/// What a formulation returns that knows both derivatives of a neighbourhood: weights on \f$B(x_j) - B(x_i)\f$.
template <class Scalar, int Size = Eigen::Dynamic>
struct Derivatives {
    Column<Scalar, Size> first, second;  ///< in units of 1/h and 1/h²
};

/// Who asks for a neighbourhood, and how many particles (itself included) it must hold.
struct Requirement {
    std::string_view formulation;
    Index particles;
};

/// Sets each diagonal entry to minus the sum of the row's others, summed without it: the row annihilates constants to the
/// last bit, whatever round-off the weights carry.
/// \throws InvalidInput for a row that stores no diagonal entry
template <class Scalar>
void annihilate_constants(Operator<Scalar>& D) {
    for_each_index(D.rows(), [&](Index i) {
        Scalar others(0);
        Scalar* own = nullptr;
        for (typename Operator<Scalar>::InnerIterator entry(D, i); entry; ++entry) {
            if (entry.col() == i)
                own = &entry.valueRef();
            else
                others += entry.value();
        }
        if (own == nullptr)
            throw InvalidInput("row " + std::to_string(i) + " of the operator stores no diagonal entry");
        *own = -others;
    });
}

/// The operator of the second derivative as the first derivative applied twice, \f$D^2 = D\,D\f$.
template <class Scalar>
Operator<Scalar> applied_twice(const Operator<Scalar>& D) {
    Operator<Scalar> D2 = D * D;
    annihilate_constants(D2);
    return D2;
}

/// \f$\sum_j D_{ij}[B(x_j) - B(x_i)]\f$ for every particle: the operator applied through differences, which is exact on
/// constants and loses nothing to the size of B.
template <class Scalar>
Column<Scalar> apply(const Operator<Scalar>& D, const Column<Scalar>& B) {
    Column<Scalar> DB(D.rows());
    for_each_index(D.rows(), [&](Index i) {
        Scalar sum(0);
        for (typename Operator<Scalar>::InnerIterator entry(D, i); entry; ++entry)
            sum += entry.value() * (B[entry.col()] - B[i]);
        DB[i] = sum;
    });
    return DB;
}

namespace detail {

/// An operator whose row i holds consecutive columns, near[i]; the values are still to come.
template <class Scalar>
Operator<Scalar> banded_pattern(const std::vector<Range>& near) {
    const auto N = static_cast<Index>(near.size());
    Index entries = 0;
    for (const Range& range : near) entries += range.size();
    if (entries > std::numeric_limits<int>::max())
        throw InvalidInput("an operator of " + std::to_string(entries) +
                           " weights is too large; take fewer particles or a smaller smoothing length");
    Operator<Scalar> D(N, N);
    D.resizeNonZeros(entries);
    D.outerIndexPtr()[0] = 0;
    for (Index i = 0; i < N; ++i)
        D.outerIndexPtr()[i + 1] =
            D.outerIndexPtr()[i] + static_cast<int>(near[static_cast<std::size_t>(i)].size());
    for_each_index(N, [&](Index i) {
        const Range& range = near[static_cast<std::size_t>(i)];
        for (Index k = 0; k < range.size(); ++k)
            D.innerIndexPtr()[D.outerIndexPtr()[i] + k] = static_cast<int>(range.first + k);
    });
    return D;
}

template <class Scalar>
void set_row(Operator<Scalar>& D, Index i, const Column<Scalar>& weights, const Scalar& unit) {
    Eigen::Map<Column<Scalar>>(D.valuePtr() + D.outerIndexPtr()[i], weights.size()) = weights * unit;
}

/// "second_order_fpm: particle 0 (x = 0) has 2 neighbours within 2h"
template <class Scalar>
std::string census(const Line<Scalar>& line, const Smoothing<Scalar>& smoothing, Index i, const Range& near,
                   const Requirement& required) {
    return std::string(required.formulation) + ": particle " + std::to_string(i) +
           " (x = " + shown(static_cast<double>(line.x()[i])) + ") has " + std::to_string(near.size()) +
           (near.size() == 1 ? " neighbour" : " neighbours") + " within " +
           shown(static_cast<double>(support<Scalar>(smoothing.kernel())), 3) + "h";
}

/// The smallest smoothing length, in spacings (or in its own, where each particle has one) and rounded up to a tenth, with which
/// particle i has enough neighbours.
template <class Scalar>
std::string remedy(const Line<Scalar>& line, const Smoothing<Scalar>& smoothing, Index i, Index needed) {
    if (line.size() < needed) return "take at least " + std::to_string(needed) + " particles";
    std::vector<double> distance(static_cast<std::size_t>(line.size()));
    for (Index j = 0; j < line.size(); ++j)
        distance[static_cast<std::size_t>(j)] = std::abs(static_cast<double>(line.x()[j] - line.x()[i]));
    const auto wanted = distance.begin() + (needed - 1);
    std::nth_element(distance.begin(), wanted, distance.end());
    const Scalar unit = smoothing.is_local() ? smoothing.h(i) : line.spacing();
    const double ratio = *wanted / static_cast<double>(unit * support<Scalar>(smoothing.kernel()));
    return "try --smoothing " + shown(std::floor(10 * ratio * (1 + 1e-6) + 1) / 10) +
           (smoothing.is_local() ? " times as large" : "");
}

}  // namespace detail

/// Assembles D and D² of a formulation in one pass over the particles, straight into compressed rows, in parallel and with
/// the same bytes on any number of threads.
/// \param rule a pure function of a Neighbourhood. It returns Derivatives, or the weights of the first derivative alone
/// \param second the operator D² as a function of D, for a rule that returns the first derivative alone
/// \throws FailedComputation naming the formulation, the particle, its position, its neighbours and a remedy where a
///         neighbourhood cannot carry the formulation
template <class Scalar, class Rule, class Second = std::nullptr_t>
Operators<Scalar> assemble(const Line<Scalar>& line, const Smoothing<Scalar>& smoothing,
                           const Requirement& required, const Rule& rule, const Second& second = {}) {
    using Answer = std::invoke_result_t<Rule, const Neighbourhood<Scalar>&>;
    constexpr bool knows_both = std::is_same_v<Answer, Derivatives<Scalar>>;
    const Index N = line.size();

    std::vector<Range> near(static_cast<std::size_t>(N));
    for_each_index(N, [&](Index i) {
        Range& range = near[static_cast<std::size_t>(i)];
        range = within_reach(line, smoothing, i);
        if (range.size() < required.particles)
            throw FailedComputation(detail::census(line, smoothing, i, range, required) + ", needs " +
                                    std::to_string(required.particles) + "; " +
                                    detail::remedy(line, smoothing, i, required.particles));
    });

    Operators<Scalar> of_line;
    of_line.D = detail::banded_pattern<Scalar>(near);
    if constexpr (knows_both) of_line.D2 = of_line.D;
    for_each_index(N, [&](Index i) {
        const Range& range = near[static_cast<std::size_t>(i)];
        const Scalar per_h = 1 / smoothing.h(i);
        try {
            const Answer weights = rule(neighbourhood(line, smoothing, i, range));
            if constexpr (knows_both) {
                detail::set_row<Scalar>(of_line.D, i, weights.first, per_h);
                detail::set_row<Scalar>(of_line.D2, i, weights.second, per_h * per_h);
            } else {
                detail::set_row<Scalar>(of_line.D, i, weights, per_h);
            }
        } catch (const SingularNeighbourhood& singular) {
            throw FailedComputation(
                detail::census(line, smoothing, i, range, required) + " (" + std::to_string(i - range.first) +
                " on the left, " + std::to_string(range.last - 1 - i) + " on the right), but " +
                singular.what() + "; take a larger --smoothing or particles that lie farther apart");
        }
    });
    annihilate_constants(of_line.D);
    if constexpr (knows_both)
        annihilate_constants(of_line.D2);
    else
        of_line.D2 = second(of_line.D);
    return of_line;
}

}  // namespace particles
