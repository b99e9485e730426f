#pragma once

#include <Eigen/SparseCore>
#include <cstddef>
#include <vector>

#include "base/vector_width.hpp"

namespace solvers {

/// A sparse matrix, stored by rows.
using SparseRows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// A matrix of zeros that stores square blocks: for some unknowns at each point, a block for each pair of
/// neighbours. The unknowns of a point follow one another.
/// \param near neighbours of each point that has rows, in increasing order
/// \param unknowns number at each point \param points number of those that have columns
/// \throws base::InvalidInput for more entries than an int can count
SparseRows rows_in_blocks(const std::vector<std::vector<int>>& near, int unknowns, Eigen::Index points);

/// The same where all points have rows.
inline SparseRows rows_in_blocks(const std::vector<std::vector<int>>& near, int unknowns) {
    return rows_in_blocks(near, unknowns, static_cast<Eigen::Index>(near.size()));
}

/// Writes a row of such a matrix: the factors of the unknowns at some points. Other entries keep their
/// values.
/// \param points in increasing order, neighbours of the row's point
/// \param factors for each unknown an array with a number for each of the points
template <class... Factors>
void set_row(SparseRows& A, Eigen::Index row, const std::vector<int>& points, const Factors&... factors) {
    constexpr int unknowns = sizeof...(factors);
    Eigen::Index place = A.outerIndexPtr()[row];
    for (std::size_t j = 0; j < points.size(); ++j) {
        while (A.innerIndexPtr()[place] != unknowns * points[j]) place += unknowns;
        double* entry = A.valuePtr() + place;
        ((*entry++ = factors[static_cast<Eigen::Index>(j)]), ...);
    }
}

}  // namespace solvers
