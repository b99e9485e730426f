#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "base/index.hpp"
#include "particles/points.hpp"

namespace particles {

using base::Index;

/// Particles sorted into a grid of equal cubes, about two particles to a cube. A cube with many particles is
/// sorted into a finer grid of its own, and so on, so that the time to find the particles near a place does
/// not grow with their number, wherever they lie. The cubes of a row are neighbours in memory. Compiled once
/// for each dimension, in cells.cpp.
template <int dim>
class Cells {
  public:
    /// A cube with more particles than this has a finer grid.
    static constexpr Index most_in_cube = 64;

    /// \param x finite positions, at least one
    explicit Cells(const Points<dim>& x);

    /// Calls `visit(j, distance²)` for each particle j that is nearer to a place than `reach`.
    template <class Visit>
    void for_each_within(const Point<dim>& place, double reach, const Visit& visit) const {
        search(grid_, place, reach, reach * reach, visit);
    }

    /// Calls `visit(j, distance²)` for each particle j of the cubes that are nearer to a place than `reach`.
    template <class Visit>
    void for_each_candidate(const Point<dim>& place, double reach, const Visit& visit) const {
        search(grid_, place, reach, std::numeric_limits<double>::infinity(), visit);
    }

    /// Squared distances of the k particles nearest to a place, in increasing order.
    /// \param k from 1 to the number of particles
    [[nodiscard]] std::vector<double> nearest(const Point<dim>& place, Index k) const;

    /// The first two of more than `most_in_cube` particles at one place, if there are so many.
    [[nodiscard]] const std::optional<std::array<int, 2>>& crowd() const { return crowd_; }

    /// Length of the side of the cube around a place, in the finest grid there.
    [[nodiscard]] double side_at(const Point<dim>& place) const;

  private:
    using Cube = std::array<Index, dim>;

    /// A grid of equal cubes over the bounding box of its particles.
    struct Grid {
        Point<dim> low, high;           // corners of the bounding box
        double side = 0;                // of a cube
        Cube count{};                   // of cubes along each axis
        std::vector<int> first;         // place of each cube's first particle in the sorted order
        std::vector<std::size_t> full;  // cubes that have finer grids, in increasing order
        std::vector<Grid> finer;

        Grid() = default;
        /// \param low_, high_ corners of the bounding box of N particles
        Grid(const Point<dim>& low_, const Point<dim>& high_, double N);

        /// The cube at a place; the nearest one, outside the bounding box.
        [[nodiscard]] Cube cube_at(const Point<dim>& place) const;
        [[nodiscard]] std::size_t number(const Cube& at) const {
            Index cube = at[dim - 1];
            for (int axis = dim - 2; axis >= 0; --axis) cube = cube * count[axis] + at[axis];
            return static_cast<std::size_t>(cube);
        }
        [[nodiscard]] bool is_within(const Point<dim>& place, double reach) const;
        /// Which of the finer grids is the first that belongs to a cube or to one after it.
        [[nodiscard]] std::size_t first_finer(std::size_t cube) const {
            if (full.empty()) return 0;
            return static_cast<std::size_t>(std::lower_bound(full.begin(), full.end(), cube) - full.begin());
        }
    };

    [[nodiscard]] int particle(Index k) const { return particle_[static_cast<std::size_t>(k)]; }

    /// Sorts the particles at the places begin … end − 1 by their cubes in a grid.
    Grid sorted_grid(const Points<dim>& x, Index begin, Index end);

    /// Visits the particles of the cubes within reach whose squared distance is less than `most`.
    template <class Visit>
    void search(const Grid& grid, const Point<dim>& place, double reach, double most,
                const Visit& visit) const {
        const Cube low = grid.cube_at(place.array() - reach), high = grid.cube_at(place.array() + reach);
        for (Cube at = low;;) {
            std::size_t cube = grid.number(at);
            const std::size_t end = cube + static_cast<std::size_t>(high[0] - low[0]) + 1;
            for (std::size_t finer = grid.first_finer(cube); cube < end; ++finer) {
                const std::size_t full = finer < grid.full.size() ? std::min(grid.full[finer], end) : end;
                const Index last = grid.first[full];
                for (Index k = grid.first[cube]; k < last; ++k) {
                    const double distance_squared = (sorted_.col(k) - place).squaredNorm();
                    if (distance_squared < most) visit(particle(k), distance_squared);
                }
                if (full < end && grid.finer[finer].is_within(place, reach))
                    search(grid.finer[finer], place, reach, most, visit);
                cube = full + 1;
            }
            int axis = 1;
            while (axis < dim && at[axis] == high[axis]) {
                at[axis] = low[axis];
                ++axis;
            }
            if (axis >= dim) return;
            ++at[axis];
        }
    }

    Grid grid_;
    std::vector<int> particle_;  // number of the particle at each place
    Points<dim> sorted_;
    std::optional<std::array<int, 2>> crowd_;
};

extern template class Cells<1>;
extern template class Cells<2>;
extern template class Cells<3>;

}  // namespace particles
