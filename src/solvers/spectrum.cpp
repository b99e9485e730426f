#include "solvers/spectrum.hpp"

#include <algorithm>

// Spectra frees inside of its own classes what g++ 12 then suspects of being used.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpragmas"
#pragma GCC diagnostic ignored "-Wunknown-warning-option"
#pragma GCC diagnostic ignored "-Wuse-after-free"
#include <Spectra/GenEigsSolver.h>

namespace solvers {

namespace {

/// What Spectra asks of a matrix; here the inverse of a factorised one.
struct Inverse {
    using Scalar = double;
    const BandedFactors<double>& factors;
    Eigen::Index N;

    [[nodiscard]] Eigen::Index rows() const { return N; }
    [[nodiscard]] Eigen::Index cols() const { return N; }
    void perform_op(const double* x, double* y) const {
        Eigen::Map<Eigen::ArrayXd>(y, N) = factors.solve(Eigen::Map<const Eigen::ArrayXd>(x, N));
    }
};

}  // namespace

Eigenpairs largest_of_inverse(const BandedFactors<double>& factors, Eigen::Index N, Eigen::Index count) {
    Inverse inverse{factors, N};
    Spectra::GenEigsSolver<Inverse> solver(inverse, count, std::min(N, 2 * count + 2));
    solver.init();
    solver.compute(Spectra::SortRule::LargestMagn, 1000, 1e-10);
    if (solver.info() != Spectra::CompInfo::Successful)
        throw base::FailedComputation("the lowest " + std::to_string(count) + " eigenvalues of a matrix of " +
                                      std::to_string(N) + " rows were not found");
    return {solver.eigenvalues(), solver.eigenvectors()};
}

}  // namespace solvers

#pragma GCC diagnostic pop
