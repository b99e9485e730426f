#pragma once

#include <Eigen/Core>
#include <complex>
#include <functional>

namespace solvers {

/// Eigenvalues, and a column for each eigenvector.
struct Eigenpairs {
    Eigen::VectorXcd values;
    Eigen::MatrixXcd vectors;
};

/// Writes A x at y. \param x N numbers
using Operator = std::function<void(const double* x, double* y)>;

/// The largest eigenvalues of a matrix A, in the order of decreasing size, by Arnoldi's method with implicit
/// restarts (Spectra).
/// \param N rows of A \param count at most N − 2 \param basis vectors of the Krylov space, at most N
/// \throws base::FailedComputation where the iteration does not converge
Eigenpairs largest(const Operator& A, Eigen::Index N, Eigen::Index count, Eigen::Index basis);

}  // namespace solvers
