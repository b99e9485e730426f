#include "particles/cells.hpp"

#include <doctest/doctest.h>

#include "tests/support/clouds.hpp"

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

/// Mean number of particles in a cube of the unit cube's grid.
template <int dim>
double per_cube(const Points<dim>& x) {
    return static_cast<double>(x.cols()) * std::pow(Cells<dim>(x).side_at(x.col(0)), dim);
}

/// Particles whose distance is computed until each has found its nearest neighbour, over their number.
template <int dim>
double candidates_of_each(const Points<dim>& x) {
    const Cells<dim> cells(x);
    double candidates = 0;
    for (Index j = 0; j < x.cols(); ++j) {
        int within = 0;
        for (double reach = cells.side_at(x.col(j)); within < 2; reach *= 2) {
            within = 0;
            cells.for_each_candidate(x.col(j), reach, [&](int, double distance_squared) {
                ++candidates;
                within += distance_squared < reach * reach ? 1 : 0;
            });
        }
    }
    return candidates / static_cast<double>(x.cols());
}

template <int dim>
void check_candidates() {
    for (const auto& [kind, x] : support::all_kinds<dim>(20000)) {
        const auto& tried = kind;
        CAPTURE(tried);
        CAPTURE(dim);
        CHECK(candidates_of_each(x) < 300);
    }
}

template <int dim>
void check_nearest() {
    for (const auto& [kind, x] : support::all_kinds<dim>(343)) {
        const auto& tried = kind;
        CAPTURE(tried);
        CAPTURE(dim);
        const Cells<dim> cells(x);
        for (Index j = 0; j < x.cols(); j += 11)
            for (const Index k : {Index{1}, Index{2}, std::min<Index>(9, x.cols()), x.cols()}) {
                std::vector<double> distances;
                for (Index i = 0; i < x.cols(); ++i) distances.push_back((x.col(i) - x.col(j)).squaredNorm());
                std::sort(distances.begin(), distances.end());
                distances.resize(static_cast<std::size_t>(k));
                REQUIRE(cells.nearest(x.col(j), k) == distances);
            }
    }
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
    for (const Index N : {100, 1000, 10000}) {
        CAPTURE(N);
        const double line = per_cube(support::random_points<1>(N, 1));
        const double plane = per_cube(support::random_points<2>(N, 1));
        const double space = per_cube(support::random_points<3>(N, 1));
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

TEST_CASE("cells: the distances to the k nearest are those of brute force") {
    check_nearest<1>();
    check_nearest<2>();
    check_nearest<3>();
}

TEST_CASE("cells: the candidates for a nearest neighbour are few for each particle, wherever particles lie") {
    check_candidates<1>();
    check_candidates<2>();
    check_candidates<3>();
}

TEST_CASE("cells: a few of many particles at one place are named, and two that are apart are not") {
    Points<3> x = support::random_points<3>(2000, 1);
    CHECK_FALSE(Cells<3>(x).crowd());
    for (Index j = 500; j < 1500; ++j) x.col(j) = x.col(100);
    CHECK(Cells<3>(x).crowd() == std::array{100, 500});
    CHECK(found<3>(Cells<3>(x), x.col(100), 1e-9).size() == 1001);
    for (Index j = 500; j < 1500; ++j) x(0, j) *= 1 + static_cast<double>(j) * 1e-15;
    CHECK_FALSE(Cells<3>(x).crowd());
    CHECK(Cells<1>(Points<1>(Points<1>::Constant(1, 70, 2.5))).crowd() == std::array{0, 1});
}
