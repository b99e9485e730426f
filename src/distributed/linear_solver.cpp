#include "distributed/linear_solver.hpp"

#include <petscksp.h>

#include <algorithm>
#include <chrono>
#include <optional>

#include "base/errors.hpp"
#include "base/text.hpp"
#include "solvers/sparse.hpp"

namespace distributed {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

using Solver = Owned<KSP, KSPDestroy>;
using Preconditioner = Owned<PC, PCDestroy>;

/// The size, relative to the largest of its row, above which an entry counts as strong for BoomerAMG.
constexpr const char* strong = "0.25";

/// An approximate inverse of A in two steps: first the equations at System::edge, which impose the conditions
/// as collocation does; then elements for the rest of the residual, which varies slowly. In the other order,
/// small errors of the elements in the forces at the edge would strongly bend a slender body.
class ByElements {
  public:
    ByElements(const System& system, int n) : system_(system) {
        MPI_Comm communicator = PetscObjectComm(reinterpret_cast<PetscObject>(static_cast<Mat>(system.A)));
        require(PCCreate(communicator, elements_.made()));
        require(PCSetOptionsPrefix(elements_, "elements_"));
        require(PCSetOperators(elements_, system.elements, system.elements));
        if (n == 1) {
            require(PCSetType(elements_, PCHYPRE));
            set_default("-elements_pc_hypre_boomeramg_strong_threshold", strong);
        } else {
            require(PCSetType(elements_, PCFIELDSPLIT));
            require(PCFieldSplitSetBlockSize(elements_, n));
            for (int k = 0; k < n; ++k) {
                const std::string field = "-elements_fieldsplit_" + std::to_string(k);
                set_default(field + "_ksp_type", "preonly");
                set_default(field + "_pc_type", "hypre");
                set_default(field + "_pc_hypre_boomeramg_strong_threshold", strong);
            }
        }
        require_options(PCSetFromOptions(elements_));
        require(PCSetUp(elements_));

        Owned<IS, ISDestroy> rows;
        require(ISCreateGeneral(communicator, petsc_int(static_cast<Index>(system.edge.size())),
                                system.edge.data(), PETSC_COPY_VALUES, rows.made()));
        require(MatCreateSubMatrix(system.A, rows, rows, MAT_INITIAL_MATRIX, A_edge_.made()));
        require(MatCreateVecs(A_edge_, x_edge_.made(), b_edge_.made()));
        require(VecDuplicate(system.b, first_.made()));
        require(VecDuplicate(system.b, rest_.made()));
        require(VecScatterCreate(rest_, rows, b_edge_, nullptr, to_edge_.made()));
        require(PCCreate(communicator, edge_.made()));
        require(PCSetOptionsPrefix(edge_, "edge_"));
        require(PCSetOperators(edge_, A_edge_, A_edge_));
        require(PCSetType(edge_, PCLU));
        require(PCFactorSetMatSolverType(edge_, MATSOLVERMUMPS));
        require_options(PCSetFromOptions(edge_));
        require(PCSetUp(edge_));
    }

    void apply(Vec b, Vec x) const {
        require(VecScatterBegin(to_edge_, b, b_edge_, INSERT_VALUES, SCATTER_FORWARD));
        require(VecScatterEnd(to_edge_, b, b_edge_, INSERT_VALUES, SCATTER_FORWARD));
        require(PCApply(edge_, b_edge_, x_edge_));
        require(VecSet(first_, 0));
        require(VecScatterBegin(to_edge_, x_edge_, first_, INSERT_VALUES, SCATTER_REVERSE));
        require(VecScatterEnd(to_edge_, x_edge_, first_, INSERT_VALUES, SCATTER_REVERSE));
        require(MatMult(system_.A, first_, rest_));
        require(VecAYPX(rest_, -1, b));
        require(VecPointwiseMult(rest_, system_.weights, rest_));
        require(PCApply(elements_, rest_, x));
        require(VecAXPY(x, 1, first_));
    }

  private:
    const System& system_;
    Preconditioner elements_, edge_;
    Matrix A_edge_;
    Vector first_, rest_, b_edge_, x_edge_;
    Owned<VecScatter, VecScatterDestroy> to_edge_;
};

PetscErrorCode apply_by_elements(PC preconditioner, Vec b, Vec x) {
    void* by_elements = nullptr;
    PetscCall(PCShellGetContext(preconditioner, &by_elements));
    static_cast<const ByElements*>(by_elements)->apply(b, x);
    return 0;
}

/// What is called at each iteration, and the first residual, of which it is given the share that is left.
struct Progress {
    const std::function<void(int, double)>& step;
    double first = 0;
};

PetscErrorCode monitor(KSP ksp, PetscInt iteration, PetscReal residual, void* context) {
    auto& progress = *static_cast<Progress*>(context);
    static_cast<void>(ksp);
    if (iteration == 0) progress.first = residual;
    if (progress.step)
        progress.step(static_cast<int>(iteration), progress.first > 0 ? residual / progress.first : 0);
    return 0;
}

/// The residual b − A x in maximum norms.
struct Residual {
    double of_terms = 1;  ///< over ‖A‖ ‖x‖ + ‖b‖: the backward error of x
    double of_given = 1;  ///< over ‖b‖: an estimate of x's error, large where A is nearly singular

    static constexpr double largest_error = 1e-5;

    [[nodiscard]] bool is_small() const {
        return of_terms < solvers::largest_residual && of_given < largest_error;
    }
    /// The factor by which it must shrink.
    [[nodiscard]] double wanted() const {
        return std::min(solvers::largest_residual / of_terms, largest_error / of_given);
    }
};

Residual residual_of(const System& system, Vec x) {
    Vector residual;
    require(VecDuplicate(system.b, residual.made()));
    require(MatMult(system.A, x, residual));
    require(VecAYPX(residual, -1, system.b));
    PetscReal left = 0, given = 0, size = 0, largest = 0;
    require(VecNorm(residual, NORM_INFINITY, &left));
    require(VecNorm(system.b, NORM_INFINITY, &given));
    require(MatNorm(system.A, NORM_INFINITY, &size));
    require(VecNorm(x, NORM_INFINITY, &largest));
    if (left == 0) return {0, 0};
    return {left / (size * largest + given), left / given};
}

/// What was tried: a solution, or why there is none.
struct Attempt {
    Vector x;
    std::string fault;
    bool nearly_singular = false;  ///< the backward error is small, but that of x may be large
};

Attempt attempt(const System& system, Mat preconditioner, int n, bool factorised, Report& report,
                const std::function<void(int, double)>& step) {
    MPI_Comm communicator = PetscObjectComm(reinterpret_cast<PetscObject>(static_cast<Mat>(system.A)));
    auto start = Clock::now();
    std::optional<ByElements> by_elements;  // outlives the solver
    Solver solver;
    PC preconditioning = nullptr;
    require(KSPCreate(communicator, solver.made()));
    require(KSPSetOperators(solver, system.A, preconditioner));
    require(KSPSetType(solver, KSPGMRES));
    require(KSPGMRESSetRestart(solver, 100));
    require(KSPSetTolerances(solver, 1e-13, PETSC_DEFAULT, PETSC_DEFAULT, 300));
    require(KSPGetPC(solver, &preconditioning));
    if (factorised) {
        require(PCSetType(preconditioning, PCLU));
        require(PCFactorSetMatSolverType(preconditioning, MATSOLVERMUMPS));
    } else {
        require(PCSetType(preconditioning, PCSHELL));
        require(PCShellSetName(preconditioning, "linear elements"));
        require_options(KSPSetFromOptions(solver));
        PetscBool is_ours = PETSC_FALSE;
        require(PetscObjectTypeCompare(reinterpret_cast<PetscObject>(preconditioning), PCSHELL, &is_ours));
        if (is_ours == PETSC_TRUE) {
            by_elements.emplace(system, n);
            require(PCShellSetContext(preconditioning, &*by_elements));
            require(PCShellSetApply(preconditioning, apply_by_elements));
        } else {
            require(KSPSetOperators(solver, system.A, system.A));
        }
    }
    Progress progress{step};
    require(KSPMonitorSet(solver, monitor, &progress, nullptr));

    Attempt tried;
    require(VecDuplicate(system.b, tried.x.made()));
    require(KSPSetUp(solver));
    require(KSPSetUpOnBlocks(solver));
    report.preparation += seconds_since(start);
    start = Clock::now();
    KSPConvergedReason reason{};
    PetscInt iterations = 0;
    Residual residual;
    PetscBool is_direct = PETSC_FALSE;
    require(PetscObjectTypeCompare(reinterpret_cast<PetscObject>(static_cast<KSP>(solver)), KSPPREONLY,
                                   &is_direct));
    // Round-off separates the residual that GMRES updates from the true one: restart from the latter.
    for (int again = 0; again < 3 && !residual.is_small(); ++again) {
        if (again > 0) {
            require(KSPSetInitialGuessNonzero(solver, PETSC_TRUE));
            require(KSPConvergedDefaultSetUIRNorm(solver));
            require(KSPSetTolerances(solver, 0.1 * residual.wanted(), PETSC_DEFAULT, PETSC_DEFAULT,
                                     PETSC_DEFAULT));
        }
        require(KSPSolve(solver, system.b, tried.x));
        PetscInt more = 0;
        require(KSPGetConvergedReason(solver, &reason));
        require(KSPGetIterationNumber(solver, &more));
        iterations += more;
        residual = residual_of(system, tried.x);
        if (reason < 0 || is_direct == PETSC_TRUE) break;
    }
    report.iteration += seconds_since(start);
    KSPType type = nullptr;
    PCType by = nullptr;
    require(KSPGetType(solver, &type));
    require(PCGetType(preconditioning, &by));
    const std::string preconditioner_name = std::string(by) == PCSHELL ? "linear elements" : by;
    report.method = std::string(type) + " with " + preconditioner_name +
                    (factorised ? " (MUMPS) of the whole matrix" : "") + ", " + std::to_string(iterations) +
                    (iterations == 1 ? " iteration" : " iterations");
    report.iterations = static_cast<int>(iterations);
    const char* words = nullptr;
    require(KSPGetConvergedReasonString(solver, &words));
    tried.nearly_singular = residual.of_terms < solvers::largest_residual;
    if (!residual.is_small())
        tried.fault = report.method + ": " + (reason < 0 ? std::string(words) + ", " : "") +
                      "relative residual " + base::shown(residual.of_terms, 2) + " (limit " +
                      base::shown(solvers::largest_residual) + "), and " + base::shown(residual.of_given, 2) +
                      " of the right-hand side (limit " + base::shown(Residual::largest_error) + ")";
    return tried;
}

}  // namespace

Eigen::MatrixXd solved(const System& system, int n, Report& report,
                       const std::function<void(int, double)>& step) {
    const bool chosen = has_options({"-ksp_type", "-pc_type", "-ksp_max_it", "-ksp_rtol", "-ksp_atol"});
    Attempt tried = attempt(system, system.elements, n, false, report, step);
    if (!tried.fault.empty() && !chosen) {
        const std::string first = tried.fault;
        tried = attempt(system, system.A, n, true, report, step);
        report.method += ", after " + first;
    }
    if (!tried.fault.empty())
        throw base::FailedComputation(
            "the linear system was not solved: " + tried.fault + "; " +
            (chosen ? "leave out PETSc's options -ksp_type, -pc_type, -ksp_max_it, -ksp_rtol and -ksp_atol"
             : tried.nearly_singular
                 ? "the conditions or the material hardly determine the solution; give a value, a larger coefficient of convection or a smaller Poisson's ratio"
                 : "take another smoothing length or other particles"));
    PetscInt rows = 0;
    require(VecGetLocalSize(tried.x, &rows));
    const double* values = nullptr;
    require(VecGetArrayRead(tried.x, &values));
    Eigen::MatrixXd x = Eigen::Map<const Eigen::MatrixXd>(values, n, rows / n);
    require(VecRestoreArrayRead(tried.x, &values));
    return x;
}

}  // namespace distributed
