#pragma once

#include <Eigen/SparseLU>

#include "base/quad.hpp"
#include "base/vector_width.hpp"

namespace solvers {

/// LU factors of a sparse matrix in its own order of unknowns, by Eigen. They are compiled in a file of their
/// own, sparse_lu.cpp, since Eigen's factorisation takes long to compile.
class SparseLU {
  public:
    using Matrix = Eigen::SparseMatrix<base::Quad>;
    using Vector = Eigen::Matrix<base::Quad, Eigen::Dynamic, 1>;

    /// \param A square, N × N
    explicit SparseLU(const Matrix& A);

    /// Whether no pivot vanishes.
    [[nodiscard]] bool succeeded() const { return factors_.info() == Eigen::Success; }

    /// \return x of \f$A x = b\f$
    [[nodiscard]] Vector solve(const Vector& b) const;

    /// \return x of \f$A^T x = b\f$
    [[nodiscard]] Vector solve_transposed(const Vector& b);

  private:
    Eigen::SparseLU<Matrix, Eigen::NaturalOrdering<int>> factors_;
};

}  // namespace solvers
