#include "command_line/body_conditions.hpp"

#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

#include "base/errors.hpp"

using namespace command_line;
using base::InvalidInput;
using bodies::Body;
using bodies::Point;

namespace {

/// A square of 3 × 3 particles, or a cube of 2 × 2 × 2, with a side for each face.
template <int dim>
Body<dim> box() {
    constexpr int count = dim == 2 ? 3 : 2;
    const std::vector<std::string> names{"left", "right", "bottom", "top", "back", "front"};
    Body<dim> body;
    body.x.resize(dim, dim == 2 ? 9 : 8);
    for (int I = 0; I < body.x.cols(); ++I)
        for (int axis = 0, rest = I; axis < dim; ++axis, rest /= count)
            body.x(axis, I) = static_cast<double>(rest % count) / (count - 1);
    for (int axis = 0; axis < dim; ++axis)
        for (int end = 0; end < 2; ++end) {
            bodies::Side<dim> side{names[static_cast<std::size_t>(2 * axis + end)], {}, {}};
            for (int I = 0; I < body.x.cols(); ++I)
                if (body.x(axis, I) == end)
                    side.places.push_back({I, Point<dim>((2 * end - 1) * Point<dim>::Unit(axis))});
            body.sides.push_back(side);
        }
    return body;
}

TypedProblem steel(const std::vector<Typed>& conditions) {
    TypedProblem typed;
    typed.young = 210e9;
    typed.poisson = 0.3;
    typed.conditions = conditions;
    return typed;
}

TypedProblem scalar(const std::vector<Typed>& conditions) {
    TypedProblem typed;
    typed.equation = "poisson";
    typed.conditions = conditions;
    return typed;
}

template <int dim, int n>
auto given(const TypedProblem& typed) {
    return problem<dim, n>(typed, box<dim>()).given;
}

template <class Work>
void check_refused(const std::string& reason, const Work& work) {
    CAPTURE(reason);
    try {
        work();
        FAIL("accepted, not refused");
    } catch (const InvalidInput& error) {
        const std::string what = error.what();
        CAPTURE(what);
        CHECK(what.find(reason) != std::string::npos);
    }
}

/// The options as a shell gives them.
TypedProblem read(std::vector<std::string> words) {
    CommandLine app("about", "body");
    TypedProblem typed;
    add_options(app, typed);
    words.insert(words.begin(), "body");
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    CHECK_FALSE(app.read(static_cast<int>(arguments.size()), arguments.data()));
    return typed;
}

const Point<2> x(0.25, 0.5), normal(0.6, 0.8);

}  // namespace

TEST_CASE("body: sides stand in the order in which any option names them first") {
    const auto typed = read({"--young", "210e9", "--poisson", "0.3", "--traction", "top: 0, -1", "--fix",
                             "left", "--pressure", "top: 2", "--displacement=right: -x, -"});
    const auto all = given<2, 2>(typed);
    REQUIRE(all.size() == 3);
    CHECK(all[0].side == "top");
    CHECK(all[1].side == "left");
    CHECK(all[2].side == "right");
    CHECK(all[2].value[0](x) == -0.25);
    CHECK_FALSE(all[2].value[1]);
}

TEST_CASE("body: tractions and pressures of a side add, and a pressure pushes") {
    const auto all = given<2, 2>(steel(
        {{"--traction", "top: max(x, y), -"}, {"--traction", "top: 0, 1"}, {"--pressure", "top: 10*x"}}));
    bodies::Values<2> sum = bodies::Values<2>::Zero();
    for (const auto& load : all[0].loads) sum += load(x, normal);
    CHECK(sum[0] == doctest::Approx(0.5 - 2.5 * 0.6));
    CHECK(sum[1] == doctest::Approx(1 - 2.5 * 0.8));
}

TEST_CASE("body: a fixed side has no displacement, one of symmetry none along its normal") {
    const auto all = given<3, 3>(steel({{"--fix", " left "}, {"--symmetry", "right"}}));
    for (const auto& value : all[0].value) CHECK(value({0.1, 0.2, 0.3}) == 0);
    CHECK(all[1].symmetry);
    for (const auto& value : all[1].value) CHECK_FALSE(value);
}

TEST_CASE("body: a name ends at the first colon, and commas within parentheses separate nothing") {
    const auto all = given<2, 2>(steel({{"--displacement", "left:atan2(y, x), min(x, y)"}}));
    CHECK(all[0].value[0](x) == doctest::Approx(std::atan2(0.5, 0.25)));
    CHECK(all[0].value[1](x) == 0.25);
}

TEST_CASE("body: values, fluxes and convection of a scalar") {
    const auto all = given<2, 1>(
        scalar({{"--value", "left: 2*y"}, {"--flux", "top: 3*x"}, {"--convection", "top: 5, 293"}}));
    CHECK(all[0].value[0](x) == 1);
    CHECK(all[1].loads[0](x, normal)[0] == 0.75);
    CHECK(all[1].exchange(x) == 5);
    CHECK(all[1].surroundings(x) == 293);
}

TEST_CASE("body: a conductivity has its gradient unless it is a number, and may have a kink at a particle") {
    TypedProblem typed = scalar({{"--value", "left: 0"}});
    CHECK_FALSE(problem<2, 1>(typed, box<2>()).equation.div_A);
    typed.conductivity = "1 + x*y + abs(x - 0.5)";
    typed.source = "x";
    typed.reaction = 2;
    const auto equation = problem<2, 1>(typed, box<2>()).equation;
    CHECK(equation.A(x)(1, 1) == doctest::Approx(1 + 0.125 + 0.25));
    CHECK(equation.div_A(x)(0, 0) == doctest::Approx(0.5 - 1));
    CHECK(equation.div_A(x)(0, 1) == doctest::Approx(0.25));
    CHECK(equation.b(x)[0] == 0.25);
    CHECK(equation.c == 2);
    CHECK(largest_coefficient<2>(typed, box<2>()) == doctest::Approx(1 + 1 + 0.5));
}

TEST_CASE("body: a corner takes each component from one of two sides") {
    TypedProblem typed = steel({{"--fix", "left"}});
    typed.corners = {{"--corner", "left + top: top, left"}};
    const auto corners = problem<2, 2>(typed, box<2>()).corners;
    REQUIRE(corners.size() == 1);
    CHECK(corners[0].sides == std::array<std::string, 2>{"left", "top"});
    CHECK(corners[0].by_component == std::vector<std::string>{"top", "left"});
    for (const auto& [text, reason] : std::vector<std::pair<std::string, std::string>>{
             {"left: left, left", "does not name two sides"},
             {"left+up: left, up", "the body has no side 'up'; its sides are left, right, bottom, top"},
             {"left+left: left, left", "names one side twice"},
             {"left+top: left", "has 1 entry, 2 are needed; write --corner \"A+B: A, B\""},
             {"left+top: left, right", "takes a condition from 'right'; take left or top"}}) {
        typed.corners = {{"--corner", text}};
        check_refused(reason, [&] { static_cast<void>(problem<2, 2>(typed, box<2>())); });
    }
}

TEST_CASE("body: names of sides may hold colons and pluses") {
    auto body = box<2>();
    body.sides[0].name = "a:b";
    body.sides[1].name = "a";
    body.sides[2].name = "c+d: e";
    TypedProblem typed = steel({{"--traction", "a:b: 0, 1"}, {"--fix", "a"}, {"--traction", "c+d: e: 0, 1"}});
    typed.corners = {{"--corner", "a:b+c+d: e: a:b, c+d: e"}};
    const auto found = problem<2, 2>(typed, body);
    REQUIRE(found.given.size() == 3);
    CHECK(found.given[0].side == "a:b");
    CHECK(found.given[1].side == "a");
    CHECK(found.given[2].side == "c+d: e");
    REQUIRE(found.corners.size() == 1);
    CHECK(found.corners[0].sides == std::array<std::string, 2>{"a:b", "c+d: e"});
    CHECK(found.corners[0].by_component == std::vector<std::string>{"a:b", "c+d: e"});
}

TEST_CASE("body: what is given twice, or beside a load, is refused with what to leave out") {
    for (
        const auto& [conditions, reason] : std::vector<std::pair<std::vector<Typed>, std::string>>{
            {{{"--fix", "left"}, {"--displacement", "left: 0, -"}},
             "--displacement on left: component 1 is given already, by --fix; leave one of them out"},
            {{{"--symmetry", "left"}, {"--fix", "left"}}, "is given already, by --symmetry"},
            {{{"--fix", "left"}, {"--traction", "left: -, 1"}},
             "--traction on left: component 2 is given by --fix and can carry no load; leave one"},
            {{{"--traction", "left: 0, 1"}, {"--displacement", "left: -, 0"}},
             "--traction on left: component 2 is given by --displacement and can carry no load; write a dash"},
            {{{"--pressure", "left: 1"}, {"--displacement", "left: 0, -"}},
             "--pressure on left: component 1 is given by --displacement and can carry no load; write a --traction"},
            {{{"--symmetry", "left"}, {"--traction", "left: -, 1"}}, "leave the load out"}})
        check_refused(reason, [&] { given<2, 2>(steel(conditions)); });
    CHECK_NOTHROW(given<2, 2>(steel({{"--pressure", "left: 1"}, {"--displacement", "left: -, 0"}})));
    for (const auto& [conditions, reason] : std::vector<std::pair<std::vector<Typed>, std::string>>{
             {{{"--value", "left: 0"}, {"--flux", "left: 1"}}, "the value is given by --value"},
             {{{"--value", "left: 0"}, {"--value", "left: 1"}}, "the value is given already, by --value"},
             {{{"--convection", "top: 1, 2"}, {"--convection", "top: 1, 3"}}, "is given twice"},
             {{{"--convection", "top: x - 1, 2"}},
              "the coefficient must not be negative, it is -1 at (0, 1)"}})
        check_refused(reason, [&] { given<2, 1>(scalar(conditions)); });
}

TEST_CASE("body: texts that cannot be read are refused with option, side and place") {
    for (const auto& [condition, reason] : std::vector<std::pair<Typed, std::string>>{
             {{"--fix", "lef"}, "--fix: the body has no side 'lef'; its sides are left, right, bottom, top"},
             {{"--fix", "left: 0"}, "--fix: the body has no side 'left: 0'"},
             {{"--traction", "left"}, "--traction: 'left' has no colon; write --traction \"NAME: 0, -1e6\""},
             {{"--traction", "left: 1"}, "has 1 entry, 2 are needed; write --traction"},
             {{"--traction", "left: 1, 2, 3"}, "has 3 entries, 2 are needed"},
             {{"--traction", "left: 1, "}, "has an empty entry"},
             {{"--traction", "left: -, -"}, "--traction on left gives nothing"},
             {{"--traction", "left: z, 0"}, "--traction on left: 'z'"},
             {{"--traction", "left: 0, log(y)"},
              "--traction on left: 'log(y)' is not finite at the particle (0, 0); write it so that it is"},
             {{"--pressure", "left: 1, 2"}, "has 2 entries, 1 is needed"},
             {{"--displacement", "left: 1/(y-1), -"}, "'1/(y-1)' is not finite at the particle (0, 1)"}})
        check_refused(reason, [&] { given<2, 2>(steel({condition})); });
    TypedProblem typed = steel({});
    typed.body_force = "0, 1/(x-0.5)";
    check_refused("--body-force: '1/(x-0.5)' is not finite at the particle (0.5, 0)",
                  [&] { given<2, 2>(typed); });
    typed.body_force = "1";
    check_refused("write --body-force \"0, 0, -1\"", [&] { given<3, 3>(typed); });
    typed = scalar({});
    typed.conductivity = "x - 0.5";
    check_refused("--conductivity must be positive, it is -0.5 at the particle (0, 0)",
                  [&] { given<2, 1>(typed); });
    typed.conductivity = "1 + sqrt(x)";
    check_refused("the gradient of '1 + sqrt(x)' is not finite at the particle (0, 0)",
                  [&] { given<2, 1>(typed); });
}

TEST_CASE("body: options of the other equation and incomplete materials are refused with the remedy") {
    check_refused("--traction belongs to --equation elasticity; for a scalar write --flux \"NAME: Q\"", [] {
        check(scalar({{"--traction", "left: 0, 1"}}), 2);
    });
    check_refused("--value belongs to --equation poisson; for an elastic body write --displacement", [] {
        check(steel({{"--value", "left: 0"}}), 2);
    });
    TypedProblem typed = steel({});
    CHECK_NOTHROW(check(typed, 3));
    typed.plane = "strain";
    CHECK_NOTHROW(check(typed, 2));
    check_refused("--plane belongs to bodies in the plane", [&] { check(typed, 3); });
    typed.young = -1;
    check_refused("Young's modulus must be positive and finite, got -1", [&] { check(typed, 2); });
    typed.young.reset();
    check_refused("an elastic body needs --young", [&] { check(typed, 2); });
    typed = scalar({});
    typed.young = 1;
    check_refused("--young belongs to --equation elasticity; for a scalar write --conductivity K",
                  [&] { check(typed, 2); });
}
