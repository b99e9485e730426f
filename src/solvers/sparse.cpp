
#include "solvers/sparse.hpp"

#include <unsupported/Eigen/IterativeSolvers>

namespace solvers {

namespace {

/// Factors in the shape in which Eigen's iterations take a preconditioner.
class Preconditioner {
  public:
    void take(const Factors& factors) { factors_ = &factors; }
    template <class Matrix>
    Preconditioner& compute(const Matrix& /*A*/) {
        return *this;
    }
    [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const { return factors_->solve(b); }
    [[nodiscard]] static Eigen::ComputationInfo info() { return Eigen::Success; }

  private:
    const Factors* factors_ = nullptr;
};

}  // namespace

std::optional<Eigen::VectorXd> iterated(const SparseRows& A, const Eigen::VectorXd& b,
                                        const SparseRows& nearest) {
    const int ordering = A.rows() > 100000 ? UMFPACK_ORDERING_METIS : UMFPACK_ORDERING_AMD;
    const Factors factors(nearest, {.ordering = ordering, .refined = false});
    if (!factors.fault().empty()) return {};
    Eigen::GMRES<SparseRows, Preconditioner> gmres;
    gmres.preconditioner().take(factors);
    gmres.compute(A);
    gmres.set_restart(20);
    gmres.setMaxIterations(60);
    Eigen::VectorXd x = Eigen::VectorXd::Zero(b.size());
    // Far larger than the first guess is x only where A is singular and nearest is not.
    const double most = 1e6 * factors.solve(b).cwiseAbs().maxCoeff();
    // Where round-off was felt, again from the true residual.
    for (const double tolerance : {1e-14, 1e-4, 1e-4}) {
        gmres.setTolerance(tolerance);
        x = gmres.solveWithGuess(b, x).eval();
        if (gmres.info() != Eigen::Success || !(x.cwiseAbs().maxCoeff() <= most)) return {};
        if (relative_residual(A, x, b) < largest_residual) return x;
    }
    return {};
}

Eigen::VectorXd solve_sparse(SparseRows A, Eigen::VectorXd b, SparseRows nearest) {
    const auto refuse = [&](const std::string& why) {
        throw base::FailedComputation("the linear system of " + std::to_string(A.rows()) + " unknowns " +
                                      why + "; take another scaling factor or other particles");
    };
    scale_rows(A, b, nearest);
    for (Eigen::Index row = 0; row < A.rows(); ++row)
        if (!std::isfinite(A.row(row).sum() + b[row]))
            refuse("has a row " + std::to_string(row) + " that is zero or not finite");
    if (nearest.rows() > 0)
        if (const auto x = iterated(A, b, nearest)) return *x;

    const Factors factors(A, {});
    if (!factors.fault().empty()) refuse(factors.fault());
    Eigen::VectorXd x = factors.solve(b);
    const double residual = relative_residual(A, x, b);
    if (!(residual < largest_residual))
        refuse("was not solved (relative residual " + base::shown(residual, 2) + ")");
    return x;
}

}  // namespace solvers
