#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>

#include "distributed/system.hpp"

namespace distributed {

/// How a system was solved.
struct Report {
    std::string method;  ///< "gmres with linear elements, 25 iterations"
    int iterations = 0;
    double preparation = 0, iteration = 0;  ///< seconds
};

/// Solves \f$A x = b\f$ by GMRES, unless PETSc's options say otherwise. The preconditioner is a solution of
/// the equations of A at the edge, factorised by MUMPS, and then one of the elements for what is left, by an
/// algebraic multigrid method, BoomerAMG for each component of the unknowns; its options begin with -edge_pc_
/// and -elements_pc_. Where the iteration fails, MUMPS factorises A, unless the user chose a method or limit.
/// \param n unknowns of each particle \param[out] report how the system was solved
/// \param step is called after each iteration with its number and the residual, relative to the first
/// \return the unknowns of the particles that this process owns, a column for each particle
/// \throws base::FailedComputation where no method reaches, in maximum norms, a residual below
///         solvers::largest_residual relative to ‖A‖ ‖x‖ + ‖b‖ and below 1e-5 relative to ‖b‖
Eigen::MatrixXd solved(const System& system, int n, Report& report,
                       const std::function<void(int, double)>& step = {});

}  // namespace distributed
