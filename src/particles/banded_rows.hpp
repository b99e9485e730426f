#pragma once

#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "base/errors.hpp"
#include "base/index.hpp"
#include "base/memory.hpp"
#include "base/pack.hpp"
#include "base/parallel.hpp"
#include "particles/neighbourhood.hpp"

namespace particles {

using base::everywhere;
using base::FailedComputation;
using base::for_each_index;
using base::Index;
using base::InvalidInput;
using base::Pack;
using base::prefer_large_pages;

/// A formulation has given weights that are infinite or no numbers.
class WeightsNotFinite : public FailedComputation {
  public:
    WeightsNotFinite() : FailedComputation("its weights are not finite") {}
};

/// The fast way behind the operators: compressed rows of consecutive columns, written in place, a Pack of
/// particles at a time.
namespace banded {

/// A sparse matrix by rows; here each row stores consecutive columns.
template <class Scalar>
using Rows = Eigen::SparseMatrix<Scalar, Eigen::RowMajor>;

/// A matrix with a column for each particle and a row for some of them, which stores the columns near[i].
/// Columns and values are not yet written.
/// \throws InvalidInput for more entries than an int can count
template <class Scalar, class Neighbours>
Rows<Scalar> allocated(const std::vector<Neighbours>& near, const Range& rows) {
    const auto stored = [&](Index i) { return static_cast<Index>(near[static_cast<std::size_t>(i)].size()); };
    Index entries = 0;
    for (Index i = rows.first; i < rows.last; ++i) entries += stored(i);
    if (entries > std::numeric_limits<int>::max())
        throw InvalidInput("an operator of " + std::to_string(entries) +
                           " weights is too large; take fewer particles or a smaller smoothing length");
    Rows<Scalar> D(rows.size(), static_cast<Index>(near.size()));
    D.outerIndexPtr()[0] = 0;
    for (Index i = 0; i < rows.size(); ++i)
        D.outerIndexPtr()[i + 1] = D.outerIndexPtr()[i] + static_cast<int>(stored(rows.first + i));
    D.resizeNonZeros(entries);
    prefer_large_pages(D.valuePtr(), entries);
    prefer_large_pages(D.innerIndexPtr(), entries);
    return D;
}

/// Writes the columns of a row. \return the address of its first value
template <class Scalar>
Scalar* begin_row(Rows<Scalar>& D, Index row, const Range& near) {
    const Index start = D.outerIndexPtr()[row];
    std::iota(D.innerIndexPtr() + start, D.innerIndexPtr() + start + near.size(),
              static_cast<int>(near.first));
    return D.valuePtr() + start;
}
template <class Scalar>
Scalar* begin_row(Rows<Scalar>& D, Index row, const std::vector<int>& near) {
    const Index start = D.outerIndexPtr()[row];
    std::copy(near.begin(), near.end(), D.innerIndexPtr() + start);
    return D.valuePtr() + start;
}

/// Sets the diagonal entry of a row to minus the sum of the others. An entry may be a Pack or an array, of
/// several rows.
/// \param own place of the diagonal entry in the row
template <class Scalar>
void annihilate_constants(Scalar* row, Index size, Index own) {
    row[own] -= row[own];
    for (Index k = 0; k < own; ++k) row[own] -= row[k];
    for (Index k = own + 1; k < size; ++k) row[own] -= row[k];
}

/// Writes a row: weights on differences, times their unit.
/// \param near the particle's neighbours \param own its place among them
/// \throws WeightsNotFinite as the diagonal entry shows, a sum of all others
template <class Scalar, class Neighbours, class Weights>
void set_row(Rows<Scalar>& D, Index row, const Neighbours& near, Index own, const Weights& weights,
             const Scalar& unit) {
    if (weights.size() != static_cast<Index>(near.size()))
        throw InvalidInput("a formulation has given " + std::to_string(weights.size()) + " weights for " +
                           std::to_string(near.size()) + " neighbours");
    Scalar* const values = begin_row(D, row, near);
    Eigen::Map<Column<Scalar>>(values, weights.size()) = weights * unit;
    annihilate_constants(values, weights.size(), own);
    using std::isfinite;
    if (!isfinite(values[own])) throw WeightsNotFinite();
}

/// The same for those particles of a Pack that have a row. Weights of particles that a lane does not reach
/// are skipped. Nothing is written where a row is not finite.
/// \param i first particle of the Pack \param near neighbours of each of its particles
/// \param rows particles that have a row
/// \throws WeightsNotFinite for any lane
inline void set_rows(Rows<double>& D, const Range& rows, Index i, const Range* near, Index own,
                     const Column<Pack>& weights, const Pack& unit) {
    Column<Pack> all = weights * unit;
    annihilate_constants(all.data(), all.size(), own);
    if (!everywhere(abs(all[own]) < Pack(std::numeric_limits<double>::infinity()))) throw WeightsNotFinite();
    const Index first = std::max<Index>(rows.first - i, 0),
                last = std::min<Index>(rows.last - i, Pack::lanes);
    for (auto lane = static_cast<int>(first); lane < last; ++lane) {
        const Index skipped = near[lane].first - (i + lane - own), size = near[lane].size();
        double* const row = begin_row(D, i + lane - rows.first, near[lane]);
        const Pack* const from = all.data() + skipped;
        for (Index k = 0; k < size; ++k) row[k] = from[k][lane];
    }
}

/// Numbers of particles on either side of its own that the particles of a Pack reach, at most.
struct Sides {
    Index left, right;
};

/// \return nothing where the Pack would reach beyond an end of the line, or more particles than its columns
///        hold
inline std::optional<Sides> sides_of_pack(const std::vector<Range>& near, Index i) {
    const auto N = static_cast<Index>(near.size());
    Sides sides{0, 0};
    for (Index j = i; j < std::min(i + Pack::lanes, N); ++j) {
        const Range& near_j = near[static_cast<std::size_t>(j)];
        sides.left = std::max(sides.left, j - near_j.first);
        sides.right = std::max(sides.right, near_j.last - 1 - j);
    }
    const bool on_the_line = i >= sides.left && i + Pack::lanes + sides.right <= N;
    if (!on_the_line || sides.left + 1 + sides.right > most_in_pack) return {};
    return sides;
}

/// The particles of all Packs that have one of `rows`. Packs begin at multiples of their size, so that a row
/// has the same bytes whatever other rows are computed.
inline Range whole_packs(const Range& rows, Index N) {
    constexpr Index lanes = Pack::lanes;
    return {rows.first / lanes * lanes, std::min((rows.last + lanes - 1) / lanes * lanes, N)};
}

/// Calls `together(i)` for each Pack that has one of `rows`, in parallel, with its first particle i; where it
/// returns false, calls `alone(i)` for each of the rows in the Pack.
template <class Together, class Alone>
void for_each_pack(const Range& rows, const Together& together, const Alone& alone) {
    const Index before = rows.first / Pack::lanes;
    for_each_index((rows.last + Pack::lanes - 1) / Pack::lanes - before, [&](Index pack) {
        const Index first = (before + pack) * Pack::lanes;
        if (together(first)) return;
        for (Index i = std::max(first, rows.first); i < std::min(first + Pack::lanes, rows.last); ++i)
            alone(i);
    });
}

/// How far some rows of a matrix reach to either side of the diagonal, at most.
template <class Scalar>
Sides sides_of_rows(const Rows<Scalar>& A, const Range& rows) {
    const int *const start = A.outerIndexPtr(), *const column = A.innerIndexPtr();
    Sides sides{0, 0};
    for (Index i = std::max<Index>(rows.first, 0); i < std::min(rows.last, A.rows()); ++i) {
        sides.left = std::max<Index>(sides.left, i - column[start[i]]);
        sides.right = std::max<Index>(sides.right, column[start[i + 1] - 1] - i);
    }
    return sides;
}

/// Some rows of a matrix by diagonals, \f$A_{i,i+a}\f$ for −left ≤ a ≤ right, so that the entries of a
/// diagonal follow one another in memory. Entries that the matrix does not store are zero, and so are rows
/// beyond it.
template <class Scalar>
class Diagonals {
  public:
    Index left, right;

    Diagonals(const Rows<Scalar>& A, const Range& rows) : first_(rows.first) {
        const int *const start = A.outerIndexPtr(), *const column = A.innerIndexPtr();
        const Range stored{std::max<Index>(rows.first, 0), std::min(rows.last, A.rows())};
        const Sides sides = sides_of_rows(A, rows);
        left = sides.left;
        right = sides.right;
        entries_.setZero(rows.size(), left + 1 + right);
        for (Index i = stored.first; i < stored.last; ++i) {
            Scalar* const row = entries_.data() + (i - first_);
            for (int k = start[i]; k < start[i + 1]; ++k)
                row[entries_.rows() * (left + column[k] - i)] = A.valuePtr()[k];
        }
    }

    /// Entries of diagonal a in `count` rows, from i on.
    template <int count>
    [[nodiscard]] auto entries(Index i, Index a) const {
        return entries_.col(left + a).template segment<count>(i - first_);
    }

  private:
    Index first_;
    Eigen::Array<Scalar, Eigen::Dynamic, Eigen::Dynamic> entries_;
};

/// \f$(A B)_{i,i+q} = \sum_a A_{i,i+a}\,B_{i+a,i+q}\f$, computed from the diagonals of A and B for a block of
/// rows at a time. The diagonal entry is minus the sum of the row's others.
template <class Scalar>
Rows<Scalar> product(const Rows<Scalar>& A, const Rows<Scalar>& B) {
    const Index N = A.rows();
    const auto stored = [](const Rows<Scalar>& D, Index i) -> Range {
        return {D.innerIndexPtr()[D.outerIndexPtr()[i]], D.innerIndexPtr()[D.outerIndexPtr()[i + 1] - 1] + 1};
    };
    std::vector<Range> near(static_cast<std::size_t>(N));
    for_each_index(N, [&](Index i) {
        Range& range = near[static_cast<std::size_t>(i)];
        range = {i, i + 1};
        for (Index j = stored(A, i).first; j < stored(A, i).last; ++j) {
            range.first = std::min(range.first, stored(B, j).first);
            range.last = std::max(range.last, stored(B, j).last);
        }
    });

    Rows<Scalar> AB = allocated<Scalar>(near, {0, N});
    constexpr Index tile = 64, block = 16;
    using Block = Eigen::Array<Scalar, block, 1>;
    for_each_index((N + tile - 1) / tile, [&](Index t) {
        const Range rows{t * tile, (t + 1) * tile};
        const Sides reach = sides_of_rows(A, rows);
        const Diagonals<Scalar> of_B(B, {rows.first - reach.left, rows.last + reach.right});
        std::optional<Diagonals<Scalar>> others;
        if (&A != &B) others.emplace(A, rows);
        const Diagonals<Scalar>& of_A = others ? *others : of_B;
        const Index left = reach.left + of_B.left, right = reach.right + of_B.right;
        std::vector<Block> sums(static_cast<std::size_t>(left + 1 + right));
        for (Index b = rows.first; b < std::min(rows.last, N); b += block) {
            for (Index q = -left; q <= right; ++q) {
                Block sum = Block::Zero();
                const Index least = std::max(-reach.left, q - of_B.right),
                            most = std::min(reach.right, q + of_B.left);
                for (Index a = least; a <= most; ++a)
                    sum += of_A.template entries<block>(b, a) * of_B.template entries<block>(b + a, q - a);
                sums[static_cast<std::size_t>(left + q)] = sum;
            }
            annihilate_constants(sums.data(), left + 1 + right, left);
            for (Index i = b; i < std::min({b + block, rows.last, N}); ++i) {
                const Range& range = near[static_cast<std::size_t>(i)];
                Scalar* const row = begin_row(AB, i, range);
                const Scalar* const from =
                    sums[static_cast<std::size_t>(left + range.first - i)].data() + (i - b);
                for (Index k = 0; k < range.size(); ++k) row[k] = from[block * k];
            }
        }
    });
    return AB;
}

}  // namespace banded
}  // namespace particles
