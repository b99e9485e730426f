#pragma once

#include <lapacke.h>

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "particles/errors.hpp"

/// Thin faces over libraries that solve linear systems and eigenvalue problems.
namespace solvers {

/// Solves A x = b for a matrix whose entries lie near the diagonal: LAPACK's banded factorisation with row exchanges, after
/// the rows are scaled to a largest entry of 1 (rows of boundary conditions and of equilibrium differ by powers of δ).
///
/// The bytes of the result do not depend on the number of threads if the BLAS is told to use one (see use_one_blas_thread()):
/// a narrow band gains nothing from more.
/// \param A square, N × N; its bandwidths are found from its entries
/// \param b N numbers
/// \throws particles::FailedComputation where A is singular to working precision, saying how nearly, or an entry is not finite
inline Eigen::ArrayXd solve_banded(const Eigen::SparseMatrix<double, Eigen::RowMajor>& A,
                                   const Eigen::ArrayXd& b) {
    using Entry = Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator;
    const auto N = static_cast<lapack_int>(A.rows());
    lapack_int below = 0, above = 0;
    Eigen::ArrayXd scale = Eigen::ArrayXd::Zero(N);
    for (lapack_int i = 0; i < N; ++i)
        for (Entry entry(A, i); entry; ++entry) {
            below = std::max(below, i - static_cast<lapack_int>(entry.col()));
            above = std::max(above, static_cast<lapack_int>(entry.col()) - i);
            scale[i] = std::max(scale[i], std::abs(entry.value()));
        }

    // Band storage: column j of A stands in column j, its diagonal entry in row below + above; the first rows take the fill
    // of the factorisation.
    const lapack_int height = 2 * below + above + 1;
    Eigen::MatrixXd band = Eigen::MatrixXd::Zero(height, N);
    for (lapack_int i = 0; i < N; ++i)
        for (Entry entry(A, i); entry; ++entry)
            band(below + above + i - entry.col(), entry.col()) = entry.value() / scale[i];
    Eigen::ArrayXd x = b / scale;
    if (!band.allFinite() || !x.allFinite())
        throw particles::FailedComputation("the linear system has rows that are zero or not finite");

    const double norm = band.cwiseAbs().colwise().sum().maxCoeff();
    std::vector<lapack_int> pivots(static_cast<std::size_t>(N));
    double reciprocal_condition = 0;
    const lapack_int zero_pivot =
        LAPACKE_dgbtrf(LAPACK_COL_MAJOR, N, N, below, above, band.data(), height, pivots.data());
    if (zero_pivot == 0)
        LAPACKE_dgbcon(LAPACK_COL_MAJOR, '1', N, below, above, band.data(), height, pivots.data(), norm,
                       &reciprocal_condition);
    if (!(reciprocal_condition > std::numeric_limits<double>::epsilon()))
        throw particles::FailedComputation(
            "the linear system of " + std::to_string(N) + " unknowns is singular (reciprocal condition " +
            particles::shown(reciprocal_condition, 2) + "); take another formulation or other particles");
    LAPACKE_dgbtrs(LAPACK_COL_MAJOR, 'N', N, below, above, 1, band.data(), height, pivots.data(), x.data(),
                   N);
    return x;
}

/// The same in any other precision, by Eigen's sparse factorisation with row exchanges in the order of the unknowns, which keeps
/// the band. \throws particles::FailedComputation where a pivot vanishes or an entry is not finite
template <class Scalar>
Eigen::Array<Scalar, Eigen::Dynamic, 1> solve_banded(const Eigen::SparseMatrix<Scalar, Eigen::RowMajor>& A,
                                                     const Eigen::Array<Scalar, Eigen::Dynamic, 1>& b) {
    using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
    Vector scale = Vector::Zero(A.rows());
    for (Eigen::Index i = 0; i < A.rows(); ++i)
        for (typename Eigen::SparseMatrix<Scalar, Eigen::RowMajor>::InnerIterator entry(A, i); entry;
             ++entry) {
            using std::abs;
            const Scalar size = abs(entry.value());
            if (size > scale[i]) scale[i] = size;
        }
    const Vector per_row = scale.cwiseInverse();
    if (!per_row.allFinite() || !b.allFinite())
        throw particles::FailedComputation("the linear system has rows that are zero or not finite");
    const Eigen::SparseMatrix<Scalar> scaled = per_row.asDiagonal() * A;
    Eigen::SparseLU<Eigen::SparseMatrix<Scalar>, Eigen::NaturalOrdering<int>> factors(scaled);
    if (factors.info() != Eigen::Success)
        throw particles::FailedComputation(
            "the linear system of " + std::to_string(A.rows()) +
            " unknowns is singular; take another formulation or other particles");
    return factors.solve(Vector(b.matrix().cwiseProduct(per_row))).array();
}

}  // namespace solvers
