#pragma once

#include <lapacke.h>

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "base/errors.hpp"
#include "base/memory.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"

/// Thin faces over libraries that solve linear systems and eigenvalue problems.
namespace solvers {

namespace detail {

/// 1 over the largest entry of each row: rows of boundary conditions and of equilibrium differ by powers of δ.
/// \throws base::FailedComputation for a row of zeros and for entries that are not finite
template <class Scalar>
Eigen::Array<Scalar, Eigen::Dynamic, 1> row_scales(const Eigen::SparseMatrix<Scalar, Eigen::RowMajor>& A) {
    using std::abs, std::isfinite;
    Eigen::Array<Scalar, Eigen::Dynamic, 1> scale(A.rows());
    base::for_each_index(A.rows(), [&](Eigen::Index i) {
        Scalar largest(0);
        bool finite = true;
        for (typename Eigen::SparseMatrix<Scalar, Eigen::RowMajor>::InnerIterator entry(A, i); entry;
             ++entry) {
            const Scalar size = abs(entry.value());
            finite = finite && isfinite(size);
            if (size > largest) largest = size;
        }
        scale[i] = 1 / largest;
        if (!finite || !isfinite(scale[i]))
            throw base::FailedComputation("row " + std::to_string(i) +
                                          " of the linear system is zero or not finite; take another "
                                          "smoothing length or other particles");
    });
    return scale;
}

[[noreturn]] inline void refuse(Eigen::Index unknowns, double reciprocal_condition) {
    throw base::FailedComputation(
        "the linear system of " + std::to_string(unknowns) + " unknowns is singular (reciprocal condition " +
        base::shown(reciprocal_condition, 2) + "); take another formulation or other particles");
}

template <class Scalar>
void require_finite(const Eigen::Array<Scalar, Eigen::Dynamic, 1>& b) {
    if (!b.allFinite())
        throw base::FailedComputation("the linear system has a right-hand side that is not finite");
}

}  // namespace detail

/// Factors of a matrix whose entries lie near the diagonal: by LAPACK's banded factorisation with row exchanges, after the rows are
/// scaled to a largest entry of 1; in another precision than double by Eigen's sparse factorisation, which in the order of the
/// unknowns keeps the band.
///
/// The bytes of the result do not depend on the number of threads if the BLAS is told to use one (see use_one_blas_thread()):
/// a narrow band gains nothing from more.
template <class Scalar = double>
class BandedFactors {
  public:
    /// \param A square, N × N
    /// \throws base::FailedComputation where a pivot vanishes or an entry is not finite
    explicit BandedFactors(const Eigen::SparseMatrix<Scalar, Eigen::RowMajor>& A)
        : scale_(detail::row_scales(A)) {
        const Eigen::SparseMatrix<Scalar> scaled = scale_.matrix().asDiagonal() * A;
        for (Eigen::Index j = 0; j < scaled.cols(); ++j)
            norm_ = std::max<Scalar>(norm_, scaled.col(j).cwiseAbs().sum());
        factors_.compute(scaled);
        if (factors_.info() != Eigen::Success) detail::refuse(A.rows(), 0);
    }

    [[nodiscard]] Eigen::Array<Scalar, Eigen::Dynamic, 1> solve(
        const Eigen::Array<Scalar, Eigen::Dynamic, 1>& b) const {
        detail::require_finite(b);
        return factors_.solve((b * scale_).matrix().eval()).array();
    }

    /// Estimate of 1/(‖A‖ ‖A⁻¹‖) in the 1-norm, the rows of A scaled. It takes about five solutions.
    [[nodiscard]] Scalar reciprocal_condition() const { return 1 / (norm_ * norm_of_inverse()); }

    /// \throws base::FailedComputation where A is singular to working precision, saying how nearly
    void require_regular() const {
        const Scalar reciprocal = reciprocal_condition();
        if (!(reciprocal > std::numeric_limits<Scalar>::epsilon()))
            detail::refuse(scale_.size(), static_cast<double>(reciprocal));
    }

  private:
    using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

    /// Hager's estimate of ‖A⁻¹‖ in the 1-norm, with Higham's alternating vector beside it, as LAPACK has it for double.
    [[nodiscard]] Scalar norm_of_inverse() const {
        const Eigen::Index N = scale_.size();
        Vector x = Vector::Constant(N, 1 / Scalar(static_cast<double>(N)));
        Scalar estimate(0);
        for (int k = 0; k < 5; ++k) {
            const Vector y = factors_.solve(x);
            if (!y.allFinite()) return std::numeric_limits<Scalar>::infinity();
            estimate = std::max<Scalar>(estimate, y.cwiseAbs().sum());
            const Vector signs = y.unaryExpr([](const Scalar& entry) { return Scalar(entry < 0 ? -1 : 1); });
            const Vector z = factors_.transpose().solve(signs);
            Eigen::Index j = 0;
            if (z.cwiseAbs().maxCoeff(&j) <= z.dot(x)) break;
            x = Vector::Unit(N, j);
        }
        for (Eigen::Index i = 0; i < N; ++i)
            x[i] = (i % 2 == 0 ? 1 : -1) *
                   (1 + Scalar(static_cast<double>(i)) / std::max<Eigen::Index>(N - 1, 1));
        const Vector y = factors_.solve(x);
        return std::max<Scalar>(estimate, 2 * y.cwiseAbs().sum() / Scalar(static_cast<double>(3 * N)));
    }

    Eigen::Array<Scalar, Eigen::Dynamic, 1> scale_;
    Scalar norm_ = Scalar(0);
    mutable Eigen::SparseLU<Eigen::SparseMatrix<Scalar>, Eigen::NaturalOrdering<int>>
        factors_;  // for transpose()
};

template <>
class BandedFactors<double> {
  public:
    using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

    /// \param A square, N × N; its bandwidths are found from its entries
    /// \throws base::FailedComputation where a pivot vanishes or an entry is not finite
    explicit BandedFactors(const Matrix& A)
        : N_(static_cast<lapack_int>(A.rows())), scale_(detail::row_scales(A)), pivots_(N_) {
        for (lapack_int i = 0; i < N_; ++i) {
            const int *const column = A.innerIndexPtr(), *const start = A.outerIndexPtr();
            below_ = std::max(below_, i - column[start[i]]);
            above_ = std::max(above_, column[start[i + 1] - 1] - i);
        }
        // Band storage: column j of A stands in column j, its diagonal entry in row below + above; the first rows take the fill of
        // the factorisation.
        const lapack_int diagonal = below_ + above_;
        band_.resize(below_ + diagonal + 1, N_);
        base::prefer_large_pages(band_.data(), band_.size());
        constexpr lapack_int block = 1024;
        Eigen::ArrayXd norm_of_block((N_ + block - 1) / block);
        base::for_each_index(norm_of_block.size(), [&](Eigen::Index b) {
            const auto first = static_cast<lapack_int>(b) * block, last = std::min(first + block, N_);
            band_.middleCols(first, last - first).setZero();
            for (lapack_int i = std::max(first - below_, 0); i < std::min(last + below_, N_); ++i)
                for (Matrix::InnerIterator entry(A, i); entry; ++entry)
                    if (entry.col() >= first && entry.col() < last)
                        band_(diagonal + i - entry.col(), entry.col()) = entry.value() * scale_[i];
            norm_of_block[b] = band_.middleCols(first, last - first).cwiseAbs().colwise().sum().maxCoeff();
        });
        const lapack_int zero_pivot = LAPACKE_dgbtrf_work(LAPACK_COL_MAJOR, N_, N_, below_, above_,
                                                          band_.data(), height(), pivots_.data());
        norm_ = norm_of_block.maxCoeff();
        if (zero_pivot != 0) detail::refuse(N_, 0);
    }

    /// Estimate of 1/(‖A‖ ‖A⁻¹‖) in the 1-norm, the rows of A scaled. It takes five solutions.
    [[nodiscard]] double reciprocal_condition() const { return 1 / (norm_ * norm_of_inverse()); }

    /// \throws base::FailedComputation where A is singular to working precision, saying how nearly
    void require_regular() const {
        const double reciprocal = reciprocal_condition();
        if (!(reciprocal > std::numeric_limits<double>::epsilon())) detail::refuse(N_, reciprocal);
    }

    [[nodiscard]] Eigen::ArrayXd solve(const Eigen::ArrayXd& b) const {
        detail::require_finite(b);
        Eigen::ArrayXd x = b * scale_;
        substitute('N', x);
        return x;
    }

  private:
    [[nodiscard]] lapack_int height() const { return static_cast<lapack_int>(band_.rows()); }

    void substitute(char transposed, Eigen::ArrayXd& x) const {
        LAPACKE_dgbtrs_work(LAPACK_COL_MAJOR, transposed, N_, below_, above_, 1, band_.data(), height(),
                            pivots_.data(), x.data(), N_);
    }

    /// Higham's estimate of ‖A⁻¹‖ in the 1-norm; dgbcon, which estimates the same, takes a time that grows with N².
    [[nodiscard]] double norm_of_inverse() const {
        Eigen::ArrayXd x(N_), v(N_);
        Eigen::ArrayXi signs(N_);
        std::array<lapack_int, 3> state{};
        double estimate = 0;
        for (lapack_int wanted = 0;;) {
            LAPACKE_dlacn2_work(N_, v.data(), x.data(), signs.data(), &estimate, &wanted, state.data());
            if (wanted == 0) return x.allFinite() ? estimate : std::numeric_limits<double>::infinity();
            substitute(wanted == 1 ? 'N' : 'T', x);
        }
    }

    lapack_int N_, below_ = 0, above_ = 0;
    Eigen::ArrayXd scale_;
    Eigen::MatrixXd band_;
    Eigen::ArrayXi pivots_;
    double norm_ = 0;
};

/// Solves A x = b for a matrix whose entries lie near the diagonal.
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
