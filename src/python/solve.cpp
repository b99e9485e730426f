#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <optional>
#include <regex>
#include <set>
#include <utility>
#include <vector>

#include "base/text.hpp"
#include "bodies/mesh_boundary.hpp"
#include "command_line/body_judgement.hpp"
#include "command_line/body_options.hpp"
#include "python/arrays.hpp"
#include "python/functions.hpp"
#include "python/messages.hpp"
#include "solvers/blas_threads.hpp"

namespace python {

using base::InvalidInput;
using bodies::Body;
using bodies::Mesh;
using bodies::Nodes;
using bodies::Point;
using bodies::Points;

namespace {

/// Warns at the line that calls solve.
void warn(const std::string& remark) {
    if (PyErr_WarnEx(PyExc_UserWarning, in_python(remark).c_str(), 2) != 0) throw py::error_already_set();
}

/// An argument as the command line has it: 1.5, (0, None) and "x^2" are "1.5", "0, -" and "x^2";
/// a power may be written as Python does, "x**2".
std::string text_of(const std::string& keyword, const py::handle& value) {
    if (value.is_none()) return "-";
    if (py::isinstance<py::str>(value)) {
        const auto text = py::cast<std::string>(value);
        if (text.empty() || text.find('\0') != std::string::npos)
            throw InvalidInput(keyword + " has an empty text, or one with a zero byte");
        return std::regex_replace(text, std::regex("[*][*]"), "^");
    }
    if (py::isinstance<py::bool_>(value)) return py::str(value);
    if (is_integer(value)) return py::str(py::int_(py::reinterpret_borrow<py::object>(value)));
    const bool has_entries = py::hasattr(value, "__len__") && !is_number(value);
    if (has_entries) {
        std::string all;
        for (const py::handle& entry : value) all += (all.empty() ? "" : ", ") + text_of(keyword, entry);
        return all;
    }
    if (!py::hasattr(value, "__float__"))
        throw InvalidInput(keyword + ": " + std::string(py::repr(value)) +
                           " is no number and no function; write functions as a text, such as \"1 + x^2\"");
    const py::float_ number(py::reinterpret_borrow<py::object>(value));
    if (!std::isfinite(static_cast<double>(number)))
        throw InvalidInput(keyword + " must be finite, got " + base::shown(static_cast<double>(number)));
    return py::repr(number);
}

/// A keyword as values of its command-line option: one, or one for each side or name.
std::vector<std::string> texts_of(const std::string& keyword, const py::handle& value) {
    static const std::set<std::string> of_sides{"fix",   "symmetry", "displacement", "traction", "pressure",
                                                "value", "flux",     "convection",   "corner"};
    std::vector<std::string> all;
    if (py::isinstance<py::dict>(value)) {
        for (const auto& [side, given] : py::cast<py::dict>(value))
            all.push_back(text_of(keyword, py::str(side)) + ": " + text_of(keyword, given));
    } else if (of_sides.contains(keyword) && py::hasattr(value, "__iter__") &&
               !py::isinstance<py::str>(value)) {
        for (const py::handle& one : value) all.push_back(text_of(keyword, one));
    } else {
        all.push_back(text_of(keyword, value));
    }
    return all;
}

/// Keywords as arguments of a program.
std::vector<std::string> arguments(const py::dict& keywords) {
    std::vector<std::string> all{"solve"};
    for (const auto& [key, value] : keywords) {
        if (value.is_none()) continue;
        const auto keyword = py::cast<std::string>(key);
        const bool is_name = keyword.find('-') == std::string::npos;  // an option has no second spelling
        if (!is_name || keyword == "help" || keyword == "version")
            throw InvalidInput("there is no option '" + keyword + "'; see help(solve)");
        if (keyword == "method" && !py::isinstance<py::str>(value))
            throw InvalidInput("solve takes one method; call it for each");
        std::string option = "--" + keyword;
        std::replace(option.begin(), option.end(), '_', '-');
        for (const std::string& text : texts_of(keyword, value)) all.push_back(option + "=" + text);
    }
    return all;
}

command_line::BodyOptions options_of(const py::dict& keywords) {
    command_line::BodyOptions options;
    command_line::CommandLine line("", "solve");
    command_line::add_options(line, options.problem);
    command_line::add_method_options(line, options);
    std::vector<std::string> all = arguments(keywords);
    std::vector<char*> argv(all.size());
    std::transform(all.begin(), all.end(), argv.begin(), [](std::string& one) { return one.data(); });
    static_cast<void>(line.read(static_cast<int>(argv.size()), argv.data()));
    command_line::check_methods(options, command_line::names_of_all_methods());
    if (options.methods.size() > 1 || options.methods == std::vector<std::string>{"all"})
        throw InvalidInput("solve takes one method; call it for each");
    return options;
}

/// "the facet of the points 4 and 7"
template <std::size_t count>
std::string named(const std::array<int, count>& facet) {
    std::string text = "the facet of the points " + std::to_string(facet[0]);
    for (std::size_t k = 1; k < count; ++k)
        text += (k + 1 < count ? ", " : " and ") + std::to_string(facet[k]);
    return text;
}

template <int dim>
Mesh<dim> mesh_of(const Numbers& points, const py::object& cells) {
    if (const auto any = py::array::ensure(cells); dim == 3 && any && any.ndim() == 2 && any.shape(1) == 3)
        throw InvalidInput(
            "cells are triangles, and points are in space; for a body in the plane take points[:, :2]");
    Mesh<dim> mesh{
        points_of<dim>(points), numbers_of_particles<dim + 1>(cells, "cells", points.shape(0)), {}};
    std::vector<bool> used(static_cast<std::size_t>(points.shape(0)), false);
    for (const auto& cell : mesh.cells)
        for (const int node : cell) used[static_cast<std::size_t>(node)] = true;
    for (Index k = 0; k < mesh.x.cols(); ++k)
        if (!mesh.x.col(k).allFinite())
            throw InvalidInput("point " + std::to_string(k) + " is not at a finite position");
    bodies::check_cells(mesh);
    if (const auto lost = std::find(used.begin(), used.end(), false); lost != used.end())
        throw InvalidInput(
            "point " + std::to_string(lost - used.begin()) +
            " is in no cell; keep those that are: used = numpy.unique(cells); points = points[used]; cells = "
            "numpy.searchsorted(used, cells), and sides alike");
    return mesh;
}

/// Gives the facets of the boundary the names of their sides.
/// \throws InvalidInput for a facet that is not on the boundary, and for one with two names
template <int dim>
void name_sides(Mesh<dim>& mesh, const py::dict& sides) {
    std::map<Nodes<dim>, std::string> names;
    for (const auto& outer : bodies::boundary_of(mesh)) {
        Nodes<dim> key = outer.nodes;
        std::sort(key.begin(), key.end());
        names[key] = "";
    }
    for (const auto& [key, value] : sides) {
        const std::string side = py::cast<std::string>(py::str(key)), argument = "sides['" + side + "']";
        if (side.empty()) throw InvalidInput("a side needs a name");
        const auto facets = numbers_of_particles<dim>(value, argument, mesh.x.cols());
        if (facets.empty())
            throw InvalidInput(argument +
                               " has no facets; to choose them by their places, allow for round-off");
        for (std::size_t k = 0; k < facets.size(); ++k) {
            Nodes<dim> sorted = facets[k];
            std::sort(sorted.begin(), sorted.end());
            const auto found = names.find(sorted);
            const std::string which = argument + "[" + std::to_string(k) + "], " + named(facets[k]) + ", ";
            if (found == names.end())
                throw InvalidInput(which +
                                   "is not on the boundary; boundary(points, cells) has those that are");
            if (!found->second.empty() && found->second != side)
                throw InvalidInput(which + "is in the side '" + found->second + "', too");
            found->second = side;
        }
    }
    const auto unnamed =
        std::count_if(names.begin(), names.end(), [](const auto& one) { return one.second.empty(); });
    if (unnamed > 0 && sides.contains("rest"))
        throw InvalidInput("the side 'rest' has the facets that are in no other, and " +
                           std::to_string(unnamed) + " are; take another name than 'rest'");
    std::map<std::string, std::vector<Nodes<dim>>> by_side;
    for (const auto& [facet, side] : names) by_side[side.empty() ? "rest" : side].push_back(facet);
    for (const auto& [side, facets] : by_side) mesh.patches.push_back({0, {side}, facets, {}});
}

/// The number of a body's particle at each point.
template <int dim>
std::vector<Index> particles_at(const Points<dim>& points, const Body<dim>& body) {
    const auto at = [](const Points<dim>& x, Index k) {
        std::array<double, dim> place{};
        Eigen::Map<Point<dim>>(place.data()) = x.col(k);
        return place;
    };
    std::map<std::array<double, dim>, Index> numbers;
    for (Index I = 0; I < body.x.cols(); ++I) numbers[at(body.x, I)] = I;
    std::vector<Index> all(static_cast<std::size_t>(points.cols()));
    for (Index k = 0; k < points.cols(); ++k) all[static_cast<std::size_t>(k)] = numbers.at(at(points, k));
    return all;
}

/// Lengths of the points as lengths of the body's particles, which have another order.
/// \throws InvalidInput unless there is one for each point
particles::Spacing reordered(const particles::Spacing& spacing, const std::vector<Index>& particle) {
    if (spacing.lengths.size() <= 1) return spacing;
    if (spacing.lengths.size() != static_cast<Index>(particle.size()))
        throw InvalidInput(std::to_string(particle.size()) +
                           " points need as many smoothing_from, or one, got " +
                           std::to_string(spacing.lengths.size()));
    Column<double> lengths(spacing.lengths.size());
    for (std::size_t k = 0; k < particle.size(); ++k)
        lengths[particle[k]] = spacing.lengths[static_cast<Index>(k)];
    return particles::Spacing(lengths);
}

/// A structured array of doubles. \param rows the numbers of a row, in the order of the names
py::object structured(const std::vector<std::string>& names, const Eigen::MatrixXd& rows) {
    py::list columns;
    for (const std::string& name : names) columns.append(py::make_tuple(name, "f8"));
    const py::module_ numpy = py::module_::import("numpy");
    return array_of(rows.data(), {rows.cols(), rows.rows()})
        .attr("view")(numpy.attr("dtype")(columns))
        .attr("reshape")(-1);
}

template <int dim, int n>
py::object fields(const command_line::SolvedBody<dim, n>& solved,
                  const std::vector<bodies::State<dim, n>>& states, const Points<dim>& places) {
    static const std::array<const char*, 3> axes{"x", "y", "z"};
    std::vector<std::string> names(axes.begin(), axes.begin() + dim);
    for (const auto& [name, number] : command_line::named(solved.at_particles.front(), solved.material))
        names.push_back(name);
    Eigen::MatrixXd rows(static_cast<Index>(names.size()), places.cols());
    for (Index k = 0; k < places.cols(); ++k) {
        rows.col(k).template head<dim>() = places.col(k);
        Index i = dim;
        for (const auto& [name, number] :
             command_line::named(states[static_cast<std::size_t>(k)], solved.material))
            rows(i++, k) = number;
    }
    return structured(names, rows);
}

template <int dim, int n>
py::tuple solved(const command_line::BodyOptions& options, const particles::Spacing& spacing,
                 const Points<dim>& points, const Body<dim>& body, const std::optional<Points<dim>>& at) {
    std::optional<py::gil_scoped_release> others_run(std::in_place);
    // METIS draws from the one rand() of a process, and OpenBLAS has one number of threads: one at a time.
    static std::mutex one_at_a_time;
    std::unique_lock<std::mutex> turn(one_at_a_time);
    std::optional<solvers::OneBlasThread> alone(std::in_place);
    const auto problem = command_line::problem<dim, n>(options.problem, body);
    const std::vector<Index> particle = particles_at(points, body);
    bodies::Discretisation how = command_line::discretisations(options, body).front();
    how.spacing = reordered(spacing, particle);
    if (at) {
        std::vector<Point<dim>> places;
        for (Index k = 0; k < at->cols(); ++k) places.push_back(at->col(k));
        command_line::require_inside(body, places);
    }
    const auto solution = bodies::solve(problem, body, how);
    command_line::SolvedBody<dim, n> all{problem, body, solution, {1, 0}};
    if constexpr (n == dim) all.material = command_line::material(options.problem);
    all.at_particles = command_line::states(problem, solution, body.x);
    const auto judged = bodies::judgement(problem, body, solution);
    const std::string finer = how.method == bodies::Method::hats ? "" : "--method hats or ";
    const auto remarks =
        command_line::remarks(solution.approximation.how(), judged, command_line::particles_of(all),
                              how.degree, finer + "a finer mesh");
    std::vector<bodies::State<dim, n>> states;
    if (at)
        states = command_line::states(problem, solution, *at);
    else
        for (const Index I : particle) states.push_back(all.at_particles[static_cast<std::size_t>(I)]);
    alone.reset();
    turn.unlock();
    others_run.reset();

    py::dict numbers;
    for (const auto& quantities : {command_line::quantities(all, {}), command_line::quantities<dim>(judged)})
        for (const auto& quantity : quantities) numbers[quantity.name.c_str()] = quantity.value;
    for (const std::string& remark : remarks) warn(remark);
    return py::make_tuple(fields(all, states, at ? *at : points), numbers);
}

template <int dim>
py::tuple solve(const Numbers& rows, const py::object& cells, const py::object& sides, const py::object& at,
                const particles::Spacing& spacing, const command_line::BodyOptions& options) {
    command_line::check(options.problem, dim);
    Mesh<dim> mesh = mesh_of<dim>(rows, cells);
    if (!sides.is_none()) {
        if (!py::isinstance<py::dict>(sides))
            throw InvalidInput("sides must be a dict from names to facets, such as boundary() gives");
        name_sides(mesh, sides);
    }
    std::optional<Points<dim>> places;
    if (!at.is_none()) {
        const auto [wanted, its_dim] = positions(at, "at");
        if (its_dim != dim)
            throw InvalidInput("at has " + std::to_string(its_dim) + " columns, and points have " +
                               std::to_string(dim));
        places = points_of<dim>(wanted);
    }
    const Body<dim> body = bodies::body_of(mesh);
    return command_line::is_scalar(options.problem)
               ? solved<dim, 1>(options, spacing, mesh.x, body, places)
               : solved<dim, dim>(options, spacing, mesh.x, body, places);
}

template <int dim>
py::object boundary(const Numbers& rows, const py::object& cells) {
    const auto outer = bodies::boundary_of(mesh_of<dim>(rows, cells));
    py::array_t<int> facets({static_cast<py::ssize_t>(outer.size()), static_cast<py::ssize_t>(dim)});
    int* next = facets.mutable_data();
    for (const auto& one : outer) next = std::copy(one.nodes.begin(), one.nodes.end(), next);
    return facets;
}

}  // namespace

void define_solve(py::module_& module) {
    module.def("boundary", [](const py::object& points, const py::object& cells) {
        const auto [rows, dim] = positions(points, "points");
        return dim == 2 ? boundary<2>(rows, cells) : boundary<3>(rows, cells);
    });
    module.def("solve", [](const py::object& points, const py::object& cells, const py::object& sides,
                           const py::object& at, const py::object& smoothing_from, const py::dict& keywords) {
        const auto [rows, dim] = positions(points, "points");
        const particles::Spacing delta = spacing(smoothing_from);
        const command_line::BodyOptions options = options_of(keywords);
        return dim == 2 ? solve<2>(rows, cells, sides, at, delta, options)
                        : solve<3>(rows, cells, sides, at, delta, options);
    });
}

}  // namespace python
