#pragma once

#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/errors.hpp"
#include "base/index.hpp"
#include "base/memory.hpp"
#include "base/pack.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "particles/local_system.hpp"
#include "particles/neighbourhood.hpp"

namespace particles {

using base::FailedComputation;
using base::for_each_index;
using base::Index;
using base::InvalidInput;
using base::Pack;
using base::prefer_large_pages;
using base::shown;

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
template <class Scalar>
struct Derivatives {
    Column<Scalar> first, second;  ///< in units of 1/h and 1/h²
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

namespace detail {

/// An operator whose row i will hold consecutive columns, near[i]; columns and values are still to come.
template <class Scalar>
Operator<Scalar> banded(const std::vector<Range>& near) {
    const auto N = static_cast<Index>(near.size());
    Index entries = 0;
    for (const Range& range : near) entries += range.size();
    if (entries > std::numeric_limits<int>::max())
        throw InvalidInput("an operator of " + std::to_string(entries) +
                           " weights is too large; take fewer particles or a smaller smoothing length");
    Operator<Scalar> D(N, N);
    D.outerIndexPtr()[0] = 0;
    for (Index i = 0; i < N; ++i)
        D.outerIndexPtr()[i + 1] =
            D.outerIndexPtr()[i] + static_cast<int>(near[static_cast<std::size_t>(i)].size());
    D.resizeNonZeros(entries);
    prefer_large_pages(D.valuePtr(), entries);
    prefer_large_pages(D.innerIndexPtr(), entries);
    return D;
}

/// Writes the columns of a row. \return where its values go
template <class Scalar>
Scalar* begin_row(Operator<Scalar>& D, Index i, const Range& near) {
    const Index start = D.outerIndexPtr()[i];
    std::iota(D.innerIndexPtr() + start, D.innerIndexPtr() + start + near.size(),
              static_cast<int>(near.first));
    return D.valuePtr() + start;
}

/// Sets a row's own entry to minus the sum of the others, summed without it: the row annihilates constants to the last bit,
/// whatever round-off the weights carry. Entries may be packs or arrays, of several rows.
template <class Scalar>
void annihilate_constants(Scalar* row, Index size, Index own) {
    row[own] -= row[own];
    for (Index k = 0; k < own; ++k) row[own] -= row[k];
    for (Index k = own + 1; k < size; ++k) row[own] -= row[k];
}

/// Weights on differences as the row of particle i.
/// \param near of the particle
/// \param own where the particle stands among its neighbours
/// \param unit of the weights
template <class Scalar>
void set_row(Operator<Scalar>& D, Index i, const Range* near, Index own, const Column<Scalar>& weights,
             const Scalar& unit) {
    Scalar* const row = begin_row(D, i, *near);
    Eigen::Map<Column<Scalar>>(row, weights.size()) = weights * unit;
    annihilate_constants(row, weights.size(), own);
}

/// The same for each particle of a Pack, from i on; of the weights, those of neighbours that a lane does not reach are left out.
inline void set_row(Operator<double>& D, Index i, const Range* near, Index own, const Column<Pack>& weights,
                    const Pack& unit) {
    Column<Pack> rows = weights * unit;
    annihilate_constants(rows.data(), rows.size(), own);
    for (int lane = 0; lane < Pack::lanes; ++lane) {
        const Index skipped = near[lane].first - (i + lane - own), size = near[lane].size();
        double* const row = begin_row(D, i + lane, near[lane]);
        const Pack* const from = rows.data() + skipped;
        for (Index k = 0; k < size; ++k) row[k] = from[k][lane];
    }
}

/// What a rule answers, as rows of the operators.
template <class Scalar, class Number>
void set_rows(Operators<Scalar>& of_line, Index i, const Range* near, Index own, const Column<Number>& first,
              const Number& per_h) {
    set_row(of_line.D, i, near, own, first, per_h);
}
template <class Scalar, class Number>
void set_rows(Operators<Scalar>& of_line, Index i, const Range* near, Index own,
              const Derivatives<Number>& both, const Number& per_h) {
    set_row(of_line.D, i, near, own, both.first, per_h);
    set_row(of_line.D2, i, near, own, both.second, Number(per_h * per_h));
}

/// The diagonals \f$D_{i,i+a}\f$ of some rows and of those that these reach; zero where D stores nothing.
template <class Scalar>
struct Diagonals {
    Index left = 0, right = 0;  ///< −left ≤ a ≤ right

    /// \param more how many rows of zeros follow
    Diagonals(const Operator<Scalar>& D, const Range& of, Index more) {
        const int *const start = D.outerIndexPtr(), *const column = D.innerIndexPtr();
        Range reached = of;
        for (Index i = of.first; i < of.last; ++i) {
            reached.first = std::min<Index>(reached.first, column[start[i]]);
            reached.last = std::max<Index>(reached.last, column[start[i + 1] - 1] + 1);
        }
        for (Index i = reached.first; i < reached.last; ++i) {
            left = std::max<Index>(left, i - column[start[i]]);
            right = std::max<Index>(right, column[start[i + 1] - 1] - i);
        }
        first_ = of.first - left;
        entries_.setZero(left + of.size() + right + more, left + 1 + right);
        for (Index i = reached.first; i < reached.last; ++i) {
            Scalar* const row = entries_.data() + (i - first_);
            for (int k = start[i]; k < start[i + 1]; ++k)
                row[entries_.rows() * (left + column[k] - i)] = D.valuePtr()[k];
        }
    }

    /// Entries of diagonal a in so many rows, from i on.
    template <int count>
    [[nodiscard]] auto rows(Index i, Index a) const {
        return entries_.col(left + a).template segment<count>(i - first_);
    }

  private:
    Index first_;
    Eigen::Array<Scalar, Eigen::Dynamic, Eigen::Dynamic> entries_;
};

}  // namespace detail

/// The operator of the second derivative as the first derivative applied twice, \f$D^2 = D\,D\f$.
///
/// \f$D^2_{i,i+q} = \sum_a D_{i,i+a}\,D_{i+a,i+q}\f$ is computed for some rows at a time from the diagonals \f$D_{i,i+a}\f$ of D,
/// which lie in memory as the rows follow one another.
/// \param D rows of consecutive columns, as assemble() makes them
template <class Scalar>
Operator<Scalar> applied_twice(const Operator<Scalar>& D) {
    const Index N = D.rows();
    const int *const start = D.outerIndexPtr(), *const column = D.innerIndexPtr();
    const auto row_of_D = [&](Index i) -> Range { return {column[start[i]], column[start[i + 1] - 1] + 1}; };
    std::vector<Range> reached(static_cast<std::size_t>(N));
    for_each_index(N, [&](Index i) {
        Range& range = reached[static_cast<std::size_t>(i)];
        range = {i, i + 1};
        for (Index j = row_of_D(i).first; j < row_of_D(i).last; ++j) {
            range.first = std::min(range.first, row_of_D(j).first);
            range.last = std::max(range.last, row_of_D(j).last);
        }
    });

    Operator<Scalar> D2 = detail::banded<Scalar>(reached);
    constexpr Index tile = 64, block = 16;
    using Block = Eigen::Array<Scalar, block, 1>;
    for_each_index((N + tile - 1) / tile, [&](Index t) {
        const Range rows{t * tile, std::min((t + 1) * tile, N)};
        const detail::Diagonals<Scalar> D_of(D, rows, block);
        const Index left = 2 * D_of.left, right = 2 * D_of.right;
        std::vector<Block> of_block(static_cast<std::size_t>(left + 1 + right));
        for (Index b = rows.first; b < rows.last; b += block) {
            for (Index q = -left; q <= right; ++q) {
                Block sum = Block::Zero();
                const Index least = std::max(-D_of.left, q - D_of.right),
                            most = std::min(D_of.right, q + D_of.left);
                for (Index a = least; a <= most; ++a)
                    sum += D_of.template rows<block>(b, a) * D_of.template rows<block>(b + a, q - a);
                of_block[static_cast<std::size_t>(left + q)] = sum;
            }
            detail::annihilate_constants(of_block.data(), left + 1 + right, left);
            for (Index i = b; i < std::min(b + block, rows.last); ++i) {
                const Range& range = reached[static_cast<std::size_t>(i)];
                Scalar* const row = detail::begin_row(D2, i, range);
                const Scalar* const from =
                    of_block[static_cast<std::size_t>(left + range.first - i)].data() + (i - b);
                for (Index k = 0; k < range.size(); ++k) row[k] = from[block * k];
            }
        }
    });
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
/// the same bytes on any number of threads. In double precision, the particles of a Pack are computed together wherever each of
/// them has its neighbours on the line; elsewhere, and where they fail, one by one.
/// \param rule a pure function of a Neighbourhood. It returns Derivatives, or the weights of the first derivative alone. If it takes a
///        Neighbourhood of Packs as well, entries with W = DW = V = 0 must not count
/// \param second the operator D² as a function of D, for a rule that returns the first derivative alone
/// \throws FailedComputation naming the formulation, the particle, its position, its neighbours and a remedy where a
///         neighbourhood cannot carry the formulation
template <class Scalar, class Rule, class Second = std::nullptr_t>
Operators<Scalar> assemble(const Line<Scalar>& line, const Smoothing<Scalar>& smoothing,
                           const Requirement& required, const Rule& rule, const Second& second = {}) {
    using Answer = std::invoke_result_t<Rule, const Neighbourhood<Scalar>&>;
    constexpr bool knows_both = std::is_same_v<Answer, Derivatives<Scalar>>;
    constexpr bool takes_packs =
        std::is_same_v<Scalar, double> && std::is_invocable_v<Rule, const Neighbourhood<Pack>&>;
    const Index N = line.size();

    const std::vector<Range> all_near = all_within_reach(line, smoothing);
    for_each_index(N, [&](Index i) {
        const Range& near = all_near[static_cast<std::size_t>(i)];
        if (near.size() < required.particles)
            throw FailedComputation(detail::census(line, smoothing, i, near, required) + ", needs " +
                                    std::to_string(required.particles) + "; " +
                                    detail::remedy(line, smoothing, i, required.particles));
    });

    Operators<Scalar> of_line{detail::banded<Scalar>(all_near),
                              knows_both ? detail::banded<Scalar>(all_near) : Operator<Scalar>()};

    const auto alone = [&](Index i) {
        const Range& near = all_near[static_cast<std::size_t>(i)];
        try {
            const Answer weights = rule(neighbourhood(line, smoothing, i, near));
            detail::set_rows(of_line, i, &near, i - near.first, weights, Scalar(1 / smoothing.h(i)));
        } catch (const SingularNeighbourhood& singular) {
            throw FailedComputation(
                detail::census(line, smoothing, i, near, required) + " (" + std::to_string(i - near.first) +
                " on the left, " + std::to_string(near.last - 1 - i) + " on the right), but " +
                singular.what() + "; take a larger --smoothing or particles that lie farther apart");
        }
    };
    const auto together = [&](Index i) {
        if constexpr (takes_packs) {
            const Range* const near = all_near.data() + i;
            Index left = 0, right = 0;
            for (Index lane = 0; lane < Pack::lanes && i + lane < N; ++lane) {
                left = std::max(left, i + lane - near[lane].first);
                right = std::max(right, near[lane].last - 1 - (i + lane));
            }
            if (i < left || i + Pack::lanes + right > N || left + 1 + right > most_in_pack) return false;
            try {
                const auto weights = rule(neighbourhoods(line, smoothing, i, left, right));
                detail::set_rows(of_line, i, near, left, weights, 1 / smoothing.pack_of_h(i));
                return true;
            } catch (const SingularNeighbourhood&) {
                return false;
            }
        }
        return false;
    };
    for_each_index((N + Pack::lanes - 1) / Pack::lanes, [&](Index pack) {
        const Index first = pack * Pack::lanes, last = std::min(first + Pack::lanes, N);
        if (together(first)) return;
        for (Index i = first; i < last; ++i) alone(i);
    });
    if constexpr (!knows_both) {
        Operator<Scalar> D2 = second(of_line.D);
        of_line.D2.swap(D2);
    }
    return of_line;
}

}  // namespace particles
