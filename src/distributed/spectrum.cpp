#include "distributed/spectrum.hpp"

#include <slepceps.h>

#include <algorithm>
#include <string>

#include "base/errors.hpp"

namespace distributed {

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

}  // namespace distributed
