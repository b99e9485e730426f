#pragma once

#include <array>
#include <vector>

#include "bodies/approximation.hpp"
#include "bodies/judgement.hpp"

/// A user's body on many processes, by collocation: each process makes the equations of the particles that it
/// owns, with the formulas for one machine, and PETSc and SLEPc solve them together.
///
/// A Part is what a process holds: a body that consists of its own particles and of a halo, those that enter
/// the equations of its own ones. solve() and eigenvalues() do on many parts what bodies::solve() and
/// bodies::eigenvalues() do on one body.
namespace distributed {

using bodies::Approximation;
using bodies::Body;
using bodies::Column;
using bodies::Discretisation;
using bodies::Index;
using bodies::Point;

/// The part of a body that a process holds.
template <int dim>
struct Part {
    /// The particles of the part in the order of their numbers in the whole body, so that sums over
    /// neighbours have the same order; all sides, with the pieces over which this process integrates; and
    /// cells: first those over which it integrates, then the others that touch a particle that it owns.
    Body<dim> body;
    Index own_cells = 0;           ///< number of cells over which this process integrates
    std::vector<Index> number;     ///< of each particle in the whole body
    std::vector<int> own;          ///< particles of the part whose equations this process makes
    Discretisation how;            ///< with smoothing lengths that are those of the whole body
    bodies::Extent<dim> extent{};  ///< of the whole body
};

/// The approximation of a part, with the particle volumes of the whole body.
template <int dim>
Approximation<dim> approximation_of(const Part<dim>& part);

/// Points in the cells over which a process integrates, bodies::rule_in().
template <int dim>
std::vector<bodies::IntegrationPoint<dim>> rule_in(const Part<dim>& part);

/// The process that has each particle, piece and cell of a body.
struct Owners {
    std::vector<int> particle;
    std::vector<std::vector<int>> piece;  ///< for each side
    std::vector<int> cell;
};

/// Number of things for the first half of the processes, in proportion to their number.
inline Index share_of_first_half(Index things, int processes) {
    return things * (processes / 2) / processes;
}

/// Divides particles by recursive bisection of the longest side of their bounding box.
/// \return a process for each particle; all processes have as many, or one more or less
template <int dim>
std::vector<int> bisected(const particles::Points<dim>& x, int processes);

/// \param particle the process of each particle, such as bisected(). A piece goes to the process of the
///        particle nearest to its first quadrature point, a cell to that of its first corner
template <int dim>
Owners owners_of(const Body<dim>& body, const Approximation<dim>& approximation, std::vector<int> particle);

/// The part of a process.
/// \param approximation of the whole body; its smoothing lengths are given, one for all or one for each
/// \param places where the solution will be asked, beside those of the particles, pieces and cells
template <int dim>
Part<dim> part_of(const Body<dim>& body, const Approximation<dim>& approximation, const Owners& owners,
                  int process, const std::vector<Point<dim>>& places = {});

}  // namespace distributed
