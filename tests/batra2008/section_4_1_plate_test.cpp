#include "batra2008/section_4_1_plate.hpp"

#include "tests/batra2008/elastic.hpp"
#include "tests/support/claims.hpp"

using namespace batra2008;
using example_problems::Method;
using support::expected;

namespace {

const elastostatics::Material material{plate::E, plate::nu};

struct Result {
    example_problems::Errors errors;
    double error_u2;
};

Result solved(Method method, Index nx, Index ny, const plate::Corners& corners = plate::default_corners(),
              double scaling = 3) {
    const Problem problem = plate::problem(material, corners);
    const Cloud<2> cloud(plate::grid(nx, ny));
    const auto solution =
        example_problems::solve(problem, cloud, {method, scaling, 2, plate::penalty(material)});
    return {example_problems::errors(plate::mesh(nx, ny), cloud, solution, problem),
            plate::largest_error_u2(cloud, solution, problem)};
}

const std::vector<Point<2>> places{{0.1, 0.03}, {0.5, 0.17}, {0.93, 0.1}};

}  // namespace

TEST_CASE("(4.1): the left edge is displaced, the others loaded; bottom and top are free") {
    const Problem problem = plate::problem(material);
    CHECK(problem.sides[3].displaced == std::array{true, true});
    for (std::size_t side = 0; side < 3; ++side)
        CHECK(problem.sides[side].displaced == std::array{false, false});
    for (const double x1 : {0.0, 0.4, 1.0}) {
        CHECK(elastostatics::traction(plate::stress({x1, 0}), {0, -1}).norm() < 1e-6 * plate::F0);
        CHECK(elastostatics::traction(plate::stress({x1, plate::L2}), {0, 1}).norm() < 1e-6 * plate::F0);
    }
    CHECK(plate::stress({plate::L1, 0.1})[0] == 0);
    CHECK(plate::stress({plate::L1, 0.1})[2] == support::relative(1.5 * plate::F0 / plate::L2, 1e-12));
}

TEST_CASE(
    "(4.2), (4.3): the stresses follow from the displacements by Hooke's law, in plane stress and strain") {
    for (const auto plane : {elastostatics::Plane::stress, elastostatics::Plane::strain}) {
        const elastostatics::Material in_plane{plate::E, plate::nu, plane};
        for (const Point<2>& x : places) {
            const double step = 1e-5;
            Eigen::Matrix2d gradient;
            for (Index axis = 0; axis < 2; ++axis) {
                const Point<2> aside = step * Point<2>::Unit(axis);
                gradient.col(axis) =
                    (plate::displacement(in_plane, x + aside) - plate::displacement(in_plane, x - aside)) /
                    (2 * step);
            }
            const Stress found = elastostatics::stress(in_plane, elastostatics::strain(gradient));
            CHECK((found - plate::stress(x)).norm() < 1e-6 * plate::stress(x).norm());
        }
    }
}

TEST_CASE("(4.3): the stresses are in equilibrium") {
    for (const Point<2>& x : places) {
        const double step = 1e-4;
        Eigen::Matrix<double, 3, 2> gradient;
        for (Index axis = 0; axis < 2; ++axis) {
            const Point<2> aside = step * Point<2>::Unit(axis);
            gradient.col(axis) = (plate::stress(x + aside) - plate::stress(x - aside)) / (2 * step);
        }
        CHECK(elastostatics::imbalance(gradient, Vector::Zero()).norm() < 1e-9 * gradient.norm());
    }
}

TEST_CASE("(4.5): Table 1, six choices at corner 3, claims B-4.1-table-1-*") {
    for (const auto& pair : plate::choices_at_corner_3()) {
        plate::Corners corners = plate::default_corners();
        corners[2] = pair;
        const double printed = expected("B-4.1-table-1-" + pair[0] + "-" + pair[1]);
        CHECK(std::abs(solved(Method::strong, 16, 4, corners).errors.log_dn - printed) < 1e-4);
    }
}

TEST_CASE("(4.6): Table 2, three choices at corner 1 on four grids, claims B-4.1-table-2-*") {
    const std::array<std::array<Index, 2>, 4> grids{{{16, 4}, {31, 7}, {61, 13}, {91, 19}}};
    for (const auto& [nx, ny] : grids)
        for (const auto& pair : plate::choices_at_corner_1()) {
            plate::Corners corners = plate::default_corners();
            corners[0] = pair;
            const double printed = expected("B-4.1-table-2-" + std::to_string(nx) + "x" + std::to_string(ny) +
                                            "-" + pair[0] + "-" + pair[1]);
            CHECK(std::abs(solved(Method::strong, nx, ny, corners).errors.log_dn - printed) < 1e-3);
        }
}

TEST_CASE("plate: the printed errors of the three methods, claims B-4.1-E-* and B-4.1-u2-*") {
    const Result strong = solved(Method::strong, 16, 4), weak1 = solved(Method::weak1, 16, 4),
                 weak2 = solved(Method::weak2, 16, 4);
    CHECK(std::abs(strong.errors.log_dn - expected("B-4.1-E-strong")) < 1e-4);
    CHECK(std::abs(strong.error_u2 - expected("B-4.1-u2-strong")) < 0.01);
    CHECK(std::abs(weak1.errors.log_nd - expected("B-4.1-E-weak1")) < 0.01);
    CHECK(std::abs(weak2.errors.log_dn - expected("B-4.1-E-weak2")) < 0.03);
    CHECK(std::abs(weak1.error_u2 - expected("B-4.1-u2-weak1")) < 0.03);
    CHECK(std::abs(weak2.error_u2 - expected("B-4.1-u2-weak2")) < 0.1);
}

TEST_CASE("plate: rates of convergence as an independent calculation found them") {
    plate::Corners corners = plate::default_corners();
    corners[0] = {"s11", "s12"};
    const auto rate = [](double coarse, double fine, double ratio) {
        return (coarse - fine) / std::log10(ratio);
    };
    const double a = solved(Method::strong, 16, 4, corners).errors.log_dn,
                 b = solved(Method::strong, 31, 7, corners).errors.log_dn,
                 c = solved(Method::strong, 61, 13, corners).errors.log_dn,
                 d = solved(Method::strong, 91, 19, corners).errors.log_dn;
    CHECK(std::abs(rate(a, b, 2) - 1.54) < 0.01);
    CHECK(std::abs(rate(b, c, 2) - 1.99) < 0.01);
    CHECK(std::abs(rate(c, d, 1.5) - 2.00) < 0.01);
    const double e = solved(Method::weak1, 16, 4).errors.log_dn,
                 f = solved(Method::weak1, 31, 7).errors.log_dn;
    CHECK(std::abs(rate(e, f, 2) - 2.00) < 0.01);
}

TEST_CASE("plate: a grid goes column by column from the left, upwards in each") {
    const Points<2> x = plate::grid(4, 3);
    REQUIRE(x.cols() == 12);
    CHECK((x.col(1) - Point<2>(0, plate::L2 / 2)).norm() < 1e-15);
    CHECK((x.col(3) - Point<2>(plate::L1 / 3, 0)).norm() < 1e-15);
    CHECK((x.col(11) - Point<2>(plate::L1, plate::L2)).norm() < 1e-15);
}

TEST_CASE("plate: the penalty parameter is 1e5 times the modulus over the length") {
    CHECK(plate::penalty({2e11, 0.3, elastostatics::Plane::strain}) ==
          support::relative(1e5 * 2e11 / (1 - 0.09) / plate::L1, 1e-14));
}

TEST_CASE("plate: the largest error of u2 is that of the bottom edge alone") {
    const support::PolynomialField field{{2e11, 0.3}};
    const Problem problem = support::plate_with(field);
    const Cloud<2> cloud(plate::grid(16, 4));
    double largest = 0;
    for (Index I = 0; I < cloud.size(); ++I)
        if (cloud.x()(1, I) == 0) largest = std::max(largest, std::abs(field.u(cloud.x().col(I))[1]));
    const auto error = [&](const auto& wrong_by) {
        Eigen::VectorXd u(2 * cloud.size());
        for (Index J = 0; J < cloud.size(); ++J) {
            const Point<2> x = cloud.x().col(J);
            u.segment<2>(2 * J) = field.u(x) + Vector(0, wrong_by(x));
        }
        const example_problems::Solution solution{
            {example_problems::Method::strong, 4}, field.material, cloud.apart(), u};
        return plate::largest_error_u2(cloud, solution, problem);
    };
    CHECK(error([](const Point<2>& x) { return x[1] * x[1]; }) < 1e-8);
    CHECK(error([](const Point<2>&) { return 0.25; }) == support::relative(100 * 0.25 / largest, 1e-8));
}

TEST_CASE("plate: the weights of the background mesh add up to its area") {
    double area = 0;
    for (const auto& at : plate::mesh(4, 3)) area += at.weight;
    CHECK(area == support::relative(plate::L1 * plate::L2, 1e-13));
}

TEST_CASE("plate: grids without meaning and conditions that say the same are refused") {
    CHECK_THROWS_AS(plate::grid(1, 4), base::InvalidInput);
    plate::Corners corners = plate::default_corners();
    corners[1] = {"u1", "u1"};
    CHECK_THROWS_WITH_AS(plate::problem(material, corners),
                         doctest::Contains("corner 2 needs two different conditions"), base::InvalidInput);
    CHECK_THROWS_WITH_AS(plate::condition_named("u3"), doctest::Contains("choose one of u1, u2, s11"),
                         base::InvalidInput);
}
