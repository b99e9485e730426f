#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

#include "base/index.hpp"
#include "particles/points.hpp"

namespace particles {

using base::Index;

/// Particles sorted into a grid of equal cubes, about two particles to a cube. A cube with many particles is
/// sorted into a finer grid of its own, and so on, so that the time to find the particles near a place does
/// not grow with their number, wherever they lie. The cubes of a row are neighbours in memory.
template <int dim>
class Cells {
  public:
    /// A cube with more particles than this has a finer grid.
    static constexpr Index most_in_cube = 64;

    /// \param x finite positions, at least one
    explicit Cells(const Points<dim>& x) : particle_(static_cast<std::size_t>(x.cols())) {
        std::iota(particle_.begin(), particle_.end(), 0);
        grid_ = sorted_grid(x, 0, x.cols());
        sorted_.resize(dim, x.cols());
        for (Index k = 0; k < x.cols(); ++k) sorted_.col(k) = x.col(particle(k));
    }

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
    [[nodiscard]] std::vector<double> nearest(const Point<dim>& place, Index k) const {
        std::vector<double> found;
        for (double reach = side_at(place); static_cast<Index>(found.size()) < k; reach *= 2) {
            found.clear();
            for_each_within(place, reach,
                            [&](int, double distance_squared) { found.push_back(distance_squared); });
        }
        std::partial_sort(found.begin(), found.begin() + k, found.end());
        found.resize(static_cast<std::size_t>(k));
        return found;
    }

    /// The first two of more than `most_in_cube` particles at one place, if there are so many.
    [[nodiscard]] const std::optional<std::array<int, 2>>& crowd() const { return crowd_; }

    /// Length of the side of the cube around a place, in the finest grid there.
    [[nodiscard]] double side_at(const Point<dim>& place) const {
        const Grid* grid = &grid_;
        while (!grid->full.empty()) {
            const std::size_t cube = grid->number(grid->cube_at(place)), finer = grid->first_finer(cube);
            if (finer == grid->full.size() || grid->full[finer] != cube) break;
            grid = &grid->finer[finer];
        }
        return grid->side;
    }

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
        Grid(const Point<dim>& low_, const Point<dim>& high_, double N) : low(low_), high(high_) {
            const Point<dim> extent = high - low;
            side = std::max(extent.maxCoeff() / N, 1e-300);
            const auto cubes = [&] { return ((extent / side).array().floor() + 1).prod(); };
            while (cubes() > std::max(N / 2, 1.0)) side *= 1.1;
            for (int axis = 0; axis < dim; ++axis) count[axis] = static_cast<Index>(extent[axis] / side) + 1;
            first.assign(static_cast<std::size_t>(cubes()) + 1, 0);
        }
        [[nodiscard]] Index clamped(double x, int axis) const {
            const double cell = std::floor((x - low[axis]) / side);
            return static_cast<Index>(std::clamp(cell, 0.0, static_cast<double>(count[axis] - 1)));
        }
        /// The cube at a place; the nearest one, outside the bounding box.
        [[nodiscard]] Cube cube_at(const Point<dim>& place) const {
            Cube at;
            for (int axis = 0; axis < dim; ++axis) at[axis] = clamped(place[axis], axis);
            return at;
        }
        [[nodiscard]] std::size_t number(const Cube& at) const {
            Index cube = at[dim - 1];
            for (int axis = dim - 2; axis >= 0; --axis) cube = cube * count[axis] + at[axis];
            return static_cast<std::size_t>(cube);
        }
        [[nodiscard]] bool is_within(const Point<dim>& place, double reach) const {
            return (low.array() <= place.array() + reach).all() &&
                   (high.array() >= place.array() - reach).all();
        }
        /// Which of the finer grids is the first that belongs to a cube or to one after it.
        [[nodiscard]] std::size_t first_finer(std::size_t cube) const {
            if (full.empty()) return 0;
            return static_cast<std::size_t>(std::lower_bound(full.begin(), full.end(), cube) - full.begin());
        }
    };

    [[nodiscard]] int particle(Index k) const { return particle_[static_cast<std::size_t>(k)]; }

    /// Sorts the particles at the places begin … end − 1 by their cubes in a grid.
    Grid sorted_grid(const Points<dim>& x, Index begin, Index end) {
        Point<dim> low = x.col(particle(begin)), high = low;
        for (Index k = begin + 1; k < end; ++k) {
            low = low.cwiseMin(x.col(particle(k)));
            high = high.cwiseMax(x.col(particle(k)));
        }
        Grid grid(low, high, static_cast<double>(end - begin));
        const std::size_t all = grid.first.size() - 1;
        std::vector<std::size_t> cube;
        cube.reserve(static_cast<std::size_t>(end - begin));
        for (Index k = begin; k < end; ++k) {
            cube.push_back(grid.number(grid.cube_at(x.col(particle(k)))));
            ++grid.first[cube.back() + 1];
        }
        grid.first[0] = static_cast<int>(begin);
        for (std::size_t c = 0; c < all; ++c) grid.first[c + 1] += grid.first[c];
        const std::vector<int> before(particle_.begin() + begin, particle_.begin() + end);
        std::vector<int> next(grid.first.begin(), grid.first.end() - 1);
        for (std::size_t k = 0; k < before.size(); ++k)
            particle_[static_cast<std::size_t>(next[cube[k]]++)] = before[k];

        const bool at_one_place = (high - low).squaredNorm() == 0;
        if (at_one_place && end - begin > most_in_cube && !crowd_)
            crowd_ = {particle(begin), particle(begin + 1)};
        for (std::size_t c = 0; c < all && !at_one_place; ++c)
            if (grid.first[c + 1] - grid.first[c] > most_in_cube) {
                grid.full.push_back(c);
                grid.finer.push_back(sorted_grid(x, grid.first[c], grid.first[c + 1]));
            }
        return grid;
    }

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

}  // namespace particles
