#include "bodies/hats.hpp"

#include <doctest/doctest.h>

#include "base/errors.hpp"
#include "bodies/integrals.hpp"
#include "tests/support/bodies.hpp"

using namespace bodies;
using support::block;
using support::Manufactured;

namespace {

Discretisation hats() {
    Discretisation how;
    how.method = Method::hats;
    return how;
}

/// A body with curved sides.
Point<2> curved(const Point<2>& s) {
    return {s[0] + 0.1 * std::sin(2 * s[1]), s[1] * (1 + 0.3 * s[0] * s[0])};
}
Point<3> curved_in_space(const Point<3>& s) {
    return {s[0] + 0.1 * std::sin(2 * s[1]), s[1] * (1 + 0.2 * s[0] * s[0]), s[2] + 0.1 * s[0] * s[1]};
}
Body<2> curved_body(int n, double amplitude, Point<2>) {
    return block<2>({{n, n}, amplitude, 7, curved});
}
Body<3> curved_body(int n, double amplitude, Point<3>) {
    return block<3>({{n, n, n}, amplitude, 7, curved_in_space});
}

template <int dim>
Equation<dim, 1> varying() {
    auto equation = diffusion<dim>([](const Point<dim>& x) { return 2 + x[0]; },
                                   [](const Point<dim>&) { return Point<dim>(Point<dim>::Unit(0)); });
    equation.c = 0.7;
    return equation;
}

const batra2008::elastostatics::Material steel{2.5, 0.3, batra2008::elastostatics::Plane::strain};

template <int dim, int n>
support::Errors errors_of(const Equation<dim, n>& equation, int polynomial, const Body<dim>& body) {
    const Manufactured<dim, n> exact(equation, polynomial, 2);
    const Problem<dim, n> problem = exact.problem(body, {"left"});
    return support::errors(problem, solve(problem, body, hats()), exact);
}

/// The force and the moment, or in space the moments, of forces at places.
/// \param add gives each to its argument
template <int dim, class Add>
Eigen::VectorXd force_and_moment(const Add& add) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(dim * (dim + 1) / 2);
    add([&sum](const Point<dim>& x, const Values<dim>& force) {
        sum.template head<dim>() += force;
        Index k = dim;
        for (int a = 0; a < dim; ++a)
            for (int b = a + 1; b < dim; ++b) sum[k++] += x[a] * force[b] - x[b] * force[a];
    });
    return sum;
}

/// What the equations of all particles leave with random unknowns, and the loads, as forces and moments.
template <int dim>
double imbalance(const Body<dim>& body) {
    Problem<dim, dim> problem{elasticity<dim>(steel)};
    problem.given = {{"right"}};
    const auto load = [](const Point<dim>& x, const Point<dim>& normal) {
        return Values<dim>(normal + 0.4 * x + Values<dim>::Unit(1));
    };
    problem.given[0].loads.push_back(load);
    const Approximation<dim> approximation(Cloud<dim>(body.x), hats());
    const Hats<dim, dim> equations(problem, body, approximation);
    const Eigen::VectorXd u = support::random_points<1>(dim * body.x.cols(), 3).transpose();
    double size = 0;
    const auto left = force_and_moment<dim>([&](const auto& add) {
        for (Index I = 0; I < body.x.cols(); ++I) {
            const Values<dim> force = equations.residual(I, u);
            add(body.x.col(I), force);
            size += force.norm();
        }
    });
    const auto loads = force_and_moment<dim>([&](const auto& add) {
        for (const auto& side : body.sides)
            if (side.name == "right")
                for (const auto& at : rule_on(side, 1)) add(at.x, at.weight * load(at.x, at.normal));
    });
    return (left + loads).norm() / size;
}

}  // namespace

TEST_CASE_TEMPLATE("hats: a constant stress and a linear temperature are exact on curved bodies", Place,
                   Point<2>, Point<3>) {
    constexpr int dim = Place::RowsAtCompileTime;
    const auto body = curved_body(dim == 2 ? 8 : 4, 0.2, Place());
    const auto [u, stress] = errors_of<dim, dim>(elasticity<dim>(steel), 1, body);
    CHECK(u < 1e-10);
    CHECK(stress < 1e-9);
    const auto [value, flux] = errors_of<dim, 1>(varying<dim>(), 1, body);
    CHECK(value < 1e-10);
    CHECK(flux < 1e-9);
}

TEST_CASE("hats: forces and moments are in equilibrium to round-off, whatever the unknowns and the cloud") {
    CHECK(imbalance(block<2>({{7, 5}, 0.3, 2, curved})) < 1e-13);
    CHECK(imbalance(support::angle(4, 0.3, 1)) < 1e-13);
    CHECK(imbalance(block<3>({{4, 3, 4}, 0.2, 2, curved_in_space})) < 1e-13);
}

TEST_CASE("hats: displacements and values on curved bodies converge with the square of the spacing") {
    const auto order = [](const auto& error, int n, int more) {
        return std::log(error(n) / error(more)) / std::log(static_cast<double>(more) / n);
    };
    const auto displacement = [](int n) {
        return errors_of<2, 2>(elasticity<2>(steel), 4, curved_body(n, 0.15, Point<2>())).u;
    };
    const auto value = [](int n) {
        return errors_of<2, 1>(varying<2>(), 4, curved_body(n, 0.15, Point<2>())).u;
    };
    const auto value_in_space = [](int n) {
        return errors_of<3, 1>(varying<3>(), 4, curved_body(n, 0, Point<3>())).u;
    };
    CHECK(order(displacement, 12, 24) > 1.7);
    CHECK(order(value, 12, 24) > 1.7);
    CHECK(order(value_in_space, 6, 12) > 1.7);
}

TEST_CASE("hats: convection and a reaction leave a linear temperature exact") {
    const Body<2> body = curved_body(8, 0.2, Point<2>());
    const Manufactured<2, 1> exact(varying<2>(), 1, 6);
    Problem<2, 1> problem = exact.problem(body, {});
    for (auto& given : problem.given) {
        given.exchange = [](const Point<2>& x) { return 2 + x[0]; };
        given.surroundings = [](const Point<2>& x) { return x[1] - 3; };
        given.loads.push_back([exact](const Point<2>& x, const Point<2>&) {
            return Values<1>((2 + x[0]) * (exact.u(x)[0] - (x[1] - 3)));
        });
    }
    CHECK(support::errors(problem, solve(problem, body, hats()), exact).u < 1e-10);
}

TEST_CASE("hats: bodies without cells, with arcs, and with corners that are no particles are refused") {
    Problem<2, 1> problem{diffusion<2>([](const Point<2>&) { return 1.0; })};
    problem.given = {{"left"}};
    problem.given[0].value[0] = [](const Point<2>&) { return 0.0; };
    const auto refused = [&](const Body<2>& body) {
        CHECK_THROWS_AS(solve(problem, body, hats()), base::InvalidInput);
    };
    const Body<2> square = block<2>({{6, 6}});
    CHECK_NOTHROW(solve(problem, square, hats()));
    Body<2> without = square, round = square, other = square;
    without.cells.clear();
    refused(without);
    for (auto* body : {&round, &other})
        for (auto& side : body->sides)
            if (side.name == "left")
                side.pieces[0] = body == &round ? Piece<2>(particles::Arc{{0, 0.5}, 0.5, 1, 2})
                                                : Piece<2>(particles::Segment{{0, 0.3}, {0, 0.1}});
    refused(round);
    refused(other);
}
