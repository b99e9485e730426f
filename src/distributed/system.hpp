#pragma once

#include <petscmat.h>

#include <functional>
#include <optional>
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
    Vector weights;  ///< factors that scale the rows of A to those of the elements, to leading order
    std::vector<PetscInt> edge;  ///< owned rows of particles with conditions, and of two layers around them
};

/// \param approximation of the part; none where it has no particles
/// \param step is called now and then, with the share that is done
/// \throws base::FailedComputation with the place of a row that is zero or not finite
template <int dim, int n>
System assembled(const Numbering& numbering, const Part<dim>& part, const bodies::Problem<dim, n>& problem,
                 const bodies::Conditions<dim, n>& conditions,
                 const std::optional<Approximation<dim>>& approximation, bodies::Wanted wanted,
                 const std::function<void(double)>& step = {});

}  // namespace distributed
