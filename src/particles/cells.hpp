#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/index.hpp"
#include "particles/points.hpp"

namespace particles {

using base::Index;

/// Particles sorted into a grid of equal cubes, about two particles to a cube. The time to find the particles
/// near a place does not grow with their number. The cubes of a row are neighbours in memory.
template <int dim>
class Cells {
  public:
    /// \param x finite positions, at least one
    explicit Cells(const Points<dim>& x) : origin_(x.rowwise().minCoeff()) {
        const Point<dim> extent = x.rowwise().maxCoeff() - origin_;
        const auto N = static_cast<double>(x.cols());
        side_ = std::max(extent.maxCoeff() / N, 1e-300);
        const auto cubes = [&] { return ((extent / side_).array().floor() + 1).prod(); };
        while (cubes() > std::max(N / 2, 1.0)) side_ *= 1.1;
        for (int axis = 0; axis < dim; ++axis) count_[axis] = static_cast<Index>(extent[axis] / side_) + 1;

        const auto all = static_cast<std::size_t>(cubes());
        std::vector<std::size_t> cube(static_cast<std::size_t>(x.cols()));
        first_.assign(all + 1, 0);
        for (Index j = 0; j < x.cols(); ++j) {
            std::array<Index, dim> at{};
            for (int axis = 0; axis < dim; ++axis) at[axis] = clamped(x(axis, j), axis);
            cube[static_cast<std::size_t>(j)] = number(at);
            ++first_[number(at) + 1];
        }
        for (std::size_t k = 0; k < all; ++k) first_[k + 1] += first_[k];
        sorted_.resize(dim, x.cols());
        particle_.resize(static_cast<std::size_t>(x.cols()));
        std::vector<Index> next(first_.begin(), first_.end() - 1);
        for (Index j = 0; j < x.cols(); ++j) {
            const Index place = next[cube[static_cast<std::size_t>(j)]]++;
            sorted_.col(place) = x.col(j);
            particle_[static_cast<std::size_t>(place)] = static_cast<int>(j);
        }
    }

    /// Length of a cube's side.
    [[nodiscard]] double side() const { return side_; }

    /// Calls `visit(j, distance²)` for each particle j that is nearer to a place than `reach`.
    template <class Visit>
    void for_each_within(const Point<dim>& place, double reach, const Visit& visit) const {
        std::array<Index, dim> low{}, high{};
        for (int axis = 0; axis < dim; ++axis) {
            low[axis] = clamped(place[axis] - reach, axis);
            high[axis] = clamped(place[axis] + reach, axis);
        }
        std::array<Index, dim> at = low;
        while (true) {
            const std::size_t row = number(at);
            const Index last = first_[row + static_cast<std::size_t>(high[0] - low[0]) + 1];
            for (Index k = first_[row]; k < last; ++k) {
                const double distance_squared = (sorted_.col(k) - place).squaredNorm();
                if (distance_squared < reach * reach)
                    visit(particle_[static_cast<std::size_t>(k)], distance_squared);
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

  private:
    [[nodiscard]] Index clamped(double x, int axis) const {
        const double cell = std::floor((x - origin_[axis]) / side_);
        return static_cast<Index>(std::clamp(cell, 0.0, static_cast<double>(count_[axis] - 1)));
    }
    [[nodiscard]] std::size_t number(const std::array<Index, dim>& at) const {
        Index cube = at[dim - 1];
        for (int axis = dim - 2; axis >= 0; --axis) cube = cube * count_[axis] + at[axis];
        return static_cast<std::size_t>(cube);
    }

    Point<dim> origin_;
    double side_ = 0;
    std::array<Index, dim> count_{};
    std::vector<Index> first_;   // place of each cube's first particle in the sorted order
    std::vector<int> particle_;  // number of the particle at each place
    Points<dim> sorted_;
};

}  // namespace particles
