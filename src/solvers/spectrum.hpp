#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "base/vector_width.hpp"
#include "solvers/arnoldi.hpp"
#include "solvers/banded.hpp"

namespace solvers {

/// All eigenvalues of a square matrix, in no particular order, by LAPACK's dgeev.
/// \throws base::FailedComputation where an entry is not finite or the iteration does not converge
std::vector<std::complex<double>> eigenvalues(Eigen::MatrixXd K);

/// All eigenvalues of \f$K x = \lambda M x\f$, both matrices symmetric and M positive definite, in increasing
/// order, by LAPACK's dsygv.
/// \throws base::FailedComputation where M is not positive definite or the iteration does not converge
std::vector<double> symmetric_eigenvalues(Eigen::MatrixXd K, Eigen::MatrixXd M);

/// The largest eigenvalues of K⁻¹, whose inverses are the eigenvalues of K nearest to zero, with their
/// eigenvectors, by largest().
/// \param factors of K \param N rows of K \param count at most N − 2
/// \throws base::FailedComputation where the iteration does not converge
Eigenpairs largest_of_inverse(const BandedFactors<double>& factors, Eigen::Index N, Eigen::Index count);

}  // namespace solvers
