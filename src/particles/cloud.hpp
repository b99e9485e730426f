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
#include "particles/points.hpp"
#include "particles/truncated_gaussian.hpp"

namespace particles {

using base::for_each_index;
using base::Index;
using base::InvalidInput;
using base::shown;

/// The particles of a cloud around a place, with one entry for each particle within reach. Offsets and kernel
/// are in units of the smoothing length h, so that the condition of local systems does not depend on h.
template <int dim, class Scalar = double>
struct Surroundings {
    Eigen::Array<Scalar, Eigen::Dynamic, dim> s;  ///< offsets \f$(\xi_j - x)/h\f$
    Column<Scalar> W;                             ///< kernel values, for h = 1
    Scalar edge;                ///< the kernel's derivative is \f$dW/d|s|^2 = -(W + \text{edge})\f$
    std::vector<int> particle;  ///< the particles' numbers in the cloud
};

/// Particles in the plane or in space, with a smoothing length each.
template <int dim>
class Cloud {
  public:
    /// Smoothing lengths are the distances Δ to the nearest neighbours.
    /// \param x positions, at least two, no two alike
    /// \throws InvalidInput naming the particle where a condition is broken
    explicit Cloud(Points<dim> x) : x_(checked(std::move(x))), cells_(x_), h_(x_.cols()) {
        if (const auto& crowd = cells_.crowd()) refuse_coincident((*crowd)[0], (*crowd)[1]);
        std::vector<int> nearest(static_cast<std::size_t>(size()));
        for_each_index(size(), [&](Index j) { h_[j] = nearest_neighbour(j, nearest); });
        for (Index j = 0; j < size(); ++j)
            if (h_[j] == 0) refuse_coincident(j, nearest[static_cast<std::size_t>(j)]);
    }

    [[nodiscard]] const Points<dim>& x() const { return x_; }
    [[nodiscard]] const Column<double>& h() const { return h_; }
    [[nodiscard]] Index size() const { return x_.cols(); }
    [[nodiscard]] const Cells<dim>& cells() const { return cells_; }

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
    Cells<dim> cells_;
    Column<double> h_;
};

/// The particles around a place, found among some particles of a cloud, for a smoothing length h. A particle
/// on the very edge of the support is left out, so that round-off does not decide (see Smoothing::reach()).
/// \param among candidates
template <int dim>
Surroundings<dim> surroundings(const Cloud<dim>& cloud, const TruncatedGaussian<dim>& kernel,
                               const Point<dim>& place, double h, std::vector<int> among) {
    const double edge = kernel.rho() * (1 - 1e-8), per_h = 1 / h;
    const auto most = static_cast<Index>(among.size());
    Eigen::Array<double, Eigen::Dynamic, dim> s(most, dim);
    Column<double> q(most);
    Index count = 0;
    for (const int j : among) {
        const Point<dim> offset = (cloud.x().col(j) - place) * per_h;
        for (Index axis = 0; axis < dim; ++axis) s(count, axis) = offset[axis];
        q[count] = offset.squaredNorm();
        among[static_cast<std::size_t>(count)] = j;
        count += q[count] < edge * edge ? 1 : 0;
    }
    among.resize(static_cast<std::size_t>(count));
    if (count < most) s.conservativeResize(count, Eigen::NoChange);
    return {std::move(s), kernel.at(q.head(count)), kernel.edge(), std::move(among)};
}

/// The same, found among all particles of the cloud.
template <int dim>
Surroundings<dim> surroundings(const Cloud<dim>& cloud, const TruncatedGaussian<dim>& kernel,
                               const Point<dim>& place, double h) {
    return surroundings(cloud, kernel, place, h, cloud.around(place, kernel.rho() * h));
}

}  // namespace particles
