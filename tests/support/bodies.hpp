#pragma once

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "bodies/problem.hpp"
#include "bodies/solution.hpp"
#include "tests/support/clouds.hpp"
#include "tests/support/polynomial.hpp"

/// Bodies of many shapes, and problems whose solution is a polynomial.
namespace support {

using bodies::Body;
using bodies::Equation;
using bodies::Given;
using bodies::Problem;
using bodies::Values;

template <int dim>
using Cell = std::array<int, dim + 1>;
template <int dim>
using Facet = std::array<int, dim>;

/// A change of a body's shape.
template <int dim>
using Map = std::function<Point<dim>(const Point<dim>&)>;

/// The facets of one cell only, each with the corner of its cell that is not its own.
template <int dim>
std::map<Facet<dim>, int> outer_facets(const std::vector<Cell<dim>>& cells) {
    std::map<Facet<dim>, int> all;
    for (const Cell<dim>& cell : cells)
        for (const int inner : cell) {
            Facet<dim> facet{};
            std::copy_if(cell.begin(), cell.end(), facet.begin(), [&](int k) { return k != inner; });
            std::sort(facet.begin(), facet.end());
            const auto [found, is_new] = all.insert({facet, inner});
            if (!is_new) found->second = -1;
        }
    std::erase_if(all, [](const auto& one) { return one.second < 0; });
    return all;
}

/// Normal of a facet, with its size as length; it points away from a place.
inline Point<2> area_away(const Point<2>& from, Facet<2>& facet, const Points<2>& x) {
    const Point<2> along = x.col(facet[1]) - x.col(facet[0]), normal(along[1], -along[0]);
    if (normal.dot(from - x.col(facet[0])) < 0) return normal;
    std::swap(facet[0], facet[1]);
    return -normal;
}
inline Point<3> area_away(const Point<3>& from, Facet<3>& facet, const Points<3>& x) {
    const Point<3> a = x.col(facet[0]), b = x.col(facet[1]), c = x.col(facet[2]);
    const Point<3> normal = Point<3>(b - a).cross(Point<3>(c - a)) / 2;
    if (normal.dot(from - a) < 0) return normal;
    std::swap(facet[1], facet[2]);
    return -normal;
}

/// The body that cells fill.
/// \param side name of the side of a facet \param normal of a side at a particle; empty for flat sides
template <int dim>
Body<dim> body_with(const Points<dim>& x, const std::vector<Cell<dim>>& cells,
                    const std::function<std::string(const Facet<dim>&)>& side,
                    const std::function<Point<dim>(const std::string&, int)>& normal = {}) {
    Body<dim> body{x, {}, cells};
    for (const auto& [sorted, inner] : outer_facets<dim>(cells)) {
        Facet<dim> facet = sorted;
        const std::string name = side(facet);
        const Point<dim> flat = area_away(x.col(inner), facet, x).normalized();
        auto found = std::find_if(body.sides.begin(), body.sides.end(),
                                  [&](const auto& one) { return one.name == name; });
        if (found == body.sides.end()) found = body.sides.insert(found, {name, {}, {}});
        if constexpr (dim == 2)
            found->pieces.emplace_back(particles::Segment{x.col(facet[0]), x.col(facet[1])});
        else
            found->pieces.push_back({{x.col(facet[0]), x.col(facet[1]), x.col(facet[2])}});
        for (const int k : facet)
            if (std::none_of(found->places.begin(), found->places.end(),
                             [&](const auto& place) { return place.particle == k; }))
                found->places.push_back({k, normal ? normal(name, k) : flat});
    }
    return body;
}

/// Unit normal of a surface of the unit cube after a map. \param axis to which the surface is normal
/// \param outward −1 or 1
template <int dim>
Point<dim> mapped_normal(const Map<dim>& map, const Point<dim>& x, int axis, double outward) {
    Eigen::Matrix<double, dim, dim> J;
    for (int k = 0; k < dim; ++k) {
        const Point<dim> step = 1e-3 * Point<dim>::Unit(k);
        J.col(k) = (8 * (map(x + step) - map(x - step)) - (map(x + 2 * step) - map(x - 2 * step))) / 12e-3;
    }
    return outward * J.inverse().row(axis).transpose().normalized();
}

/// How a block is made.
template <int dim>
struct Block {
    std::array<int, dim> n;                            ///< cells along each axis
    double amplitude = 0;                              ///< by which particles inside are moved, in cells
    unsigned seed = 1;                                 ///< of these moves
    Map<dim> map = {};                                 ///< from the unit square or cube to the body
    std::function<bool(const Point<dim>&)> keep = {};  ///< whether a place of the unit cube is in the body
};

/// The unit square or cube in cells, each cut into 2 triangles or 6 tetrahedra, then mapped. Its sides are
/// left, right; bottom, top; back, front: where the first, second and third coordinate is 0 or 1 before the
/// map. Other parts of its boundary are the side inner.
template <int dim>
Body<dim> block(const Block<dim>& how) {
    static constexpr std::array<std::array<const char*, 2>, 3> names{
        {{"left", "right"}, {"bottom", "top"}, {"back", "front"}}};
    const Index N = std::accumulate(how.n.begin(), how.n.end(), Index{1},
                                    [](Index product, int n) { return product * (n + 1); });
    Points<dim> x(dim, N);
    for (Index j = 0; j < N; ++j)
        for (Index axis = 0, left = j; axis < dim; ++axis) {
            const int n = how.n[static_cast<std::size_t>(axis)];
            x(axis, j) = static_cast<double>(left % (n + 1)) / n;
            left /= n + 1;
        }
    std::vector<Cell<dim>> cells;
    for (Index j = 0; j < N; ++j) {
        if ((x.col(j).array() == 1).any()) continue;
        std::array<int, dim> axes{}, stride{};
        std::iota(axes.begin(), axes.end(), 0);
        for (std::size_t axis = 0; axis < dim; ++axis)
            stride[axis] = axis == 0 ? 1 : stride[axis - 1] * (how.n[axis - 1] + 1);
        do {
            Cell<dim> cell{static_cast<int>(j)};
            for (std::size_t k = 0; k < dim; ++k)
                cell[k + 1] = cell[k] + stride[static_cast<std::size_t>(axes[k])];
            const Point<dim> middle = (x.col(cell[0]) + x.col(cell[dim])) / 2;
            if (!how.keep || how.keep(middle)) cells.push_back(cell);
        } while (std::next_permutation(axes.begin(), axes.end()));
    }
    std::vector<int> used(static_cast<std::size_t>(N), -1);
    Index kept = 0;
    for (Cell<dim>& cell : cells)
        for (int& k : cell) used[static_cast<std::size_t>(k)] = 0;
    for (Index j = 0; j < N; ++j)
        if (int& number = used[static_cast<std::size_t>(j)]; number == 0) {
            number = static_cast<int>(kept);
            x.col(kept++) = x.col(j);
        }
    x.conservativeResize(dim, kept);
    for (Cell<dim>& cell : cells)
        for (int& k : cell) k = used[static_cast<std::size_t>(k)];

    const Points<dim> before = x;
    std::vector<bool> inside(static_cast<std::size_t>(kept), true);
    for (const auto& [facet, inner] : outer_facets<dim>(cells))
        for (const int k : facet) inside[static_cast<std::size_t>(k)] = false;
    Draws draw(how.seed);
    for (Index j = 0; j < kept; ++j) {
        if (inside[static_cast<std::size_t>(j)])
            for (int axis = 0; axis < dim; ++axis)
                x(axis, j) += how.amplitude * draw() / how.n[static_cast<std::size_t>(axis)];
        if (how.map) x.col(j) = how.map(x.col(j));
    }
    const auto side = [&](const Facet<dim>& facet) -> std::string {
        for (int axis = 0; axis < dim; ++axis)
            for (const int end : {0, 1})
                if (std::all_of(facet.begin(), facet.end(), [&](int k) { return before(axis, k) == end; }))
                    return names[static_cast<std::size_t>(axis)][static_cast<std::size_t>(end)];
        return "inner";
    };
    const auto normal = [&](const std::string& name, int k) -> Point<dim> {
        for (int axis = 0; axis < dim; ++axis)
            for (const int end : {0, 1})
                if (name == names[static_cast<std::size_t>(axis)][static_cast<std::size_t>(end)])
                    return mapped_normal<dim>(how.map, before.col(k), axis, 2 * end - 1);
        return Point<dim>::Zero();
    };
    using Normal = std::function<Point<dim>(const std::string&, int)>;
    return body_with<dim>(x, cells, side, how.map ? Normal(normal) : Normal());
}

/// The square whose upper right quarter is missing, of size 1.
inline Body<2> angle(int n, double amplitude, unsigned seed) {
    return block<2>(
        {{2 * n, 2 * n}, amplitude, seed, {}, [](const Point<2>& x) { return x[0] < 0.5 || x[1] < 0.5; }});
}

/// A convex quadrilateral. \param corners anticlockwise from the lower left one
inline Map<2> quadrilateral(const std::array<Point<2>, 4>& corners) {
    return [corners](const Point<2>& s) -> Point<2> {
        return (1 - s[0]) * (1 - s[1]) * corners[0] + s[0] * (1 - s[1]) * corners[1] +
               s[0] * s[1] * corners[2] + (1 - s[0]) * s[1] * corners[3];
    };
}

/// The unit disc around the origin: a particle in the middle and n rings of 6, 12, … particles. Its side is
/// edge.
inline Body<2> disc(int n, double amplitude, unsigned seed) {
    const double pi = std::acos(-1.0);
    const auto first = [](int ring) { return ring == 0 ? 0 : 1 + 3 * ring * (ring - 1); };
    Points<2> x(2, first(n + 1));
    x.col(0).setZero();
    Draws draw(seed);
    std::vector<Cell<2>> cells;
    for (int ring = 1; ring <= n; ++ring) {
        const int count = 6 * ring, before = std::max(1, 6 * (ring - 1));
        for (int k = 0; k < count; ++k) {
            const double angle = 2 * pi * k / count, r = static_cast<double>(ring) / n;
            x.col(first(ring) + k) = r * Point<2>(std::cos(angle), std::sin(angle));
        }
        for (int sector = 0; sector < 6; ++sector)
            for (int k = 0; k < ring; ++k) {
                const int outer = sector * ring + k, inner = sector * (ring - 1) + k;
                const int a = first(ring) + outer, b = first(ring) + (outer + 1) % count;
                const int c = first(ring - 1) + inner % before;
                cells.push_back({a, b, c});
                if (k < ring - 1) cells.push_back({b, first(ring - 1) + (inner + 1) % before, c});
            }
    }
    for (Index j = 0; j < first(n); ++j) x.col(j) += amplitude / n * draw.point<2>();
    return body_with<2>(
        x, cells, [](const auto&) { return "edge"; },
        [&](const std::string&, int k) { return Point<2>(x.col(k).normalized()); });
}

/// A ring around the origin, its particles on rays. Its sides are hole and edge.
/// \param n cells along the radius \param rays cells around
inline Body<2> ring(double inner, double outer, int n, int rays) {
    const double pi = std::acos(-1.0);
    Points<2> x(2, (n + 1) * rays);
    std::vector<Cell<2>> cells;
    const auto at = [&](int i, int j) { return i * rays + j % rays; };
    for (int i = 0; i <= n; ++i)
        for (int j = 0; j < rays; ++j) {
            const double r = inner * std::pow(outer / inner, static_cast<double>(i) / n);
            const double angle = 2 * pi * (j + 0.5 * i) / rays;
            x.col(at(i, j)) = r * Point<2>(std::cos(angle), std::sin(angle));
            if (i == n) continue;
            cells.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
            cells.push_back({at(i, j + 1), at(i + 1, j), at(i + 1, j + 1)});
        }
    return body_with<2>(
        x, cells, [&](const Facet<2>& facet) { return facet[0] < rays ? "hole" : "edge"; },
        [&](const std::string& name, int k) {
            return Point<2>((name == "hole" ? -1 : 1) * x.col(k).normalized());
        });
}

/// A body in the plane by its particles and its boundary; it has no cells.
/// \param sides each with its name
inline Body<2> body_within(const Points<2>& x,
                           const std::vector<std::pair<std::string, particles::Curve>>& sides, double size) {
    Body<2> body{x, {}};
    for (const auto& [name, curve] : sides) {
        bodies::Side<2> side{name, {curve}, {}};
        for (Index j = 0; j < x.cols(); ++j)
            if (particles::lies_on(curve, x.col(j), size))
                side.places.push_back({static_cast<int>(j), particles::normal_at(curve, x.col(j))});
        body.sides.push_back(side);
    }
    return body;
}

/// Functions that are polynomials, with all that follows from them for an equation.
template <int dim, int n>
class Manufactured {
  public:
    Manufactured(Equation<dim, n> equation, int degree, unsigned seed) : equation_(std::move(equation)) {
        for (unsigned i = 0; i < n; ++i) u_.emplace_back(dim, degree, 10 * seed + i);
    }

    [[nodiscard]] Values<n> u(const Point<dim>& x) const {
        Values<n> all;
        for (int i = 0; i < n; ++i) all[i] = of(i)(x);
        return all;
    }
    [[nodiscard]] Eigen::Matrix<double, n, dim> F(const Point<dim>& x) const {
        const auto A = equation_.A(x);
        Eigen::Matrix<double, n, dim> all = Eigen::Matrix<double, n, dim>::Zero();
        for (int i = 0; i < n; ++i)
            for (int a = 0; a < dim; ++a)
                for (int j = 0; j < n; ++j)
                    for (int b = 0; b < dim; ++b)
                        all(i, a) += A(dim * i + a, dim * j + b) * of(j).derivative(once(b), x);
        return all;
    }
    /// What keeps it in balance, \f$c\,u_i - \sum_a \partial_a F_{ia}\f$.
    [[nodiscard]] Values<n> b(const Point<dim>& x) const {
        const auto A = equation_.A(x);
        Values<n> all = equation_.c * u(x);
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j)
                for (int b = 0; b < dim; ++b) {
                    for (int a = 0; a < dim; ++a) {
                        Powers twice = once(a);
                        ++twice[static_cast<std::size_t>(b)];
                        all[i] -= A(dim * i + a, dim * j + b) * of(j).derivative(twice, x);
                    }
                    if (equation_.div_A)
                        all[i] -= equation_.div_A(x)(i, dim * j + b) * of(j).derivative(once(b), x);
                }
        return all;
    }

    /// The side with these values.
    [[nodiscard]] Given<dim, n> values_on(const std::string& side) const {
        Given<dim, n> given{side};
        for (int i = 0; i < n; ++i)
            given.value[static_cast<std::size_t>(i)] = [f = of(i)](const Point<dim>& x) { return f(x); };
        return given;
    }
    /// The side with these loads.
    [[nodiscard]] Given<dim, n> loads_on(const std::string& side) const {
        Given<dim, n> given{side};
        given.loads.push_back(
            [*this](const Point<dim>& x, const Point<dim>& normal) { return Values<n>(F(x) * normal); });
        return given;
    }
    /// The problem on a body with values on some sides and loads on the others.
    [[nodiscard]] Problem<dim, n> problem(const Body<dim>& body,
                                          const std::vector<std::string>& valued) const {
        Problem<dim, n> problem{equation_};
        problem.equation.b = [*this](const Point<dim>& x) { return b(x); };
        for (const std::string& side : valued) problem.given.push_back(values_on(side));
        for (const auto& side : body.sides)
            if (std::find(valued.begin(), valued.end(), side.name) == valued.end())
                problem.given.push_back(loads_on(side.name));
        return problem;
    }

  private:
    static Powers once(int axis) {
        Powers powers{};
        powers[static_cast<std::size_t>(axis)] = 1;
        return powers;
    }
    [[nodiscard]] const Polynomial& of(int i) const { return u_[static_cast<std::size_t>(i)]; }

    Equation<dim, n> equation_;
    std::vector<Polynomial> u_;
};

/// Errors of a solution at its particles, relative to the largest exact value there.
struct Errors {
    double u, F;
};

template <int dim, int n>
Errors errors(const Problem<dim, n>& problem, const bodies::Solution<dim, n>& solution,
              const Manufactured<dim, n>& exact) {
    double u = 0, F = 0, most_u = 0, most_F = 0;
    const auto& x = solution.approximation.cloud().x();
    for (Index I = 0; I < x.cols(); ++I) {
        const auto state = bodies::state_at<dim, n>(problem, solution, x.col(I));
        const Values<n> exact_u = exact.u(x.col(I));
        const auto exact_F = exact.F(x.col(I));
        u = std::max(u, (state.u - exact_u).norm());
        F = std::max(F, (state.F - exact_F).norm());
        most_u = std::max(most_u, exact_u.norm());
        most_F = std::max(most_F, exact_F.norm());
    }
    return {u / most_u, F / most_F};
}

}  // namespace support
