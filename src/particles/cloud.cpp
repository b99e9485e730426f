#include "particles/cloud.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/parallel.hpp"
#include "base/text.hpp"

namespace particles {

namespace {

template <int dim>
Points<dim> checked(Points<dim> x) {
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

/// Distance from particle j to the nearest other one. \param[out] number of that one
template <int dim>
double nearest_neighbour(const Points<dim>& x, const Cells<dim>& cells, Index j, int& number) {
    double least = -1, reach = cells.side_at(x.col(j)) / 2;
    while (least < 0)
        cells.for_each_within(x.col(j), reach *= 2, [&](int k, double distance_squared) {
            if (k == j || (least >= 0 && distance_squared >= least)) return;
            least = distance_squared;
            number = k;
        });
    return std::sqrt(least);
}

}  // namespace

template <int dim>
double spacing_of_grid(const Point<dim>& L, Index N) {
    // Newton's method for 1/δ starts from what is too large, and decreases.
    double per_length = static_cast<double>(N - 1) / L.sum();
    while (true) {
        const Eigen::Array<double, dim, 1> along = L.array() * per_length + 1;
        const double less = (1 - static_cast<double>(N) / along.prod()) / (L.array() / along).sum();
        if (!(per_length - less < per_length)) return 1 / per_length;
        per_length -= less;
    }
}

template <int dim>
Cloud<dim>::Cloud(const Points<dim>& x) : Cloud(x, Column<double>::Zero(x.cols())) {
    V_.setConstant(std::pow(spacing(), dim));
}

template <int dim>
Cloud<dim>::Cloud(Points<dim> x, Column<double> V)
    : x_(checked<dim>(std::move(x))), V_(std::move(V)), cells_(x_), apart_(x_.cols()) {
    if (V_.size() != size())
        throw InvalidInput(std::to_string(size()) + " particles need as many volumes, got " +
                           std::to_string(V_.size()));
    for (Index j = 0; j < size(); ++j)
        if (!std::isfinite(V_[j]) || V_[j] < 0)
            throw InvalidInput("particle " + std::to_string(j) +
                               " has a volume that is negative or not finite");
    const auto refuse_coincident = [&](Index j, Index k) {
        throw InvalidInput("particles " + std::to_string(j) + " and " + std::to_string(k) + " coincide at " +
                           shown_point(x_.col(j)));
    };
    if (const auto& crowd = cells_.crowd()) refuse_coincident((*crowd)[0], (*crowd)[1]);
    std::vector<int> nearest(static_cast<std::size_t>(size()));
    base::for_each_index(size(), [&](Index j) {
        apart_[j] = nearest_neighbour<dim>(x_, cells_, j, nearest[static_cast<std::size_t>(j)]);
    });
    for (Index j = 0; j < size(); ++j)
        if (apart_[j] == 0) refuse_coincident(j, nearest[static_cast<std::size_t>(j)]);
}

template <int dim>
double Cloud<dim>::spacing() const {
    const Point<dim> sides = x_.rowwise().maxCoeff() - x_.rowwise().minCoeff();
    return spacing_of_grid<dim>(sides, size());
}

template <int dim>
std::vector<int> Cloud<dim>::around(const Point<dim>& place, double reach) const {
    std::vector<int> found;
    found.reserve(64);
    cells_.for_each_within(place, reach, [&](int j, double) { found.push_back(j); });
    return found;
}

template <int dim>
std::vector<int> Cloud<dim>::within(const Point<dim>& place, double reach) const {
    std::vector<int> found = around(place, reach);
    std::sort(found.begin(), found.end());
    return found;
}

template <int dim>
int Cloud<dim>::nearest(const Point<dim>& place) const {
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

template double spacing_of_grid<1>(const Point<1>&, Index);
template double spacing_of_grid<2>(const Point<2>&, Index);
template double spacing_of_grid<3>(const Point<3>&, Index);

template class Cloud<1>;
template class Cloud<2>;
template class Cloud<3>;

}  // namespace particles
