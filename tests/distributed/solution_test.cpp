#include "distributed/solution.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "bodies/level.hpp"
#include "distributed/grid.hpp"
#include "tests/distributed/parts.hpp"
#include "tests/distributed/world.hpp"
#include "tests/support/relative.hpp"
#include "tests/support/remedies.hpp"

using namespace bodies;
using distributed::Grid;
using distributed::Part;
using distributed::Processes;

namespace {

Discretisation by(Method method) {
    Discretisation how;
    how.method = method;
    return how;
}

/// The part of this process, of a body with a given process for each particle.
template <int dim>
Part<dim> part_of(const Body<dim>& body, Discretisation how, const std::vector<int>& owner) {
    const Cloud<dim> cloud(body.x);
    how.spacing = particles::Spacing(particles::spacing(cloud, how.spacing));
    const Approximation<dim> approximation(cloud, how);
    return distributed::part_of(body, approximation, distributed::owners_of(body, approximation, owner),
                                support::world().rank());
}

/// The largest difference from the solution of one machine, relative to the largest unknown, on all
/// processes.
template <int dim, int n>
double difference(const Problem<dim, n>& problem, const Body<dim>& body, const Part<dim>& part) {
    const Processes all = support::world();
    const auto expected = bodies::solve(problem, body, by(part.how.method));
    const auto found = distributed::solve(all, part, problem);
    double most = 0;
    for (std::size_t k = 0; k < part.number.size() && found.part; ++k)
        for (Index i = 0; i < n; ++i)
            most = std::max(most, std::abs(found.part->above[n * static_cast<Index>(k) + i] -
                                           expected.above[n * part.number[k] + i]));
    if (found.part) CHECK(found.part->level == expected.level);
    return all.largest(most) / expected.above.cwiseAbs().maxCoeff();
}

}  // namespace

TEST_CASE("solution: on any number of processes it is that of one machine") {
    const int processes = support::world().count();
    const auto on_grid = [&](const auto& grid, const auto& problem, Method method) {
        const auto part = distributed::part_of(grid, by(method), processes, support::world().rank());
        return difference(problem, distributed::body_of(grid), part);
    };
    for (const Method method : {Method::fpm, Method::strong}) {
        CHECK(on_grid(Grid<2>{{41, 30}, {1, 1}}, support::heat<2>(), method) < 1e-9);
        CHECK(on_grid(Grid<2>{{41, 30}, {1, 1}}, bodies::above_level(support::heat<2>(), -1e6), method) <
              1e-9);
        CHECK(on_grid(Grid<2>{{31, 20}, {2, 1}}, support::pulled<2>(), method) < 1e-9);
        CHECK(on_grid(Grid<3>{{9, 8, 7}, {1, 1, 1}}, support::heat<3>(), method) < 1e-9);
        CHECK(on_grid(Grid<3>{{8, 7, 7}, {1, 1, 1}}, support::pulled<3>(), method) < 1e-9);
    }
}

TEST_CASE("solution: nor does it matter which process has which particle, or that some have none") {
    const Body<2> body = support::block<2>({{24, 18}, 0.2, 2});
    const auto N = static_cast<std::size_t>(body.x.cols());
    const int last = support::world().count() - 1;
    std::vector<int> mixed, few(N, 0), none_on_first(N, last);
    for (std::size_t I = 0; I < N; ++I) mixed.push_back(static_cast<int>(I * I) % (last + 1));
    for (std::size_t I = 0; I < 5; ++I) few[I] = last;
    for (const auto& owner : {mixed, few, none_on_first})
        CHECK(difference(support::pulled<2>(), body, part_of(body, by(Method::strong), owner)) < 1e-9);
}

TEST_CASE("solution: the rows in PETSc's matrix are those of one machine to the last bit") {
    const Processes all = support::world();
    const Grid<2> grid{{15, 11}, {1, 1}};
    const Body<2> body = distributed::body_of(grid);
    const auto problem = support::pulled<2>();
    const auto part = distributed::part_of(grid, by(Method::fpm), all.count(), all.rank());
    const distributed::Numbering numbering(all, part, 2);
    const auto system = distributed::assembled<2, 2>(numbering, part, problem, conditions(problem, part.body),
                                                     distributed::approximation_of(part), Wanted::solution);
    auto expected =
        collocated(problem, conditions(problem, body), Approximation<2>(Cloud<2>(body.x), by(Method::fpm)));
    solvers::SparseRows none;
    solvers::scale_rows(expected.A, expected.b, none);
    // Where a place in PETSc's vectors lies in the whole body.
    std::vector<double> own;
    for (std::size_t k = 0; k < part.number.size(); ++k) own.push_back(static_cast<double>(part.number[k]));
    std::vector<double> number(static_cast<std::size_t>(body.x.cols()), -1);
    for (std::size_t k = 0; k < part.number.size(); ++k)
        number[static_cast<std::size_t>(numbering.places()[k])] = own[k];
    Index entries = 0;
    for (const int I : part.own)
        for (PetscInt i = 0; i < 2; ++i) {
            const Index row = 2 * part.number[static_cast<std::size_t>(I)] + i;
            PetscInt count = 0;
            const PetscInt* columns = nullptr;
            const PetscScalar* values = nullptr;
            const PetscInt place = 2 * numbering.places()[static_cast<std::size_t>(I)] + i;
            MatGetRow(system.A, place, &count, &columns, &values);
            CHECK(count == expected.A.row(row).nonZeros());
            for (PetscInt k = 0; k < count; ++k)
                CHECK(values[k] ==
                      expected.A.coeff(
                          row, 2 * static_cast<Index>(number[static_cast<std::size_t>(columns[k] / 2)]) +
                                   columns[k] % 2));
            entries += count;
            MatRestoreRow(system.A, place, &count, &columns, &values);
        }
    CHECK(all.sum(static_cast<double>(entries)) == static_cast<double>(expected.A.nonZeros()));
    MatInfo info;
    MatGetInfo(system.A, MAT_LOCAL, &info);
    CHECK(info.mallocs == 0);
    CHECK(info.nz_allocated == info.nz_used);
}

TEST_CASE("solution: the lowest eigenvalues are those of one machine") {
    const Processes all = support::world();
    const Grid<2> grid{{25, 19}, {1, 1}};
    const Body<2> body = distributed::body_of(grid);
    for (const Method method : {Method::fpm, Method::strong}) {
        const auto part = distributed::part_of(grid, by(method), all.count(), all.rank());
        const auto found = distributed::eigenvalues(all, part, support::pulled<2>(), 4);
        const auto expected = bodies::eigenvalues(support::pulled<2>(), body, by(method), 4);
        REQUIRE(found.size() == 4);
        for (std::size_t k = 0; k < 4; ++k) CHECK(found[k] == support::relative(expected[k], 1e-8));
    }
    const auto part = distributed::part_of(grid, by(Method::fpm), all.count(), all.rank());
    CHECK_THROWS_WITH_AS(distributed::eigenvalues(all, part, support::heat<2>(), 1000),
                         "ask for 1 to 237 modes on 475 particles, got 1000", base::InvalidInput);
}

TEST_CASE("solution: derivatives that cannot be trusted on one process are refused on all") {
    const Processes all = support::world();
    Discretisation how = by(Method::fpm);
    how.smoothing = 0.4;
    const auto part = distributed::part_of(Grid<2>{{20, 20}, {1, 1}}, how, all.count(), all.rank());
    const std::string why = support::refusal([&] { distributed::solve(all, part, support::heat<2>()); });
    CAPTURE(why);
    CHECK(why.starts_with("fpm: at ("));
    CHECK(why == all.from(0, why));
    how.smoothing = support::smoothing_to_try(why);
    const auto other = distributed::part_of(Grid<2>{{20, 20}, {1, 1}}, how, all.count(), all.rank());
    CHECK_NOTHROW(distributed::solve(all, other, support::heat<2>()));
}

TEST_CASE("solution: a method whose equations need the whole body is refused") {
    const Processes all = support::world();
    const auto part =
        distributed::part_of(Grid<2>{{9, 9}, {1, 1}}, by(Method::weak1), all.count(), all.rank());
    CHECK_THROWS_WITH_AS(distributed::solve(all, part, support::heat<2>()),
                         "weak1: works on one machine only, in the program body; here take fpm or strong",
                         base::InvalidInput);
}

TEST_CASE("solution: numbers of the own particles reach every halo") {
    const Processes all = support::world();
    const auto part = distributed::part_of(Grid<2>{{9, 8}, {1, 1}}, by(Method::fpm), all.count(), all.rank());
    const distributed::Numbering numbering(all, part, 1);
    Eigen::MatrixXd own(3, static_cast<Index>(part.own.size()));
    for (Index k = 0; k < own.cols(); ++k)
        own.col(k).setConstant(static_cast<double>(
            part.number[static_cast<std::size_t>(part.own[static_cast<std::size_t>(k)])]));
    const Eigen::MatrixXd everywhere = numbering.at_all(own);
    for (Index k = 0; k < everywhere.cols(); ++k)
        CHECK((everywhere.col(k).array() == static_cast<double>(part.number[static_cast<std::size_t>(k)]))
                  .all());
}
