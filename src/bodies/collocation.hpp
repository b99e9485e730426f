#pragma once

#include "bodies/approximation.hpp"
#include "bodies/conditions.hpp"
#include "solvers/sparse.hpp"

namespace bodies {

/// A linear system with n equations for each particle.
struct System {
    solvers::SparseRows A;
    Eigen::VectorXd b;
    solvers::SparseRows nearest{};  ///< the same equations on few neighbours; or no rows
    Eigen::VectorXd mass{};
};

/// Collocation: the equation at the particles inside, the conditions at those on the boundary.
template <int dim, int n>
System collocated(const Problem<dim, n>& problem, const Body<dim>& body,
                  const Approximation<dim>& approximation, double fic = 0.5);

}  // namespace bodies
