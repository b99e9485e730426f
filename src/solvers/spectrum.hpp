#pragma once

#include <lapacke.h>

#include <Eigen/Core>
#include <complex>
#include <string>
#include <vector>

#include "base/errors.hpp"
#include "solvers/banded.hpp"

namespace solvers {

/// All eigenvalues of a square matrix, in no particular order, by LAPACK's dgeev.
/// \throws base::FailedComputation where an entry is not finite or the iteration does not converge
inline std::vector<std::complex<double>> eigenvalues(Eigen::MatrixXd K) {
    const auto N = static_cast<lapack_int>(K.rows());
    Eigen::VectorXd real(N), imaginary(N);
    // A matrix without rows has no leading dimension that LAPACK would take.
    const lapack_int failed = N == 0 ? 0
                                     : LAPACKE_dgeev(LAPACK_COL_MAJOR, 'N', 'N', N, K.data(), N, real.data(),
                                                     imaginary.data(), nullptr, 1, nullptr, 1);
    if (failed != 0)
        throw base::FailedComputation("the eigenvalues of a matrix of " + std::to_string(N) +
                                      " rows were not found");
    std::vector<std::complex<double>> all;
    all.reserve(static_cast<std::size_t>(N));
    for (lapack_int k = 0; k < N; ++k) all.emplace_back(real[k], imaginary[k]);
    return all;
}

/// All eigenvalues of \f$K x = \lambda M x\f$, both matrices symmetric and M positive definite, in increasing order, by LAPACK's
/// dsygv.
/// \throws base::FailedComputation where M is not positive definite or the iteration does not converge
inline std::vector<double> symmetric_eigenvalues(Eigen::MatrixXd K, Eigen::MatrixXd M) {
    const auto N = static_cast<lapack_int>(K.rows());
    std::vector<double> all(static_cast<std::size_t>(N));
    const lapack_int failed =
        N == 0 ? 0 : LAPACKE_dsygv(LAPACK_COL_MAJOR, 1, 'N', 'L', N, K.data(), N, M.data(), N, all.data());
    if (failed > N) throw base::FailedComputation("the mass matrix is not positive definite");
    if (failed != 0)
        throw base::FailedComputation("the eigenvalues of a symmetric problem of " + std::to_string(N) +
                                      " rows were not found");
    return all;
}

/// Eigenvalues, and a column for each eigenvector.
struct Eigenpairs {
    Eigen::VectorXcd values;
    Eigen::MatrixXcd vectors;
};

/// The largest eigenvalues of K⁻¹, those of K that are nearest to zero, with their eigenvectors: Arnoldi's method with implicit
/// restarts (Spectra).
/// \param factors of K \param N rows of K \param count at most N − 2
/// \throws base::FailedComputation where the iteration does not converge
Eigenpairs largest_of_inverse(const BandedFactors<double>& factors, Eigen::Index N, Eigen::Index count);

}  // namespace solvers
