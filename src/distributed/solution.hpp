#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "bodies/solution.hpp"
#include "distributed/linear_solver.hpp"

namespace distributed {

/// What a solution calls while it is made, on each process.
struct Progress {
    std::function<void(double)> assembly{};         ///< the share of the rows that are made
    std::function<void(int, double)> iterations{};  ///< their number, and the residual relative to the first
};

/// A solution, and how it was found.
template <int dim, int n>
struct Solved {
    /// On the part of a process, with the unknowns of its own particles and of the halo; none where it has no
    /// particles. Quality and worst particle are those of the particles that it owns.
    std::optional<bodies::Solution<dim, n>> part;
    double quality = 0;   ///< the largest of all processes
    Point<dim> worst;     ///< its place
    double assembly = 0;  ///< seconds
    Report report;
};

/// bodies::solve() on many processes, by the method fpm or strong.
/// \throws base::InvalidInput and base::FailedComputation as bodies::solve(), on all processes; a remedy in
///         the message was tried on one part only. The caller checks bodies::require_held() first.
template <int dim, int n>
Solved<dim, n> solve(const Processes& processes, const Part<dim>& part,
                     const bodies::Problem<dim, n>& problem, const Progress& progress = {});

/// bodies::eigenvalues() on many processes.
template <int dim, int n>
std::vector<double> eigenvalues(const Processes& processes, const Part<dim>& part,
                                const bodies::Problem<dim, n>& problem, Index count,
                                const Progress& progress = {});

}  // namespace distributed
