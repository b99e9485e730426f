#include "bodies/solution.hpp"

#include <doctest/doctest.h>

#include "base/errors.hpp"
#include "particles/quality.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/relative.hpp"
#include "tests/support/remedies.hpp"
#include "tests/support/ring.hpp"

using namespace bodies;
using batra2008::elastostatics::Material;
using batra2008::elastostatics::Plane;
using support::block;
using support::relative;

namespace {

const double pi = std::acos(-1.0);

Discretisation by(Method method) {
    Discretisation how;
    how.method = method;
    return how;
}

const auto zero = [](const Point<2>&) { return 0.0; };

/// A membrane that is held all around.
Problem<2, 1> membrane(const Body<2>& body) {
    Problem<2, 1> problem{diffusion<2>([](const Point<2>&) { return 1.0; })};
    for (const auto& side : body.sides) problem.given.push_back({side.name, {zero}});
    return problem;
}

double lowest(const Body<2>& body, const Discretisation& how) {
    return eigenvalues(membrane(body), body, how, 1)[0];
}

/// A body turned, enlarged and moved.
Body<2> moved(Body<2> body, const Eigen::Rotation2Dd& turn, double scale, const Point<2>& shift) {
    const auto move = [&](const Point<2>& x) { return Point<2>(scale * (turn * x) + shift); };
    for (Index j = 0; j < body.x.cols(); ++j) body.x.col(j) = move(body.x.col(j));
    for (auto& side : body.sides) {
        for (auto& place : side.places) place.normal = turn * place.normal;
        for (auto& piece : side.pieces) {
            const auto& edge = std::get<particles::Segment>(piece);
            piece = particles::Segment{move(edge.from), move(edge.to)};
        }
    }
    return body;
}

/// Held on the left, pressed on the right and pulled along the top.
Problem<2, 2> pressed(const Material& material, double pressure, const Eigen::Rotation2Dd& turn) {
    Problem<2, 2> problem{elasticity<2>(material)};
    problem.given = {{"left", {zero, zero}}, {"right"}, {"top"}};
    problem.given[1].loads.push_back(
        [pressure](const Point<2>&, const Point<2>& n) { return Values<2>(-pressure * n); });
    problem.given[2].loads.push_back([pressure, turn](const Point<2>&, const Point<2>&) {
        return Values<2>(turn * (pressure * Values<2>::UnitX()));
    });
    return problem;
}

/// The quality number of derivatives along other axes, the rows of Q: second ones mix when the axes turn.
double quality_along(const Solution<2, 2>& solution, const Eigen::Matrix2d& Q) {
    const auto& cloud = solution.approximation.cloud();
    const auto& how = solution.approximation.how();
    const bool collocated = how.method == Method::fpm || how.method == Method::strong;
    double largest = 0;
    for (Index I = 0; I < cloud.size(); ++I) {
        const Weights<2> at = solution.approximation.at_particle(I);
        const double h = solution.approximation.h()[I];
        particles::Offsets<double, 2> r(at.value.size(), 2);
        for (Index j = 0; j < r.rows(); ++j)
            r.row(j) =
                (cloud.x().col(at.particle[static_cast<std::size_t>(j)]) - cloud.x().col(I)).transpose() / h;
        const auto add = [&](const Column<double>& w) {
            largest =
                std::max(largest, particles::quality<double, 2>(w, r, how.method == Method::fpm ? 3 : 2));
        };
        const bool second = collocated && solution.conditions[static_cast<std::size_t>(I)].empty();
        for (int a = 0; a < 2; ++a) {
            if (!second) add(h * (Q(a, 0) * at.first.col(0) + Q(a, 1) * at.first.col(1)));
            for (int b = a; second && b < 2; ++b)
                add(h * h *
                    (Q(a, 0) * Q(b, 0) * at.second.col(0) +
                     (Q(a, 0) * Q(b, 1) + Q(a, 1) * Q(b, 0)) * at.second.col(1) +
                     Q(a, 1) * Q(b, 1) * at.second.col(2)));
        }
    }
    return largest;
}

}  // namespace

TEST_CASE("solution: the lowest eigenvalue of a disc's membrane tends to the square of Bessel's zero") {
    const auto error = [](int rings, const Discretisation& how) {
        return std::abs(lowest(support::disc(rings, 0.15, 1), how) / 5.783185962946785 - 1);
    };
    for (const auto& how : {by(Method::hats), by(Method::fpm), by(Method::strong)}) {
        const double fine = error(11, how);
        CHECK(fine < 0.02);
        CHECK(fine < error(5, how) / 3);
    }
    Discretisation cubic = by(Method::hats);
    cubic.degree = 3;
    CHECK(error(11, cubic) < 0.01);
}

TEST_CASE("solution: the eigenvalues of a square's membrane tend to pi^2 times 2, 5, 5 and 8") {
    const auto errors = [](int n, Method method) {
        const Body<2> square = block<2>({{n, n}, 0.15, 1});
        const auto found = eigenvalues(membrane(square), square, by(method), 4);
        REQUIRE(found.size() == 4);
        std::array<double, 4> all{2, 5, 5, 8};
        for (std::size_t k = 0; k < 4; ++k) all[k] = std::abs(found[k] / (pi * pi * all[k]) - 1);
        return all;
    };
    for (const Method method : {Method::hats, Method::fpm, Method::strong}) {
        const auto coarse = errors(10, method), fine = errors(20, method);
        CHECK(fine[0] < 0.02);
        for (std::size_t k = 0; k < 4; ++k) {
            CHECK(fine[k] < coarse[k] / 2.5);
        }
    }
}

TEST_CASE("solution: a reaction is added to all eigenvalues") {
    const Body<2> square = block<2>({{10, 10}, 0.15, 1});
    Problem<2, 1> problem = membrane(square);
    const double without = eigenvalues(problem, square, by(Method::hats), 1)[0];
    problem.equation.c = 7;
    CHECK(eigenvalues(problem, square, by(Method::hats), 1)[0] == relative(without + 7, 1e-9));
}

TEST_CASE("solution: displacements turn with the body, and follow the units of length and stress") {
    const Body<2> body = block<2>({{10, 10}, 0.2, 3, [](const Point<2>& s) {
                                       return Point<2>(s[0] + 0.1 * s[0] * s[1], s[1] - 0.1 * s[0]);
                                   }});
    const Material material{2, 0.3, Plane::stress}, in_pascals{2e6, 0.3, Plane::stress};
    constexpr double scale = 1e-3;
    const Point<2> shift(0.02, -0.03), place(0.6, 0.5);
    for (const Method method : {Method::hats, Method::fpm, Method::strong})
        for (const double angle : {0.0, 0.3, pi / 2}) {
            INFO(name(method), ", turned by ", angle);
            const Eigen::Rotation2Dd turn(angle), none(0);
            const auto problem = pressed(material, 1, none), same = pressed(in_pascals, 1e6, turn);
            const Body<2> other = moved(body, turn, scale, shift);
            const auto solution = solve(problem, body, by(method)), turned = solve(same, other, by(method));
            const auto here = state_at(problem, solution, place);
            const auto there = state_at(same, turned, Point<2>(scale * (turn * place) + shift));
            const Eigen::Matrix2d R = turn.toRotationMatrix();
            CHECK((there.u / scale - R * here.u).norm() < 1e-8 * here.u.norm());
            CHECK((there.F / 1e6 - R * here.F * R.transpose()).norm() < 1e-8 * here.F.norm());
            CHECK(von_mises<2>(there.F, in_pascals) == relative(1e6 * von_mises<2>(here.F, material), 1e-8));
            CHECK(turned.quality == relative(quality_along(solution, R), 1e-8));
        }
}

TEST_CASE("solution: von Mises' stress of tension, of shear and of pressure") {
    const Material stress{1, 0.3, Plane::stress}, strain{1, 0.3, Plane::strain};
    const Eigen::Matrix2d tension{{5, 0}, {0, 0}}, shear{{0, 2}, {2, 0}},
        squeeze = -4 * Eigen::Matrix2d::Identity();
    CHECK(von_mises<2>(tension, stress) == relative(5, 1e-14));
    // s33 = 0.3 s11
    CHECK(von_mises<2>(tension, strain) == relative(5 * std::sqrt(1 - 0.3 + 0.09), 1e-14));
    CHECK(von_mises<2>(shear, stress) == relative(2 * std::sqrt(3), 1e-14));
    CHECK(von_mises<2>(shear, strain) == relative(2 * std::sqrt(3), 1e-14));
    CHECK(von_mises<2>(squeeze, stress) == relative(4, 1e-14));
    // s33 = 0.6 s11
    CHECK(von_mises<2>(squeeze, strain) == relative(4 * 0.4, 1e-14));
    Eigen::Matrix3d all = Eigen::Matrix3d::Zero();
    all(2, 2) = -5;
    CHECK(von_mises<3>(all, stress) == relative(5, 1e-14));
    CHECK(von_mises<3>(all, strain) == relative(5, 1e-14));
    CHECK(von_mises<3>(Eigen::Matrix3d::Identity(), strain) == 0);
    all.setZero();
    all(0, 2) = all(2, 0) = 2;
    CHECK(von_mises<3>(all, stress) == relative(2 * std::sqrt(3), 1e-14));
}

TEST_CASE("solution: three values with one power of the spacing as error give its order and the limit") {
    const double r = std::sqrt(2);
    for (const double order : {0.6, 1.0, 2.0, 2.9})
        for (const double error : {0.3, -0.3}) {
            const auto f = [&](int k) { return 5 + error * std::pow(r, -order * k); };
            const Extrapolated found = extrapolated(f(0), f(1), f(2), r, 2);
            CHECK(found.order == relative(order, 1e-10));
            CHECK(found.value == relative(5, 1e-12));
            CHECK(found.uncertainty == relative(1.25 * std::abs(5 - f(2)), 1e-10));
        }
}

TEST_CASE("solution: where no order can be observed the uncertainty is three times the range") {
    const auto check = [](double f1, double f2, double f3, double range) {
        const Extrapolated found = extrapolated(f1, f2, f3, 2, 2);
        CHECK(std::isnan(found.order));
        CHECK(found.value == f3);
        CHECK(found.uncertainty == relative(3 * range, 1e-14));
    };
    check(1, 2, 1.5, 1);                   // not monotone
    check(1, 2, 4, 3);                     // growing differences
    check(1, 1.5, 1.95, 0.95);             // order 0.15
    check(1, 2, 2 + 1.0 / 16, 17.0 / 16);  // order 4, above the formal one
    check(1, 1, 2, 1);
    check(1, 2, 2, 1);
    const Extrapolated same = extrapolated(3, 3, 3, 2, 2);
    CHECK(same.value == 3);
    CHECK(same.uncertainty == 0);
}

TEST_CASE("solution: the stresses in a ring under pressure are those of Lame") {
    const auto problem = support::lame();
    for (const Method method : {Method::hats, Method::fpm, Method::strong}) {
        INFO(name(method));
        const auto solution = solve(problem, support::quarter_ring(16), by(method));
        constexpr double r = 1.5, outer = support::outer, a = support::pressure / (outer * outer - 1);
        const Point<2> n(std::cos(0.7), std::sin(0.7)), t(-n[1], n[0]);
        const auto F = state_at(problem, solution, Point<2>(r * n)).F;
        CHECK(n.dot(F * n) == relative(a * (1 - outer * outer / (r * r)), 0.03));
        CHECK(t.dot(F * t) == relative(a * (1 + outer * outer / (r * r)), 0.03));
    }
}

TEST_CASE("solution: its worst particle is that with the largest quality number") {
    const Body<2> body = support::disc(6, 0.1, 1);
    for (const Method method : {Method::hats, Method::strong, Method::fpm}) {
        CAPTURE(name(method));
        Problem<2, 1> problem = membrane(body);
        problem.equation.b = [](const Point<2>&) { return Values<1>(1); };
        const auto solution = solve(problem, body, by(method));
        CHECK(solution.R.maxCoeff() == relative(solution.quality, 1e-12));
        CHECK(solution.R[solution.worst] == solution.R.maxCoeff());
    }
}

TEST_CASE("solution: hats of degree 3 take degree 2 in a strip two cells wide, and say so") {
    const auto flat = [](const Point<2>& x) { return Point<2>(x[0], x[1] / 10); };
    const Body<2> thin = block<2>({{20, 2}, 0, 1, flat}), wide = block<2>({{20, 20}});
    Discretisation cubic = by(Method::hats);
    cubic.degree = 3;
    CHECK(solve(membrane(thin), thin, cubic).approximation.how().degree == 2);
    CHECK(solve(membrane(wide), wide, cubic).approximation.how().degree == 3);
}

TEST_CASE("solution: too few particles for fpm are refused with their place") {
    const Body<2> body = block<2>({{1, 1}});
    CHECK_THROWS_WITH_AS(static_cast<void>(solve(membrane(body), body, by(Method::fpm))),
                         doctest::Contains("fpm: at (0, 0) there are 4 particles within "),
                         base::FailedComputation);
}

TEST_CASE("solution: where derivatives by fpm are determined badly or not at all, what was tried is named") {
    const auto flat = [](const Point<2>& x) { return Point<2>(x[0], x[1] / 5); };
    const Body<2> grid = block<2>({{30, 5}, 0, 1, flat}),
                  moved_a_little = block<2>({{30, 5}, 0.003, 1, flat});
    const auto refused = [](const Body<2>& body, double ratio) {
        Discretisation how = by(Method::fpm);
        how.smoothing = ratio;
        return support::refusal([&] { return solve(membrane(body), body, how); });
    };
    const std::string bad = refused(moved_a_little, 0.5), not_at_all = refused(grid, 0.5);
    CAPTURE(bad);
    CAPTURE(not_at_all);
    CHECK(bad.find(" has the quality number ") != std::string::npos);
    CHECK(bad.ends_with(", or the method hats"));
    CHECK(refused(moved_a_little, support::smoothing_to_try(bad)).empty());
    CHECK(not_at_all.find(" are not independent on them; try --smoothing ") != std::string::npos);
    CHECK(refused(grid, support::smoothing_to_try(not_at_all)).empty());
}
