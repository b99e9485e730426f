#include "fpm_in_space/section_2_literal_extension.hpp"

#include "solvers/spectrum.hpp"

namespace fpm_in_space::literal_extension {

double condition(const Table<double>& A) {
    const Index n = A.rows();
    Eigen::MatrixXd symmetric = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    symmetric.topRightCorner(n, n) = A;
    symmetric.bottomLeftCorner(n, n) = A.transpose();
    const auto sigma = solvers::symmetric_eigenvalues(symmetric, Eigen::MatrixXd::Identity(2 * n, 2 * n));
    return sigma.back() / sigma[static_cast<std::size_t>(n)];
}

FPM_IN_SPACE_LITERAL_EXTENSION(template, double, 1)
FPM_IN_SPACE_LITERAL_EXTENSION(template, double, 2)
FPM_IN_SPACE_LITERAL_EXTENSION(template, double, 3)
FPM_IN_SPACE_LITERAL_EXTENSION(template, base::Quad, 2)
FPM_IN_SPACE_LITERAL_EXTENSION(template, base::Quad, 3)

}  // namespace fpm_in_space::literal_extension
