#include "solvers/sparse_spectrum.hpp"

#include <algorithm>

#include "solvers/arnoldi.hpp"
#include "solvers/sparse.hpp"

namespace solvers {

namespace {

/// The operator K⁻¹ M, as Spectra takes it.
struct InverseTimes {
    using Scalar = double;
    const SparseFactors& factors;
    const SparseRows& M;

    [[nodiscard]] Eigen::Index rows() const { return M.rows(); }
    [[nodiscard]] Eigen::Index cols() const { return M.rows(); }
    void perform_op(const double* x, double* y) const {
        const Eigen::Map<const Eigen::VectorXd> from(x, M.rows());
        Eigen::Map<Eigen::VectorXd>(y, M.rows()) = factors.solve(M * from);
    }
};

}  // namespace

Eigen::VectorXcd largest_of_inverse(const SparseRows& K, const SparseRows& M, Eigen::Index count) {
    const SparseFactors factors(K);
    InverseTimes inverse{factors, M};
    return arnoldi(inverse, count, std::min(K.rows(), 2 * count + 20)).eigenvalues();
}

}  // namespace solvers
