#include "bodies/conditions.hpp"

#include <doctest/doctest.h>

#include <limits>

#include "base/errors.hpp"
#include "tests/support/bodies.hpp"

using namespace bodies;
using support::block;

namespace {

const Body<2> square = support::block<2>({{2, 2}});
constexpr int lower_left = 0, lower_right = 2, middle = 4, upper_right = 8;

template <int dim, int n>
Given<dim, n> value(const std::string& side, double u, const std::vector<int>& components) {
    Given<dim, n> given{side};
    for (const int i : components)
        given.value[static_cast<std::size_t>(i)] = [u](const Point<dim>&) { return u; };
    return given;
}

template <int dim, int n>
Given<dim, n> load(const std::string& side, double t) {
    Given<dim, n> given{side};
    given.loads.push_back(
        [t](const Point<dim>&, const Point<dim>&) { return Values<n>(Values<n>::Constant(t)); });
    return given;
}

template <int dim>
Given<dim, dim> symmetry(const std::string& side) {
    Given<dim, dim> given{side};
    given.symmetry = true;
    return given;
}

template <int dim, int n>
Problem<dim, n> problem_of(std::vector<Given<dim, n>> given) {
    Problem<dim, n> problem;
    if constexpr (n == 1)
        problem.equation = diffusion<dim>([](const Point<dim>&) { return 1.0; });
    else
        problem.equation = elasticity<dim>({2, 0.3});
    problem.given = std::move(given);
    return problem;
}

template <class Work>
std::string refusal(const Work& work) {
    try {
        work();
    } catch (const std::exception& error) {
        return error.what();
    }
    return "";
}

template <int dim, int n>
std::string motion(const Problem<dim, n>& problem, const Body<dim>& body) {
    return refusal([&] { require_held(problem, body, conditions(problem, body)); });
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("conditions: a particle on the boundary has one for each component, one inside has none") {
    const auto all = conditions(problem_of<2, 2>({value<2, 2>("left", 0, {0, 1})}), square);
    for (int I = 0; I < 9; ++I) CHECK(all[static_cast<std::size_t>(I)].size() == (I == middle ? 0 : 2));
}

TEST_CASE("conditions: at a corner a value goes before a load that is named first") {
    const auto all =
        conditions(problem_of<2, 2>({load<2, 2>("bottom", 5), value<2, 2>("left", 7, {0})}), square);
    const auto& here = all[lower_left];
    REQUIRE(here.size() == 2);
    CHECK(here[0].of_value);
    CHECK(here[0].given == 7);
    CHECK(here[0].from == 1);
    CHECK_FALSE(here[1].of_value);
    CHECK(here[1].given == 5);
    CHECK(here[1].from == 0);
    CHECK((here[1].direction - Values<2>::UnitY()).norm() == 0);
}

TEST_CASE("conditions: of two values, and of two loads, the side named first holds") {
    for (const bool bottom_first : {true, false}) {
        std::vector<Given<2, 1>> values{value<2, 1>("bottom", 1, {0}), value<2, 1>("left", 2, {0})};
        std::vector<Given<2, 1>> loads{load<2, 1>("bottom", 1), load<2, 1>("left", 2)};
        if (!bottom_first) std::swap(values[0], values[1]), std::swap(loads[0], loads[1]);
        CHECK(conditions(problem_of(values), square)[lower_left][0].given == (bottom_first ? 1 : 2));
        const auto here = conditions(problem_of(loads), square)[lower_left][0];
        CHECK(here.given == (bottom_first ? 1 : 2));
        CHECK((here.normal - (bottom_first ? Point<2>(0, -1) : Point<2>(-1, 0))).norm() < 1e-15);
    }
}

TEST_CASE(
    "conditions: the shear that symmetry excludes comes after loads that are named and after a free side") {
    auto problem = problem_of<2, 2>({symmetry<2>("left")});
    auto here = conditions(problem, square)[lower_left];
    CHECK(here[0].of_value);
    CHECK(std::abs(here[0].direction[0]) == 1);
    CHECK_FALSE(here[1].of_value);
    CHECK((here[1].normal - Point<2>(0, -1)).norm() < 1e-15);
    CHECK(here[1].from == -1);
    problem.given.push_back(load<2, 2>("bottom", 3));
    here = conditions(problem, square)[lower_left];
    CHECK(here[1].from == 1);
    CHECK(here[1].given == 3);
}

TEST_CASE("conditions: two planes of symmetry hold both components of their edge, three all of a corner") {
    const auto corner =
        conditions(problem_of<2, 2>({symmetry<2>("left"), symmetry<2>("bottom")}), square)[lower_left];
    CHECK((corner[0].of_value && corner[1].of_value));
    const Body<3> cube = block<3>({{2, 2, 2}});
    const auto all =
        conditions(problem_of<3, 3>({symmetry<3>("left"), symmetry<3>("bottom"), symmetry<3>("back")}), cube);
    const auto count = [&](int I) {
        const auto& here = all[static_cast<std::size_t>(I)];
        return std::count_if(here.begin(), here.end(), [](const auto& one) { return one.of_value; });
    };
    CHECK(count(0) == 3);
    CHECK(count(1) == 2);
    CHECK(count(2) == 2);
    CHECK(count(4) == 1);
    CHECK(count(26) == 0);
}

TEST_CASE("conditions: along a slanted plane of symmetry the value is that along its normal") {
    const Body<2> slanted =
        block<2>({{2, 2}, 0, 1, [](const Point<2>& s) { return Point<2>(s[0] + 0.5 * s[1], s[1]); }});
    const auto here = conditions(problem_of<2, 2>({symmetry<2>("left")}), slanted)[3];
    const Point<2> normal = Point<2>(-1, 0.5).normalized();
    CHECK((here[0].direction - normal).norm() < 1e-10);
    CHECK(here[0].of_value);
    CHECK(std::abs(here[1].direction.dot(normal)) < 1e-10);
}

TEST_CASE("conditions: corners override the rule, component by component") {
    auto problem = problem_of<2, 2>({load<2, 2>("bottom", 1), load<2, 2>("right", 2)});
    problem.corners = {{{"right", "bottom"}, {"right", "bottom"}}};
    const auto here = conditions(problem, square)[lower_right];
    CHECK(here[0].given == 2);
    CHECK(here[1].given == 1);
    problem.given.push_back(value<2, 2>("top", 9, {0, 1}));
    problem.corners = {{{"right", "top"}, {"top", "right"}}};
    const auto there = conditions(problem, square)[upper_right];
    CHECK(there[0].of_value);
    CHECK_FALSE(there[1].of_value);
    CHECK(there[1].given == 2);
}

TEST_CASE("conditions: convection is an exchange and a load, and loads on a side add up") {
    Given<2, 1> given = load<2, 1>("left", 1);
    given.loads.push_back(given.loads[0]);
    given.exchange = [](const Point<2>&) { return 3.0; };
    given.surroundings = [](const Point<2>&) { return 5.0; };
    const auto here = conditions(problem_of<2, 1>({given}), square)[3][0];
    CHECK(here.exchange == 3);
    CHECK(here.given == 2 + 3 * 5);
}

TEST_CASE("conditions: unknown sides, sides given twice and corners without meaning are refused") {
    const auto message = [](Problem<2, 2> problem) {
        return refusal([&] { static_cast<void>(conditions(problem, square)); });
    };
    const std::string unknown = message(problem_of<2, 2>({load<2, 2>("lid", 1)}));
    for (const char* word : {"lid", "left", "right", "bottom", "top"}) CHECK(has(unknown, word));
    CHECK(has(message(problem_of<2, 2>({load<2, 2>("top", 1), load<2, 2>("top", 1)})), "top is given twice"));
    auto problem = problem_of<2, 2>({load<2, 2>("top", 1)});
    problem.corners = {{{"left", "lid"}, {"left", "left"}}};
    CHECK(has(message(problem), "lid"));
    problem.corners = {{{"left", "top"}, {"left"}}};
    CHECK(has(message(problem), "one for each component"));
    problem.corners = {{{"left", "top"}, {"left", "bottom"}}};
    CHECK(has(message(problem), "not from bottom"));
}

TEST_CASE("conditions: a choice at a corner of sides that do not meet is refused") {
    auto problem = problem_of<2, 2>({load<2, 2>("top", 1)});
    problem.corners = {{{"left", "top"}, {"left", "top"}}};
    CHECK_NOTHROW(require_corners(problem, square));
    problem.corners = {{{"left", "right"}, {"left", "right"}}};
    CHECK(refusal([&] { require_corners(problem, square); }) ==
          "the sides left and right have no corner: they meet at no particle");
    problem.corners = {{{"left", "left"}, {"left", "left"}}};
    CHECK_THROWS_AS(require_corners(problem, square), base::InvalidInput);
}

TEST_CASE("conditions: a given function that is not finite is refused with its side and place") {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                     infinite = std::numeric_limits<double>::infinity();
    for (const auto& given : {value<2, 1>("right", nan, {0}), load<2, 1>("right", infinite)}) {
        const std::string message =
            refusal([&] { static_cast<void>(conditions(problem_of<2, 1>({given}), square)); });
        CHECK(has(message, "right"));
        CHECK(has(message, "(1, 0)"));
    }
}

TEST_CASE("conditions: a motion that is left free is named") {
    CHECK(has(motion(problem_of<2, 2>({}), square), "is not held"));
    CHECK(has(motion(problem_of<2, 2>({value<2, 2>("left", 0, {0})}), square), "move along x2"));
    CHECK(has(motion(problem_of<2, 2>({value<2, 2>("left", 0, {1})}), square), "move along x1"));
    CHECK(motion(problem_of<2, 2>({value<2, 2>("left", 0, {0, 1})}), square).empty());
    CHECK(motion(problem_of<2, 2>({symmetry<2>("left"), symmetry<2>("bottom")}), square).empty());
    const Body<2> disc = support::disc(3, 0, 1);
    CHECK(has(motion(problem_of<2, 2>({symmetry<2>("edge")}), disc), "turn"));
    const Body<3> cube = block<3>({{2, 2, 2}});
    CHECK(has(motion(problem_of<3, 3>({symmetry<3>("left"), symmetry<3>("bottom")}), cube), "move along x3"));
    CHECK(motion(problem_of<3, 3>({symmetry<3>("left"), symmetry<3>("bottom"), symmetry<3>("back")}), cube)
              .empty());
}

TEST_CASE("conditions: of two parts each must be held") {
    const auto two =
        block<2>({{3, 2}, 0, 1, {}, [](const Point<2>& x) { return std::abs(x[0] - 0.5) > 0.2; }});
    const std::string message = motion(problem_of<2, 2>({value<2, 2>("left", 0, {0, 1})}), two);
    CHECK(has(message, "is not held"));
    CHECK(has(message, "(0.666"));
    CHECK(motion(problem_of<2, 2>({value<2, 2>("left", 0, {0, 1}), value<2, 2>("right", 0, {0, 1})}), two)
              .empty());
}

TEST_CASE("conditions: a scalar needs a value, convection or a reaction") {
    CHECK(has(motion(problem_of<2, 1>({load<2, 1>("left", 1)}), square), "up to a constant"));
    CHECK(motion(problem_of<2, 1>({value<2, 1>("left", 1, {0})}), square).empty());
    Given<2, 1> cooled{"left"};
    cooled.exchange = cooled.surroundings = [](const Point<2>&) { return 1.0; };
    CHECK(motion(problem_of<2, 1>({cooled}), square).empty());
    auto with_reaction = problem_of<2, 1>({});
    with_reaction.equation.c = 1;
    CHECK(motion(with_reaction, square).empty());
}
