
#include "solvers/sparse.hpp"

#include <Eigen/UmfPackSupport>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <unsupported/Eigen/IterativeSolvers>

#include "base/errors.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"

namespace solvers {

namespace {

/// The triangular factors of a sparse matrix, with row exchanges.
class Factors {
  public:
    struct Settings {
        /// METIS leaves fewer entries in the factors than AMD, which is faster itself.
        int ordering = UMFPACK_ORDERING_METIS;
        bool refined = true;  ///< solve() refines its result iteratively
    };
    Factors(const SparseRows& A, const Settings& settings) : columns_(A) {
        auto& control = factors_.umfpackControl();
        // Particles are neighbours of each other, or nearly always.
        control[UMFPACK_STRATEGY] = UMFPACK_STRATEGY_SYMMETRIC;
        control[UMFPACK_ORDERING] = settings.ordering;
        control[UMFPACK_SCALE] = UMFPACK_SCALE_NONE;
        if (!settings.refined) control[UMFPACK_IRSTEP] = 0;
        factors_.compute(columns_);
        if (factors_.info() != Eigen::Success) {
            fault_ = factors_.out_of_memory() ? "does not fit into memory" : "is singular";
            return;
        }
        // Nearly every vector reveals a singular matrix; the right-hand side may be one of the few that do
        // not.
        const Eigen::VectorXd probe = Eigen::VectorXd::NullaryExpr(A.rows(), [](Eigen::Index k) {
            return std::cos(static_cast<double>(k) * static_cast<double>(k));
        });
        const double growth = solve(probe).cwiseAbs().maxCoeff();
        if (!(growth < 1 / (100 * std::numeric_limits<double>::epsilon()))) fault_ = "is singular";
    }

    /// Why the matrix cannot be solved with; empty if it can.
    [[nodiscard]] const std::string& fault() const { return fault_; }
    [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const { return factors_.solve(b); }

  private:
    /// Long indices: the factors of a million particles have more entries than an int can count.
    using Columns = Eigen::SparseMatrix<double, Eigen::ColMajor, SuiteSparse_long>;
    struct Umfpack : Eigen::UmfPackLU<Columns> {
        [[nodiscard]] bool out_of_memory() const { return m_fact_errorCode < 0; }
    };

    Columns columns_;
    Umfpack factors_;
    std::string fault_;
};

/// Factors with the interface of a preconditioner of Eigen's iterations.
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

void scale_rows(SparseRows& A, Eigen::VectorXd& b, SparseRows& nearest) {
    const auto values = [](SparseRows& matrix, Eigen::Index row) {
        const int first = matrix.outerIndexPtr()[row];
        return Eigen::Map<Eigen::ArrayXd>(matrix.valuePtr() + first, matrix.outerIndexPtr()[row + 1] - first);
    };
    base::for_each_index(A.rows(), [&](Eigen::Index row) {
        double largest = 0;
        for (const double entry : values(A, row)) largest = std::max(largest, std::abs(entry));
        const double scale = 1 / largest;
        values(A, row) *= scale;
        b[row] *= scale;
        if (nearest.rows() > 0) values(nearest, row) *= scale;
    });
}

double relative_residual(const SparseRows& A, const Eigen::VectorXd& x, const Eigen::VectorXd& b) {
    Eigen::VectorXd residual(A.rows()), size(A.rows());
    base::for_each_index(A.rows(), [&](Eigen::Index row) {
        double sum = 0, terms = 0;
        for (SparseRows::InnerIterator entry(A, row); entry; ++entry) {
            sum += entry.value() * x[entry.col()];
            terms += std::abs(entry.value() * x[entry.col()]);
        }
        residual[row] = std::abs(b[row] - sum);
        size[row] = terms;
    });
    const double largest = size.maxCoeff() + b.cwiseAbs().maxCoeff();
    return largest == 0 ? 0 : residual.maxCoeff() / largest;
}

std::optional<Eigen::VectorXd> iterated(const SparseRows& A, const Eigen::VectorXd& b,
                                        const SparseRows& nearest) {
    const int ordering = A.rows() > 100000 ? UMFPACK_ORDERING_METIS : UMFPACK_ORDERING_AMD;
    const Factors factors(nearest, {.ordering = ordering, .refined = false});
    if (!factors.fault().empty()) return {};
    Eigen::GMRES<SparseRows, Preconditioner> gmres;
    gmres.preconditioner().take(factors);
    gmres.compute(A);
    gmres.set_restart(100);
    gmres.setMaxIterations(200);
    Eigen::VectorXd x = Eigen::VectorXd::Zero(b.size());
    // A solution far larger than this means that A is singular and nearest is not.
    const double most = 1e6 * factors.solve(b).cwiseAbs().maxCoeff();
    // Where round-off has separated the two residuals, restart from the true one.
    for (const double tolerance : {1e-14, 1e-4, 1e-4}) {
        gmres.setTolerance(tolerance);
        x = gmres.solveWithGuess(b, x).eval();
        if (gmres.info() != Eigen::Success || !(x.cwiseAbs().maxCoeff() <= most)) return {};
        if (relative_residual(A, x, b) < largest_residual) return x;
    }
    return {};
}

Eigen::VectorXd solve_sparse(SparseRows&& A, Eigen::VectorXd b, SparseRows&& nearest) {
    const auto refuse = [&](const std::string& why) {
        throw base::FailedComputation(
            "the linear system of " + std::to_string(A.rows()) + " unknowns " + why +
            "; take another scaling factor, another smoothing length or other particles");
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

struct SparseFactors::Factorised {
    Factorised(const SparseRows& A, Eigen::VectorXd row_scale)
        : scale(std::move(row_scale)), factors(A, {}) {}

    Eigen::VectorXd scale;
    Factors factors;
};

SparseFactors::SparseFactors(SparseRows A) {
    Eigen::VectorXd scale = Eigen::VectorXd::Ones(A.rows());
    SparseRows none;
    scale_rows(A, scale, none);
    factorised_ = std::make_unique<Factorised>(A, std::move(scale));
    if (const std::string& fault = factorised_->factors.fault(); !fault.empty())
        throw base::FailedComputation("the linear system of " + std::to_string(A.rows()) + " unknowns " +
                                      fault + "; take another smoothing length or other particles");
}
SparseFactors::~SparseFactors() = default;

Eigen::VectorXd SparseFactors::solve(Eigen::VectorXd b) const {
    b.array() *= factorised_->scale.array();
    return factorised_->factors.solve(b);
}

}  // namespace solvers
