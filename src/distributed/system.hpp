#pragma once

#include <petscmat.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bodies/collocation.hpp"
#include "distributed/numbering.hpp"

namespace distributed {

using Matrix = Owned<Mat, MatDestroy>;
using Vector = Owned<Vec, VecDestroy>;

/// The equations of a problem on all processes, each with the rows of its own particles, scaled as by
/// solvers::scale_rows(): bodies::System in PETSc's matrices.
struct System {
    Matrix A;
    Matrix elements;  ///< the equations of linear elements on the same cells, for a solution
    Matrix M;         ///< for eigenvalues
    Vector b;
    Vector weights;  ///< what makes the rows of A those of the elements, but for what an element is large
    std::vector<PetscInt> edge;  ///< own rows of particles with conditions, and of two layers around them
};

/// \param approximation of the part; none where it has no particles
/// \param step is called now and then, with the share that is done
/// \throws base::FailedComputation with the place of a row that is zero or not finite
template <int dim, int n>
System assembled(const Numbering& numbering, const Part<dim>& part, const bodies::Problem<dim, n>& problem,
                 const bodies::Conditions<dim, n>& conditions,
                 const std::optional<Approximation<dim>>& approximation, bodies::Wanted wanted,
                 const std::function<void(double)>& step = {});

/// How a system was solved.
struct Report {
    std::string method;                     ///< "GMRES, 12 iterations, preconditioned by hypre"
    double preparation = 0, iteration = 0;  ///< seconds
};

/// Solves \f$A x = b\f$ by GMRES, unless PETSc's options say otherwise. The preconditioner is an algebraic
/// multigrid method on the equations of the nearest particles, one for each component of the unknowns. Where
/// the iteration fails, and no options were given, MUMPS factorises A.
/// \param n unknowns of each particle \param[out] report how
/// \param step is called after each iteration with its number and the residual, relative to the first
/// \return those of the own particles, a column for each
/// \throws base::FailedComputation where no method has a residual below solvers::largest_residual
Eigen::MatrixXd solved(const System& system, int n, Report& report,
                       const std::function<void(int, double)>& step = {});

/// The eigenvalues λ of \f$A u = \lambda M u\f$ that are the smallest in size, as complex numbers; SLEPc
/// finds them with the inverse of A, a factorisation by MUMPS.
std::vector<std::complex<double>> smallest_eigenvalues(const System& system, Index count);

}  // namespace distributed
