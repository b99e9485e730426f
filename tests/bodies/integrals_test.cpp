#include "bodies/integrals.hpp"

#include <doctest/doctest.h>

#include "base/errors.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/relative.hpp"

using namespace bodies;
using support::block;

namespace {

const double pi = std::acos(-1.0);

template <int dim>
double sum(
    const std::vector<IntegrationPoint<dim>>& rule,
    const std::function<double(const Point<dim>&)>& f = [](const auto&) { return 1.0; }) {
    double all = 0;
    for (const auto& point : rule) all += point.weight * f(point.x);
    return all;
}

/// \f$\int n\,d\Gamma\f$ over the whole boundary.
template <int dim>
Point<dim> closing(const Body<dim>& body) {
    Point<dim> all = Point<dim>::Zero();
    for (const auto& side : body.sides)
        for (const auto& point : rule_on(side, 0.1)) all += point.weight * point.normal;
    return all;
}

/// \f$\int x\cdot n\,d\Gamma / \dim\f$ over the whole boundary: the body's volume.
template <int dim>
double volume(const Body<dim>& body) {
    double all = 0;
    for (const auto& side : body.sides)
        for (const auto& point : rule_on(side, 0.1)) all += point.weight * point.x.dot(point.normal) / dim;
    return all;
}

Body<2> circle(bool is_hole) {
    return {Points<2>{{0, 2, 0, -2, 0}, {0, 0, 2, 0, -2}},
            {{"edge", {particles::Arc{{0, 0}, 2, 0, 2 * pi, !is_hole}}, {}}}};
}

}  // namespace

TEST_CASE("integrals: on flat sides polynomials of degree 2 are exact, in the plane up to 5") {
    const auto square = block<2>({{3, 4}});
    for (const auto& side : square.sides) {
        CHECK(sum<2>(rule_on(side, 0.1)) == support::relative(1, 1e-14));
        CHECK(sum<2>(rule_on(side, 10), [](const auto& x) { return std::pow(x[0] + x[1], 5); }) ==
              support::relative(side.name == "left" || side.name == "bottom" ? 1.0 / 6 : 63.0 / 6, 1e-13));
    }
    const auto cube = block<3>({{2, 3, 2}});
    for (const auto& side : cube.sides) {
        CHECK(sum<3>(rule_on(side, 0.1)) == support::relative(1, 1e-14));
        CHECK(sum<3>(rule_on(side, 0.1), [](const auto& x) { return x.squaredNorm(); }) ==
              support::relative(
                  (side.name == "right" || side.name == "top" || side.name == "front" ? 1 : 0) + 2.0 / 3,
                  1e-13));
    }
}

TEST_CASE("integrals: an arc has its own length and normals, in a disc and around a hole") {
    for (const bool is_hole : {false, true}) {
        const auto rule = rule_on(circle(is_hole).sides[0], 0.2);
        CHECK(sum<2>(rule) == support::relative(4 * pi, 1e-13));
        CHECK(sum<2>(rule, [](const auto& x) { return x[0] * x[0]; }) == support::relative(8 * pi, 1e-8));
        for (const auto& point : rule)
            CHECK((point.normal - (is_hole ? -0.5 : 0.5) * point.x).norm() < 1e-14);
    }
}

TEST_CASE("integrals: the normals of a closed boundary add up to zero, and it encloses the cells' volume") {
    const auto check = [](const auto& body) {
        CHECK(closing(body).norm() < 1e-13);
        CHECK(volume(body) == support::relative(sum(rule_in(body)), 1e-13));
    };
    check(support::angle(4, 0.3, 1));
    check(support::ring(0.4, 1, 3, 16));
    check(support::disc(4, 0.2, 1));
    check(block<3>({{3, 3, 3}, 0.2, 1, [](const Point<3>& s) -> Point<3> {
                        return {s[0] * (1 + 0.3 * s[1]), s[1] + 0.2 * s[2] * s[2], s[2]};
                    }}));
}

TEST_CASE("integrals: over cells linear functions are exact") {
    CHECK(sum<3>(rule_in(block<3>({{2, 3, 4}, 0.2})), [](const auto& x) { return 1 + x[0] - 2 * x[1]; }) ==
          support::relative(0.5, 1e-13));
    CHECK(sum<2>(rule_in(support::angle(3, 0.2, 1)), [](const auto& x) { return x[0]; }) ==
          support::relative(0.5 - 0.25 * 0.75, 1e-13));
}

TEST_CASE("integrals: a body without cells is integrated within its boundary") {
    CHECK(sum<2>(rule_in(circle(false)), [](const auto& x) { return x[0] * x[0]; }) ==
          support::relative(4 * pi, 1e-10));
    auto corner = support::angle(4, 0, 1);
    corner.cells.clear();
    CHECK(sum(rule_in(corner)) == support::relative(0.75, 1e-10));
    auto cube = block<3>({{2, 2, 2}});
    cube.cells.clear();
    CHECK_THROWS_AS(rule_in(cube), base::InvalidInput);
}
