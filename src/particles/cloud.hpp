#pragma once

#include <vector>

#include "base/errors.hpp"
#include "base/index.hpp"
#include "particles/cells.hpp"
#include "particles/points.hpp"

namespace particles {

using base::Index;
using base::InvalidInput;

/// The distance δ of a grid of N particles that fills a box with sides L: \f$\prod_a (L_a/\delta + 1) = N\f$.
template <int dim>
double spacing_of_grid(const Point<dim>& L, Index N);

/// Particles in any order in one, two or three dimensions: positions, and a volume for each particle
/// [length^dim]. Compiled once for each dimension, in cloud.cpp.
template <int dim>
class Cloud {
  public:
    /// All volumes are \f$\delta^{\dim}\f$ with the mean distance δ: on a grid, the volume of a cell.
    /// \param x positions, at least two, no two alike
    /// \throws InvalidInput naming the particle where a condition is broken
    explicit Cloud(const Points<dim>& x);

    /// \param V volumes, not negative, one per particle
    Cloud(Points<dim> x, Column<double> V);

    [[nodiscard]] const Points<dim>& x() const { return x_; }
    [[nodiscard]] const Column<double>& V() const { return V_; }
    [[nodiscard]] Index size() const { return x_.cols(); }
    [[nodiscard]] const Cells<dim>& cells() const { return cells_; }

    /// Distance Δ of each particle to the nearest other one. [length]
    [[nodiscard]] const Column<double>& apart() const { return apart_; }

    /// Mean distance δ between particles: that of a grid of as many that fills the same box. [length]
    [[nodiscard]] double spacing() const;

    /// The particles nearer to a place than `reach`, in the order of the search, which is the same each time.
    [[nodiscard]] std::vector<int> around(const Point<dim>& place, double reach) const;

    /// The same in increasing order.
    [[nodiscard]] std::vector<int> within(const Point<dim>& place, double reach) const;

    /// The particle nearest to a place; the first of several at the same distance.
    [[nodiscard]] int nearest(const Point<dim>& place) const;

  private:
    Points<dim> x_;
    Column<double> V_;
    Cells<dim> cells_;
    Column<double> apart_;
};

extern template class Cloud<1>;
extern template class Cloud<2>;
extern template class Cloud<3>;

}  // namespace particles
