#include "command_line/body_conditions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <span>
#include <string_view>
#include <utility>

#include "base/errors.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "command_line/lists.hpp"
#include "expressions/parser.hpp"

namespace command_line {

using base::InvalidInput;
using base::shown;
using bodies::Body;
using bodies::Field;
using bodies::Given;
using bodies::Index;
using bodies::Point;
using bodies::Problem;
using bodies::Side;
using bodies::Values;

namespace {

/// "x", "y" and, in space, "z".
template <int dim>
std::vector<std::string> coordinates() {
    return dim == 2 ? std::vector<std::string>{"x", "y"} : std::vector<std::string>{"x", "y", "z"};
}

}  // namespace

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
            "forces for each unit of area on a side; tractions and pressures of a side add");
    on_side("--pressure", "\"NAME: P\"", "pressure on a side; a positive one pushes");
    app.add_option("--body-force", typed.body_force, "forces for each unit of volume")
        .type_name("\"BX,BY[,BZ]\"");
    on_side("--value", "\"NAME: U\"", "the scalar on a side");
    on_side("--flux", "\"NAME: Q\"", "k du/dn on a side: a positive one heats the body");
    on_side("--convection", "\"NAME: A,U0\"", "-k du/dn = A (u - U0) on a side");
    app.add_option("--source", typed.source, "the source f of the scalar").type_name("F");
    app.add_option("--conductivity", typed.conductivity, "the conductivity k (default 1)").type_name("K");
    app.add_option("--reaction", typed.reaction, "c of a term c u, as of an elastic bed (default 0)")
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

/// The function of the place that a text says. \param where option and side, for messages
template <int dim>
Field<dim> function(const std::string& where, const std::string& text) {
    const auto f = expressions::directional(where, text, coordinates<dim>());
    return [f](const Point<dim>& x) { return f({x.data(), static_cast<std::size_t>(dim)}, {}).value; };
}

/// Refuses a function that is not finite at a particle.
template <int dim>
double finite(const std::string& where, const std::string& text, double value, const Point<dim>& x) {
    if (!std::isfinite(value))
        throw InvalidInput(where + ": " + base::quoted(text) + " is not finite at the particle " +
                           particles::shown_point(x) + "; write it so that it is, for instance with max");
    return value;
}

/// The function of a text that is finite at all particles of the body.
template <int dim>
Field<dim> function_in(const Body<dim>& body, const std::string& option, const std::string& text) {
    Field<dim> f = function<dim>(option, text);
    for (Index I = 0; I < body.x.cols(); ++I) {
        const Point<dim> x = body.x.col(I);
        finite<dim>(option, text, f(x), x);
    }
    return f;
}

/// The entries of a list of functions, which commas separate outside of parentheses.
/// \throws InvalidInput unless there are as many as wanted
std::vector<std::string> entries(const std::string& where, const std::string& text, std::size_t wanted,
                                 const std::string& example) {
    std::vector<std::string> all = expressions::separated(text);
    for (std::string& entry : all) {
        entry = base::trimmed(entry);
        if (entry.empty())
            throw InvalidInput(where + ": " + base::quoted(text) + " has an empty entry; write " + example);
    }
    if (all.size() != wanted)
        throw InvalidInput(where + ": " + base::quoted(text) + " has " + std::to_string(all.size()) +
                           (all.size() == 1 ? " entry" : " entries") + ", " + std::to_string(wanted) +
                           (wanted == 1 ? " is" : " are") + " needed; write " + example);
    return all;
}

bool is_dash(const std::string& entry) {
    return entry == "-";
}

template <int dim>
const Side<dim>& side_named(const Body<dim>& body, const std::string& option, const std::string& name) {
    return of_option(option, [&]() -> const Side<dim>& { return bodies::side_named(body, name); });
}

/// What options say on the sides of a body.
template <int dim, int n>
class Conditions {
  public:
    explicit Conditions(const Body<dim>& body) : body_(body) {}

    void add(const Typed& typed) {
        const std::size_t colon = takes_name_alone(typed) ? std::string::npos : typed.text.find(':');
        const std::string name(base::trimmed(std::string_view(typed.text).substr(0, colon)));
        if (!takes_name_alone(typed) && colon == std::string::npos)
            throw InvalidInput(typed.option + ": " + base::quoted(typed.text) + " has no colon; write " +
                               example(typed.option));
        side_ = &side_named(body_, typed.option, name);
        option_ = typed.option;
        given_ = std::find_if(given.begin(), given.end(), [&](const auto& one) { return one.side == name; }) -
                 given.begin();
        if (given_ == static_cast<std::ptrdiff_t>(given.size())) {
            given.push_back({name});
            by_.emplace_back();
        }
        add_to_side(takes_name_alone(typed) ? "" : typed.text.substr(colon + 1));
    }

    std::vector<Given<dim, n>> given;

  private:
    /// The options that gave the value and the loads of each component; empty where none did.
    struct By {
        std::array<std::string, static_cast<std::size_t>(n)> value, load;
    };

    static bool takes_name_alone(const Typed& typed) {
        return typed.option == "--fix" || typed.option == "--symmetry";
    }

    static std::string example(const std::string& option) {
        const std::string zeros = dim == 2 ? "0, -1e6\"" : "0, 0, -1e6\"";
        return option + (option == "--traction" ? " \"NAME: " + zeros
                         : option == "--displacement"
                             ? std::string(dim == 2 ? " \"NAME: 0, -\"" : " \"NAME: 0, -, -\"")
                         : option == "--convection" ? " \"NAME: 10, 293\""
                                                    : " \"NAME: 1\"");
    }

    [[nodiscard]] std::string where() const { return option_ + " on " + side_->name; }
    [[nodiscard]] Given<dim, n>& here() { return given[static_cast<std::size_t>(given_)]; }
    [[nodiscard]] By& by() { return by_[static_cast<std::size_t>(given_)]; }

    [[nodiscard]] std::vector<std::string> entries_of(const std::string& text, std::size_t wanted) const {
        return entries(where(), text, wanted, example(option_));
    }

    /// A function that is finite at the particles of the side.
    [[nodiscard]] Field<dim> function_on_side(const std::string& text) const {
        Field<dim> f = function<dim>(where(), text);
        for (const auto& place : side_->places) {
            const Point<dim> x = body_.x.col(place.particle);
            finite<dim>(where(), text, f(x), x);
        }
        return f;
    }

    static std::string component(std::size_t i) {
        return n == 1 ? "the value" : "component " + std::to_string(i + 1);
    }

    void give_value(std::size_t i, const Field<dim>& value) {
        if (!by().value[i].empty())
            throw InvalidInput(where() + ": " + component(i) + " is given already, by " + by().value[i] +
                               "; leave one of them out" + (n > 1 ? ", or write a dash for it" : ""));
        refuse_load_beside_value(i, by().load[i], option_);
        by().value[i] = option_;
        here().value[i] = value;
    }

    void claim_load(std::size_t i) {
        refuse_load_beside_value(i, option_, by().value[i]);
        by().load[i] = option_;
    }

    void refuse_load_beside_value(std::size_t i, const std::string& load, const std::string& value) const {
        if (load.empty() || value.empty()) return;
        throw InvalidInput(load + " on " + side_->name + ": " + component(i) + " is given by " + value +
                           " and can carry no load" +
                           (n == 1                  ? "; leave one of them out"
                            : value == "--symmetry" ? "; leave the load out"
                            : load == "--pressure"  ? "; write a --traction with a dash for it"
                            : value == "--fix"      ? "; leave one of them out"
                                                    : "; write a dash for it in one of them"));
    }

    void add_to_side(const std::string& text) {
        if constexpr (n == dim)
            add_mechanical(text);
        else
            add_scalar(text);
    }

    void add_mechanical(const std::string& text) {
        if (option_ == "--fix") {
            for (std::size_t i = 0; i < n; ++i) give_value(i, [](const Point<dim>&) { return 0.0; });
        } else if (option_ == "--symmetry") {
            for (std::size_t i = 0; i < n; ++i) give_value(i, {});
            here().symmetry = true;
        } else if (option_ == "--displacement") {
            const auto components = entries_of(text, n);
            require_one(components);
            for (std::size_t i = 0; i < n; ++i)
                if (!is_dash(components[i])) give_value(i, function_on_side(components[i]));
        } else if (option_ == "--traction") {
            const auto components = entries_of(text, n);
            require_one(components);
            std::array<Field<dim>, static_cast<std::size_t>(n)> t;
            for (std::size_t i = 0; i < n; ++i) {
                if (is_dash(components[i])) continue;
                claim_load(i);
                t[i] = function_on_side(components[i]);
            }
            here().loads.push_back([t](const Point<dim>& x, const Point<dim>&) {
                Values<n> load = Values<n>::Zero();
                for (std::size_t i = 0; i < n; ++i)
                    if (t[i]) load[static_cast<Index>(i)] = t[i](x);
                return load;
            });
        } else {
            const Field<dim> p = function_on_side(entries_of(text, 1)[0]);
            for (std::size_t i = 0; i < n; ++i)
                if (faces(i)) claim_load(i);
            here().loads.push_back(
                [p](const Point<dim>& x, const Point<dim>& normal) { return Values<n>(-p(x) * normal); });
        }
    }

    void add_scalar(const std::string& text) {
        if (option_ == "--value") {
            give_value(0, function_on_side(entries_of(text, 1)[0]));
            return;
        }
        claim_load(0);
        if (option_ == "--flux") {
            const Field<dim> q = function_on_side(entries_of(text, 1)[0]);
            here().loads.push_back(
                [q](const Point<dim>& x, const Point<dim>&) { return Values<n>(Values<n>::Constant(q(x))); });
            return;
        }
        if (here().exchange)
            throw InvalidInput(where() + " is given twice; give it once, with the sum of the coefficients");
        const auto both = entries_of(text, 2);
        here().exchange = function_on_side(both[0]);
        here().surroundings = function_on_side(both[1]);
        for (const auto& place : side_->places) {
            const Point<dim> x = body_.x.col(place.particle);
            if (const double a = here().exchange(x); a < 0)
                throw InvalidInput(where() + ": the coefficient must not be negative, it is " + shown(a) +
                                   " at " + particles::shown_point(x));
        }
    }

    void require_one(const std::vector<std::string>& components) const {
        if (std::all_of(components.begin(), components.end(), is_dash))
            throw InvalidInput(where() + " gives nothing: each component is a dash; leave it out");
    }

    /// Whether a pressure on the side has this component anywhere.
    [[nodiscard]] bool faces(std::size_t i) const {
        constexpr double along = 0.02;
        return std::any_of(side_->places.begin(), side_->places.end(), [&](const auto& place) {
            return std::abs(place.normal[static_cast<Index>(i)]) > along;
        });
    }

    const Body<dim>& body_;
    std::vector<By> by_;  // in the order of given
    // of the condition that is being added
    std::string option_;
    const Side<dim>* side_ = nullptr;
    std::ptrdiff_t given_ = 0;
};

/// The corner of a text such as "wall+tip: wall, tip".
template <int dim, int n>
bodies::Corner corner(const Body<dim>& body, const Typed& typed) {
    const std::string example = n == 1   ? "--corner \"A+B: A\""
                                : n == 2 ? "--corner \"A+B: A, B\""
                                         : "--corner \"A+B: A, B, B\"";
    const std::size_t colon = typed.text.find(':'), plus = typed.text.find('+');
    if (colon == std::string::npos || plus > colon)
        throw InvalidInput(typed.option + ": " + base::quoted(typed.text) +
                           " does not name two sides and what holds where they meet; write " + example);
    const auto name = [&](std::size_t from, std::size_t to) {
        return side_named(body, typed.option,
                          std::string(base::trimmed(std::string_view(typed.text).substr(from, to - from))))
            .name;
    };
    bodies::Corner found{{name(0, plus), name(plus + 1, colon)}, {}};
    if (found.sides[0] == found.sides[1])
        throw InvalidInput(typed.option + ": " + base::quoted(typed.text) + " names one side twice; write " +
                           example);
    found.by_component = entries(typed.option, typed.text.substr(colon + 1), n, example);
    for (const std::string& side : found.by_component)
        if (side != found.sides[0] && side != found.sides[1])
            throw InvalidInput(typed.option + ": " + base::quoted(typed.text) + " takes a condition from " +
                               base::quoted(side) + "; take " + found.sides[0] + " or " + found.sides[1]);
    return found;
}

/// Whether a text has no x, y or z.
template <int dim>
bool is_constant(const std::string& text) {
    const auto program = expressions::parsed(text, coordinates<dim>());
    return std::none_of(program.steps.begin(), program.steps.end(), [](const expressions::Step& step) {
        return step.kind == expressions::Step::Kind::variable;
    });
}

/// The gradient, from derivatives along the axes.
template <int dim>
Field<dim, Point<dim>> gradient(const std::string& option, const std::string& text) {
    const auto f = expressions::directional(option, text, coordinates<dim>());
    return [f](const Point<dim>& x) {
        Point<dim> g;
        for (Index axis = 0; axis < dim; ++axis) {
            const Point<dim> e = Point<dim>::Unit(axis);
            g[axis] =
                f({x.data(), static_cast<std::size_t>(dim)}, {e.data(), static_cast<std::size_t>(dim)}).first;
        }
        return g;
    };
}

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
    Conditions<dim, n> conditions(body);
    for (const Typed& condition : typed.conditions) conditions.add(condition);
    Problem<dim, n> found{equation<dim, n>(typed, body), conditions.given, {}};
    for (const Typed& one : typed.corners) found.corners.push_back(corner<dim, n>(body, one));
    return found;
}

template Problem<2, 1> problem(const TypedProblem&, const Body<2>&);
template Problem<3, 1> problem(const TypedProblem&, const Body<3>&);
template Problem<2, 2> problem(const TypedProblem&, const Body<2>&);
template Problem<3, 3> problem(const TypedProblem&, const Body<3>&);

}  // namespace command_line
