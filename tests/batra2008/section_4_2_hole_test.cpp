#include "batra2008/section_4_2_hole.hpp"

#include <string>

#include "batra2008/basis_at.hpp"
#include "tests/batra2008/bases.hpp"
#include "tests/batra2008/elastic.hpp"

using namespace batra2008;

namespace {

const elastostatics::Material material{hole::E, hole::nu, elastostatics::Plane::strain};
const hole::Shape shape;
const std::vector<Point<2>> places{{0.31, 0.02}, {0.5, 0.4}, {0.05, 0.33}, {2.9, 2.7}};

}  // namespace

TEST_CASE("hole: the penalty parameter is 1e5 times the modulus over the side") {
    CHECK(hole::penalty({2e11, 0.3, elastostatics::Plane::strain}) ==
          support::relative(1e5 * 2e11 / (1 - 0.09) / 3, 1e-14));
}

TEST_CASE("(4.7): the hole carries no traction, and far away there is the tension alone") {
    for (double theta = 0; theta < 1.6; theta += 0.1) {
        const Eigen::Vector3d at_hole = hole::polar_stress(0.3, 0.3, theta);
        CHECK(std::abs(at_hole[0]) < 1e-9 * hole::sigma_0);
        CHECK(std::abs(at_hole[2]) < 1e-9 * hole::sigma_0);
        const Point<2> on(0.3 * std::cos(theta), 0.3 * std::sin(theta));
        CHECK(elastostatics::traction(hole::stress(shape, on), -on / 0.3).norm() < 1e-9 * hole::sigma_0);
    }
    CHECK((hole::stress(shape, {3e6, 1e6}) - Stress(hole::sigma_0, 0, 0)).norm() < 1e-9 * hole::sigma_0);
}

TEST_CASE("(4.7): the stresses are in equilibrium") {
    for (const Point<2>& x : places) {
        const double step = 1e-5;
        Eigen::Matrix<double, 3, 2> gradient;
        for (Index axis = 0; axis < 2; ++axis) {
            const Point<2> aside = step * Point<2>::Unit(axis);
            gradient.col(axis) =
                (hole::stress(shape, x + aside) - hole::stress(shape, x - aside)) / (2 * step);
        }
        const double size = gradient.norm() + hole::sigma_0;
        CHECK(elastostatics::imbalance(gradient, Vector::Zero()).norm() < 1e-6 * size);
    }
}

TEST_CASE("(4.8): the displacements give the stresses (4.7) by Hooke's law, in plane strain and stress") {
    for (const auto plane : {elastostatics::Plane::stress, elastostatics::Plane::strain}) {
        const elastostatics::Material of_plane{hole::E, hole::nu, plane};
        for (const Point<2>& x : places) {
            const double step = 1e-6;
            Eigen::Matrix2d gradient;
            for (Index axis = 0; axis < 2; ++axis) {
                const Point<2> aside = step * Point<2>::Unit(axis);
                gradient.col(axis) = (hole::displacement(of_plane, shape, x + aside) -
                                      hole::displacement(of_plane, shape, x - aside)) /
                                     (2 * step);
            }
            const Stress found = elastostatics::stress(of_plane, elastostatics::strain(gradient));
            CHECK((found - hole::stress(shape, x)).norm() < 1e-6 * hole::sigma_0);
        }
    }
}

TEST_CASE("(4.9): the exact solution satisfies the conditions of the symmetry planes") {
    const Problem problem = hole::problem(material, shape);
    CHECK(problem.sides[3].displaced == std::array{true, false});
    CHECK(problem.sides[0].displaced == std::array{false, true});
    for (const double r : {0.3, 0.7, 3.0}) {
        CHECK(std::abs(problem.exact.u({0, r})[0]) < 1e-15);
        CHECK(std::abs(problem.exact.u({r, 0})[1]) < 1e-15);
        CHECK(std::abs(problem.exact.stress({0, r})[2]) < 1e-6 * hole::sigma_0);
        CHECK(std::abs(problem.exact.stress({r, 0})[2]) < 1e-6 * hole::sigma_0);
    }
    const auto top = elastostatics::conditions_at(problem, {0, 0.3});
    REQUIRE(top.size() == 2);
    CHECK(top[0].displacement);
    CHECK_FALSE(top[1].displacement);
    CHECK((top[1].n - Vector(0, -1)).norm() < 1e-12);
    CHECK_THROWS_AS(hole::problem(material, {3, 3}), base::InvalidInput);
}

TEST_CASE("(4.10): along the x2-axis it is (4.7) and (4.8), with a concentration of three at the hole") {
    for (const double r : {0.3, 0.45, 1.0, 3.0}) {
        const auto [u2, concentration] = hole::along_x2_axis(material, shape, r);
        CHECK(u2 == support::relative(hole::displacement(material, shape, {0, r})[1], 1e-12));
        CHECK(concentration == support::relative(hole::stress(shape, {0, r})[0] / hole::sigma_0, 1e-12));
    }
    CHECK(hole::along_x2_axis(material, shape, 0.3)[1] == support::relative(3, 1e-14));
}

TEST_CASE("hole: the layouts have the print's numbers of particles, lie in the body, and follow their draw") {
    const Problem problem = hole::problem(material, shape);
    for (const auto& [N, on_arc] : {std::pair<Index, Index>{188, 11}, {686, 21}}) {
        const Points<2> x = hole::graded_layout(shape, N, on_arc, 1);
        CHECK(x.cols() == N);
        CHECK_NOTHROW(elastostatics::checked(problem, Cloud<2>(x)));
        Index count = 0;
        for (Index j = 0; j < N; ++j) count += std::abs(x.col(j).norm() - 0.3) < 1e-9 ? 1 : 0;
        CHECK(count == on_arc);
        CHECK(x == hole::graded_layout(shape, N, on_arc, 1));
        CHECK(x != hole::graded_layout(shape, N, on_arc, 2));
    }
    CHECK(hole::polar_layout(shape, 11, 17).cols() == 187);
    CHECK_THROWS_AS(hole::graded_layout(shape, 20, 11, 1), base::InvalidInput);
    CHECK_THROWS_AS(hole::polar_layout(shape, 2, 2), base::InvalidInput);
}

TEST_CASE("hole: C is well conditioned all over the quarter, for both reference layouts") {
    for (const auto& [N, on_arc] : {std::pair<Index, Index>{188, 11}, {686, 21}}) {
        const Cloud<2> cloud(hole::graded_layout(shape, N, on_arc, 1));
        for (const auto& at : hole::mesh(shape, 15, 15)) {
            const double h = cloud.apart()[cloud.nearest(at.x)];
            CHECK(support::condition(ssph_basis::basis_at<2>(cloud, Kernel(4), at.x, h).matrix()) < 1000);
        }
    }
}

TEST_CASE("hole: a scaling factor that is too small is refused with one that all particles can take") {
    const Problem problem = hole::problem(material, shape);
    for (const unsigned long draw : {1UL, 2UL, 3UL})
        for (const double scaling : {1.2, 1.5, 2.0}) {
            const Cloud<2> cloud(hole::graded_layout(shape, 188, 11, draw));
            example_problems::Discretisation how{.method = example_problems::Method::strong,
                                                 .scaling = scaling};
            std::string why;
            try {
                example_problems::solve(problem, cloud, how);
            } catch (const base::FailedComputation& refused) {
                why = refused.what();
            }
            CAPTURE(why);
            const auto remedy = why.find("try --scaling ");
            REQUIRE(remedy != std::string::npos);
            how.scaling = std::stod(why.substr(remedy + 14));
            CHECK_NOTHROW(example_problems::solve(problem, cloud, how));
        }
}

TEST_CASE("hole: the background mesh has the area of the quarter") {
    double area = 0;
    for (const auto& at : hole::mesh(shape)) area += at.weight;
    CHECK(area == support::relative(9 - std::acos(-1.0) * 0.09 / 4, 1e-5));
}

TEST_CASE("hole: the weak forms approach the concentration of three, more particles come closer") {
    const Problem problem = hole::problem(material, shape);
    for (const auto method : {example_problems::Method::weak1, example_problems::Method::weak2}) {
        const auto error = [&](Index N, Index on_arc) {
            const Cloud<2> cloud(hole::graded_layout(shape, N, on_arc, 1));
            const auto solution =
                example_problems::solve(problem, cloud, {method, 4, 2, hole::penalty(material)});
            return std::abs(hole::stress_concentration(cloud, solution, shape) - 3);
        };
        const double coarse = error(188, 11), fine = error(686, 21);
        CHECK(coarse < 0.4);
        CHECK(fine < 0.1);
        CHECK(fine < coarse);
    }
}

TEST_CASE(
    "hole: no particle deviates more than the named one, and no place of the axis more than the largest") {
    const Problem problem = hole::problem(material, shape);
    const Cloud<2> cloud(hole::graded_layout(shape, 188, 11, 1));
    const auto solution = example_problems::solve(
        problem, cloud, {example_problems::Method::weak1, 4, 2, hole::penalty(material)});
    const auto deviation = [&](const Point<2>& x) {
        return Vector(example_problems::state_at(cloud, solution, x).u - problem.exact.u(x))
            .cwiseAbs()
            .eval();
    };
    const auto largest = hole::largest_deviations(cloud, solution, problem);
    for (Index i = 0; i < 2; ++i) {
        const auto& [size, x] = largest[static_cast<std::size_t>(i)];
        CHECK(size == deviation(x)[i]);
        for (Index I = 0; I < cloud.size(); ++I) CHECK(deviation(cloud.x().col(I))[i] <= size);
    }
    const auto [u2, s11] = hole::largest_deviations_on_axis(cloud, solution, problem, shape);
    CHECK(s11 >= std::abs(hole::stress_concentration(cloud, solution, shape) - 3) - 1e-9);
    for (const double r : {shape.b, (shape.b + shape.side) / 2, shape.side})
        CHECK(u2 >= deviation({0, r})[1] * (1 - 1e-9));
    CHECK(u2 < 1e-3);
}
