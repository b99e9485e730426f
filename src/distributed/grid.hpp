#pragma once

#include <array>

#include "distributed/part.hpp"

namespace distributed {

/// A rectangle or a box with a corner at the origin, full of particles in rows. Its sides are left, right;
/// bottom, top; back, front: where the first, second and third coordinate is least and largest.
template <int dim>
struct Grid {
    std::array<Index, static_cast<std::size_t>(dim)> count;  ///< of particles along each axis, at least 2
    Point<dim> length;                                       ///< of the box [length]
};

/// The number of particles. \throws base::InvalidInput for fewer than 2 along an axis, and for lengths that
///         are not positive and finite
template <int dim>
Index checked_size(const Grid<dim>& grid);

/// The whole body, with cells.
template <int dim>
Body<dim> body_of(const Grid<dim>& grid);

/// The part of a process, made without the others: a box of particles, and layers around it.
template <int dim>
Part<dim> part_of(const Grid<dim>& grid, const Discretisation& how, int processes, int process);

}  // namespace distributed
