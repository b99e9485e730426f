#include "command_line/body_functions.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/errors.hpp"
#include "base/number.hpp"
#include "expressions/parser.hpp"

namespace command_line {

using base::InvalidInput;
using bodies::Body;
using bodies::Field;
using bodies::Index;
using bodies::Point;

namespace {

/// "x", "y" and, in space, "z".
template <int dim>
std::vector<std::string> coordinates() {
    return dim == 2 ? std::vector<std::string>{"x", "y"} : std::vector<std::string>{"x", "y", "z"};
}

}  // namespace

template <int dim>
Field<dim> function(const std::string& where, const std::string& text) {
    const auto f = expressions::directional(where, text, coordinates<dim>());
    return [f](const Point<dim>& x) { return f({x.data(), static_cast<std::size_t>(dim)}, {}).value; };
}

template <int dim>
double finite(const std::string& where, const std::string& text, double value, const Point<dim>& x) {
    if (!std::isfinite(value))
        throw InvalidInput(where + ": " + base::quoted(text) + " is not finite at the particle " +
                           particles::shown_point(x) + "; write it so that it is, for instance with max");
    return value;
}

template <int dim>
Field<dim> function_in(const Body<dim>& body, const std::string& option, const std::string& text) {
    Field<dim> f = function<dim>(option, text);
    for (Index I = 0; I < body.x.cols(); ++I) {
        const Point<dim> x = body.x.col(I);
        finite<dim>(option, text, f(x), x);
    }
    return f;
}

template <int dim>
bool is_constant(const std::string& text) {
    const auto program = expressions::parsed(text, coordinates<dim>());
    return std::none_of(program.steps.begin(), program.steps.end(), [](const expressions::Step& step) {
        return step.kind == expressions::Step::Kind::variable;
    });
}

template <int dim>
Field<dim, Point<dim>> gradient(const std::string& where, const std::string& text) {
    const auto f = expressions::directional(where, text, coordinates<dim>());
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

template Field<2> function<2>(const std::string&, const std::string&);
template Field<2, Point<2>> gradient<2>(const std::string&, const std::string&);
template bool is_constant<2>(const std::string&);
template double finite(const std::string&, const std::string&, double, const Point<2>&);
template Field<2> function_in(const Body<2>&, const std::string&, const std::string&);

template Field<3> function<3>(const std::string&, const std::string&);
template Field<3, Point<3>> gradient<3>(const std::string&, const std::string&);
template bool is_constant<3>(const std::string&);
template double finite(const std::string&, const std::string&, double, const Point<3>&);
template Field<3> function_in(const Body<3>&, const std::string&, const std::string&);

}  // namespace command_line
