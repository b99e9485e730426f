#pragma once

#include <Eigen/SparseCore>
#include <memory>

#include "base/vector_width.hpp"

/// Thin faces over libraries that solve linear systems and eigenvalue problems.
namespace solvers {

/// LU factors of a matrix whose entries lie near the diagonal, with row exchanges, after each row is scaled
/// to a largest entry of 1: rows of boundary conditions and of equilibrium differ by powers of δ.
///
/// Double precision takes LAPACK's banded factorisation. Long double and quad take Eigen's sparse one in
/// quadruple precision, which keeps the band when the unknowns keep their order. The result has the same
/// bytes on any number of threads if BLAS uses one thread (see use_one_blas_thread()); more threads would not
/// speed up a narrow band.
/// \tparam Scalar double, long double or base::Quad
template <class Scalar = double>
class BandedFactors {
  public:
    using Matrix = Eigen::SparseMatrix<Scalar, Eigen::RowMajor>;
    using Vector = Eigen::Array<Scalar, Eigen::Dynamic, 1>;

    /// \param A square, N × N; its bandwidths are found from its entries
    /// \throws base::FailedComputation where a pivot vanishes, a row is zero or an entry is not finite
    explicit BandedFactors(const Matrix& A);

    /// \param b N numbers
    /// \return x of \f$A x = b\f$
    /// \throws base::FailedComputation where b is not finite
    [[nodiscard]] Vector solve(const Vector& b) const;

    /// Estimate of \f$1/(\|A\|\,\|A^{-1}\|)\f$ in the 1-norm, the rows of A scaled. It costs about five
    /// solutions.
    [[nodiscard]] Scalar reciprocal_condition() const;

    /// \throws base::FailedComputation with the reciprocal condition, where A is singular to working
    ///        precision
    void require_regular() const;

  private:
    struct Library;
    Vector scale_;
    std::shared_ptr<Library> library_;
};

/// Solves \f$A x = b\f$ for a matrix whose entries lie near the diagonal.
/// \param A square, N × N \param b N numbers
/// \throws base::FailedComputation where A is singular to working precision or an entry is not finite
template <class Scalar>
Eigen::Array<Scalar, Eigen::Dynamic, 1> solve_banded(const Eigen::SparseMatrix<Scalar, Eigen::RowMajor>& A,
                                                     const Eigen::Array<Scalar, Eigen::Dynamic, 1>& b) {
    const BandedFactors<Scalar> factors(A);
    factors.require_regular();
    return factors.solve(b);
}
inline Eigen::ArrayXd solve_banded(const Eigen::SparseMatrix<double, Eigen::RowMajor>& A,
                                   const Eigen::ArrayXd& b) {
    return solve_banded<double>(A, b);
}

}  // namespace solvers
