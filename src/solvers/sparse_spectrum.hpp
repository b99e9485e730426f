#pragma once

#include <Eigen/Core>

#include "base/vector_width.hpp"
#include "solvers/rows.hpp"

namespace solvers {

/// The largest eigenvalues μ of \f$K^{-1} M\f$, of which 1/μ are the lowest of \f$K x = \lambda M x\f$, in
/// the order of decreasing size.
/// \param count at most N − 2
/// \throws base::FailedComputation where K is singular or the iteration does not converge
Eigen::VectorXcd largest_of_inverse(const SparseRows& K, const SparseRows& M, Eigen::Index count);

}  // namespace solvers
