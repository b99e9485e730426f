#include "distributed/system.hpp"

#include <petscksp.h>
#include <slepceps.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/errors.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "bodies/hats.hpp"
#include "solvers/sparse.hpp"

namespace distributed {

namespace {

using solvers::SparseRows;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

PetscInt petsc_int(Index number) {
    return static_cast<PetscInt>(number);
}

/// The place in PETSc's vectors of each of a matrix's columns.
std::vector<PetscInt> places_of_columns(const Numbering& numbering, int n) {
    std::vector<PetscInt> all;
    for (const PetscInt place : numbering.places())
        for (int k = 0; k < n; ++k) all.push_back(n * place + k);
    return all;
}

/// A matrix without entries, with room for exactly those to come.
/// \param near the neighbours of each own particle
Matrix matrix_for(const Numbering& numbering, int n, const std::vector<std::vector<int>>& near) {
    std::vector<PetscInt> own(n * near.size(), 0), others(own);
    for (std::size_t k = 0; k < near.size(); ++k) {
        PetscInt within = 0;
        for (const int J : near[k])
            if (numbering.is_own(numbering.places()[static_cast<std::size_t>(J)])) ++within;
        for (int i = 0; i < n; ++i) {
            own[n * k + static_cast<std::size_t>(i)] = n * within;
            others[n * k + static_cast<std::size_t>(i)] =
                n * (petsc_int(static_cast<Index>(near[k].size())) - within);
        }
    }
    const PetscInt rows = n * numbering.count_of_own();
    Matrix A;
    require(MatCreate(numbering.processes().communicator(), A.made()));
    require(MatSetSizes(A, rows, rows, PETSC_DETERMINE, PETSC_DETERMINE));
    require(MatSetType(A, MATAIJ));
    require(MatSetBlockSize(A, n));
    require(MatSeqAIJSetPreallocation(A, 0, own.data()));
    require(MatMPIAIJSetPreallocation(A, 0, own.data(), 0, others.data()));
    require(MatSetOption(A, MAT_NEW_NONZERO_ALLOCATION_ERR, PETSC_TRUE));
    require(MatSetOption(A, MAT_NO_OFF_PROC_ENTRIES, PETSC_TRUE));
    return A;
}

/// Puts rows into a matrix. \param first place of the first row \param columns places_of_columns()
void put(Mat A, PetscInt first, const SparseRows& rows, const std::vector<PetscInt>& columns) {
    std::vector<PetscInt> places;
    for (Index row = 0; row < rows.rows(); ++row) {
        const int begin = rows.outerIndexPtr()[row], end = rows.outerIndexPtr()[row + 1];
        places.clear();
        for (int entry = begin; entry < end; ++entry)
            places.push_back(columns[static_cast<std::size_t>(rows.innerIndexPtr()[entry])]);
        const PetscInt place = first + petsc_int(row);
        require(
            MatSetValues(A, 1, &place, end - begin, places.data(), rows.valuePtr() + begin, INSERT_VALUES));
    }
}

/// Rows of a matrix whose length is known only when they are made.
struct Rows {
    std::vector<PetscInt> first{0}, column;
    std::vector<double> value;

    void add(const SparseRows& rows, const std::vector<PetscInt>& columns) {
        for (Index entry = 0; entry < rows.nonZeros(); ++entry) {
            column.push_back(columns[static_cast<std::size_t>(rows.innerIndexPtr()[entry])]);
            value.push_back(rows.valuePtr()[entry]);
        }
        const PetscInt before = first.back();
        for (Index row = 0; row < rows.rows(); ++row) first.push_back(before + rows.outerIndexPtr()[row + 1]);
    }

    [[nodiscard]] Matrix matrix(const Numbering& numbering, int n) const {
        const PetscInt rows = n * numbering.count_of_own();
        Matrix A;
        require(MatCreate(numbering.processes().communicator(), A.made()));
        require(MatSetSizes(A, rows, rows, PETSC_DETERMINE, PETSC_DETERMINE));
        require(MatSetType(A, MATAIJ));
        require(MatSetBlockSize(A, n));
        require(MatSeqAIJSetPreallocationCSR(A, first.data(), column.data(), value.data()));
        require(MatMPIAIJSetPreallocationCSR(A, first.data(), column.data(), value.data()));
        return A;
    }
};

/// The own particles that have conditions, or lie within so many cells of one that has, in increasing order.
template <int dim, int n>
std::vector<int> edge_of(const Part<dim>& part, const bodies::Conditions<dim, n>& conditions, int layers) {
    std::vector<char> chosen;
    for (const auto& here : conditions) chosen.push_back(here.empty() ? 0 : 1);
    for (; layers > 0; --layers) {
        std::vector<char> more = chosen;
        for (const auto& cell : part.body.cells)
            if (std::any_of(cell.begin(), cell.end(),
                            [&](int I) { return chosen[static_cast<std::size_t>(I)]; }))
                for (const int I : cell) more[static_cast<std::size_t>(I)] = 1;
        chosen = more;
    }
    std::vector<int> edge;
    for (const int I : part.own)
        if (chosen[static_cast<std::size_t>(I)] != 0) edge.push_back(I);
    return edge;
}

/// What the equations of collocation are multiplied with to become those of linear elements, but for what an
/// element is large: volumes, areas, or 1 where a value is given.
template <int dim, int n>
Eigen::VectorXd weights_of_elements(const bodies::Hats<dim, n>& hats,
                                    const bodies::Conditions<dim, n>& conditions,
                                    const std::vector<int>& rows) {
    Eigen::VectorXd weights(static_cast<Index>(n * rows.size()));
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const double volume = hats.volume(rows[k]);
        const auto& here = conditions[static_cast<std::size_t>(rows[k])];
        for (std::size_t i = 0; i < n; ++i)
            weights[static_cast<Index>(n * k + i)] = here.empty()       ? -volume
                                                     : here[i].of_value ? 1
                                                                        : std::pow(volume, 1 - 1.0 / dim);
    }
    return weights;
}

/// A diagonal matrix of ones.
SparseRows unity(Index rows) {
    SparseRows one(rows, rows);
    one.setIdentity();
    return one;
}

void finish(const Matrix& A) {
    if (A == nullptr) return;
    require(MatAssemblyBegin(A, MAT_FINAL_ASSEMBLY));
    require(MatAssemblyEnd(A, MAT_FINAL_ASSEMBLY));
}

}  // namespace

template <int dim, int n>
System assembled(const Numbering& numbering, const Part<dim>& part, const bodies::Problem<dim, n>& problem,
                 const bodies::Conditions<dim, n>& conditions,
                 const std::optional<Approximation<dim>>& approximation, bodies::Wanted wanted,
                 const std::function<void(double)>& step) {
    const Processes& processes = numbering.processes();
    const bool for_solution = wanted == bodies::Wanted::solution;
    const std::size_t own = part.own.size();
    std::vector<std::vector<int>> near(own);
    processes.together([&] {
        base::for_each_index(static_cast<Index>(own), [&](Index k) {
            const auto place = static_cast<std::size_t>(k);
            near[place] = approximation->neighbours(part.own[place]);
        });
    });
    System system;
    system.A = matrix_for(numbering, n, near);
    if (!for_solution) system.M = matrix_for(numbering, n, near);
    std::vector<std::vector<int>>().swap(near);
    require(MatCreateVecs(system.A, system.weights.made(), system.b.made()));

    std::optional<bodies::Hats<dim, n>> hats;
    processes.together([&] {
        if (approximation && for_solution) hats.emplace(problem, part.body, *approximation);
    });
    Rows elements;
    const std::vector<PetscInt> columns = places_of_columns(numbering, n);
    processes.together([&] {
        constexpr std::size_t at_once = 1U << 14U;  // the rows exist twice meanwhile
        for (std::size_t first = 0; first < own; first += at_once) {
            const std::vector<int> rows(
                part.own.begin() + static_cast<std::ptrdiff_t>(first),
                part.own.begin() + static_cast<std::ptrdiff_t>(std::min(first + at_once, own)));
            bodies::System some = bodies::collocated(problem, conditions, *approximation, wanted, rows);
            SparseRows other = for_solution ? unity(some.A.rows()) : std::move(some.M);
            solvers::scale_rows(some.A, some.b, other);
            for (Index row = 0; row < some.A.rows(); ++row)
                if (!std::isfinite(some.A.row(row).sum() + some.b[row]))
                    throw base::FailedComputation(
                        bodies::name(part.how.method) + ": the equations of the particle at " +
                        particles::shown_point(
                            Point<dim>(part.body.x.col(rows[static_cast<std::size_t>(row / n)]))) +
                        " are zero or not finite; take another smoothing length or other particles");
            const PetscInt place = n * (numbering.first() + petsc_int(static_cast<Index>(first)));
            put(system.A, place, some.A, columns);
            if (for_solution) {
                elements.add(hats->elements(conditions, rows), columns);
                const Eigen::VectorXd weights =
                    weights_of_elements(*hats, conditions, rows).cwiseQuotient(other.diagonal());
                for (Index row = 0; row < weights.size(); ++row)
                    require(VecSetValue(system.weights, place + petsc_int(row), weights[row], INSERT_VALUES));
            } else {
                put(system.M, place, other, columns);
            }
            for (Index row = 0; row < some.b.size(); ++row)
                require(VecSetValue(system.b, place + petsc_int(row), some.b[row], INSERT_VALUES));
            if (step) step(static_cast<double>(first + rows.size()) / static_cast<double>(own));
        }
    });
    finish(system.A);
    finish(system.M);
    if (!for_solution) return system;
    system.elements = elements.matrix(numbering, n);
    for (const int I : edge_of(part, conditions, 2))
        for (PetscInt k = 0; k < n; ++k)
            system.edge.push_back(n * numbering.places()[static_cast<std::size_t>(I)] + k);
    require(VecAssemblyBegin(system.b));
    require(VecAssemblyEnd(system.b));
    require(VecAssemblyBegin(system.weights));
    require(VecAssemblyEnd(system.weights));
    return system;
}

namespace {

using Solver = Owned<KSP, KSPDestroy>;
using Preconditioner = Owned<PC, PCDestroy>;

/// The size, relative to the largest of its row, above which an entry counts as strong for BoomerAMG.
constexpr const char* strong = "0.25";

/// An approximate inverse of A: a solution by elements, for what varies slowly, and then one of the equations
/// of A at the edge, which imposes conditions in a way of its own.
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
        require(PCSetFromOptions(elements_));
        require(PCSetUp(elements_));

        Owned<IS, ISDestroy> rows;
        require(ISCreateGeneral(communicator, petsc_int(static_cast<Index>(system.edge.size())),
                                system.edge.data(), PETSC_COPY_VALUES, rows.made()));
        require(MatCreateSubMatrix(system.A, rows, rows, MAT_INITIAL_MATRIX, A_edge_.made()));
        require(MatCreateVecs(A_edge_, x_edge_.made(), rest_edge_.made()));
        require(VecDuplicate(system.b, rest_.made()));
        require(VecScatterCreate(rest_, rows, rest_edge_, nullptr, to_edge_.made()));
        require(PCCreate(communicator, edge_.made()));
        require(PCSetOptionsPrefix(edge_, "edge_"));
        require(PCSetOperators(edge_, A_edge_, A_edge_));
        require(PCSetType(edge_, PCLU));
        require(PCFactorSetMatSolverType(edge_, MATSOLVERMUMPS));
        require(PCSetFromOptions(edge_));
        require(PCSetUp(edge_));
    }

    void apply(Vec b, Vec x) const {
        require(VecPointwiseMult(rest_, system_.weights, b));
        require(PCApply(elements_, rest_, x));
        require(MatMult(system_.A, x, rest_));
        require(VecAYPX(rest_, -1, b));
        require(VecScatterBegin(to_edge_, rest_, rest_edge_, INSERT_VALUES, SCATTER_FORWARD));
        require(VecScatterEnd(to_edge_, rest_, rest_edge_, INSERT_VALUES, SCATTER_FORWARD));
        require(PCApply(edge_, rest_edge_, x_edge_));
        require(VecScatterBegin(to_edge_, x_edge_, x, ADD_VALUES, SCATTER_REVERSE));
        require(VecScatterEnd(to_edge_, x_edge_, x, ADD_VALUES, SCATTER_REVERSE));
    }

  private:
    const System& system_;
    Preconditioner elements_, edge_;
    Matrix A_edge_;
    Vector rest_, rest_edge_, x_edge_;
    Owned<VecScatter, VecScatterDestroy> to_edge_;
};

PetscErrorCode apply_by_elements(PC preconditioner, Vec b, Vec x) {
    void* by_elements = nullptr;
    PetscCall(PCShellGetContext(preconditioner, &by_elements));
    static_cast<const ByElements*>(by_elements)->apply(b, x);
    return 0;
}

PetscErrorCode monitor(KSP ksp, PetscInt iteration, PetscReal residual, void* context) {
    auto& [step, first] = *static_cast<std::pair<const std::function<void(int, double)>*, double>*>(context);
    static_cast<void>(ksp);
    if (iteration == 0) first = residual;
    if (*step) (*step)(static_cast<int>(iteration), first > 0 ? residual / first : 0);
    return 0;
}

/// \f$\|b - A x\| / (\|A\|\,\|x\| + \|b\|)\f$ with largest sizes: how far the system is from one that x solves.
double relative_residual(const System& system, Vec x) {
    Vector residual;
    require(VecDuplicate(system.b, residual.made()));
    require(MatMult(system.A, x, residual));
    require(VecAYPX(residual, -1, system.b));
    PetscReal left = 0, given = 0, size = 0, largest = 0;
    require(VecNorm(residual, NORM_INFINITY, &left));
    require(VecNorm(system.b, NORM_INFINITY, &given));
    require(MatNorm(system.A, NORM_INFINITY, &size));
    require(VecNorm(x, NORM_INFINITY, &largest));
    const double all = size * largest + given;
    return all == 0 ? 0 : left / all;
}

/// What was tried: a solution, or why there is none.
struct Attempt {
    Vector x;
    std::string fault;
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
        require(KSPSetFromOptions(solver));
        PetscBool is_ours = PETSC_FALSE;
        require(PetscObjectTypeCompare(reinterpret_cast<PetscObject>(preconditioning), PCSHELL, &is_ours));
        if (is_ours == PETSC_TRUE) {
            by_elements.emplace(system, n);
            require(PCShellSetContext(preconditioning, &*by_elements));
            require(PCShellSetApply(preconditioning, apply_by_elements));
        }
    }
    std::pair<const std::function<void(int, double)>*, double> context{&step, 0};
    require(KSPMonitorSet(solver, monitor, &context, nullptr));

    Attempt tried;
    require(VecDuplicate(system.b, tried.x.made()));
    require(KSPSetUp(solver));
    require(KSPSetUpOnBlocks(solver));
    report.preparation += seconds_since(start);
    start = Clock::now();
    KSPConvergedReason reason{};
    PetscInt iterations = 0;
    double residual = 1;
    // Where round-off has separated the two residuals, the iteration begins again from the true one.
    for (int again = 0; again < 3 && !(residual < solvers::largest_residual); ++again) {
        if (again == 1) {
            require(KSPSetInitialGuessNonzero(solver, PETSC_TRUE));
            require(KSPConvergedDefaultSetUIRNorm(solver));
            require(KSPSetTolerances(solver, 1e-4, PETSC_DEFAULT, PETSC_DEFAULT, PETSC_DEFAULT));
        }
        require(KSPSolve(solver, system.b, tried.x));
        PetscInt more = 0;
        require(KSPGetConvergedReason(solver, &reason));
        require(KSPGetIterationNumber(solver, &more));
        iterations += more;
        residual = relative_residual(system, tried.x);
        if (reason < 0) break;
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
    const char* words = nullptr;
    require(KSPGetConvergedReasonString(solver, &words));
    if (!(residual < solvers::largest_residual))
        tried.fault = report.method + ": " + words + ", relative residual " + base::shown(residual, 2) +
                      " where " + base::shown(solvers::largest_residual) + " is the most";
    return tried;
}

}  // namespace

Eigen::MatrixXd solved(const System& system, int n, Report& report,
                       const std::function<void(int, double)>& step) {
    const bool chosen = has_options("-ksp_") || has_options("-pc_");
    Attempt tried = attempt(system, system.elements, n, false, report, step);
    if (!tried.fault.empty() && !chosen) {
        const std::string first = tried.fault;
        tried = attempt(system, system.A, n, true, report, step);
        report.method += ", after " + first;
    }
    if (!tried.fault.empty())
        throw base::FailedComputation("the linear system was not solved: " + tried.fault + "; " +
                                      (chosen ? "leave PETSc's options -ksp_... and -pc_... out"
                                              : "take another smoothing length or other particles"));
    PetscInt rows = 0;
    require(VecGetLocalSize(tried.x, &rows));
    const double* values = nullptr;
    require(VecGetArrayRead(tried.x, &values));
    Eigen::MatrixXd x = Eigen::Map<const Eigen::MatrixXd>(values, n, rows / n);
    require(VecRestoreArrayRead(tried.x, &values));
    return x;
}

std::vector<std::complex<double>> smallest_eigenvalues(const System& system, Index count) {
    MPI_Comm communicator = PetscObjectComm(reinterpret_cast<PetscObject>(static_cast<Mat>(system.A)));
    Owned<EPS, EPSDestroy> solver;
    ST transformation = nullptr;
    KSP inverse = nullptr;
    PC factors = nullptr;
    require(EPSCreate(communicator, solver.made()));
    require(EPSSetOperators(solver, system.A, system.M));
    require(EPSSetProblemType(solver, EPS_GNHEP));
    require(EPSSetDimensions(solver, petsc_int(count), petsc_int(2 * count + 20), PETSC_DEFAULT));
    require(EPSSetTolerances(solver, 1e-12, 1000));
    require(EPSSetTarget(solver, 0));
    require(EPSSetWhichEigenpairs(solver, EPS_TARGET_MAGNITUDE));
    require(EPSGetST(solver, &transformation));
    require(STSetType(transformation, STSINVERT));
    require(STGetKSP(transformation, &inverse));
    require(KSPSetType(inverse, KSPPREONLY));
    require(KSPGetPC(inverse, &factors));
    require(PCSetType(factors, PCLU));
    require(PCFactorSetMatSolverType(factors, MATSOLVERMUMPS));
    require(EPSSetFromOptions(solver));
    require(EPSSolve(solver));
    PetscInt found = 0;
    require(EPSGetConverged(solver, &found));
    if (found < petsc_int(count))
        throw base::FailedComputation("the iteration for " + std::to_string(count) + " eigenvalues found " +
                                      std::to_string(found) + "; take fewer, or more particles");
    std::vector<std::complex<double>> all;
    for (PetscInt k = 0; k < petsc_int(count); ++k) {
        PetscScalar real = 0, imaginary = 0;
        require(EPSGetEigenvalue(solver, k, &real, &imaginary));
        all.emplace_back(real, imaginary);
    }
    return all;
}

template System assembled(const Numbering&, const Part<2>&, const bodies::Problem<2, 1>&,
                          const bodies::Conditions<2, 1>&, const std::optional<Approximation<2>>&,
                          bodies::Wanted, const std::function<void(double)>&);
template System assembled(const Numbering&, const Part<3>&, const bodies::Problem<3, 1>&,
                          const bodies::Conditions<3, 1>&, const std::optional<Approximation<3>>&,
                          bodies::Wanted, const std::function<void(double)>&);
template System assembled(const Numbering&, const Part<2>&, const bodies::Problem<2, 2>&,
                          const bodies::Conditions<2, 2>&, const std::optional<Approximation<2>>&,
                          bodies::Wanted, const std::function<void(double)>&);
template System assembled(const Numbering&, const Part<3>&, const bodies::Problem<3, 3>&,
                          const bodies::Conditions<3, 3>&, const std::optional<Approximation<3>>&,
                          bodies::Wanted, const std::function<void(double)>&);

}  // namespace distributed
