#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "distributed/grid.hpp"
#include "distributed/processes.hpp"

namespace distributed {

/// A body and its parts: a grid, of which each process makes its own part, or a body that the first process
/// holds, which sends the others theirs.
template <int dim>
class Whole {
  public:
    /// \throws base::InvalidInput as checked_size()
    Whole(const Processes& processes, const Grid<dim>& grid);
    /// \param body on the first process; null on the others
    Whole(const Processes& processes, std::unique_ptr<Body<dim>> body);

    [[nodiscard]] Index particles() const { return particles_; }

    /// A body of the same shape and sides, to check a problem before there are parts: for a grid one with few
    /// particles, for a mesh a copy of the body; null on the processes that do not hold it.
    [[nodiscard]] std::unique_ptr<Body<dim>> small() const;

    /// The part of this process, for a method. \param places where the solution will be asked
    [[nodiscard]] Part<dim> part(const Discretisation& how, const std::vector<Point<dim>>& places);

    /// On the first process, the places of the particles with neighbours across a gap, bodies::across_gaps();
    /// of the method of part().
    [[nodiscard]] std::vector<Point<dim>> across_gaps() const;

    /// On the first process, bodies::checked_quality() of a mesh by the method of part(), whose remedy serves
    /// all particles.
    template <int n>
    void require_quality(const bodies::Problem<dim, n>& problem) const;

  private:
    const Processes& processes_;
    std::optional<Grid<dim>> grid_;
    std::unique_ptr<Body<dim>> body_;
    std::optional<Approximation<dim>> approximation_;  // of the body
    Index particles_ = 0;
};

}  // namespace distributed
