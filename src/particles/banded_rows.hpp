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

/// Numbers for which entries are kept: a few more than asked for, so that values and columns, with what
/// malloc writes before them, fill large pages.
inline Index in_large_pages(Index entries) {
    constexpr Index pages = base::large_page / sizeof(int), before = 16;
    return entries < pages / 2 ? entries : (entries + before + pages - 1) / pages * pages - before;
}

/// Gives a matrix room for its entries, whose rows begin where its outer index says; in the memory that it
/// has if there is enough.
template <class Scalar>
void make_room(Rows<Scalar>& D) {
    const Index entries = D.outerIndexPtr()[D.rows()];
    if (entries > D.data().allocatedSize()) {
        D.reserve(in_large_pages(entries));
        prefer_large_pages(D.valuePtr(), D.data().allocatedSize());
        prefer_large_pages(D.innerIndexPtr(), D.data().allocatedSize());
    }
    D.resizeNonZeros(entries);
}

/// Gives a matrix rows of some sizes. Columns and values are not yet written.
/// \param write_sizes writes the number of entries of each row, from an address on
/// \throws InvalidInput for more entries than an int can count
template <class Scalar, class WriteSizes>
void shape(Rows<Scalar>& D, Index rows, Index columns, const WriteSizes& write_sizes) {
    D.resize(rows, columns);
    int* const start = D.outerIndexPtr();
    write_sizes(start + 1);
    Index entries = 0;
    for (Index i = 1; i <= rows; ++i) {
        entries += start[i];
        start[i] = static_cast<int>(entries);
    }
    if (entries > std::numeric_limits<int>::max())
        throw InvalidInput("an operator of " + std::to_string(entries) +
                           " weights is too large; take fewer particles or a smaller smoothing length");
    make_room(D);
}

/// Gives a matrix rows of the same sizes as another's.
template <class Scalar>
void shape_as(Rows<Scalar>& D, const Rows<Scalar>& other) {
    D.resize(other.rows(), other.cols());
    std::copy_n(other.outerIndexPtr(), other.rows() + 1, D.outerIndexPtr());
    make_room(D);
}

/// A matrix with a column for each particle and a row for some of them, which stores the columns near[i].
/// Columns and values are not yet written.
/// \throws InvalidInput for more entries than an int can count
inline Rows<double> allocated(const std::vector<std::vector<int>>& near, const Range& rows) {
    Rows<double> D;
    shape(D, rows.size(), static_cast<Index>(near.size()), [&](int* size) {
        for (Index i = rows.first; i < rows.last; ++i)
            *size++ = static_cast<int>(near[static_cast<std::size_t>(i)].size());
    });
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

/// \f$D_{ii}\f$, or zero where it is not stored. It is found without a search where the columns of its row
/// are consecutive.
template <class Scalar>
Scalar diagonal_entry(const Rows<Scalar>& D, Index i) {
    const Index start = D.outerIndexPtr()[i], last = D.outerIndexPtr()[i + 1] - 1;
    if (!D.isCompressed() || start > last) return D.coeff(i, i);
    const Index own = start + i - D.innerIndexPtr()[start];
    const bool found = own >= start && own <= last && D.innerIndexPtr()[own] == i;
    return found ? D.valuePtr()[own] : D.coeff(i, i);
}

/// \f$\sum_j D_{ij}\,[B_j - B_i]\f$ for row i. Where its columns are consecutive, they are not read.
template <class Scalar>
Scalar on_differences(const Rows<Scalar>& D, Index i, const Scalar* B) {
    const Index start = D.outerIndexPtr()[i];
    const Index size = D.isCompressed() ? D.outerIndexPtr()[i + 1] - start : D.innerNonZeroPtr()[i];
    const int* const column = D.innerIndexPtr() + start;
    const Scalar* const weight = D.valuePtr() + start;
    const Scalar B_i = B[i];
    Scalar sum(0);
    if (size > 0 && column[size - 1] - column[0] == size - 1) {
        const Scalar* const near = B + column[0];
        for (Index k = 0; k < size; ++k) sum += weight[k] * (near[k] - B_i);
    } else {
        for (Index k = 0; k < size; ++k) sum += weight[k] * (B[column[k]] - B_i);
    }
    return sum;
}

/// Numbers of particles on either side of its own that the particles of a Pack reach, at most.
struct Sides {
    Index left, right;
};

/// \param near neighbours of each particle of the Pack \param i its first particle, of N
/// \return nothing where the Pack would reach beyond an end of the line, or more particles than its columns
///        hold
inline std::optional<Sides> sides_of_pack(const Range* near, Index i, Index N) {
    if (i + Pack::lanes > N) return {};
    Sides sides{0, 0};
    for (Index lane = 0; lane < Pack::lanes; ++lane) {
        sides.left = std::max(sides.left, i + lane - near[lane].first);
        sides.right = std::max(sides.right, near[lane].last - 1 - (i + lane));
    }
    const bool on_the_line = i >= sides.left && i + Pack::lanes + sides.right <= N;
    if (!on_the_line || sides.left + 1 + sides.right > most_in_pack) return {};
    return sides;
}

/// Calls `work(particles)` for each block of eight Packs that has one of `rows` of N, in parallel. Blocks
/// begin at multiples of their size, so that a row has the same bytes whatever other rows are computed.
template <class Work>
void for_each_block(const Range& rows, Index N, const Work& work) {
    constexpr Index block = Index{8} * Pack::lanes;
    const Index before = rows.first / block;
    for_each_index((rows.last + block - 1) / block - before, [&](Index b) {
        const Index first = (before + b) * block;
        work(Range{first, std::min(first + block, N)});
    });
}

/// Calls `together(i)` for each Pack of these particles that has one of `rows`, with its first particle i;
/// where it returns false, calls `alone(i)` for each of the rows in the Pack.
template <class Together, class Alone>
void for_each_pack(const Range& particles, const Range& rows, const Together& together, const Alone& alone) {
    constexpr Index lanes = Pack::lanes;
    const Range some{std::max(particles.first, rows.first), std::min(particles.last, rows.last)};
    for (Index first = some.first / lanes * lanes; first < some.last; first += lanes) {
        if (together(first)) continue;
        for (Index i = std::max(first, some.first); i < std::min(first + lanes, some.last); ++i) alone(i);
    }
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

/// The columns that a row stores.
template <class Scalar>
Range columns_of(const Rows<Scalar>& D, Index row) {
    const int *const start = D.outerIndexPtr(), *const column = D.innerIndexPtr();
    return {column[start[row]], column[start[row + 1] - 1] + 1};
}

/// Do the columns of each of these rows begin, and end, no earlier than those of the row before it? With one
/// smoothing length they do.
template <class Scalar>
bool in_order(const Rows<Scalar>& D, const Range& rows) {
    Range before{0, 0};
    for (Index i = std::max<Index>(rows.first, 0); i < std::min(rows.last, D.rows()); ++i) {
        const Range here = columns_of(D, i);
        if (here.first < before.first || here.last < before.last) return false;
        before = here;
    }
    return true;
}

/// The columns of a row of A B, which has its diagonal entry.
/// \param ordered whether the rows of B that meet the row of A are in_order()
template <class Scalar>
Range columns_of_product(const Rows<Scalar>& A, const Rows<Scalar>& B, Index row, bool ordered) {
    Range all{row, row + 1};
    const auto add = [&](Index j) {
        const Range of_B = columns_of(B, j);
        all = {std::min(all.first, of_B.first), std::max(all.last, of_B.last)};
    };
    const Range of_A = columns_of(A, row);
    add(of_A.first);
    add(of_A.last - 1);
    for (Index j = of_A.first + 1; !ordered && j < of_A.last - 1; ++j) add(j);
    return all;
}

/// \f$(A B)_{i,i+q} = \sum_a A_{i,i+a}\,B_{i+a,i+q}\f$, computed from the diagonals of A and B for a block of
/// rows at a time. The diagonal entry is minus the sum of the row's others.
/// \param memory another matrix, neither A nor B, whose memory becomes the product's
template <class Scalar>
Rows<Scalar> product(const Rows<Scalar>& A, const Rows<Scalar>& B, Rows<Scalar>&& memory = {}) {
    const Index N = A.rows();
    Rows<Scalar> AB;
    AB.swap(memory);
    constexpr Index tile = 64, block = 16;
    const Index tiles = (N + tile - 1) / tile;
    const auto rows_of_B = [&](const Range& rows) {
        const Sides reach = sides_of_rows(A, rows);
        return Range{rows.first - reach.left, rows.last + reach.right};
    };
    shape(AB, N, N, [&](int* size) {
        for_each_index(tiles, [&](Index t) {
            const Range rows{t * tile, std::min((t + 1) * tile, N)};
            const bool ordered = in_order(B, rows_of_B(rows));
            for (Index i = rows.first; i < rows.last; ++i)
                size[i] = static_cast<int>(columns_of_product(A, B, i, ordered).size());
        });
    });

    using Block = Eigen::Array<Scalar, block, 1>;
    for_each_index(tiles, [&](Index t) {
        const Range rows{t * tile, (t + 1) * tile};
        const Sides reach = sides_of_rows(A, rows);
        const Diagonals<Scalar> of_B(B, rows_of_B(rows));
        const bool ordered = in_order(B, rows_of_B(rows));
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
                const Range range = columns_of_product(A, B, i, ordered);
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
