#include "bodies/collocation.hpp"

#include <doctest/doctest.h>

#include "batra2008/section_4_1_plate.hpp"
#include "batra2008/section_4_2_hole.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/bodies_of_batra2008.hpp"

using namespace bodies;
using support::Block;
using support::block;
using support::Manufactured;

namespace {

const Block<2> quadrilateral{
    {8, 8}, 0.25, 3, support::quadrilateral({{{0, 0}, {1.2, 0.1}, {1.0, 0.9}, {-0.1, 1.1}}})};
/// A box that is stretched and sheared.
const Block<3> slanted{{4, 4, 4}, 0.2, 5, [](const Point<3>& s) -> Point<3> {
                           return {s[0] + 0.2 * s[1], 0.9 * s[1] - 0.1 * s[2], 1.1 * s[2] + 0.1 * s[0]};
                       }};
const batra2008::elastostatics::Material steel{2.5, 0.3, batra2008::elastostatics::Plane::strain};

/// k = 1 + x1 + x2² and a reaction.
template <int dim>
Equation<dim, 1> varying() {
    auto equation = diffusion<dim>([](const Point<dim>& x) { return 1 + x[0] + x[1] * x[1]; },
                                   [](const Point<dim>& x) {
                                       Point<dim> gradient = Point<dim>::Zero();
                                       gradient[0] = 1;
                                       gradient[1] = 2 * x[1];
                                       return gradient;
                                   });
    equation.c = 0.7;
    return equation;
}

/// The errors on a body with values on its left side and loads on the others.
template <int dim, int n>
support::Errors errors_of(const Equation<dim, n>& equation, int polynomial, const Body<dim>& body,
                          const Discretisation& how) {
    const Manufactured<dim, n> exact(equation, polynomial, 2);
    const Problem<dim, n> problem = exact.problem(body, {"left"});
    return support::errors(problem, solve(problem, body, how), exact);
}

/// The relative difference of the unknowns of strong from those of its own program.
double difference(const Problem<2, 2>& problem, const Body<2>& body, const batra2008::Problem& same,
                  int degree, double scaling) {
    Discretisation how;
    how.method = Method::strong;
    how.degree = degree;
    how.scaling = scaling;
    how.spacing = particles::Spacing::nearest;
    const auto expected = batra2008::example_problems::solve(
        same, Cloud<2>(body.x), {batra2008::example_problems::Method::strong, scaling, degree});
    return (solve(problem, body, how).u() - expected.u).norm() / expected.u.norm();
}

}  // namespace

TEST_CASE("collocation: the plate given as a body has the unknowns of its own program, m = 2 and 3") {
    const Body<2> body = support::plate_body({30, 6});
    const auto same = batra2008::plate::problem(support::plate_material());
    for (const auto& [degree, scaling] : {std::pair(2, 3.0), std::pair(3, 4.0)})
        CHECK(difference(support::plate_problem(), body, same, degree, scaling) < 1e-10);
}

TEST_CASE("collocation: the hole given as a body has the unknowns of its own program, m = 2 and 3") {
    const Body<2> body = support::hole_body(188, 11);
    const auto same = batra2008::hole::problem(support::hole_material(), {});
    for (const auto& [degree, scaling] : {std::pair(2, 3.0), std::pair(3, 4.0)})
        CHECK(difference(support::hole_problem(), body, same, degree, scaling) < 1e-10);
}

TEST_CASE_TEMPLATE("collocation: polynomials of degree 1 and 2 are exact under tractions and fluxes",
                   dim_type, std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    constexpr int dim = dim_type::value;
    Body<dim> body;
    if constexpr (dim == 2) body = block<2>(quadrilateral);
    if constexpr (dim == 3) body = block<3>(slanted);
    for (const Method method : {Method::fpm, Method::strong})
        for (const int polynomial : {1, 2}) {
            INFO(name(method), ", degree ", polynomial);
            Discretisation how;
            how.method = method;
            const auto [u, stress] = errors_of<dim, dim>(elasticity<dim>(steel), polynomial, body, how);
            CHECK(u < 1e-9);
            CHECK(stress < 1e-8);
            const auto [value, flux] = errors_of<dim, 1>(varying<dim>(), polynomial, body, how);
            CHECK(value < 1e-9);
            CHECK(flux < 1e-8);
        }
}

TEST_CASE("collocation: convection is exact for a polynomial of degree 2") {
    const Body<2> body = block<2>(quadrilateral);
    const Manufactured<2, 1> exact(varying<2>(), 2, 4);
    Problem<2, 1> problem = exact.problem(body, {});
    for (auto& given : problem.given) {
        // t = F n, of which a (u0 - u) is convection
        given.exchange = [](const Point<2>& x) { return 2 + x[0]; };
        given.surroundings = [](const Point<2>& x) { return x[1] - 3; };
        given.loads.push_back([exact](const Point<2>& x, const Point<2>&) {
            return Values<1>((2 + x[0]) * (exact.u(x)[0] - (x[1] - 3)));
        });
    }
    problem.equation.c = varying<2>().c;
    for (const Method method : {Method::fpm, Method::strong}) {
        Discretisation how;
        how.method = method;
        CHECK(support::errors(problem, solve(problem, body, how), exact).u < 1e-9);
    }
}

TEST_CASE("collocation: errors decrease with the square of the spacing where distances change smoothly") {
    const auto order = [](Method method, int degree) {
        Discretisation how;
        how.method = method;
        how.degree = degree;
        const auto error = [&](int n) {
            const Block<2> finer{{n, n}, 0, 1, quadrilateral.map};
            return errors_of<2, 1>(varying<2>(), 4, block<2>(finer), how).u;
        };
        return std::log2(error(16) / error(32));
    };
    CHECK(order(Method::fpm, 2) > 1.8);
    CHECK(order(Method::strong, 2) > 1.8);
    CHECK(order(Method::strong, 3) > 1.8);
}
