#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/errors.hpp"
#include "base/index.hpp"
#include "base/pack.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "particles/cells.hpp"

namespace particles {

using base::for_each_index;
using base::Index;
using base::InvalidInput;
using base::shown;

namespace detail {

/// The distance δ of a grid of N particles that fills a box with sides L: \f$\prod_a (L_a/\delta + 1) = N\f$.
/// Newton's method for 1/δ starts at \f$(N-1)/\sum_a L_a\f$, which is too large, and decreases.
template <int dim>
double spacing_of_grid(const Point<dim>& L, Index N) {
    double per_length = static_cast<double>(N - 1) / L.sum();
    while (true) {
        const Eigen::Array<double, dim, 1> along = L.array() * per_length + 1;
        const double less = (1 - static_cast<double>(N) / along.prod()) / (L.array() / along).sum();
        if (!(per_length - less < per_length)) return 1 / per_length;
        per_length -= less;
    }
}

}  // namespace detail

/// Particles in any order in one, two or three dimensions: positions, and a volume for each particle
/// [length^dim].
template <int dim>
class Cloud {
  public:
    /// All volumes are \f$\delta^{\dim}\f$ with the mean distance δ: on a grid, the volume of a cell.
    /// \param x positions, at least two, no two alike
    /// \throws InvalidInput naming the particle where a condition is broken
    explicit Cloud(const Points<dim>& x) : Cloud(x, Column<double>::Zero(x.cols())) {
        V_.setConstant(std::pow(spacing(), dim));
    }

    /// \param V volumes, not negative, one per particle
    Cloud(Points<dim> x, Column<double> V)
        : x_(checked(std::move(x))), V_(std::move(V)), cells_(x_), apart_(x_.cols()) {
        if (V_.size() != size())
            throw InvalidInput(std::to_string(size()) + " particles need as many volumes, got " +
                               std::to_string(V_.size()));
        for (Index j = 0; j < size(); ++j)
            if (!std::isfinite(V_[j]) || V_[j] < 0)
                throw InvalidInput("particle " + std::to_string(j) +
                                   " has a volume that is negative or not finite");
        if (const auto& crowd = cells_.crowd()) refuse_coincident((*crowd)[0], (*crowd)[1]);
        std::vector<int> nearest(static_cast<std::size_t>(size()));
        for_each_index(size(), [&](Index j) { apart_[j] = nearest_neighbour(j, nearest); });
        for (Index j = 0; j < size(); ++j)
            if (apart_[j] == 0) refuse_coincident(j, nearest[static_cast<std::size_t>(j)]);
    }

    [[nodiscard]] const Points<dim>& x() const { return x_; }
    [[nodiscard]] const Column<double>& V() const { return V_; }
    [[nodiscard]] Index size() const { return x_.cols(); }
    [[nodiscard]] const Cells<dim>& cells() const { return cells_; }

    /// Distance Δ of each particle to the nearest other one. [length]
    [[nodiscard]] const Column<double>& apart() const { return apart_; }

    /// Mean distance δ between particles: that of a grid of as many that fills the same box. [length]
    [[nodiscard]] double spacing() const {
        const Point<dim> sides = x_.rowwise().maxCoeff() - x_.rowwise().minCoeff();
        return detail::spacing_of_grid<dim>(sides, size());
    }

    /// The particles nearer to a place than `reach`, in the order of the search, which is the same each time.
    [[nodiscard]] std::vector<int> around(const Point<dim>& place, double reach) const {
        std::vector<int> found;
        found.reserve(64);
        cells_.for_each_within(place, reach, [&](int j, double) { found.push_back(j); });
        return found;
    }

    /// The same in increasing order.
    [[nodiscard]] std::vector<int> within(const Point<dim>& place, double reach) const {
        std::vector<int> found = around(place, reach);
        std::sort(found.begin(), found.end());
        return found;
    }

    /// The particle nearest to a place; the first of several at the same distance.
    [[nodiscard]] int nearest(const Point<dim>& place) const {
        int closest = -1;
        double least = 0, reach = cells_.side_at(place) / 2;
        while (closest < 0)
            cells_.for_each_within(place, reach *= 2, [&](int j, double distance_squared) {
                if (closest >= 0 && (distance_squared > least || (distance_squared == least && j > closest)))
                    return;
                closest = j;
                least = distance_squared;
            });
        return closest;
    }

  private:
    static Points<dim> checked(Points<dim> x) {
        if (x.cols() < 2)
            throw InvalidInput("a cloud needs at least 2 particles, got " + std::to_string(x.cols()));
        for (Index j = 0; j < x.cols(); ++j) {
            if (!x.col(j).allFinite())
                throw InvalidInput("particle " + std::to_string(j) + " is not at a finite position");
            if (x.col(j).squaredNorm() > 1e300)  // distances to there overflow
                throw InvalidInput("particle " + std::to_string(j) + " is too far away, at " +
                                   shown_point(x.col(j)));
        }
        return x;
    }

    [[noreturn]] void refuse_coincident(Index j, Index k) const {
        throw InvalidInput("particles " + std::to_string(j) + " and " + std::to_string(k) + " coincide at " +
                           shown_point(x_.col(j)));
    }

    double nearest_neighbour(Index j, std::vector<int>& nearest) const {
        double least = -1, reach = cells_.side_at(x_.col(j)) / 2;
        while (least < 0)
            cells_.for_each_within(x_.col(j), reach *= 2, [&](int k, double distance_squared) {
                if (k == j || (least >= 0 && distance_squared >= least)) return;
                least = distance_squared;
                nearest[static_cast<std::size_t>(j)] = k;
            });
        return std::sqrt(least);
    }

    Points<dim> x_;
    Column<double> V_;
    Cells<dim> cells_;
    Column<double> apart_;
};

}  // namespace particles
