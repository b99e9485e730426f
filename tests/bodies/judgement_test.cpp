#include "bodies/judgement.hpp"

#include <doctest/doctest.h>

#include "bodies/mesh.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/relative.hpp"
#include "tests/support/ring.hpp"

using namespace bodies;
using batra2008::elastostatics::Plane;
using support::block;
using support::inner;
using support::lame;
using support::outer;
using support::pressure;
using support::quarter_ring;
using support::relative;

namespace {

Discretisation by(Method method) {
    Discretisation how;
    how.method = method;
    return how;
}

const auto zero = [](const Point<2>&) { return 0.0; };

/// The unit square with (n + 1)² particles and one side.
Body<2> square(int n) {
    Mesh<2> mesh{Points<2>(2, (n + 1) * (n + 1)), {}, {}};
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) mesh.x.col(j * (n + 1) + i) = Point<2>(i, j) / n;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const int a = j * (n + 1) + i, c = a + n + 1;
            mesh.cells.push_back({a, a + 1, c + 1});
            mesh.cells.push_back({a, c + 1, c});
        }
    return body_of(mesh);
}

template <int n>
Values<n> on(const std::vector<std::pair<std::string, Values<n>>>& all, const std::string& side) {
    for (const auto& [name, value] : all)
        if (name == side) return value;
    FAIL("nothing acts on ", side);
    return {};
}

}  // namespace

TEST_CASE("judgement: planes of symmetry carry the pressure within a ring, to the last bit by hats") {
    const auto problem = lame();
    const auto error = [&](int n, Method method) {
        INFO(name(method), " ", n);
        const Body<2> body = quarter_ring(n);
        const auto solution = solve(problem, body, by(method));
        const auto found = judgement(problem, body, solution).balance;
        CHECK((on(found.loads, "left") - pressure * inner * Values<2>::Ones()).norm() < 1e-9);
        CHECK(found.volume.norm() == 0);
        const double reaction =
            (on(found.reactions, "bottom") + pressure * inner * Values<2>::UnitY()).norm() +
            (on(found.reactions, "top") + pressure * inner * Values<2>::UnitX()).norm();
        CHECK(found.defect <= reaction / pressure);
        return reaction / pressure;
    };
    CHECK(error(8, Method::hats) < 1e-9);
    for (const Method method : {Method::fpm, Method::strong}) {
        CHECK(error(16, method) < error(8, method) / 2.5);
    }
}

TEST_CASE("judgement: a heated square loses its source through the sides that are cooled") {
    const Body<2> square = block<2>({{12, 12}, 0.15, 1});
    Problem<2, 1> problem{diffusion<2>([](const Point<2>&) { return 2.0; })};
    problem.equation.b = [](const Point<2>&) { return Values<1>(6); };
    problem.given = {{"left", {zero}}, {"right"}};
    problem.given[1].exchange = [](const Point<2>&) { return 4.0; };
    problem.given[1].surroundings = [](const Point<2>&) { return 0.0; };
    // u = x (q - 3 x / 2), where the flux 2 (3 - q) at the right is 4 (q - 3/2)
    constexpr double q = 2;
    for (const Method method : {Method::hats, Method::fpm, Method::strong}) {
        INFO(name(method));
        const auto solution = solve(problem, square, by(method));
        const auto found = judgement(problem, square, solution).balance;
        CHECK(found.volume[0] == relative(6, 1e-12));
        CHECK(found.defect < (method == Method::hats ? 1e-10 : 1e-8));
        CHECK(on(found.reactions, "left")[0] == relative(-2 * q, 0.01));
        CHECK(on(found.loads, "right")[0] == relative(-4 * (q - 1.5), 0.01));
        CHECK(state_at(problem, solution, {0.5, 0.5}).u[0] == relative(0.5 * (q - 0.75), 0.01));
    }
}

TEST_CASE("judgement: a field that is a polynomial of the basis has no noise") {
    const Body<2> body = block<2>({{8, 8}, 0.2, 1});
    const support::Manufactured<2, 2> exact(elasticity<2>({2, 0.3}), 2, 3);
    const auto problem = exact.problem(body, {"left"});
    CHECK(judgement(problem, body, solve(problem, body, by(Method::strong))).noise < 1e-8);
}

TEST_CASE(
    "judgement: the loads that stresses miss vanish with the cells, and are none of a body that only moves") {
    const auto problem = lame();
    const auto missed = [&](int n) {
        const Body<2> body = quarter_ring(n);
        return judgement(problem, body, solve(problem, body, by(Method::hats))).missed_loads;
    };
    CHECK(missed(8) > 2 * missed(16));
    CHECK(missed(16) < 0.03);

    const Body<2> body = block<2>({{8, 8}});
    Problem<2, 2> shifted{elasticity<2>({2, 0.3})};
    shifted.given = {{"left", {[](const Point<2>&) { return 3.0; }, [](const Point<2>&) { return -1.0; }}}};
    CHECK(judgement(shifted, body, solve(shifted, body, by(Method::hats))).missed_loads == 0);
}

TEST_CASE("judgement: a load that is off by a known amount on one side misses that amount") {
    const Body<2> body = block<2>({{8, 8}, 0.15, 1});
    const support::Manufactured<2, 2> exact(elasticity<2>({2, 0.3}), 1, 3);
    Problem<2, 2> problem = exact.problem(body, {"left"});
    for (const Method method : {Method::hats, Method::strong}) {
        const auto solution = solve(problem, body, by(method));
        CHECK(judgement(problem, body, solution).missed_loads < 1e-9);
        const auto F = state_at(problem, solution, {0.5, 0.5}).F;
        Problem<2, 2> other = problem;
        for (auto& given : other.given)
            if (given.side == "right")
                given.loads.push_back([](const Point<2>&, const Point<2>&) { return Values<2>(0.3, -0.4); });
        CHECK(judgement(other, body, solution).missed_loads == relative(0.5 / (2 * F.norm()), 1e-9));
    }
}

TEST_CASE(
    "judgement: a material that hardly changes its volume misses loads where its displacements are right") {
    const Body<2> body = quarter_ring(24);
    const auto missed = [&](double nu) {
        Problem<2, 2> problem = lame();
        problem.equation = elasticity<2>({1, nu, Plane::strain});
        const auto solution = solve(problem, body, by(Method::hats));
        const double of_lame = (1 + nu) * pressure / (outer * outer - 1) * (1 - 2 * nu + outer * outer);
        CHECK(state_at(problem, solution, {inner, 0}).u[0] == relative(of_lame, 2e-3));
        return judgement(problem, body, solution).missed_loads;
    };
    CHECK(missed(0.3) < 0.02);
    CHECK(missed(0.499) > 0.2);
}

TEST_CASE("judgement: reactions that cancel on the one side of a body have a defect of round-off") {
    const Body<2> body = square(8);
    Problem<2, 1> heat{diffusion<2>([](const Point<2>&) { return 1.0; })};
    Given<2, 1> warm;
    warm.side = "boundary";
    warm.value = {[](const Point<2>& x) { return 1 + 2 * x[0]; }};
    heat.given.push_back(warm);
    Problem<2, 2> stretched{elasticity<2>({1, 0.3})};
    Given<2, 2> pulled;
    pulled.side = "boundary";
    pulled.value = {[](const Point<2>& x) { return x[0]; }, [](const Point<2>& x) { return x[1]; }};
    stretched.given.push_back(pulled);
    for (const Method method : {Method::hats, Method::strong, Method::fpm}) {
        Discretisation how;
        how.method = method;
        CHECK(judgement(heat, body, solve(heat, body, how)).balance.defect < 1e-9);
        CHECK(judgement(stretched, body, solve(stretched, body, how)).balance.defect < 1e-9);
    }
}

TEST_CASE("judgement: a body of one temperature, or one that only moves, has no defect that counts") {
    const Body<2> body = block<2>({{8, 8}, 0.15, 1});
    Problem<2, 1> warm{diffusion<2>([](const Point<2>&) { return 200.0; })};
    warm.given = {{"left", {[](const Point<2>&) { return 293.15; }}}};
    Problem<2, 2> turned{elasticity<2>({210e9, 0.3})};
    turned.given = {{"left",
                     {[](const Point<2>& x) { return 1 - 0.01 * x[1]; },
                      [](const Point<2>& x) { return 2 + 0.01 * x[0]; }}}};
    for (const Method method : {Method::hats, Method::fpm, Method::strong, Method::weak1, Method::weak2}) {
        INFO(name(method));
        Discretisation how = by(method);
        how.penalty = 1e8;
        CHECK(judgement(warm, body, solve(warm, body, how)).balance.defect < 0.01);
        how.penalty = 1e16;
        CHECK(judgement(turned, body, solve(turned, body, how)).balance.defect < 0.01);
    }
}

TEST_CASE("judgement: a flux between values that hardly differ is right to the digits that they have") {
    const Body<2> body = block<2>({{20, 20}});
    constexpr double large = 1e6, step = 1e-6;
    Problem<2, 1> heat{diffusion<2>([](const Point<2>&) { return 2.0; })};
    heat.given = {{"left", {[](const Point<2>&) { return large + step; }}},
                  {"right", {[](const Point<2>&) { return large; }}}};
    const double difference = (large + step) - large;
    for (const Method method : {Method::hats, Method::fpm, Method::strong, Method::weak1, Method::weak2}) {
        INFO(name(method));
        Discretisation how = by(method);
        how.penalty = 1e8;
        const auto solution = solve(heat, body, how);
        const auto state = state_at(heat, solution, {0.5, 0.5});
        CHECK(state.u[0] == relative(large + difference / 2, 1e-15));
        CHECK(state.F(0, 0) == relative(-2 * difference, 1e-5));
        const auto judged = judgement(heat, body, solution);
        CHECK(judged.share_of_terms > round_off_of_terms);
        CHECK(judged.noise < 1e-3);
        CHECK(on(judged.balance.reactions, "left")[0] == relative(2 * difference, 1e-5));
        CHECK(judged.balance.defect < 1e-3);
    }
}

TEST_CASE("judgement: a flux through a body that conducts well is right, whatever its temperature") {
    const Body<2> body = block<2>({{10, 10}, 0, 1, [](const Point<2>& x) { return Point<2>(1e-6 * x); }});
    Problem<2, 1> heat{diffusion<2>([](const Point<2>&) { return 1e9; })};
    heat.given = {{"left", {[](const Point<2>&) { return 20.0; }}}, {"right"}};
    heat.given[1].loads = {[](const Point<2>&, const Point<2>&) { return Values<1>(1); }};
    for (const Method method : {Method::hats, Method::fpm, Method::strong}) {
        INFO(name(method));
        const auto solution = solve(heat, body, by(method));
        CHECK(state_at(heat, solution, {5e-7, 5e-7}).F(0, 0) == relative(1, 1e-6));
        CHECK(judgement(heat, body, solution).missed_loads < 1e-3);
    }
}

TEST_CASE("judgement: given values that differ by round-off alone are one temperature") {
    const Body<2> body = block<2>({{8, 8}, 0.15, 1});
    const auto one = [](const Point<2>& x) {
        return 293.15 * (std::sin(9 * x[1]) * std::sin(9 * x[1]) + std::cos(9 * x[1]) * std::cos(9 * x[1]));
    };
    Problem<2, 1> heat{diffusion<2>([](const Point<2>&) { return 200.0; })};
    heat.given = {{"left", {one}}, {"right"}};
    heat.given[1].exchange = [](const Point<2>&) { return 5.0; };
    heat.given[1].surroundings = one;
    for (const Method method : {Method::hats, Method::fpm, Method::strong}) {
        INFO(name(method));
        const auto judged = judgement(heat, body, solve(heat, body, by(method)));
        CHECK(judged.noise == 0);
        CHECK(judged.missed_loads == 0);
        CHECK(judged.balance.defect < 0.01);
        CHECK(judged.share_of_terms < round_off_of_terms);
    }
}

TEST_CASE("judgement: a temperature of the surroundings does not hide that heat enters on all sides") {
    const Body<2> body = block<2>({{8, 8}, 0.15, 1});
    const auto defect = [&](double load, double surroundings) {
        Problem<2, 1> heat{diffusion<2>([](const Point<2>&) { return 1.0; })};
        heat.given = {{"left"}, {"right"}};
        heat.given[0].loads = {[load](const Point<2>& x, const Point<2>&) {
            return Values<1>(load * std::exp(-900 * (x[1] - 0.5) * (x[1] - 0.5)));
        }};
        heat.given[1].exchange = [](const Point<2>&) { return 5.0; };
        heat.given[1].surroundings = [surroundings](const Point<2>&) { return surroundings; };
        return judgement(heat, body, solve(heat, body, by(Method::fpm))).balance.defect;
    };
    CHECK(defect(1, 0) > 0.1);
    CHECK(defect(1e-12, 300) == relative(defect(1, 0), 1e-6));
}

TEST_CASE("judgement: a source that is in balance with the reaction to round-off has no defect") {
    const Body<2> body = block<2>({{10, 10}});
    Problem<2, 1> heat{diffusion<2>([](const Point<2>&) { return 1e-4; })};
    heat.equation.c = 0.7;
    heat.equation.b = [](const Point<2>&) { return Values<1>(205.205); };
    heat.given = {{"left"}};
    for (const bool convection : {false, true})
        for (const Method method : {Method::hats, Method::fpm, Method::strong}) {
            INFO(name(method), " ", convection);
            Given<2, 1>& given = heat.given[0];
            given = {"left"};
            (convection ? given.surroundings : given.value[0]) = [](const Point<2>&) { return 293.15; };
            if (convection) given.exchange = [](const Point<2>&) { return 2.0; };
            const auto judged = judgement(heat, body, solve(heat, body, by(method)));
            CHECK(judged.balance.defect < 0.01);
            CHECK(judged.missed_loads == 0);
            CHECK(judged.noise == 0);
        }
}

TEST_CASE("judgement: a motion of the whole body does not change which loads are missed") {
    const Body<2> body = quarter_ring(12);
    const auto missed = [&](double motion) {
        Problem<2, 2> pulled{elasticity<2>({1, 0.3})};
        const auto moved = [motion](const Point<2>&) { return motion; };
        pulled.given = {{"bottom", {moved, moved}}, {"top"}};
        pulled.given[1].loads = {[](const Point<2>&, const Point<2>&) { return Values<2>(1, 0); }};
        return judgement(pulled, body, solve(pulled, body, by(Method::hats))).missed_loads;
    };
    CHECK(missed(1e9) == relative(missed(0), 1e-2));
}

TEST_CASE("judgement: loads that round-off of a large motion hides are missed") {
    const Body<2> body = block<2>({{8, 8}, 0.15, 1});
    Problem<2, 2> moved{elasticity<2>({1, 0.3})};
    moved.given = {{"left", {[](const Point<2>&) { return 1e16; }, zero}}, {"right"}};
    moved.given[1].loads = {[](const Point<2>&, const Point<2>&) { return Values<2>(100, 0); }};
    for (const Method method : {Method::hats, Method::fpm, Method::strong}) {
        INFO(name(method));
        const auto judged = judgement(moved, body, solve(moved, body, by(method)));
        CHECK(judged.share_of_terms < round_off_of_terms);
        CHECK(judged.missed_loads > 0.1);
    }
}

TEST_CASE(
    "judgement: particles see across a slot that is narrower than their support, and not across a wide one") {
    // Rows of squares, some of them left out.
    const auto slotted = [](int n, int rows) {
        Mesh<2> mesh{Points<2>(2, (n + 1) * (n + 1)), {}, {}};
        for (int k = 0; k < mesh.x.cols(); ++k) mesh.x.col(k) = Point<2>(k % (n + 1), k / (n + 1)) / n;
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                if (j >= n / 3 && j < n / 3 + rows && i > 3) continue;
                const int a = j * (n + 1) + i, c = a + n + 1;
                mesh.cells.push_back({a, a + 1, c + 1});
                mesh.cells.push_back({a, c + 1, c});
            }
        return body_of(mesh);
    };
    Problem<2, 1> problem{diffusion<2>([](const Point<2>&) { return 1.0; })};
    problem.given = {{"boundary", {[](const Point<2>& x) { return x[0]; }}}};
    const auto across = [&](int rows, Method method) {
        const Body<2> body = slotted(24, rows);
        return across_gaps(body, solve(problem, body, by(method)).approximation).size();
    };
    CHECK(across(0, Method::fpm) == 0);
    CHECK(across(3, Method::fpm) > 20);
    CHECK(across(10, Method::fpm) == 0);
    CHECK(across(2, Method::hats) > 20);
    CHECK(across(10, Method::hats) == 0);
    CHECK(across_gaps(quarter_ring(16), solve(lame(), quarter_ring(16), by(Method::fpm)).approximation)
              .empty());
}
