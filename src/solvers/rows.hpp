#pragma once

#include <Eigen/SparseCore>
#include <vector>

namespace solvers {

/// A sparse matrix, stored by rows.
using SparseRows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// A matrix of zeros that stores 2 × 2 blocks: for two unknowns at each point, a block for each pair of
/// neighbours.
/// \param near neighbours of each point, in increasing order
/// \throws base::InvalidInput for more entries than an int can count
SparseRows rows_in_pairs(const std::vector<std::vector<int>>& near);

/// Writes a row of such a matrix: the factors of both unknowns at some points. Other entries keep their
/// values.
/// \param points in increasing order, neighbours of the row's point
void set_row(SparseRows& A, Eigen::Index row, const std::vector<int>& points, const Eigen::ArrayXd& first,
             const Eigen::ArrayXd& second);

}  // namespace solvers
