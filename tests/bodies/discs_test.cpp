#include "bodies/discs.hpp"

#include <doctest/doctest.h>

#include "base/errors.hpp"
#include "tests/support/bodies_of_batra2008.hpp"
#include "tests/support/relative.hpp"

using namespace bodies;

namespace {

Discretisation weak(Method method, double penalty) {
    Discretisation how;
    how.method = method;
    how.spacing = particles::Spacing::nearest;
    how.penalty = penalty;
    return how;
}

/// The relative difference of the unknowns from those of the method's own program.
double difference(const Problem<2, 2>& problem, const Body<2>& body, const batra2008::Problem& same,
                  Method method, double penalty) {
    batra2008::example_problems::Discretisation own;
    own.method = batra2008::example_problems::method_named(name(method));
    own.penalty = penalty;
    const auto expected = batra2008::example_problems::solve(same, Cloud<2>(body.x), own);
    return (solve(problem, body, weak(method, penalty)).u() - expected.u).norm() / expected.u.norm();
}

}  // namespace

TEST_CASE("discs: the plate given as a body has the unknowns of its own program") {
    const auto material = support::plate_material();
    const auto same = batra2008::plate::problem(material);
    const Body<2> in_edges = support::plate_body({20, 4});
    const Body<2> body = support::body_within(in_edges.x,
                                              {{"bottom", same.sides[0].curve},
                                               {"right", same.sides[1].curve},
                                               {"top", same.sides[2].curve},
                                               {"left", same.sides[3].curve}},
                                              same.size);
    for (const Method method : {Method::weak1, Method::weak2}) {
        const double penalty = batra2008::plate::penalty(material);
        CHECK(difference(support::plate_problem(), body, same, method, penalty) < 1e-10);
        // Edge by edge the boundary has other quadrature points.
        CHECK(difference(support::plate_problem(), in_edges, same, method, penalty) < 1e-6);
    }
}

TEST_CASE("discs: the hole given as a body has the unknowns of its own program") {
    const auto material = support::hole_material();
    for (const Method method : {Method::weak1, Method::weak2})
        CHECK(difference(support::hole_problem(), support::hole_body(80, 7),
                         batra2008::hole::problem(material, {}), method,
                         batra2008::hole::penalty(material)) < 1e-10);
}

TEST_CASE("discs: a membrane on a body with a corner inside is exact for polynomials of degree 2") {
    const Body<2> body = support::angle(4, 0.2, 3);
    auto equation = diffusion<2>([](const Point<2>&) { return 2.0; });
    equation.c = 0.4;
    const support::Manufactured<2, 1> exact(equation, 2, 5);
    const Problem<2, 1> problem = exact.problem(body, {"left", "top"});
    const auto [u, flux] = support::errors(problem, solve(problem, body, weak(Method::weak1, 1e5)), exact);
    CHECK(u < 1e-6);
    CHECK(flux < 1e-5);
}

TEST_CASE("discs: convection and symmetry leave a constant stress and a linear field exact") {
    const Body<2> body = support::block<2>({{8, 8}, 0.2, 4});
    const support::Manufactured<2, 1> exact(diffusion<2>([](const Point<2>&) { return 2.0; }), 1, 6);
    Problem<2, 1> problem = exact.problem(body, {});
    for (auto& given : problem.given) {
        given.exchange = [](const Point<2>&) { return 3.0; };
        given.surroundings = [](const Point<2>& x) { return x[0]; };
        given.loads.push_back(
            [exact](const Point<2>& x, const Point<2>&) { return Values<1>(3 * (exact.u(x)[0] - x[0])); });
    }
    for (const Method method : {Method::weak1, Method::weak2})
        CHECK(support::errors(problem, solve(problem, body, weak(method, 1e5)), exact).u < 1e-6);

    const batra2008::elastostatics::Material material{2, 0.3};
    Problem<2, 2> pulled{elasticity<2>(material)};
    pulled.given = {{"right"}, {"left"}, {"bottom"}};
    pulled.given[0].loads.push_back([](const Point<2>&, const Point<2>& n) { return Values<2>(n); });
    pulled.given[1].symmetry = pulled.given[2].symmetry = true;
    for (const Method method : {Method::weak1, Method::weak2}) {
        const auto solution = solve(pulled, body, weak(method, 1e5));
        const auto state = state_at(pulled, solution, {0.6, 0.7});
        CHECK(state.u[0] == support::relative(0.6 / 2, 1e-5));
        CHECK(state.u[1] == support::relative(-0.3 * 0.7 / 2, 1e-5));
        CHECK(state.F(0, 0) == support::relative(1, 1e-4));
    }
}

TEST_CASE("discs: a boundary that is not closed is refused") {
    Body<2> body = support::block<2>({{6, 6}});
    const support::Manufactured<2, 1> exact(diffusion<2>([](const Point<2>&) { return 2.0; }), 1, 6);
    const Problem<2, 1> problem = exact.problem(body, {"left"});
    body.sides[1].pieces.pop_back();
    CHECK_THROWS_AS(solve(problem, body, weak(Method::weak1, 1e5)), base::InvalidInput);
}
