#include "distributed/part.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "distributed/bytes.hpp"
#include "tests/distributed/parts.hpp"

using namespace bodies;
using distributed::Part;
using support::block;

namespace {

Discretisation by(Method method) {
    Discretisation how;
    how.method = method;
    return how;
}

/// The method with smoothing lengths that are given.
template <int dim>
Approximation<dim> approximation_of(const Body<dim>& body, Discretisation how) {
    const Cloud<dim> cloud(body.x);
    how.spacing = particles::Spacing(particles::spacing(cloud, how.spacing));
    return Approximation<dim>(cloud, how);
}

template <int dim>
std::vector<Part<dim>> parts_of(const Body<dim>& body, const Discretisation& how,
                                const std::vector<int>& owner, int processes) {
    const auto approximation = approximation_of(body, how);
    const auto owners = distributed::owners_of(body, approximation, owner);
    std::vector<Part<dim>> all;
    for (int process = 0; process < processes; ++process)
        all.push_back(distributed::part_of(body, approximation, owners, process));
    return all;
}

/// A process for each particle by chance, so that parts lie within each other.
std::vector<int> scattered(Index particles, int processes) {
    support::Draws draw(3);
    std::vector<int> owner;
    for (Index I = 0; I < particles; ++I)
        owner.push_back(std::min(processes - 1, static_cast<int>((draw() + 1) / 2 * processes)));
    return owner;
}

}  // namespace

TEST_CASE("part: halves of halves have as many particles, or one more or less") {
    const Body<3> body = block<3>({{6, 4, 3}, 0.2, 1});
    for (const int processes : {1, 2, 3, 5, 8}) {
        const auto owner = distributed::bisected<3>(body.x, processes);
        const auto each = static_cast<int>(body.x.cols()) / processes;
        for (int process = 0; process < processes; ++process)
            CHECK(std::abs(std::count(owner.begin(), owner.end(), process) - each) <= 1);
    }
}

TEST_CASE("part: of three particles on five processes two have none") {
    particles::Points<2> x(2, 3);
    x << 0, 1, 2, 0, 0, 0;
    const auto owner = distributed::bisected<2>(x, 5);
    CHECK(std::set<int>(owner.begin(), owner.end()).size() == 3);
}

TEST_CASE("part: each particle, piece and cell belongs to one process") {
    const Body<2> body = support::angle(4, 0.3, 1);
    for (const auto& owner : {distributed::bisected<2>(body.x, 3), scattered(body.x.cols(), 3)})
        support::check_parts_are_of(body, parts_of(body, by(Method::fpm), owner, 3));
}

TEST_CASE("part: its equations are those of the whole body to the last bit") {
    const Body<2> square = block<2>({{13, 9}, 0.25, 2});
    const Body<3> cube = block<3>({{7, 6, 5}, 0.1, 4});
    for (const Method method : {Method::fpm, Method::strong})
        for (const auto kind :
             {particles::Spacing::local, particles::Spacing::mean, particles::Spacing::largest}) {
            Discretisation how = by(method);
            how.spacing = kind;
            for (const auto& owner : {distributed::bisected<2>(square.x, 3), scattered(square.x.cols(), 3)})
                for (const auto& part : parts_of(square, how, owner, 3)) {
                    support::check_rows_are_those_of(support::heat<2>(), square, how, part);
                    support::check_rows_are_those_of(support::pulled<2>(), square, how, part);
                }
            for (const auto& part : parts_of(cube, how, distributed::bisected<3>(cube.x, 2), 2))
                support::check_rows_are_those_of(support::pulled<3>(), cube, how, part);
        }
}

TEST_CASE("part: the sums of a solution's judgement over the parts are those over the body") {
    const Body<2> body = block<2>({{12, 10}, 0.2, 3});
    const auto problem = support::pulled<2>();
    const auto solution = solve(problem, body, by(Method::strong));
    const auto extent = extent_of(body);
    std::vector<double> most, added;
    for (const auto& part : parts_of(body, by(Method::strong), scattered(body.x.cols(), 3), 3)) {
        Eigen::VectorXd u(2 * part.body.x.cols());
        for (Index k = 0; k < part.body.x.cols(); ++k)
            u.segment<2>(2 * k) = solution.above.segment<2>(2 * part.number[static_cast<std::size_t>(k)]);
        const Solution<2, 2> of_part{
            Approximation<2>(Cloud<2>(part.body.x), part.how), conditions(problem, part.body), {}, 0, 0, u};
        auto of_one =
            sums(problem, part.body, of_part, distributed::rule_in(part), extent.spacing(), part.own);
        std::size_t place = 0;
        most.resize(100, 0);
        added.resize(100, 0);
        combine(
            of_one, [&](double number) { added[place++] += number; },
            [&](double number) { most[place] = std::max(most[place], number), ++place; });
    }
    std::vector<int> all;
    for (Index I = 0; I < body.x.cols(); ++I) all.push_back(static_cast<int>(I));
    auto expected = sums(problem, body, solution, rule_in(body), extent.spacing(), all);
    std::size_t place = 0;
    combine(
        expected, [&](double number) { CHECK(added[place++] == doctest::Approx(number).epsilon(1e-11)); },
        [&](double number) { CHECK(most[place++] == doctest::Approx(number).epsilon(1e-11)); });
    CHECK(place > 20);
}

TEST_CASE("part: it survives as bytes") {
    Body<2> body = support::ring(1, 2, 4, 12);
    body.sides[0].pieces[0] = particles::Arc{{0, 0}, 1, 0.1, 0.2};
    const auto in_plane = parts_of(body, by(Method::strong), distributed::bisected<2>(body.x, 2), 2)[1];
    const auto in_space = parts_of(block<3>({{3, 3, 3}}), by(Method::fpm), std::vector<int>(64, 0), 1)[0];
    const auto same = distributed::part_from<2>(distributed::bytes_of(in_plane));
    CHECK(distributed::bytes_of(same) == distributed::bytes_of(in_plane));
    CHECK(same.number == in_plane.number);
    CHECK(same.body.x == in_plane.body.x);
    CHECK(same.body.sides[0].name == in_plane.body.sides[0].name);
    CHECK(same.how.method == Method::strong);
    const auto there = distributed::part_from<3>(distributed::bytes_of(in_space));
    CHECK(distributed::bytes_of(there) == distributed::bytes_of(in_space));
    CHECK(there.body.cells == in_space.body.cells);
}
