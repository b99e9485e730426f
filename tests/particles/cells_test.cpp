#include "particles/cells.hpp"

#include <doctest/doctest.h>

#include "tests/clouds.hpp"

using namespace particles;

namespace {

/// Particles and squared distances, in the order of the particles.
using Found = std::vector<std::pair<int, double>>;

template <int dim>
Found found(const Cells<dim>& cells, const Point<dim>& place, double reach) {
    Found all;
    cells.for_each_within(place, reach,
                          [&](int j, double distance_squared) { all.emplace_back(j, distance_squared); });
    std::sort(all.begin(), all.end());
    return all;
}

template <int dim>
Found by_brute_force(const Points<dim>& x, const Point<dim>& place, double reach) {
    Found all;
    for (Index j = 0; j < x.cols(); ++j) {
        const double distance_squared = (x.col(j) - place).squaredNorm();
        if (distance_squared < reach * reach) all.emplace_back(static_cast<int>(j), distance_squared);
    }
    return all;
}

template <int dim>
void check_every_kind() {
    for (const auto& [kind, x] : support::all_kinds<dim>(343)) {
        const auto& tried = kind;  // clang++ 14 captures no bindings
        CAPTURE(tried);
        CAPTURE(dim);
        const Cells<dim> cells(x);
        support::Draws draw(3);
        const Point<dim> middle = x.rowwise().mean();
        const double size = (x.rowwise().maxCoeff() - x.rowwise().minCoeff()).maxCoeff();
        std::vector<Point<dim>> places{x.col(0), x.col(x.cols() - 1),
                                       middle + 1e6 * size * Point<dim>::Ones()};
        for (int k = 0; k < 20; ++k) {
            places.push_back(x.col(k * (x.cols() - 1) / 20));
            places.push_back(middle + size * draw.template point<dim>());  // a part of them outside
        }
        for (const Point<dim>& place : places)
            for (const double reach : {0.0, 1e-7, 1e-3, 0.05, 1.0 / 6, 2.0 / 6, 0.7, 3.0, 1e7})
                REQUIRE(found(cells, place, reach * size) == by_brute_force(x, place, reach * size));
    }
}

}  // namespace

TEST_CASE("cells: each particle within reach is visited once, with its distance, as by brute force") {
    check_every_kind<1>();
    check_every_kind<2>();
    check_every_kind<3>();
}

TEST_CASE("cells: a particle at the distance of the reach is not within it") {
    const Cells<2> cells(support::grid_points<2>(5));  // spacing 1/4, which has no round-off
    CHECK(found<2>(cells, {0.5, 0.5}, 0.25).size() == 1);
    CHECK(found<2>(cells, {0.5, 0.5}, 0.25 * (1 + 1e-15)).size() == 5);
    CHECK(found<2>(cells, {0.5, 0.5}, 0).empty());
}

TEST_CASE("cells: a cube holds about two particles") {
    const auto per_cube = [](const auto& cells, double volume, int dim, Index N) {
        return static_cast<double>(N) * std::pow(cells.side(), dim) / volume;
    };
    for (const Index N : {100, 1000, 10000}) {
        CAPTURE(N);
        const double line = per_cube(Cells<1>(support::random_points<1>(N, 1)), 1, 1, N);
        const double plane = per_cube(Cells<2>(support::random_points<2>(N, 1)), 1, 2, N);
        const double space = per_cube(Cells<3>(support::random_points<3>(N, 1)), 1, 3, N);
        for (const double number : {line, plane, space}) {
            CHECK(number > 1);
            CHECK(number < 4);
        }
    }
}

TEST_CASE("cells: one particle, and several at one place, are found") {
    const Cells<2> one(Points<2>(Point<2>(0.3, 0.4)));
    CHECK(found<2>(one, {0.3, 0.4}, 1e-9) == Found{{0, 0.0}});
    CHECK(found<2>(one, {0, 0}, 0.6) == Found{{0, Point<2>(0.3, 0.4).squaredNorm()}});
    const Cells<3> same(Points<3>(Points<3>::Constant(3, 4, 2.5)));
    CHECK(found<3>(same, {2.5, 2.5, 2.5}, 1e-9) == Found{{0, 0.0}, {1, 0.0}, {2, 0.0}, {3, 0.0}});
}
