#include "batra2008/section_3_elastostatics.hpp"

#include "tests/batra2008/elastic.hpp"

using namespace batra2008;
using namespace batra2008::elastostatics;

namespace {

const Material stressed{2e11, 0.3, Plane::stress}, strained{2e11, 0.3, Plane::strain};
const Point<2> somewhere(0.4, 0.13);

}  // namespace

TEST_CASE(
    "(3.1): a polynomial displacement is in equilibrium with the force that it needs, by finite differences") {
    const support::PolynomialField field{strained, true};
    const double step = 1e-4;
    Eigen::Matrix<double, 3, 2> gradient;
    for (Index axis = 0; axis < 2; ++axis) {
        const Point<2> aside = step * Point<2>::Unit(axis);
        gradient.col(axis) = (field.stress(somewhere + aside) - field.stress(somewhere - aside)) / (2 * step);
    }
    const double size = gradient.cwiseAbs().maxCoeff();
    CHECK((gradient - field.stress_gradient(somewhere)).cwiseAbs().maxCoeff() < 1e-9 * size);
    CHECK(imbalance(gradient, field.b(somewhere)).norm() < 1e-9 * size);
    CHECK(imbalance(gradient, Vector::Zero()).norm() > 0.1 * size);
}

TEST_CASE("(3.1): each component's derivatives by their coordinates, and the body force") {
    const Eigen::Matrix<double, 3, 2> gradient{{2, 3}, {5, 7}, {11, 13}};  // of the stresses 11, 22, 12
    CHECK(imbalance(gradient, Vector(100, 200)) == Vector(2 + 13 + 100, 11 + 7 + 200));
}

TEST_CASE("(3.2): the traction is the stress tensor times the normal") {
    const Stress sigma(3, -5, 2);
    const Eigen::Matrix2d tensor{{3, 2}, {2, -5}};
    for (const Vector& n : {Vector(1, 0), Vector(0, -1), Vector(0.6, 0.8)})
        CHECK((traction(sigma, n) - tensor * n).norm() < 1e-14);
}

TEST_CASE(
    "(3.3), (3.4), (3.5): plane stress and strain are Hooke's law in space with one component of zero") {
    const double E = 2e11, nu = 0.3, G = E / (2 * (1 + nu)), lambda = E * nu / ((1 + nu) * (1 - 2 * nu));
    const Strain strain(1e-3, -4e-4, 6e-4);
    const double trace = strain[0] + strain[1];
    const Stress in_strain(2 * G * strain[0] + lambda * trace, 2 * G * strain[1] + lambda * trace,
                           G * strain[2]);
    CHECK((stress(strained, strain) - in_strain).norm() < 1e-12 * in_strain.norm());
    const double across = -nu / (1 - nu) * trace;  // the strain that keeps the third stress zero
    const Stress in_stress(2 * G * strain[0] + lambda * (trace + across),
                           2 * G * strain[1] + lambda * (trace + across), G * strain[2]);
    CHECK((stress(stressed, strain) - in_stress).norm() < 1e-12 * in_stress.norm());
    CHECK(nu0(stressed) == nu);
    CHECK(E0(stressed) == E);
    CHECK(D(strained) == D(strained).transpose());
}

TEST_CASE("(3.6), (3.7): strains are the symmetric part of the gradient, and a rotation has none") {
    const Eigen::Matrix2d gradient{{0.1, 0.3}, {-0.2, 0.5}};
    CHECK((strain(gradient) - Strain(0.1, 0.5, 0.1)).norm() < 1e-15);
    CHECK(strain(Eigen::Matrix2d{{0, 0.7}, {-0.7, 0}}).norm() == 0);
    CHECK(L({2, 3}) == Eigen::Matrix<double, 3, 2>{{2, 0}, {0, 3}, {3, 2}});
}

TEST_CASE("elastostatics: materials without meaning are refused") {
    CHECK_THROWS_WITH_AS(checked({-1, 0.3}), doctest::Contains("Young's modulus must be positive"),
                         base::InvalidInput);
    CHECK_THROWS_AS(checked({1, 0.6}), base::InvalidInput);
    CHECK_THROWS_AS(checked({1, 0.5, Plane::strain}), base::InvalidInput);
    CHECK_THROWS_WITH_AS(
        checked({1, 0.4999999999999999, Plane::strain}),
        doctest::Contains("Poisson's ratio of 0.49999999999999989 is too near to 0.5 for plane strain"),
        base::InvalidInput);
    CHECK_NOTHROW(checked({1, 0.499999999999, Plane::strain}));
    CHECK_NOTHROW(checked({1, 0.4999999999999999, Plane::stress}));
    CHECK_THROWS_AS(checked({1, std::nan("")}), base::InvalidInput);
    CHECK_THROWS_WITH_AS(plane_named("flat"), doctest::Contains("choose one of stress, strain"),
                         base::InvalidInput);
}

TEST_CASE(
    "elastostatics: a side gives two conditions, a corner the displaced ones first, an inner particle none") {
    Problem problem = plate::problem(stressed);
    problem.corners.clear();
    CHECK(conditions_at(problem, {0.3, 0.1}).empty());
    const auto bottom = conditions_at(problem, {0.3, 0});
    REQUIRE(bottom.size() == 2);
    CHECK_FALSE(bottom[0].displacement);
    CHECK(bottom[1].n == Vector(0, -1));
    for (const auto& condition : conditions_at(problem, {0, 0.1})) CHECK(condition.displacement);
    for (const auto& condition : conditions_at(problem, {0, 0})) CHECK(condition.displacement);
    const auto outer = conditions_at(problem, {plate::L1, plate::L2});
    REQUIRE(outer.size() == 2);
    CHECK(outer[0].n == Vector(1, 0));
    CHECK(outer[1].n == Vector(0, 1));
}

TEST_CASE("elastostatics: a choice at a corner is taken, and its value comes from the exact solution") {
    const support::PolynomialField field{stressed};
    Problem problem = support::plate_with(field);
    const Point<2> corner(plate::L1, plate::L2);
    const auto conditions = conditions_at(problem, corner);
    REQUIRE(conditions.size() == 2);
    CHECK(value(problem, conditions[0], corner) == support::relative(field.stress(corner)[0], 1e-14));
    CHECK(value(problem, conditions[1], corner) == support::relative(field.stress(corner)[1], 1e-14));
    CHECK(value(problem, {true, 1}, corner) == support::relative(field.u(corner)[1], 1e-14));
}

TEST_CASE("elastostatics: a particle outside the body is named") {
    Points<2> x = plate::grid(4, 3);
    x(1, 7) = 0.3;
    CHECK_THROWS_WITH_AS(
        checked(plate::problem(stressed), Cloud<2>(x)),
        doctest::Contains(
            "particle 7 at (0.666667, 0.3) lies outside the body, 0.1 from the side from (1, 0.2) to (0, 0.2)"),
        base::InvalidInput);
}

TEST_CASE("elastostatics: a problem's boundary is closed, its sides are turned, its corners lie on it") {
    const Cloud<2> cloud(plate::grid(4, 3));
    Problem clockwise = plate::problem(stressed);
    for (Side& side : clockwise.sides) {
        auto& segment = std::get<particles::Segment>(side.curve);
        std::swap(segment.from, segment.to);
    }
    const Problem right = checked(clockwise, cloud);
    for (std::size_t k = 0; k < right.sides.size(); ++k) {
        const Point<2> x = particles::ends(right.sides[k].curve)[0];
        CHECK(particles::normal_at(right.sides[k].curve, x) ==
              particles::normal_at(plate::problem(stressed).sides[k].curve, x));
        CHECK(right.sides[k].displaced == plate::problem(stressed).sides[k].displaced);
    }
    Problem open = plate::problem(stressed);
    open.sides.pop_back();
    CHECK_THROWS_WITH_AS(checked(open, cloud), doctest::Contains("the boundary is not closed"),
                         base::InvalidInput);
    Problem corner = plate::problem(stressed);
    corner.corners[1].at = {0.5, 0};
    CHECK_THROWS_WITH_AS(checked(corner, cloud), doctest::Contains("no sides meet at the corner (0.5, 0)"),
                         base::InvalidInput);
    Problem soft = plate::problem(stressed);
    soft.material.nu = 0.7;
    CHECK_THROWS_AS(checked(soft, cloud), base::InvalidInput);
}
