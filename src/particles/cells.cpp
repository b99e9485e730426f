#include "particles/cells.hpp"

#include <cmath>
#include <numeric>

namespace particles {

template <int dim>
Cells<dim>::Cells(const Points<dim>& x) : particle_(static_cast<std::size_t>(x.cols())) {
    std::iota(particle_.begin(), particle_.end(), 0);
    grid_ = sorted_grid(x, 0, x.cols());
    sorted_.resize(dim, x.cols());
    for (Index k = 0; k < x.cols(); ++k) sorted_.col(k) = x.col(particle(k));
}

template <int dim>
std::vector<double> Cells<dim>::nearest(const Point<dim>& place, Index k) const {
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

template <int dim>
double Cells<dim>::side_at(const Point<dim>& place) const {
    const Grid* grid = &grid_;
    while (!grid->full.empty()) {
        const std::size_t cube = grid->number(grid->cube_at(place)), finer = grid->first_finer(cube);
        if (finer == grid->full.size() || grid->full[finer] != cube) break;
        grid = &grid->finer[finer];
    }
    return grid->side;
}

template <int dim>
Cells<dim>::Grid::Grid(const Point<dim>& low_, const Point<dim>& high_, double N) : low(low_), high(high_) {
    const Point<dim> extent = high - low;
    side = std::max(extent.maxCoeff() / N, 1e-300);
    const auto cubes = [&] { return ((extent / side).array().floor() + 1).prod(); };
    while (cubes() > std::max(N / 2, 1.0)) side *= 1.1;
    for (int axis = 0; axis < dim; ++axis) count[axis] = static_cast<Index>(extent[axis] / side) + 1;
    first.assign(static_cast<std::size_t>(cubes()) + 1, 0);
}

template <int dim>
auto Cells<dim>::Grid::cube_at(const Point<dim>& place) const -> Cube {
    Cube at;
    for (int axis = 0; axis < dim; ++axis) {
        const double cell = std::floor((place[axis] - low[axis]) / side);
        at[axis] = static_cast<Index>(std::clamp(cell, 0.0, static_cast<double>(count[axis] - 1)));
    }
    return at;
}

template <int dim>
bool Cells<dim>::Grid::is_within(const Point<dim>& place, double reach) const {
    return (low.array() <= place.array() + reach).all() && (high.array() >= place.array() - reach).all();
}

template <int dim>
auto Cells<dim>::sorted_grid(const Points<dim>& x, Index begin, Index end) -> Grid {
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

template class Cells<1>;
template class Cells<2>;
template class Cells<3>;

}  // namespace particles
