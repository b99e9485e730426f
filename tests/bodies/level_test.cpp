#include "bodies/level.hpp"

#include <doctest/doctest.h>

#include "bodies/solution.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/relative.hpp"

using namespace bodies;
using support::relative;

namespace {

/// A square with values 3 + x on the top and convection on the right to surroundings of 7 − y.
Problem<2, 1> cooled() {
    Problem<2, 1> problem{diffusion<2>([](const Point<2>&) { return 2.0; })};
    problem.given = {{"top", {[](const Point<2>& x) { return 3 + x[0]; }}}, {"right"}};
    problem.given[1].exchange = [](const Point<2>&) { return 5.0; };
    problem.given[1].surroundings = [](const Point<2>& x) { return 7 - x[1]; };
    return problem;
}

}  // namespace

TEST_CASE("level: it is the number nearest to zero among what is given") {
    CHECK(Range{}.nearest_to_zero() == 0);
    CHECK(Range{2, 5}.nearest_to_zero() == 2);
    CHECK(Range{-5, -2}.nearest_to_zero() == -2);
    CHECK(Range{-2, 5}.nearest_to_zero() == 0);
}

TEST_CASE("level: the range has values and surroundings, and not the surroundings that exchange nothing") {
    const Body<2> body = support::block<2>({{4, 4}});
    Problem<2, 1> problem = cooled();
    const Range both = range_of(problem, body, conditions(problem, body));
    CHECK(both.lowest == 3);
    CHECK(both.highest == 7);
    problem.given[1].exchange = [](const Point<2>&) { return 0.0; };
    const Range of_values = range_of(problem, body, conditions(problem, body));
    CHECK(of_values.lowest == 3);
    CHECK(of_values.highest == 4);
}

TEST_CASE("level: a displacement has none, since planes of symmetry do not move with it") {
    const Body<2> body = support::block<2>({{4, 4}});
    Problem<2, 2> problem{elasticity<2>({1, 0.3})};
    const auto one = [](const Point<2>&) { return 1.0; };
    problem.given = {{"left", {one, one}}};
    CHECK(range_of(problem, body, conditions(problem, body)).nearest_to_zero() == 0);
}

TEST_CASE("level: the solution above it is that of the problem less a constant, with a reaction, too") {
    const Body<2> body = support::block<2>({{12, 12}, 0.15, 1});
    Problem<2, 1> problem = cooled();
    problem.equation.b = [](const Point<2>& x) { return Values<1>(1 + x[1]); };
    problem.equation.c = 4;
    const auto above = above_level(problem, 3);
    const auto u = solve(problem, body, {}), v = solve(above, body, {});
    CHECK(u.level == 3);
    CHECK(v.level == 0);
    CHECK((u.above - v.above).cwiseAbs().maxCoeff() < 1e-12);
    const Point<2> x(0.4, 0.7);
    CHECK(state_at(problem, u, x).u[0] == relative(state_at(above, v, x).u[0] + 3, 1e-12));
    CHECK((state_at(problem, u, x).F - state_at(above, v, x).F).norm() < 1e-11);
    CHECK(above.equation.b({0, 0.5})[0] == 1.5 - 4 * 3);
}
