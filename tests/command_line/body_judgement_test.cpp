#include "command_line/body_judgement.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "tests/support/bodies.hpp"
#include "tests/support/remedies.hpp"
#include "tests/support/ring.hpp"

using namespace bodies;
using batra2008::elastostatics::Plane;
using command_line::SolvedBody;

namespace {

/// What is said of a square that is clamped on the left and sheared on the right.
std::vector<std::string> remarks_on_sheared(Method method) {
    const Body<2> body = support::block<2>({{10, 10}});
    Problem<2, 2> problem{elasticity<2>({1, 0.3})};
    const auto zero = [](const Point<2>&) { return 0.0; };
    problem.given = {{"left", {zero, zero}}, {"right"}};
    problem.given[1].loads.push_back([](const Point<2>&, const Point<2>&) { return Values<2>(0, 1); });
    Discretisation how;
    how.method = method;
    const auto solution = solve(problem, body, how);
    const SolvedBody<2, 2> all{problem, body, solution, {1, 0.3}};
    return command_line::remarks(solution.approximation.how(), judgement(problem, body, solution),
                                 command_line::particles_of(all), how.degree, "THIS");
}

}  // namespace

TEST_CASE(
    "body judgement: stresses of a body that only turns may be round-off, those of a stretched one are not") {
    const Body<2> body = support::block<2>({{10, 10}});
    const auto said = [&](double stretch) {
        Problem<2, 2> problem{elasticity<2>({1, 0.3})};
        problem.given = {
            {"left", {[](const Point<2>& x) { return -x[1]; }, [](const Point<2>&) { return 5.0; }}},
            {"right",
             {[stretch](const Point<2>& x) { return stretch - x[1]; }, [](const Point<2>&) { return 6.0; }}}};
        const auto solution = solve(problem, body, {});
        return command_line::about_round_off(solution.approximation.how(),
                                             judgement(problem, body, solution));
    };
    REQUIRE(said(0).size() == 1);
    CHECK(said(0)[0].starts_with("fpm: stresses may be round-off: their size is "));
    CHECK(said(1e-3).empty());
}

TEST_CASE("body judgement: a load that a motion of the body hides is judged without the motion") {
    const Body<2> body = support::block<2>({{10, 10}});
    const auto said = [&](double motion) {
        Problem<2, 2> problem{elasticity<2>({210e9, 0.3})};
        const auto moved = [motion](const Point<2>&) { return motion; };
        problem.given = {{"left", {moved, moved}}, {"right"}};
        problem.given[1].loads.push_back([](const Point<2>&, const Point<2>&) { return Values<2>(3e-3, 0); });
        Discretisation how;
        how.method = Method::hats;
        const auto solution = solve(problem, body, how);
        const SolvedBody<2, 2> all{problem, body, solution, {210e9, 0.3}};
        return command_line::remarks(solution.approximation.how(), judgement(problem, body, solution),
                                     command_line::particles_of(all), how.degree, "THIS");
    };
    const std::string refused = support::refusal([&] { return said(1); });
    CAPTURE(refused);
    CHECK(refused.ends_with("; take displacements less a motion of the whole body"));
    for (const std::string& remark : said(0)) CHECK(remark.find("defect") == std::string::npos);
}

TEST_CASE("body judgement: a solution far out of equilibrium is refused with its method, forces and remedy") {
    const std::string refused = support::refusal([] { return remarks_on_sheared(Method::strong); });
    CAPTURE(refused);
    CHECK(refused.starts_with("strong: loads and reactions leave a defect of "));
    CHECK(refused.find("; loads right (0, 1), reactions left (") != std::string::npos);
    CHECK(refused.ends_with("; take THIS"));
}

TEST_CASE("body judgement: stresses that miss the given loads have a remark, and a good solution has none") {
    const Body<2> body = support::quarter_ring(24);
    Problem<2, 2> problem = support::lame();
    Discretisation how;
    how.method = Method::hats;
    for (const double nu : {0.3, 0.499}) {
        problem.equation = elasticity<2>({1, nu, Plane::strain});
        const auto solution = solve(problem, body, how);
        const SolvedBody<2, 2> all{problem, body, solution, {1, nu, Plane::strain}};
        const Judgement<2> judged = judgement(all.problem, all.body, all.solution);
        const auto remarks = command_line::remarks(solution.approximation.how(), judged,
                                                   command_line::particles_of(all), how.degree, "");
        const bool missed = std::any_of(remarks.begin(), remarks.end(), [](const std::string& remark) {
            return remark.starts_with("hats: the stresses at the boundary miss the given loads by ");
        });
        CHECK(missed == (nu > 0.4));
        if (nu < 0.4) CHECK(remarks.empty());
        const auto numbers = command_line::quantities<2>(judged);
        const auto named = std::find_if(numbers.begin(), numbers.end(),
                                        [](const auto& number) { return number.name == "missed_loads"; });
        REQUIRE(named != numbers.end());
        CHECK(named->value == judged.missed_loads);
    }
}

TEST_CASE("body judgement: monomials of a lower degree than asked for have a remark") {
    const Body<2> body = support::block<2>({{6, 6}});
    Problem<2, 1> problem{diffusion<2>([](const Point<2>&) { return 1.0; })};
    problem.given = {{"left", {[](const Point<2>& x) { return x[1]; }}}};
    Discretisation how;
    how.method = Method::hats;
    const auto solution = solve(problem, body, how);
    const SolvedBody<2, 1> all{problem, body, solution, {1, 0}};
    const Judgement<1> judged = judgement(all.problem, all.body, all.solution);
    const auto says = [&](int degree) {
        const auto remarks = command_line::remarks(solution.approximation.how(), judged,
                                                   command_line::particles_of(all), degree, "");
        return std::any_of(remarks.begin(), remarks.end(), [](const std::string& remark) {
            return remark.starts_with(
                "hats: monomials of degree 2, since the particles determine those of degree 3");
        });
    };
    CHECK(says(3));
    CHECK_FALSE(says(2));
}
