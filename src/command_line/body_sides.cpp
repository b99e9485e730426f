#include "command_line/body_sides.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

#include "base/errors.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "command_line/body_functions.hpp"
#include "command_line/lists.hpp"

namespace command_line {

using base::InvalidInput;
using base::shown;
using bodies::Body;
using bodies::Field;
using bodies::Given;
using bodies::Index;
using bodies::Point;
using bodies::Side;
using bodies::Values;

namespace {

bool is_dash(const std::string& entry) {
    return entry == "-";
}

/// The text before a place, without blanks around it.
std::string before(std::size_t end, const std::string& text) {
    return std::string(base::trimmed(std::string_view(text).substr(0, end)));
}

/// Where the name of a side ends: at the last mark behind one, since names may hold marks, too; else at the
/// first mark.
template <int dim>
std::size_t end_of_name(const Body<dim>& body, const std::string& text, char mark) {
    std::size_t end = text.find(mark);
    for (std::size_t place = end; place != std::string::npos; place = text.find(mark, place + 1))
        if (std::any_of(body.sides.begin(), body.sides.end(),
                        [&](const Side<dim>& side) { return side.name == before(place, text); }))
            end = place;
    return end;
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
        const std::size_t colon =
            takes_name_alone(typed) ? std::string::npos : end_of_name(body_, typed.text, ':');
        const std::string name = before(colon, typed.text);
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

}  // namespace

template <int dim, int n>
std::vector<Given<dim, n>> given_on_sides(const std::vector<Typed>& conditions, const Body<dim>& body) {
    Conditions<dim, n> all(body);
    for (const Typed& condition : conditions) all.add(condition);
    return std::move(all.given);
}

template <int dim, int n>
bodies::Corner corner(const Body<dim>& body, const Typed& typed) {
    const std::string example = n == 1   ? "--corner \"A+B: A\""
                                : n == 2 ? "--corner \"A+B: A, B\""
                                         : "--corner \"A+B: A, B, B\"";
    const std::size_t plus = end_of_name(body, typed.text, '+');
    const std::string second = plus == std::string::npos ? "" : typed.text.substr(plus + 1);
    const std::size_t colon = end_of_name(body, second, ':');
    if (plus == std::string::npos || colon == std::string::npos)
        throw InvalidInput(typed.option + ": " + base::quoted(typed.text) +
                           " does not name two sides and what holds where they meet; write " + example);
    const auto name = [&](std::size_t end, const std::string& text) {
        return side_named(body, typed.option, before(end, text)).name;
    };
    bodies::Corner found{{name(plus, typed.text), name(colon, second)}, {}};
    if (found.sides[0] == found.sides[1])
        throw InvalidInput(typed.option + ": " + base::quoted(typed.text) + " names one side twice; write " +
                           example);
    found.by_component = entries(typed.option, second.substr(colon + 1), n, example);
    for (const std::string& side : found.by_component)
        if (side != found.sides[0] && side != found.sides[1])
            throw InvalidInput(typed.option + ": " + base::quoted(typed.text) + " takes a condition from " +
                               base::quoted(side) + "; take " + found.sides[0] + " or " + found.sides[1]);
    return found;
}

template std::vector<Given<2, 1>> given_on_sides(const std::vector<Typed>&, const Body<2>&);
template bodies::Corner corner<2, 1>(const Body<2>&, const Typed&);
template std::vector<Given<3, 1>> given_on_sides(const std::vector<Typed>&, const Body<3>&);
template bodies::Corner corner<3, 1>(const Body<3>&, const Typed&);
template std::vector<Given<2, 2>> given_on_sides(const std::vector<Typed>&, const Body<2>&);
template bodies::Corner corner<2, 2>(const Body<2>&, const Typed&);
template std::vector<Given<3, 3>> given_on_sides(const std::vector<Typed>&, const Body<3>&);
template bodies::Corner corner<3, 3>(const Body<3>&, const Typed&);

}  // namespace command_line
