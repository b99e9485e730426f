#include "distributed/spectrum.hpp"

#include <slepceps.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/errors.hpp"
#include "base/text.hpp"

namespace distributed {

namespace {

/// \f$\|A u - \lambda M u\| / \|\lambda M u\|\f$ of the k-th pair: an estimate of the relative error of λ.
double residual_of(EPS solver, const System& system, PetscInt k) {
    std::array<Vector, 2> u, Au, Mu;  // real and imaginary parts
    for (auto* parts : {&u, &Au, &Mu})
        for (Vector& part : *parts) require(MatCreateVecs(system.A, part.made(), nullptr));
    std::array<PetscScalar, 2> lambda{};
    require(EPSGetEigenpair(solver, k, lambda.data(), &lambda[1], u[0], u[1]));
    for (std::size_t part = 0; part < 2; ++part) {
        require(MatMult(system.A, u[part], Au[part]));
        require(MatMult(system.M, u[part], Mu[part]));
    }
    require(VecAXPY(Au[0], -lambda[0], Mu[0]));
    require(VecAXPY(Au[0], lambda[1], Mu[1]));
    require(VecAXPY(Au[1], -lambda[0], Mu[1]));
    require(VecAXPY(Au[1], -lambda[1], Mu[0]));
    std::array<PetscReal, 4> norms{};
    for (std::size_t part = 0; part < 2; ++part) {
        require(VecNorm(Au[part], NORM_2, &norms[part]));
        require(VecNorm(Mu[part], NORM_2, &norms[2 + part]));
    }
    return std::hypot(norms[0], norms[1]) /
           (std::hypot(lambda[0], lambda[1]) * std::hypot(norms[2], norms[3]));
}

/// Refuses options that ask for other eigenvalues than the smallest.
void require_smallest(EPS solver) {
    PetscScalar target = 0;
    EPSWhich which{};
    ST transformation = nullptr;
    PetscBool is_inverse = PETSC_FALSE;
    require(EPSGetTarget(solver, &target));
    require(EPSGetWhichEigenpairs(solver, &which));
    require(EPSGetST(solver, &transformation));
    require(PetscObjectTypeCompare(reinterpret_cast<PetscObject>(transformation), STSINVERT, &is_inverse));
    if (target != 0 || which != EPS_TARGET_MAGNITUDE || is_inverse == PETSC_FALSE)
        throw base::InvalidInput(
            "--modes finds the smallest eigenvalues, with the inverse of the matrix; leave PETSc's options for others out, such as -eps_target and -st_type");
}

}  // namespace

std::vector<std::complex<double>> smallest_eigenvalues(const System& system, Index count) {
    MPI_Comm communicator = PetscObjectComm(reinterpret_cast<PetscObject>(static_cast<Mat>(system.A)));
    Owned<EPS, EPSDestroy> solver;
    ST transformation = nullptr;
    KSP inverse = nullptr;
    PC factors = nullptr;
    require(EPSCreate(communicator, solver.made()));
    require(EPSSetOperators(solver, system.A, system.M));
    require(EPSSetProblemType(solver, EPS_GNHEP));
    PetscInt unknowns = 0;
    require(MatGetSize(system.A, &unknowns, nullptr));
    require(EPSSetDimensions(solver, petsc_int(count), std::min(unknowns, petsc_int(2 * count + 20)),
                             PETSC_DEFAULT));
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
    require_options(EPSSetFromOptions(solver));
    require_smallest(solver);
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
        constexpr double largest_error = 1e-6;
        const double residual = residual_of(solver, system, k);
        if (!(residual < largest_error))
            throw base::FailedComputation(
                "the relative residual of the eigenvalue " + base::shown(real, 4) + " is " +
                base::shown(residual, 2) + ", limit " + base::shown(largest_error) +
                "; leave out PETSc's options -st_… and -eps_…, or take fewer modes");
        all.emplace_back(real, imaginary);
    }
    return all;
}

}  // namespace distributed
