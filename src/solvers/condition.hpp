#pragma once

#include <Eigen/Core>

namespace solvers {

/// Reciprocal of the condition number, in the 2-norm, of a small symmetric matrix that is scaled to a unit
/// diagonal: its smallest eigenvalue over its largest. 0 if the matrix is not positive definite, or not
/// finite.
double reciprocal_condition(const Eigen::MatrixXd& A);

}  // namespace solvers
