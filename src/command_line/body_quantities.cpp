#include "command_line/body_quantities.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "base/errors.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "particles/boundary.hpp"

namespace command_line {

using base::FailedComputation;
using base::InvalidInput;
using base::shown;
using batra2008::elastostatics::Material;
using bodies::Body;
using bodies::Index;
using bodies::Point;
using bodies::Points;
using bodies::State;

template <int dim>
double size_of(const Body<dim>& body) {
    return (body.x.rowwise().maxCoeff() - body.x.rowwise().minCoeff()).maxCoeff();
}

namespace {

/// Whether a place lies in a triangle or tetrahedron, or beyond one of its faces by a distance at most.
template <int dim>
bool lies_in(const Body<dim>& body, const std::array<int, dim + 1>& cell, const Point<dim>& x,
             double distance) {
    Eigen::Matrix<double, dim, dim> edges;
    for (int k = 0; k < dim; ++k)
        edges.col(k) = body.x.col(cell[static_cast<std::size_t>(k) + 1]) - body.x.col(cell[0]);
    const Eigen::Matrix<double, dim, dim> gradients = edges.inverse();  // of the hats, in rows
    const Point<dim> hats = gradients * (x - body.x.col(cell[0]));
    for (int k = 0; k < dim; ++k)
        if (hats[k] < -distance * gradients.row(k).norm()) return false;
    return 1 - hats.sum() >= -distance * gradients.colwise().sum().norm();
}

/// Whether a place lies in a body, or outside by a distance at most.
template <int dim>
class Inside {
  public:
    explicit Inside(const Body<dim>& body) : body_(body) {
        if constexpr (dim == 2) {
            if (!body.cells.empty()) return;
            particles::Region region;
            for (const auto& side : body.sides)
                region.insert(region.end(), side.pieces.begin(), side.pieces.end());
            boundary_.emplace(region);
        }
    }

    [[nodiscard]] bool operator()(const Point<dim>& x, double distance) const {
        if constexpr (dim == 2)
            if (boundary_) return particles::signed_distance(*boundary_, x) <= distance;
        return std::any_of(body_.cells.begin(), body_.cells.end(),
                           [&](const auto& cell) { return lies_in<dim>(body_, cell, x, distance); });
    }

  private:
    const Body<dim>& body_;
    std::optional<particles::Boundary> boundary_;
};

}  // namespace

template <int dim>
void require_inside(const Body<dim>& body, const std::vector<Point<dim>>& places) {
    const Inside<dim> inside(body);
    for (const Point<dim>& x : places) {
        if (inside(x, 1e-6 * size_of(body) + body.gap)) continue;
        Index nearest = 0;
        const double distance = (body.x.colwise() - x).colwise().norm().minCoeff(&nearest);
        throw InvalidInput(
            "the place " + particles::shown_point(x) + " lies outside of the body; the nearest particle is " +
            particles::shown_point(Point<dim>(body.x.col(nearest))) + ", " + shown(distance) + " away");
    }
}

template <int dim, int n>
std::vector<State<dim, n>> states(const bodies::Problem<dim, n>& problem,
                                  const bodies::Solution<dim, n>& solution, const Points<dim>& places) {
    std::vector<State<dim, n>> all(static_cast<std::size_t>(places.cols()));
    base::for_each_index(places.cols(), [&](Index k) {
        const Point<dim> x = places.col(k);
        auto& state = all[static_cast<std::size_t>(k)];
        state = bodies::state_at(problem, solution, x);
        if (!state.u.allFinite() || !state.F.allFinite())
            throw FailedComputation("the solution is not finite at " + particles::shown_point(x) +
                                    "; take another --method or a smaller --size");
    });
    return all;
}

namespace {

/// Pairs of axes of the stresses, in the order in which they are listed.
template <int dim>
constexpr auto stresses() {
    if constexpr (dim == 2)
        return std::array<std::array<int, 2>, 3>{{{0, 0}, {1, 1}, {0, 1}}};
    else
        return std::array<std::array<int, 2>, 6>{{{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}};
}

}  // namespace

std::string numbered(const std::string& name, Index axis) {
    return name + std::to_string(axis + 1);
}

template <int dim, int n>
std::vector<std::pair<std::string, double>> named(const State<dim, n>& state, const Material& material) {
    std::vector<std::pair<std::string, double>> all;
    if constexpr (n == 1) {
        all.emplace_back("u", state.u[0]);
        for (Index a = 0; a < dim; ++a) all.emplace_back(numbered("q", a), -state.F(0, a));
        static_cast<void>(material);
    } else {
        for (Index i = 0; i < n; ++i) all.emplace_back(numbered("u", i), state.u[i]);
        for (const auto& [i, a] : stresses<dim>())
            all.emplace_back(numbered(numbered("s", i), a), state.F(i, a));
        all.emplace_back("von_mises", bodies::von_mises<dim>(state.F, material));
    }
    return all;
}

namespace {

/// The largest number at a particle, with its place. \param sign −1 for the smallest
template <int dim, int n, class Number>
Quantity<dim> largest(const SolvedBody<dim, n>& solved, const std::string& name, const Number& number,
                      double sign = 1) {
    double most = -std::numeric_limits<double>::infinity();
    Index where = 0;
    for (std::size_t I = 0; I < solved.at_particles.size(); ++I)
        if (const double here = sign * number(solved.at_particles[I]); here > most) {
            most = here;
            where = static_cast<Index>(I);
        }
    return {name, Point<dim>(solved.body.x.col(where)), sign * most};
}

}  // namespace

template <int dim, int n>
std::vector<Quantity<dim>> quantities(const SolvedBody<dim, n>& solved,
                                      const std::vector<Point<dim>>& places) {
    std::vector<Quantity<dim>> all;
    Points<dim> x(dim, static_cast<Index>(places.size()));
    for (Index k = 0; k < x.cols(); ++k) x.col(k) = places[static_cast<std::size_t>(k)];
    const auto there = states(solved.problem, solved.solution, x);
    for (std::size_t k = 0; k < places.size(); ++k)
        for (const auto& [name, value] : named(there[k], solved.material))
            all.push_back({name, places[k], value});
    for (const Quantity<dim>& most : extremes(solved)) all.push_back(most);
    const auto& [worst, quality] = std::pair(solved.solution.worst, solved.solution.quality);
    if (std::isfinite(quality))
        all.push_back({"quality", Point<dim>(solved.body.x.col(worst)), quality, false});
    return all;
}

template <int dim, int n>
std::vector<Quantity<dim>> extremes(const SolvedBody<dim, n>& solved) {
    using Here = State<dim, n>;
    if constexpr (n == 1) {
        const auto u = [](const Here& state) { return state.u[0]; };
        return {largest(solved, "max_u", u), largest(solved, "min_u", u, -1)};
    } else {
        return {largest(solved, "max_displacement", [](const Here& state) { return state.u.norm(); }),
                largest(solved, "max_von_mises",
                        [&](const Here& state) { return bodies::von_mises<dim>(state.F, solved.material); })};
    }
}

template <int dim, int n>
std::vector<bodies::NamedField> fields(const std::vector<State<dim, n>>& at_particles,
                                       const bodies::Column<double>& R, const Material& material,
                                       const std::string& suffix) {
    std::vector<bodies::NamedField> all;
    const auto N = static_cast<Index>(at_particles.size());
    Eigen::MatrixXd u(n, N), q(dim, N);
    for (Index I = 0; I < N; ++I) {
        const auto& state = at_particles[static_cast<std::size_t>(I)];
        u.col(I) = state.u;
        if constexpr (n == 1) q.col(I) = -state.F.transpose();
    }
    all.push_back({"u" + suffix, u});
    if constexpr (n == 1) {
        all.push_back({"q" + suffix, q});
    } else {
        const State<dim, n> zero{bodies::Values<n>::Zero(), {}, Eigen::Matrix<double, n, dim>::Zero()};
        const auto names = named(zero, material);
        for (std::size_t k = n; k < names.size(); ++k)
            all.push_back({names[k].first + suffix, Eigen::MatrixXd(1, N)});
        for (Index I = 0; I < N; ++I) {
            const auto numbers = named(at_particles[static_cast<std::size_t>(I)], material);
            for (std::size_t k = n; k < numbers.size(); ++k) all[k - n + 1].values(0, I) = numbers[k].second;
        }
    }
    all.push_back({"quality" + suffix, R.matrix().transpose()});
    return all;
}

namespace {

/// The triangles of a body in the plane, or of the surface of one in space: faces of one cell only.
template <int dim>
std::vector<std::array<int, 3>> triangles(const Body<dim>& body) {
    if constexpr (dim == 2) {
        return body.cells;
    } else {
        std::map<std::array<int, 3>, int> count;
        for (const auto& cell : body.cells)
            for (std::size_t left_out = 0; left_out < 4; ++left_out) {
                std::array<int, 3> face{};
                for (std::size_t k = 0; k < 3; ++k) face[k] = cell[(left_out + 1 + k) % 4];
                std::sort(face.begin(), face.end());
                ++count[face];
            }
        std::vector<std::array<int, 3>> all;
        for (const auto& [face, cells] : count)
            if (cells == 1) all.push_back(face);
        return all;
    }
}

}  // namespace

template <int dim, int n>
report::Table drawing(const SolvedBody<dim, n>& solved) {
    const Body<dim>& body = solved.body;
    std::vector<double> values;
    for (const auto& state : solved.at_particles) {
        const auto all = named(state, solved.material);
        values.push_back(n == 1 ? all.front().second : all.back().second);
    }
    report::Table table{{n == 1 ? "u" : "von Mises stress"}, {}, {}};
    const std::size_t corners = body.cells.empty() ? 1 : 3;
    for (std::size_t corner = 1; corner <= corners; ++corner)
        for (const char* name : {"x", "y", "z", "value"})
            table.columns.push_back({name + std::to_string(corner), {1e-6, 0}});
    const auto row = [&](const auto& particles) {
        std::vector<report::Cell> cells;
        for (const int I : particles) {
            for (int axis = 0; axis < 3; ++axis) cells.emplace_back(axis < dim ? body.x(axis, I) : 0.0);
            cells.emplace_back(values[static_cast<std::size_t>(I)]);
        }
        table.rows.push_back(cells);
    };
    if (body.cells.empty())
        for (int I = 0; I < body.x.cols(); ++I) row(std::array{I});
    else
        for (const auto& triangle : triangles(body)) row(triangle);
    return table;
}

template double size_of(const Body<2>&);
template double size_of(const Body<3>&);
template void require_inside(const Body<2>&, const std::vector<Point<2>>&);
template void require_inside(const Body<3>&, const std::vector<Point<3>>&);

template std::vector<State<2, 1>> states(const bodies::Problem<2, 1>&, const bodies::Solution<2, 1>&,
                                         const Points<2>&);
template std::vector<std::pair<std::string, double>> named(const State<2, 1>&, const Material&);
template std::vector<Quantity<2>> quantities(const SolvedBody<2, 1>&, const std::vector<Point<2>>&);
template std::vector<Quantity<2>> extremes(const SolvedBody<2, 1>&);
template std::vector<bodies::NamedField> fields(const std::vector<State<2, 1>>&,
                                                const bodies::Column<double>&, const Material&,
                                                const std::string&);
template report::Table drawing(const SolvedBody<2, 1>&);

template std::vector<State<3, 1>> states(const bodies::Problem<3, 1>&, const bodies::Solution<3, 1>&,
                                         const Points<3>&);
template std::vector<std::pair<std::string, double>> named(const State<3, 1>&, const Material&);
template std::vector<Quantity<3>> quantities(const SolvedBody<3, 1>&, const std::vector<Point<3>>&);
template std::vector<Quantity<3>> extremes(const SolvedBody<3, 1>&);
template std::vector<bodies::NamedField> fields(const std::vector<State<3, 1>>&,
                                                const bodies::Column<double>&, const Material&,
                                                const std::string&);
template report::Table drawing(const SolvedBody<3, 1>&);

template std::vector<State<2, 2>> states(const bodies::Problem<2, 2>&, const bodies::Solution<2, 2>&,
                                         const Points<2>&);
template std::vector<std::pair<std::string, double>> named(const State<2, 2>&, const Material&);
template std::vector<Quantity<2>> quantities(const SolvedBody<2, 2>&, const std::vector<Point<2>>&);
template std::vector<Quantity<2>> extremes(const SolvedBody<2, 2>&);
template std::vector<bodies::NamedField> fields(const std::vector<State<2, 2>>&,
                                                const bodies::Column<double>&, const Material&,
                                                const std::string&);
template report::Table drawing(const SolvedBody<2, 2>&);

template std::vector<State<3, 3>> states(const bodies::Problem<3, 3>&, const bodies::Solution<3, 3>&,
                                         const Points<3>&);
template std::vector<std::pair<std::string, double>> named(const State<3, 3>&, const Material&);
template std::vector<Quantity<3>> quantities(const SolvedBody<3, 3>&, const std::vector<Point<3>>&);
template std::vector<Quantity<3>> extremes(const SolvedBody<3, 3>&);
template std::vector<bodies::NamedField> fields(const std::vector<State<3, 3>>&,
                                                const bodies::Column<double>&, const Material&,
                                                const std::string&);
template report::Table drawing(const SolvedBody<3, 3>&);

}  // namespace command_line
