#include <pybind11/stl.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "bodies/mesh_boundary.hpp"
#include "command_line/body_judgement.hpp"
#include "command_line/body_options.hpp"
#include "python/arrays.hpp"
#include "python/functions.hpp"
#include "python/messages.hpp"
#include "solvers/blas_threads.hpp"

namespace python {

using namespace pybind11::literals;
using base::InvalidInput;
using bodies::Body;
using bodies::Mesh;
using bodies::Nodes;
using bodies::Point;
using bodies::Points;

namespace {

constexpr auto about_boundary = R"(The facets on the boundary of a mesh: those of one cell only.

points  positions, shape (N, 2) or (N, 3) [length]
cells   triangles or tetrahedra, the numbers of their corners, shape (n, 3) or (n, 4)

Returns the numbers of their points, shape (m, 2) or (m, 3). Seen from outside, the corners of a triangle run
counter-clockwise; a segment has the body to its left.

>>> facets = boundary(points, cells)
>>> middles = points[facets].mean(axis=1)
>>> sides = {"wall": facets[middles[:, 0] == 0], "tip": facets[middles[:, 0] == 1]}
)";

constexpr auto about_solve =
    R"raw(The solution of a boundary-value problem on a body, with an account of its errors.

points   positions, shape (N, 2) or (N, 3) [length]
cells    triangles or tetrahedra, the numbers of their corners, shape (n, 3) or (n, 4)
sides    a dict from the name of a side to its facets, shape (m, 2) or (m, 3), see boundary(); facets of the
         boundary in no side are the side "rest". By default all of it is the side "boundary"
at       places where the solution is wanted, shape (M, 2) or (M, 3); by default the points
problem  keywords with the names of the options of the program `body`, in the units of the points and of the
         loads. Numbers, or functions of the place as a text such as "-1e6*(1-x)"; None leaves a component free

  equation="elasticity"  young=, poisson=, plane="stress"|"strain", body_force=(bx, by)
                         fix="wall"|["wall", "foot"], symmetry=, displacement={"wall": (0, None)},
                         traction={"tip": (0, -1e6)}, pressure={"bore": 5e6}
  equation="poisson"     -div(k grad u) + c u = f: conductivity=, source=, reaction=
                         value={"wall": 0}, flux={"base": 1e4}, convection={"fins": (50, 293)}
  methods                method="hats"|"fpm"|"strong"|"weak1"|"weak2", degree=, scaling=, smoothing=,
                         smoothing_from=, gauss=, penalty=

A side on which nothing is given is free of loads, or insulated.

Returns (fields, numbers). `fields` is a structured array, a row for each place: x, y(, z), then u1, u2(, u3),
s11, s22, ... and von_mises, or u and the flux of heat q1, q2(, q3). `numbers` is a dict: the largest ones, the
loads and reactions, and what tells of errors: quality, noise, missed_loads, defect. What is wrong with them
comes as a warning.
Raises ValueError for arguments without meaning, RuntimeError where the method fails or its forces are not in
equilibrium.
)raw";

/// An argument as the command line has it: 1e6, (0, None) and "x^2" are "1000000.0", "0, -" and "x^2".
std::string text_of(const py::handle& value) {
    if (py::isinstance<py::str>(value)) return py::cast<std::string>(value);
    if (value.is_none()) return "-";
    if (py::isinstance<py::sequence>(value) || py::isinstance<py::array>(value)) {
        std::string all;
        for (const py::handle& entry : value) all += (all.empty() ? "" : ", ") + text_of(entry);
        return all;
    }
    if (PyNumber_Check(value.ptr()) == 0)
        throw InvalidInput(std::string(py::repr(value)) +
                           " is no number and no function; write functions as a text, such as \"1 + x^2\"");
    return py::repr(py::float_(py::reinterpret_borrow<py::object>(value)));
}

/// Keywords as arguments of a program.
std::vector<std::string> arguments(const py::kwargs& keywords) {
    std::vector<std::string> all{"solve"};
    for (const auto& [key, value] : keywords) {
        std::string option = "--" + py::cast<std::string>(key);
        std::replace(option.begin(), option.end(), '_', '-');
        const bool names = py::isinstance<py::list>(value) && py::len(value) > 0 &&
                           std::all_of(value.begin(), value.end(), py::isinstance<py::str>);
        if (py::isinstance<py::dict>(value))
            for (const auto& [side, given] : py::cast<py::dict>(value))
                all.push_back(option + "=" + py::cast<std::string>(py::str(side)) + ": " + text_of(given));
        else if (names)
            for (const py::handle& name : value) all.push_back(option + "=" + text_of(name));
        else
            all.push_back(option + "=" +
                          (py::isinstance<py::int_>(value) ? std::string(py::str(value)) : text_of(value)));
    }
    return all;
}

command_line::BodyOptions options_of(const py::kwargs& keywords) {
    command_line::BodyOptions options;
    command_line::CommandLine line("", "solve");
    command_line::add_options(line, options.problem);
    command_line::add_method_options(line, options);
    std::vector<std::string> all = arguments(keywords);
    std::vector<char*> argv;
    for (std::string& one : all) argv.push_back(one.data());
    static_cast<void>(line.read(static_cast<int>(argv.size()), argv.data()));
    command_line::check_methods(options);
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
    Mesh<dim> mesh{
        points_of<dim>(points), numbers_of_particles<dim + 1>(cells, "cells", points.shape(0)), {}};
    std::vector<bool> used(static_cast<std::size_t>(points.shape(0)), false);
    for (const auto& cell : mesh.cells)
        for (const int node : cell) used[static_cast<std::size_t>(node)] = true;
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
    Eigen::MatrixXd rows;
    for (std::size_t k = 0; k < states.size(); ++k) {
        const auto numbers = command_line::named(states[k], solved.material);
        if (k == 0) {
            for (const auto& [name, number] : numbers) names.push_back(name);
            rows.resize(static_cast<Index>(names.size()), places.cols());
        }
        const auto column = static_cast<Index>(k);
        rows.col(column).template head<dim>() = places.col(column);
        for (std::size_t i = 0; i < numbers.size(); ++i)
            rows(dim + static_cast<Index>(i), column) = numbers[i].second;
    }
    return structured(names, rows);
}

void warn(const std::string& remark) {
    if (PyErr_WarnEx(PyExc_UserWarning, in_python(remark).c_str(), 1) != 0) throw py::error_already_set();
}

template <int dim, int n>
py::tuple solved(const command_line::BodyOptions& options, const Points<dim>& points, const Body<dim>& body,
                 const std::optional<Points<dim>>& at) {
    std::optional<py::gil_scoped_release> others_run(std::in_place);
    const solvers::OneBlasThread alone;
    const auto problem = command_line::problem<dim, n>(options.problem, body);
    const bodies::Discretisation how = command_line::discretisations(options, body).front();
    if (at) {
        std::vector<Point<dim>> places;
        for (Index k = 0; k < at->cols(); ++k) places.push_back(at->col(k));
        command_line::require_inside(body, places);
    }
    const auto solution = bodies::solve(problem, body, how);
    command_line::SolvedBody<dim, n> all{problem, body, solution, {1, 0}};
    if constexpr (n == dim) all.material = command_line::material(options.problem);
    all.at_particles = command_line::states(problem, solution, body.x);
    const auto judged = command_line::judgement(all);
    const std::string finer = how.method == bodies::Method::hats ? "" : "--method hats or ";
    const auto remarks = command_line::remarks(all, judged, how.degree, finer + "a finer mesh");
    std::vector<bodies::State<dim, n>> states;
    if (at)
        states = command_line::states(problem, solution, *at);
    else
        for (const Index I : particles_at(points, body))
            states.push_back(all.at_particles[static_cast<std::size_t>(I)]);
    others_run.reset();

    py::dict numbers;
    for (const auto& quantities : {command_line::quantities(all, {}), command_line::quantities<dim>(judged)})
        for (const auto& quantity : quantities) numbers[quantity.name.c_str()] = quantity.value;
    for (const std::string& remark : remarks) warn(remark);
    return py::make_tuple(fields(all, states, at ? *at : points), numbers);
}

template <int dim>
py::tuple solve(const Numbers& rows, const py::object& cells, const py::object& sides, const py::object& at,
                const command_line::BodyOptions& options) {
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
    return command_line::is_scalar(options.problem) ? solved<dim, 1>(options, mesh.x, body, places)
                                                    : solved<dim, dim>(options, mesh.x, body, places);
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
    module.def(
        "boundary",
        [](const py::object& points, const py::object& cells) {
            const auto [rows, dim] = positions(points, "points");
            return dim == 2 ? boundary<2>(rows, cells) : boundary<3>(rows, cells);
        },
        about_boundary, "points"_a, "cells"_a);
    module.def(
        "solve",
        [](const py::object& points, const py::object& cells, const py::object& sides, const py::object& at,
           const py::kwargs& keywords) {
            const auto [rows, dim] = positions(points, "points");
            const command_line::BodyOptions options = options_of(keywords);
            return dim == 2 ? solve<2>(rows, cells, sides, at, options)
                            : solve<3>(rows, cells, sides, at, options);
        },
        about_solve, "points"_a, "cells"_a, "sides"_a = py::none(), py::kw_only(), "at"_a = py::none());
}

}  // namespace python
