#include "solvers/sparse_spectrum.hpp"

#include <algorithm>
#include <string>

#include "base/errors.hpp"
#include "solvers/sparse.hpp"

// g++ 12 suspects Spectra of using memory that its own classes have freed.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpragmas"
#pragma GCC diagnostic ignored "-Wunknown-warning-option"
#pragma GCC diagnostic ignored "-Wuse-after-free"
#include <Spectra/GenEigsSolver.h>

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
    Spectra::GenEigsSolver<InverseTimes> solver(inverse, count, std::min(K.rows(), 2 * count + 20));
    solver.init();
    solver.compute(Spectra::SortRule::LargestMagn, 1000, 1e-10);
    if (solver.info() != Spectra::CompInfo::Successful)
        throw base::FailedComputation("the lowest " + std::to_string(count) + " eigenvalues of a matrix of " +
                                      std::to_string(K.rows()) + " rows were not found");
    return solver.eigenvalues();
}

}  // namespace solvers

#pragma GCC diagnostic pop
