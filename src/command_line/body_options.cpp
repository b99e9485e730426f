#include "command_line/body_options.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "base/errors.hpp"
#include "base/memory.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "bodies/field_file.hpp"
#include "command_line/body_quantities.hpp"
#include "command_line/lists.hpp"
#include "command_line/options.hpp"
#include "command_line/positions.hpp"
#include "expressions/parser.hpp"

namespace command_line {

using base::InvalidInput;
using base::shown;
using bodies::Body;
using bodies::Discretisation;
using bodies::Index;
using bodies::Point;

namespace {

/// The parameters of the approximation, for any method. \param degree added to the default in --degree's help
void add_parameters(CommandLine& app, BodyOptions& options, const std::string& degree) {
    app.add_option("--degree", options.degree, "degree m of the monomials of SSPH (default 2" + degree + ")")
        .type_name("2|3")
        .within(2, 3);
    app.add_option("--scaling", options.scaling, "scaling factor rho of the kernel of SSPH (default 3)")
        .type_name("RHO");
    app.add_option("--smoothing", options.smoothing,
                   "fpm: smoothing length over spacing, h/delta (default 1.2)")
        .type_name("RATIO");
    app.add_option(
           "--smoothing-from", options.smoothing_from,
           "the spacing delta, the unit of smoothing lengths: local (default), mean, largest, nearest, K-nearest (such as 8-nearest); a length; or a file with a number for each particle, FILE or FILE:COLUMN")
        .type_name("NAME");
}

}  // namespace

void add_collocation_options(CommandLine& app, BodyOptions& options) {
    app.add_list("--method", options.methods, "methods: fpm, strong, or both (default fpm)");
    add_parameters(app, options, "");
}

void add_method_options(CommandLine& app, BodyOptions& options) {
    app.add_list(
        "--method", options.methods,
        "methods: all that apply, or some of fpm, strong, weak1, weak2, hats (default hats, without cells weak1)");
    add_parameters(app, options, "; of hats in the plane 3");
    app.add_option("--gauss", options.gauss, "Gauss points n_G of the weak forms (default 10)")
        .type_name("N")
        .within(1, 1000);
    app.add_option(
           "--penalty", options.penalty,
           "penalty of weak1 and weak2, in units of 1e5 E0/L, for a scalar 1e5 k/L, L the largest extent of the body (default 1)")
        .type_name("FACTOR");
}

void add_options(CommandLine& app, BodyOptions& options) {
    app.column_width(34);
    app.add_option("--mesh", options.mesh,
                   "a drawing or a mesh that Gmsh reads; its physical groups name the sides")
        .type_name("FILE");
    app.add_option("--size", options.size, "size of the cells of a drawing (default: that of the drawing)")
        .type_name("D");
    app.add_option("--points", options.points, "instead, in the plane: a file of particles, x,y")
        .type_name("FILE");
    app.add_option("--boundary", options.boundary,
                   "with --points: a file of sides, name,order,x,y and, if known, the normals nx,ny")
        .type_name("FILE");
    app.add_option(
           "--snap", options.snap,
           "with --points: particles within this distance are moved onto the boundary (default: none)")
        .type_name("D");
    add_options(app, options.problem);
    add_method_options(app, options);
    app.add_repeated("--at", options.places, "a place where all quantities are wanted").type_name("X,Y[,Z]");
    app.add_repeated("--along", options.places, "N places on a line, its ends among them")
        .type_name("X0,Y0:X1,Y1:N");
    app.add_option("--modes", options.modes, "the K lowest eigenvalues instead; loads count as zero")
        .type_name("K")
        .within(1, 1000);
    app.add_option(
           "--refine", options.refine,
           "K clouds of --size, size/sqrt(2), size/2, ...: with the observed order, the extrapolated value and its uncertainty from the last three")
        .type_name("K")
        .within(3, 12);
    app.add_flag("--seconds", options.seconds, "add the seconds of assembly and solution");
    app.add_option("--field", options.field,
                   "file for the fields at the particles: .vtu for ParaView, or .csv")
        .type_name("FILE");
    add_plot_option(app, options.figure);
    app.add_threads(options.threads);
    app.add_output(options.output);
}

namespace {

void require_positive(const std::string& option, double number) {
    if (!(std::isfinite(number) && number > 0))
        throw InvalidInput(option + " must be positive and finite, got " + shown(number));
}

/// \throws InvalidInput unless there is one body
void check_body(const BodyOptions& options) {
    const bool files = !options.points.empty() || !options.boundary.empty();
    if (options.mesh.empty() && !files)
        throw InvalidInput("there is no body; give --mesh FILE, or --points FILE and --boundary FILE");
    if (!options.mesh.empty() && files)
        throw InvalidInput("--mesh has the particles and the boundary; leave --points and --boundary out");
    if (files && (options.points.empty() || options.boundary.empty()))
        throw InvalidInput(
            std::string(options.points.empty() ? "--boundary needs --points" : "--points needs --boundary") +
            "; give both");
    if (files && options.size)
        throw InvalidInput("--size belongs to a drawing, --mesh; leave it out beside --points");
    if (!files && options.snap) throw InvalidInput("--snap belongs to --points; leave it out beside --mesh");
    if (options.size) require_positive("--size", *options.size);
    if (options.snap) require_positive("--snap", *options.snap);
    if (options.refine > 1 && files)
        throw InvalidInput("--refine needs a drawing, --mesh FILE.geo, whose clouds can be made finer");
    if (options.refine > 1 && !options.size)
        throw InvalidInput("--refine needs the --size of the first cloud");
}

/// \throws InvalidInput for what eigenvalues do not have
void check_modes(const BodyOptions& options) {
    if (options.modes == 0) return;
    const std::string why = " shows a solution, and --modes asks for eigenvalues; leave one of them out";
    if (!options.places.empty()) throw InvalidInput(options.places.front().option + why);
    if (options.seconds) throw InvalidInput("--seconds" + why);
    if (!options.field.empty()) throw InvalidInput("--field" + why);
    if (!options.figure.path.empty()) throw InvalidInput("--plot" + why);
}

/// The names of the methods for which a condition holds.
template <class Holds>
std::vector<std::string> names_of_methods(const Holds& holds) {
    std::vector<std::string> all;
    for (const auto& [name, method] : bodies::methods())
        if (holds(method)) all.push_back(name);
    return all;
}

/// The methods by their names; none where the body decides.
std::vector<std::string> method_names(const BodyOptions& options) {
    if (options.methods.empty()) return {};
    return chosen("method", options.methods, names_of_all_methods());
}

/// \param known the methods of the program
/// \throws InvalidInput for an option that belongs to none of the methods
void check_effect(const BodyOptions& options, const std::vector<std::string>& known) {
    std::vector<std::string> methods = method_names(options);
    if (methods.empty() && !options.mesh.empty()) methods = {"hats"};
    const BodyOptions untouched;
    const auto refuse_without = [&](const std::string& option, bool changed, const std::string& whose,
                                    std::vector<std::string> those) {
        std::erase_if(those, [&](const std::string& method) {
            return std::find(known.begin(), known.end(), method) == known.end();
        });
        const bool asked = std::any_of(methods.begin(), methods.end(), [&](const std::string& method) {
            return std::find(those.begin(), those.end(), method) != those.end();
        });
        if (changed && !methods.empty() && !asked)
            throw InvalidInput(option + " belongs to " + whose +
                               (those.empty()
                                    ? "; leave it out"
                                    : (those.size() == 1 ? "; add " : "; add one of ") + joined(those) +
                                          " to --method, or leave " + option + " out"));
    };
    const std::vector<std::string> weak{"weak1", "weak2"}, ssph{"strong", "weak1", "weak2", "hats"};
    refuse_without("--gauss", options.gauss != untouched.gauss, "weak1 and weak2", weak);
    refuse_without("--penalty", options.penalty != untouched.penalty, "weak1 and weak2", weak);
    refuse_without("--degree", options.degree.has_value(), "methods with an SSPH basis", ssph);
    refuse_without("--scaling", options.scaling != untouched.scaling, "methods with an SSPH basis", ssph);
    if (options.smoothing != untouched.smoothing &&
        std::find(methods.begin(), methods.end(), "fpm") == methods.end())
        throw InvalidInput("--smoothing belongs to fpm; add fpm to --method, or leave --smoothing out");
}

}  // namespace

std::vector<std::string> names_of_all_methods() {
    return names_of_methods([](bodies::Method) { return true; });
}

void check_methods(const BodyOptions& options, const std::vector<std::string>& known) {
    check_effect(options, known);
    require_positive("--scaling", options.scaling);
    require_positive("--smoothing", options.smoothing);
    require_positive("--penalty", options.penalty);
}

void check(const BodyOptions& options) {
    check_body(options);
    check_modes(options);
    check_methods(options, names_of_all_methods());
    if (!options.field.empty()) bodies::check_field_path(options.field);
    if (!options.figure.path.empty() && method_names(options).size() > 1)
        throw InvalidInput("--plot draws one method; name one by --method");
    std::vector<std::pair<std::string, std::string>> files{
        {"--output", options.output}, {"--field", options.field},   {"--plot", options.figure.path},
        {"--mesh", options.mesh},     {"--points", options.points}, {"--boundary", options.boundary}};
    if (const auto spacing = spacing_from(options.smoothing_from); spacing.kind == particles::Spacing::given)
        files.emplace_back("--smoothing-from", named_file(options.smoothing_from).path);
    check_apart(files);
}

namespace {

/// The methods by their names. "all" are those that work in this dimension, and without cells.
std::vector<std::string> method_names(const BodyOptions& options, int dim, bool has_cells) {
    if (options.methods.empty()) return {has_cells ? "hats" : dim == 2 ? "weak1" : "fpm"};
    if (options.methods != std::vector<std::string>{"all"}) return options.methods;
    return names_of_methods([&](bodies::Method method) { return bodies::works(method, dim, has_cells); });
}

}  // namespace

Discretisation discretisation(const BodyOptions& options, const std::string& method, int dim) {
    Discretisation how;
    how.method = bodies::method_named(method);
    how.degree =
        static_cast<int>(options.degree.value_or(how.method == bodies::Method::hats && dim == 2 ? 3 : 2));
    how.scaling = options.scaling;
    how.smoothing = options.smoothing;
    return how;
}

template <int dim>
std::vector<Discretisation> discretisations(const BodyOptions& options, const Body<dim>& body) {
    const std::vector<std::string> methods = method_names(options, dim, !body.cells.empty());
    const particles::Spacing spacing = spacing_from(options.smoothing_from);
    check_lengths(spacing, options.smoothing_from, body.x.cols());
    std::vector<Discretisation> all;
    for (const std::string& method : methods) {
        Discretisation& how = all.emplace_back(discretisation(options, method, dim));
        how.spacing = spacing;
        how.penalty = options.penalty * 1e5 * largest_coefficient<dim>(options.problem, body) / size_of(body);
        how.gauss = options.gauss;
    }
    return all;
}

template std::vector<Discretisation> discretisations(const BodyOptions&, const Body<2>&);
template std::vector<Discretisation> discretisations(const BodyOptions&, const Body<3>&);

namespace {

template <int dim>
Point<dim> place(const Typed& typed, const std::string& text) {
    const std::vector<std::string> numbers = parts(text, ',');
    if (numbers.size() != dim)
        throw InvalidInput(typed.option + ": " + base::quoted(typed.text) +
                           " is no place of this body; write " +
                           (typed.option == "--at" ? (dim == 2 ? "--at 0.1,0.2" : "--at 0.1,0.2,0.3")
                            : dim == 2             ? "--along 0,0:0.1,0.2:11"
                                                   : "--along 0,0,0:0.1,0.2,0.3:11"));
    Point<dim> x;
    for (std::size_t axis = 0; axis < dim; ++axis)
        x[static_cast<Index>(axis)] = number(typed.option, numbers[axis]);
    return x;
}

template <int dim>
std::vector<Point<dim>> line(const Typed& typed) {
    const std::vector<std::string> ends = parts(typed.text, ':');
    if (ends.size() != 3)
        throw InvalidInput(typed.option + ": " + base::quoted(typed.text) +
                           " is no line of places; write --along " +
                           (dim == 2 ? "0,0:0.1,0.2:11" : "0,0,0:0.1,0.2,0.3:11"));
    const Point<dim> from = place<dim>(typed, ends[0]), to = place<dim>(typed, ends[1]);
    const long count = whole_number(typed.option, ends[2]);
    if (count < 2 || count > 1000000)
        throw InvalidInput(typed.option + ": the number of places must lie between 2 and 1000000, got " +
                           std::to_string(count));
    std::vector<Point<dim>> all;
    for (long k = 0; k < count; ++k)
        all.emplace_back(from + (to - from) * static_cast<double>(k) / static_cast<double>(count - 1));
    return all;
}

}  // namespace

template <int dim>
std::vector<Point<dim>> places(const BodyOptions& options) {
    std::vector<Point<dim>> all;
    for (const Typed& typed : options.places) {
        if (typed.option == "--at") {
            all.push_back(place<dim>(typed, typed.text));
            continue;
        }
        const std::vector<Point<dim>> more = line<dim>(typed);
        all.insert(all.end(), more.begin(), more.end());
    }
    return all;
}

template std::vector<Point<2>> places(const BodyOptions&);
template std::vector<Point<3>> places(const BodyOptions&);

std::vector<std::string> comments(const TypedProblem& problem, int dim) {
    std::string equation;
    if (is_scalar(problem)) {
        equation = "-div(k grad u) + c u = f with k = " + problem.conductivity.value_or("1") +
                   ", f = " + problem.source.value_or("0");
    } else {
        equation = "elasticity, " + (dim == 3 ? "in space" : "plane " + problem.plane.value_or("stress")) +
                   ", E = " + shown(*problem.young) + ", nu = " + shown(*problem.poisson);
        if (problem.body_force) equation += ", body force " + *problem.body_force;
    }
    if (is_scalar(problem) || problem.reaction != 0) equation += ", c = " + shown(problem.reaction);
    std::string conditions;
    for (const auto* list : {&problem.conditions, &problem.corners})
        for (const auto& [option, text] : *list)
            conditions += (conditions.empty() ? "" : "; ") + option + " " + text;
    for (char& letter : conditions)
        if (std::iscntrl(static_cast<unsigned char>(letter)) != 0) letter = ' ';
    return {equation, "conditions: " + (conditions.empty() ? "none" : conditions)};
}

std::string comment_on_body(const BodyOptions& options) {
    return (options.mesh.empty() ? options.points + " within " + options.boundary : options.mesh) +
           (options.size ? ", --size " + shown(*options.size) : "") +
           "; lengths, forces and stresses in the user's units";
}

}  // namespace command_line
