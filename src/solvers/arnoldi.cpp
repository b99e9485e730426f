#include "solvers/arnoldi.hpp"

#include <string>

#include "base/errors.hpp"

// g++ 12 suspects Spectra of using memory that its own classes have freed.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpragmas"
#pragma GCC diagnostic ignored "-Wunknown-warning-option"
#pragma GCC diagnostic ignored "-Wuse-after-free"
#include <Spectra/GenEigsSolver.h>

namespace solvers {

namespace {

/// An operator as Spectra takes it.
struct Matrix {
    using Scalar = double;
    const Operator& A;
    Eigen::Index N;

    [[nodiscard]] Eigen::Index rows() const { return N; }
    [[nodiscard]] Eigen::Index cols() const { return N; }
    void perform_op(const double* x, double* y) const { A(x, y); }
};

}  // namespace

Eigenpairs largest(const Operator& A, Eigen::Index N, Eigen::Index count, Eigen::Index basis) {
    Matrix matrix{A, N};
    Spectra::GenEigsSolver<Matrix> solver(matrix, count, basis);
    solver.init();
    solver.compute(Spectra::SortRule::LargestMagn, 1000, 1e-10);
    if (solver.info() != Spectra::CompInfo::Successful)
        throw base::FailedComputation("the lowest " + std::to_string(count) + " eigenvalues of a matrix of " +
                                      std::to_string(N) + " rows were not found");
    return {solver.eigenvalues(), solver.eigenvectors()};
}

}  // namespace solvers

#pragma GCC diagnostic pop
