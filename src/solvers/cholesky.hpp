#pragma once

#include <Eigen/Cholesky>

#include "base/vector_width.hpp"

namespace solvers {

/// Cholesky factors \f$A = L\,L^T\f$ of a small symmetric matrix, of 20 rows at most. They are compiled here,
/// once for each scalar, since Eigen's factorisation takes long to compile.
/// \tparam Scalar double, long double or base::Quad
template <class Scalar>
class Cholesky {
  public:
    using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 20, 20>;
    using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1, Eigen::ColMajor, 20, 1>;

    /// \param A symmetric, n × n; only its lower triangle is read
    explicit Cholesky(const Matrix& A);

    /// Whether every pivot is positive.
    [[nodiscard]] bool succeeded() const { return factors_.info() == Eigen::Success; }

    /// L in the lower triangle; above it stands what is left of A.
    [[nodiscard]] const Matrix& L() const { return factors_.matrixLLT(); }

    /// \return x of \f$A x = b\f$
    [[nodiscard]] Vector solve(const Vector& b) const;

  private:
    Eigen::LLT<Matrix> factors_;
};

}  // namespace solvers
