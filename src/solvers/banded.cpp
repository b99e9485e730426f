#include "solvers/banded.hpp"

#include <lapacke.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/errors.hpp"
#include "base/memory.hpp"
#include "base/parallel.hpp"
#include "base/quad.hpp"
#include "base/text.hpp"
#include "solvers/sparse_lu.hpp"

namespace solvers {

namespace {

/// 1 over the largest entry of each row.
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
            throw base::FailedComputation(
                "row " + std::to_string(i) +
                " of the linear system is zero or not finite; take another smoothing length or other particles");
    });
    return scale;
}

[[noreturn]] void refuse(Eigen::Index unknowns, double reciprocal_condition) {
    throw base::FailedComputation("the linear system of " + std::to_string(unknowns) +
                                  " unknowns is singular (reciprocal condition " +
                                  base::shown(reciprocal_condition, 2) +
                                  "); take another smoothing length, another formulation or other particles");
}

/// Hager's estimate of \f$\|A^{-1}\|\f$ in the 1-norm, with Higham's alternating vector beside it, as in
/// LAPACK's dlacn2. It costs about five solutions.
/// \param solve \f$A^{-1} x\f$ \param solve_transposed \f$A^{-T} x\f$
template <class Numbers, class Solve, class SolveTransposed>
typename Numbers::Scalar norm_of_inverse(Eigen::Index N, const Solve& solve,
                                         const SolveTransposed& solve_transposed) {
    using Real = typename Numbers::Scalar;
    const auto real = [](Eigen::Index count) { return Real(static_cast<double>(count)); };
    Numbers x = Numbers::Constant(N, 1 / real(N));
    Real estimate(0);
    for (int k = 0; k < 5; ++k) {
        const Numbers y = solve(x);
        if (!y.allFinite()) return std::numeric_limits<Real>::infinity();
        estimate = std::max<Real>(estimate, y.cwiseAbs().sum());
        const Numbers signs = y.unaryExpr([](const Real& entry) { return Real(entry < 0 ? -1 : 1); });
        const Numbers z = solve_transposed(signs);
        Eigen::Index j = 0;
        if (z.cwiseAbs().maxCoeff(&j) <= z.dot(x)) break;
        x = Numbers::Unit(N, j);
    }
    for (Eigen::Index i = 0; i < N; ++i)
        x[i] = (i % 2 == 0 ? 1 : -1) * (1 + real(i) / real(std::max<Eigen::Index>(N - 1, 1)));
    const Numbers y = solve(x);
    return std::max<Real>(estimate, 2 * y.cwiseAbs().sum() / real(3 * N));
}

}  // namespace

/// Eigen's sparse factorisation of the scaled matrix, in quadruple precision.
template <class Scalar>
struct BandedFactors<Scalar>::Library {
    using Quad = base::Quad;
    using Columns = SparseLU::Matrix;
    using Numbers = SparseLU::Vector;

    Eigen::Index N = 0;
    Quad norm = Quad(0);
    SparseLU factors;

    Library(const Matrix& A, const Vector& scale)
        : Library(Columns(Matrix(scale.matrix().asDiagonal() * A).template cast<Quad>())) {}
    explicit Library(const Columns& scaled) : N(scaled.rows()), factors(scaled) {
        for (Eigen::Index j = 0; j < scaled.cols(); ++j)
            norm = std::max<Quad>(norm, scaled.col(j).cwiseAbs().sum());
        if (!factors.succeeded()) refuse(N, 0);
    }

    [[nodiscard]] Vector solve(const Vector& b) const {
        return factors.solve(b.template cast<Quad>().matrix()).array().template cast<Scalar>();
    }

    [[nodiscard]] Quad norm_of_inverse() {
        return solvers::norm_of_inverse<Numbers>(
            N, [this](const Numbers& x) { return factors.solve(x); },
            [this](const Numbers& x) { return factors.solve_transposed(x); });
    }
};

/// LAPACK's banded factorisation of the scaled matrix.
template <>
struct BandedFactors<double>::Library {
    lapack_int N, below = 0, above = 0;
    Eigen::MatrixXd band;
    Eigen::ArrayXi pivots;
    double norm = 0;

    /// In band storage, column j of A stands in column j and its diagonal entry in row below + above; the
    /// factorisation fills the first rows.
    Library(const Matrix& A, const Vector& scale) : N(static_cast<lapack_int>(A.rows())), pivots(N) {
        for (lapack_int i = 0; i < N; ++i) {
            const int *const column = A.innerIndexPtr(), *const start = A.outerIndexPtr();
            below = std::max(below, i - column[start[i]]);
            above = std::max(above, column[start[i + 1] - 1] - i);
        }
        const lapack_int diagonal = below + above;
        band.resize(below + diagonal + 1, N);
        base::prefer_large_pages(band.data(), band.size());
        constexpr lapack_int block = 1024;
        Eigen::ArrayXd norm_of_block((N + block - 1) / block);
        base::for_each_index(norm_of_block.size(), [&](Eigen::Index b) {
            const auto first = static_cast<lapack_int>(b) * block, last = std::min(first + block, N);
            band.middleCols(first, last - first).setZero();
            for (lapack_int i = std::max(first - below, 0); i < std::min(last + below, N); ++i)
                for (Matrix::InnerIterator entry(A, i); entry; ++entry)
                    if (entry.col() >= first && entry.col() < last)
                        band(diagonal + i - entry.col(), entry.col()) = entry.value() * scale[i];
            norm_of_block[b] = band.middleCols(first, last - first).cwiseAbs().colwise().sum().maxCoeff();
        });
        const lapack_int zero_pivot =
            LAPACKE_dgbtrf_work(LAPACK_COL_MAJOR, N, N, below, above, band.data(), height(), pivots.data());
        norm = norm_of_block.maxCoeff();
        if (zero_pivot != 0) refuse(N, 0);
    }

    [[nodiscard]] Vector solve(const Vector& b) const { return substituted('N', b); }

    [[nodiscard]] double norm_of_inverse() const {
        return solvers::norm_of_inverse<Eigen::VectorXd>(
            N, [this](const Eigen::VectorXd& x) { return substituted('N', x); },
            [this](const Eigen::VectorXd& x) { return substituted('T', x); });
    }

  private:
    [[nodiscard]] lapack_int height() const { return static_cast<lapack_int>(band.rows()); }

    [[nodiscard]] Eigen::VectorXd substituted(char transposed, Eigen::VectorXd x) const {
        LAPACKE_dgbtrs_work(LAPACK_COL_MAJOR, transposed, N, below, above, 1, band.data(), height(),
                            pivots.data(), x.data(), N);
        return x;
    }
};

template <class Scalar>
BandedFactors<Scalar>::BandedFactors(const Matrix& A)
    : scale_(row_scales(A)), library_(std::make_shared<Library>(A, scale_)) {}

template <class Scalar>
typename BandedFactors<Scalar>::Vector BandedFactors<Scalar>::solve(const Vector& b) const {
    if (!b.allFinite())
        throw base::FailedComputation("the linear system has a right-hand side that is not finite");
    return library_->solve(b * scale_);
}

template <class Scalar>
Scalar BandedFactors<Scalar>::reciprocal_condition() const {
    return static_cast<Scalar>(1 / (library_->norm * library_->norm_of_inverse()));
}

template <class Scalar>
void BandedFactors<Scalar>::require_regular() const {
    const Scalar reciprocal = reciprocal_condition();
    if (!(reciprocal > std::numeric_limits<Scalar>::epsilon()))
        refuse(scale_.size(), static_cast<double>(reciprocal));
}

template class BandedFactors<double>;
template class BandedFactors<long double>;
template class BandedFactors<base::Quad>;

}  // namespace solvers
