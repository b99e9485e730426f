#include "solvers/condition.hpp"

#include <lapacke.h>

#include <algorithm>

namespace solvers {

double reciprocal_condition(const Eigen::MatrixXd& A) {
    if (A.rows() == 0 || !A.allFinite() || !(A.diagonal().minCoeff() > 0)) return 0;
    const auto scale = A.diagonal().cwiseSqrt().cwiseInverse().asDiagonal();
    Eigen::MatrixXd scaled = scale * A * scale;
    const auto n = static_cast<lapack_int>(A.rows());
    Eigen::VectorXd eigenvalues(n);  // in increasing order
    if (LAPACKE_dsyev(LAPACK_COL_MAJOR, 'N', 'L', n, scaled.data(), n, eigenvalues.data()) != 0) return 0;
    return std::max(eigenvalues[0] / eigenvalues[n - 1], 0.0);
}

}  // namespace solvers
