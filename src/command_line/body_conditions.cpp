#include "command_line/body_conditions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "base/errors.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "command_line/body_functions.hpp"
#include "command_line/body_sides.hpp"

namespace command_line {

using base::InvalidInput;
using base::shown;
using bodies::Body;
using bodies::Field;
using bodies::Index;
using bodies::Point;
using bodies::Problem;
using bodies::Values;

void add_options(CommandLine& app, TypedProblem& typed) {
    app.add_option("--equation", typed.equation,
                   "elasticity (default), or poisson for a scalar: -div(k grad u) + c u = f")
        .type_name("NAME")
        .among({"elasticity", "poisson"});
    app.add_option("--young", typed.young, "Young's modulus").type_name("E");
    app.add_option("--poisson", typed.poisson, "Poisson's ratio").type_name("NU");
    app.add_option("--plane", typed.plane, "in the plane: stress (default) or strain")
        .type_name("NAME")
        .among({"stress", "strain"});
    const auto on_side = [&](const std::string& name, const std::string& shown, const std::string& about) {
        app.add_repeated(name, typed.conditions, about).type_name(shown);
    };
    on_side("--fix", "NAME", "a side that does not move");
    on_side("--symmetry", "NAME", "a side in a plane of symmetry: no motion along its normal, and no shear");
    on_side("--displacement", "\"NAME: UX,UY[,UZ]\"",
            "displacements of a side; a lone dash leaves a component free");
    on_side("--traction", "\"NAME: TX,TY[,TZ]\"",
            "force per unit area on a side; tractions and pressures on the same side add up");
    on_side("--pressure", "\"NAME: P\"", "pressure on a side; a positive one pushes");
    app.add_option("--body-force", typed.body_force, "force per unit volume").type_name("\"BX,BY[,BZ]\"");
    on_side("--value", "\"NAME: U\"", "the scalar on a side");
    on_side("--flux", "\"NAME: Q\"", "k du/dn on a side: a positive one heats the body");
    on_side("--convection", "\"NAME: A,U0\"", "-k du/dn = A (u - U0) on a side");
    app.add_option("--source", typed.source, "the source f of the scalar").type_name("F");
    app.add_option("--conductivity", typed.conductivity, "the conductivity k (default 1)").type_name("K");
    app.add_option("--reaction", typed.reaction,
                   "c of the term c u, such as an elastic foundation (default 0)")
        .type_name("C");
    app.add_repeated("--corner", typed.corners,
                     "where two sides meet: for each component, the side whose condition holds")
        .type_name("\"A+B: A|B,...\"");
}

bool is_scalar(const TypedProblem& typed) {
    return typed.equation == "poisson";
}

namespace {

/// The options of one equation, with what stands for them in the other.
const std::map<std::string, std::string> of_elasticity{
    {"--fix", "write --value \"NAME: 0\""},
    {"--symmetry", "leave it out: a side that is named nowhere is insulated"},
    {"--displacement", "write --value \"NAME: U\""},
    {"--traction", "write --flux \"NAME: Q\""},
    {"--pressure", "write --flux \"NAME: Q\""},
    {"--body-force", "write --source F"},
    {"--young", "write --conductivity K"},
    {"--poisson", "leave it out"},
    {"--plane", "leave it out"}};
const std::map<std::string, std::string> of_scalars{{"--value", "write --displacement \"NAME: UX,UY\""},
                                                    {"--flux", "write --traction \"NAME: TX,TY\""},
                                                    {"--convection", "write --traction or --displacement"},
                                                    {"--source", "write --body-force \"BX,BY\""},
                                                    {"--conductivity", "write --young E --poisson NU"}};

/// The options that were given, other than --reaction and --corner.
std::vector<std::string> given_options(const TypedProblem& typed) {
    std::vector<std::string> given;
    const auto note = [&](bool is_given, const char* option) {
        if (is_given) given.emplace_back(option);
    };
    note(typed.young.has_value(), "--young");
    note(typed.poisson.has_value(), "--poisson");
    note(typed.plane.has_value(), "--plane");
    note(typed.body_force.has_value(), "--body-force");
    note(typed.source.has_value(), "--source");
    note(typed.conductivity.has_value(), "--conductivity");
    for (const Typed& condition : typed.conditions) given.push_back(condition.option);
    return given;
}

}  // namespace

void check(const TypedProblem& typed, int dim) {
    const auto& others = is_scalar(typed) ? of_elasticity : of_scalars;
    for (const std::string& option : given_options(typed))
        if (const auto other = others.find(option); other != others.end())
            throw InvalidInput(
                option + " belongs to --equation " +
                (is_scalar(typed) ? "elasticity; for a scalar " : "poisson; for an elastic body ") +
                other->second);
    if (!std::isfinite(typed.reaction))
        throw InvalidInput("--reaction must be finite, got " + shown(typed.reaction));
    if (is_scalar(typed)) return;
    for (const auto& [option, number] : {std::pair{"--young", typed.young}, {"--poisson", typed.poisson}})
        if (!number)
            throw InvalidInput(std::string("an elastic body needs ") + option +
                               "; for steel, in SI units: --young 210e9 --poisson 0.3");
    if (dim == 3 && typed.plane)
        throw InvalidInput("--plane belongs to bodies in the plane; leave it out for this one in space");
    static_cast<void>(material(typed));
}

batra2008::elastostatics::Material material(const TypedProblem& typed) {
    return batra2008::elastostatics::checked(
        {*typed.young, *typed.poisson,
         batra2008::elastostatics::plane_named(typed.plane.value_or("stress"))});
}

namespace {

/// A conductivity that is positive at all particles.
template <int dim>
Field<dim> conductivity(const TypedProblem& typed, const Body<dim>& body) {
    const std::string text = typed.conductivity.value_or("1");
    Field<dim> k = function_in(body, "--conductivity", text);
    for (Index I = 0; I < body.x.cols(); ++I) {
        const Point<dim> x = body.x.col(I);
        if (!(k(x) > 0))
            throw InvalidInput("--conductivity must be positive, it is " + shown(k(x)) + " at the particle " +
                               particles::shown_point(x));
    }
    return k;
}

template <int dim>
bodies::Equation<dim, 1> scalar_equation(const TypedProblem& typed, const Body<dim>& body) {
    const Field<dim> k = conductivity(typed, body);
    const std::string text = typed.conductivity.value_or("1");
    if (is_constant<dim>(text)) return bodies::diffusion<dim>(k);
    const auto grad_k = gradient<dim>("--conductivity", text);
    for (Index I = 0; I < body.x.cols(); ++I) {
        const Point<dim> x = body.x.col(I);
        if (!grad_k(x).allFinite())
            throw InvalidInput("--conductivity: the gradient of " + base::quoted(text) +
                               " is not finite at the particle " + particles::shown_point(x));
    }
    return bodies::diffusion<dim>(k, grad_k);
}

template <int dim, int n>
bodies::Equation<dim, n> equation(const TypedProblem& typed, const Body<dim>& body) {
    bodies::Equation<dim, n> found;
    if constexpr (n == dim)
        found = bodies::elasticity<dim>(material(typed));
    else
        found = scalar_equation<dim>(typed, body);
    found.c = typed.reaction;
    const std::string option = n == dim ? "--body-force" : "--source";
    const auto& text = n == dim ? typed.body_force : typed.source;
    if (!text) return found;
    std::array<Field<dim>, static_cast<std::size_t>(n)> b;
    const auto all = entries(option, *text, n,
                             n == 1     ? "--source 1"
                             : dim == 2 ? "--body-force \"0, -1\""
                                        : "--body-force \"0, 0, -1\"");
    for (std::size_t i = 0; i < n; ++i) b[i] = function_in(body, option, all[i]);
    found.b = [b](const Point<dim>& x) {
        Values<n> all_b;
        for (std::size_t i = 0; i < n; ++i) all_b[static_cast<Index>(i)] = b[i](x);
        return all_b;
    };
    return found;
}

}  // namespace

template <int dim>
double largest_coefficient(const TypedProblem& typed, const Body<dim>& body) {
    using batra2008::elastostatics::Plane;
    if (!is_scalar(typed)) {
        auto known = material(typed);
        if (dim == 3) known.plane = Plane::strain;
        return batra2008::elastostatics::E0(known);
    }
    const Field<dim> k = conductivity(typed, body);
    double largest = 0;
    for (Index I = 0; I < body.x.cols(); ++I) largest = std::max(largest, k(Point<dim>(body.x.col(I))));
    return largest;
}

template double largest_coefficient(const TypedProblem&, const Body<2>&);
template double largest_coefficient(const TypedProblem&, const Body<3>&);

template <int dim, int n>
Problem<dim, n> problem(const TypedProblem& typed, const Body<dim>& body) {
    auto given = given_on_sides<dim, n>(typed.conditions, body);
    Problem<dim, n> found{equation<dim, n>(typed, body), std::move(given), {}};
    for (const Typed& one : typed.corners) found.corners.push_back(corner<dim, n>(body, one));
    return found;
}

template Problem<2, 1> problem(const TypedProblem&, const Body<2>&);
template Problem<3, 1> problem(const TypedProblem&, const Body<3>&);
template Problem<2, 2> problem(const TypedProblem&, const Body<2>&);
template Problem<3, 3> problem(const TypedProblem&, const Body<3>&);

}  // namespace command_line
