#pragma once

#include <Eigen/Core>

#include "base/vector_width.hpp"

namespace solvers {

namespace detail {

/// Most rows of a matrix of n rows: 20 if n is not known when compiling.
constexpr int most_rows(int n) {
    return n == Eigen::Dynamic ? 20 : n;
}

}  // namespace detail

/// The factors \f$A = L\,\operatorname{diag}(p)\,L^T\f$ of a small symmetric matrix, Cholesky's without
/// roots: p holds the pivots, and L has a diagonal of ones. Eigen's factors take twice the time of these
/// loops on the matrix of a local fit, and far longer to compile.
/// \tparam Scalar a real type
/// \tparam n number of rows; if it is not known when compiling, at most 20
template <class Scalar, int n = Eigen::Dynamic>
class Cholesky {
    static constexpr int most = detail::most_rows(n);

  public:
    using Matrix = Eigen::Matrix<Scalar, n, n, Eigen::RowMajor, most, most>;
    using Vector = Eigen::Matrix<Scalar, n, 1, Eigen::ColMajor, most, 1>;

    /// \param A symmetric; only its upper triangle is read
    explicit Cholesky(const Matrix& A) : U_(A), pivots_(A.rows()), per_pivot_(A.rows()) {
        for (Eigen::Index i = 0; i < size(); ++i) {
            for (Eigen::Index k = 0; k < i; ++k) {
                const Scalar factor = U_(k, i) * pivots_[k];
                for (Eigen::Index j = i; j < size(); ++j) U_(i, j) -= factor * U_(k, j);
            }
            pivots_[i] = U_(i, i);
            per_pivot_[i] = 1 / pivots_[i];
            for (Eigen::Index j = i; j < size(); ++j) U_(i, j) *= per_pivot_[i];
        }
    }

    [[nodiscard]] Eigen::Index size() const { return U_.rows(); }

    /// p, the squares of the diagonal of Cholesky's own factor. All are positive if A is positive definite.
    [[nodiscard]] const Vector& pivots() const { return pivots_; }

    /// Solution X of \f$A X = B\f$, for all columns together.
    /// \param B a vector, or a matrix whose columns are many and stored by rows
    template <class Columns>
    [[nodiscard]] typename Columns::PlainObject solve(const Eigen::MatrixBase<Columns>& B) const {
        typename Columns::PlainObject X = B;
        const auto row = [&X](Eigen::Index i) -> decltype(auto) {
            if constexpr (Columns::ColsAtCompileTime == 1)
                return X[i];
            else
                return X.row(i);
        };
        for (Eigen::Index i = 0; i < size(); ++i)
            for (Eigen::Index k = 0; k < i; ++k) row(i) -= U_(k, i) * row(k);
        for (Eigen::Index i = size() - 1; i >= 0; --i) {
            row(i) *= per_pivot_[i];
            for (Eigen::Index k = i + 1; k < size(); ++k) row(i) -= U_(i, k) * row(k);
        }
        return X;
    }

  private:
    Matrix U_;  // Lᵀ
    Vector pivots_, per_pivot_;
};

}  // namespace solvers
