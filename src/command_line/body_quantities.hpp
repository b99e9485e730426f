#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bodies/field_file.hpp"
#include "bodies/solution.hpp"
#include "report/table.hpp"

namespace command_line {

/// A solution with the problem and the body that it belongs to.
template <int dim, int n>
struct SolvedBody {
    const bodies::Problem<dim, n>& problem;
    const bodies::Body<dim>& body;
    const bodies::Solution<dim, n>& solution;
    batra2008::elastostatics::Material material;  ///< of an elastic body
    std::vector<bodies::State<dim, n>> at_particles{};
};

/// A number of a solution, at a place or of the body as a whole.
template <int dim>
struct Quantity {
    std::string name;
    std::optional<bodies::Point<dim>> place;
    double value = 0;
    bool has_limit = true;  ///< for ever finer particles
};

/// "u1", "s12": a name with the number of an axis, counted from 1.
std::string numbered(const std::string& name, bodies::Index axis);

/// The largest extent of a body along an axis. [length]
template <int dim>
double size_of(const bodies::Body<dim>& body);

/// Refuses a place that lies outside of a body by more than 1e-6 of its size, and by more than the distance
/// between its boundary and the shape that was meant. \throws base::InvalidInput naming the nearest particle
template <int dim>
void require_inside(const bodies::Body<dim>& body, const std::vector<bodies::Point<dim>>& places);

/// What a solution is at places: computed in parallel.
/// \throws base::FailedComputation where it is not finite
template <int dim, int n>
std::vector<bodies::State<dim, n>> states(const bodies::Problem<dim, n>& problem,
                                          const bodies::Solution<dim, n>& solution,
                                          const bodies::Points<dim>& places);

/// u1, u2 (u3), stresses s11, s22 (s33, s23, s13), s12 and von_mises; of a scalar u and the flux of heat
/// \f$q = -k\nabla u\f$.
template <int dim, int n>
std::vector<std::pair<std::string, double>> named(const bodies::State<dim, n>& state,
                                                  const batra2008::elastostatics::Material& material);

/// All numbers of a solution at places, the largest ones over the particles, and the worst row.
template <int dim, int n>
std::vector<Quantity<dim>> quantities(const SolvedBody<dim, n>& solved,
                                      const std::vector<bodies::Point<dim>>& places);

/// The largest numbers over the particles, of a scalar the smallest, too.
template <int dim, int n>
std::vector<Quantity<dim>> extremes(const SolvedBody<dim, n>& solved);

/// The fields at particles, for `--field`. \param R quality number of each \param suffix of their names
template <int dim, int n>
std::vector<bodies::NamedField> fields(const std::vector<bodies::State<dim, n>>& at_particles,
                                       const bodies::Column<double>& R,
                                       const batra2008::elastostatics::Material& material,
                                       const std::string& suffix);

/// A table for `--plot`: a row for each triangle of the body or, in space, of its surface, with the places
/// and the numbers of its corners; without cells a row for each particle.
template <int dim, int n>
report::Table drawing(const SolvedBody<dim, n>& solved);

}  // namespace command_line
