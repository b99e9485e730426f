#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <complex>
#include <vector>

#include "particles/errors.hpp"

namespace solvers {

/// All eigenvalues of a square matrix, in no particular order.
/// \throws particles::FailedComputation where the iteration does not converge
inline std::vector<std::complex<double>> eigenvalues(const Eigen::MatrixXd& K) {
    const Eigen::EigenSolver<Eigen::MatrixXd> spectrum(K, /* computeEigenvectors */ false);
    if (spectrum.info() != Eigen::Success)
        throw particles::FailedComputation("the eigenvalues of a matrix of " + std::to_string(K.rows()) +
                                           " rows were not found");
    return {spectrum.eigenvalues().begin(), spectrum.eigenvalues().end()};
}

/// All eigenvalues of \f$K x = \lambda M x\f$, both matrices symmetric and M positive definite, in increasing order.
/// \throws particles::FailedComputation where M is not positive definite or the iteration does not converge
inline std::vector<double> symmetric_eigenvalues(const Eigen::MatrixXd& K, const Eigen::MatrixXd& M) {
    if (Eigen::LLT<Eigen::MatrixXd>(M).info() != Eigen::Success)
        throw particles::FailedComputation("the mass matrix is not positive definite");
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> spectrum(K, M, Eigen::EigenvaluesOnly);
    if (spectrum.info() != Eigen::Success)
        throw particles::FailedComputation("the eigenvalues of a symmetric problem of " +
                                           std::to_string(K.rows()) + " rows were not found");
    return {spectrum.eigenvalues().begin(), spectrum.eigenvalues().end()};
}

}  // namespace solvers
