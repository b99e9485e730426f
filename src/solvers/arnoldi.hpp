#pragma once

#include <string>

#include "base/errors.hpp"
#include "base/vector_width.hpp"

// g++ 12 suspects Spectra of using memory that its own classes have freed.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpragmas"
#pragma GCC diagnostic ignored "-Wunknown-warning-option"
#pragma GCC diagnostic ignored "-Wuse-after-free"
#include <Spectra/GenEigsSolver.h>

namespace solvers {

/// Arnoldi's method with implicit restarts (Spectra), for the largest eigenvalues of an inverse. Included by
/// source files only, since it takes long to compile.
/// \param inverse the operator, as Spectra takes it \param basis vectors of the Krylov space
/// \return Spectra's solver, which has the eigenvalues and the eigenvectors
/// \throws base::FailedComputation where the iteration does not converge
template <class Operator>
Spectra::GenEigsSolver<Operator> arnoldi(Operator& inverse, Eigen::Index count, Eigen::Index basis) {
    Spectra::GenEigsSolver<Operator> solver(inverse, count, basis);
    solver.init();
    solver.compute(Spectra::SortRule::LargestMagn, 1000, 1e-10);
    if (solver.info() != Spectra::CompInfo::Successful)
        throw base::FailedComputation("the lowest " + std::to_string(count) + " eigenvalues of a matrix of " +
                                      std::to_string(inverse.rows()) + " rows were not found");
    return solver;
}

}  // namespace solvers

#pragma GCC diagnostic pop
