#pragma once

#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "particles/cells.hpp"

/// Particles of many kinds, in one, two and three dimensions.
namespace support {

using particles::Index;
using particles::Point;
using particles::Points;

/// Random numbers from [−1, 1], the same for the same seed.
class Draws {
  public:
    explicit Draws(unsigned seed) : random_(seed) {}
    double operator()() { return 2 * (static_cast<double>(random_()) / 4294967295.0) - 1; }

    template <int dim>
    Point<dim> point() {
        Point<dim> x;
        for (double& coordinate : x) coordinate = (*this)();
        return x;
    }

  private:
    std::mt19937 random_;
};

/// N random places in the unit cube.
template <int dim>
Points<dim> random_points(Index N, unsigned seed) {
    Draws draw(seed);
    Points<dim> x(dim, N);
    for (Index j = 0; j < N; ++j) x.col(j) = (draw.point<dim>().array() + 1) / 2;
    return x;
}

/// A grid on the unit cube, n particles in each direction.
template <int dim>
Points<dim> grid_points(Index n) {
    const auto N = static_cast<Index>(std::lround(std::pow(static_cast<double>(n), dim)));
    Points<dim> x(dim, N);
    for (Index j = 0; j < N; ++j)
        for (Index axis = 0, rest = j; axis < dim; ++axis, rest /= n)
            x(axis, j) = static_cast<double>(rest % n) / static_cast<double>(n - 1);
    return x;
}

/// A grid whose particles are moved by up to a times the spacing.
template <int dim>
Points<dim> irregular_points(Index n, double a, unsigned seed) {
    Draws draw(seed);
    Points<dim> x = grid_points<dim>(n);
    for (Index j = 0; j < x.cols(); ++j) x.col(j) += a / static_cast<double>(n - 1) * draw.point<dim>();
    return x;
}

/// Clouds of many kinds by their names; no two particles coincide.
template <int dim>
std::vector<std::pair<std::string, Points<dim>>> all_kinds(Index N) {
    const Points<dim> random = random_points<dim>(N, 7);
    Points<dim> graded = random, axis = Points<dim>::Zero(dim, N), diagonal = random, line = random,
                outlier = random, clusters = random, nested = random, spiral = Points<dim>::Zero(dim, N);
    for (Index j = 0; j < N; ++j) {
        graded.col(j) *= std::pow(10, -8 * random(0, j));  // distances from 1 down to 1e-8
        axis(dim - 1, j) = random(0, j);
        diagonal.col(j).setConstant(random(0, j));
        line.col(j) = random(0, j) * Point<dim>::LinSpaced(1, 3.3).array() + 0.3;
        clusters.col(j) = 1e-6 * random.col(j).array() + static_cast<double>(j % 2);
        nested.col(j) *= std::pow(1e-3, static_cast<double>(j % 4));
        const double turn = static_cast<double>(j) / static_cast<double>(N), r = std::exp(-18 * turn);
        for (int k = 0; k < dim; ++k) spiral(k, j) = k < 2 ? r * std::cos(60 * turn + 1.5 * k) : r;
    }
    outlier.col(N / 2).setConstant(1e6);
    const Index n = std::lround(std::pow(static_cast<double>(N), 1.0 / dim));
    return {{"random", random},
            {"graded", graded},
            {"along an axis", axis},
            {"along a diagonal", diagonal},
            {"along a line", line},
            {"one of them far away", outlier},
            {"two clusters", clusters},
            {"clusters in clusters", nested},
            {"an exponential spiral", spiral},
            {"far from the origin", (random.array() + 1e6).matrix()},
            {"negative and large", (-1e9 * random.array()).matrix()},
            {"a grid", grid_points<dim>(n)},
            {"two", random.leftCols(2)}};
}

}  // namespace support
