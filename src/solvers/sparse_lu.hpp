#pragma once

#include <Eigen/SparseLU>

#include "base/quad.hpp"

namespace solvers {

/// LU factors of a sparse matrix in its own order of unknowns, by Eigen. They are compiled once for each
/// scalar, in sparse_lu_long.cpp and sparse_lu_quad.cpp, since Eigen's factorisation takes long to compile.
/// \tparam Scalar long double or base::Quad
template <class Scalar>
class SparseLU {
  public:
    using Matrix = Eigen::SparseMatrix<Scalar>;
    using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

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

template <class Scalar>
SparseLU<Scalar>::SparseLU(const Matrix& A) : factors_(A) {}

template <class Scalar>
auto SparseLU<Scalar>::solve(const Vector& b) const -> Vector {
    return factors_.solve(b);
}

template <class Scalar>
auto SparseLU<Scalar>::solve_transposed(const Vector& b) -> Vector {
    return factors_.transpose().solve(b);
}

extern template class SparseLU<long double>;
extern template class SparseLU<base::Quad>;

}  // namespace solvers
