#include "solvers/spectrum.hpp"

#include <lapacke.h>

#include <algorithm>
#include <string>

#include "base/errors.hpp"

namespace solvers {

std::vector<std::complex<double>> eigenvalues(Eigen::MatrixXd K) {
    const auto N = static_cast<lapack_int>(K.rows());
    Eigen::VectorXd real(N), imaginary(N);
    // LAPACK refuses a matrix without rows.
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

std::vector<double> symmetric_eigenvalues(Eigen::MatrixXd K, Eigen::MatrixXd M) {
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

Eigenpairs largest_of_inverse(const BandedFactors<double>& factors, Eigen::Index N, Eigen::Index count) {
    const auto inverse = [&](const double* x, double* y) {
        Eigen::Map<Eigen::ArrayXd>(y, N) = factors.solve(Eigen::Map<const Eigen::ArrayXd>(x, N));
    };
    // So many vectors converge without a restart where eigenvalues grow with the squares of their numbers.
    return largest(inverse, N, count, std::min(N, 2 * count + 10));
}

}  // namespace solvers
