#include "distributed/grid.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

#include "tests/distributed/parts.hpp"

using namespace bodies;
using distributed::Grid;

namespace {

template <int dim>
void check_parts(const Grid<dim>& grid, const Discretisation& how, int processes) {
    const Body<dim> body = distributed::body_of(grid);
    std::vector<distributed::Part<dim>> parts;
    for (int process = 0; process < processes; ++process)
        parts.push_back(distributed::part_of(grid, how, processes, process));
    support::check_parts_are_of(body, parts);
    for (const auto& part : parts) support::check_rows_are_those_of(support::heat<dim>(), body, how, part);
}

template <int dim>
void check_linear_field(const Grid<dim>& grid) {
    const Body<dim> body = distributed::body_of(grid);
    const support::Manufactured<dim, dim> exact(elasticity<dim>({1, 0.3}), 1, 2);
    Discretisation how;
    how.method = Method::hats;
    const auto problem = exact.problem(body, {"left"});
    CHECK(support::errors(problem, solve(problem, body, how), exact).u < 1e-9);
}

}  // namespace

TEST_CASE("grid: its parts are those of the whole, with equations that are the same to the last bit") {
    for (const Method method : {Method::fpm, Method::strong})
        for (const auto& spacing :
             {particles::Spacing(particles::Spacing::local), particles::Spacing(particles::Spacing::mean),
              particles::Spacing(particles::Spacing::largest), particles::Spacing::to_nearest(9),
              particles::Spacing(0.2)}) {
            Discretisation how;
            how.method = method;
            how.spacing = spacing;
            check_parts(Grid<2>{{17, 9}, {2, 1}}, how, 3);
        }
    check_parts(Grid<2>{{30, 7}, {4, 1}}, {}, 4);  // cells of other sides
    check_parts(Grid<3>{{9, 8, 7}, {1, 1, 1}}, {}, 3);
    check_parts(Grid<2>{{7, 7}, {1, 1}}, {}, 60);  // more processes than particles
}

TEST_CASE("grid: smoothing lengths of each particle go with it") {
    const Grid<2> grid{{9, 9}, {1, 1}};
    Discretisation how;
    how.spacing = particles::Spacing(Column<double>(Column<double>::LinSpaced(81, 0.125, 0.2)));
    check_parts(grid, how, 3);
}

TEST_CASE("grid: a linear field is solved exactly by a weak form, whose pieces must be faces of the cells") {
    check_linear_field(Grid<2>{{8, 6}, {2, 1}});
    check_linear_field(Grid<3>{{5, 6, 5}, {1, 1.5, 1}});
}

TEST_CASE("grid: what is no grid is refused") {
    const auto size = [](Index count, double length) {
        return distributed::checked_size(Grid<2>{{count, 5}, {1, length}});
    };
    CHECK(size(4, 2) == 20);
    CHECK_THROWS_WITH_AS(size(1, 1), "a grid needs at least 2 particles along each axis, got 1",
                         base::InvalidInput);
    CHECK_THROWS_WITH_AS(size(4, 0), "the lengths of a grid must be positive and finite, got 0",
                         base::InvalidInput);
    CHECK_THROWS_AS(size(4, std::numeric_limits<double>::infinity()), base::InvalidInput);
    CHECK_THROWS_AS(size(Index{1} << 60, 1), base::InvalidInput);
}
