#include "solvers/sparse_spectrum.hpp"

#include <algorithm>

#include "solvers/arnoldi.hpp"
#include "solvers/sparse.hpp"

namespace solvers {

Eigen::VectorXcd largest_of_inverse(const SparseRows& K, const SparseRows& M, Eigen::Index count) {
    const SparseFactors factors(K);
    const Eigen::Index N = K.rows();
    const auto inverse_times_M = [&](const double* x, double* y) {
        Eigen::Map<Eigen::VectorXd>(y, N) = factors.solve(M * Eigen::Map<const Eigen::VectorXd>(x, N));
    };
    return largest(inverse_times_M, N, count, std::min(N, 2 * count + 20)).values;
}

}  // namespace solvers
