#pragma once

#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <new>
#include <queue>
#include <string>
#include <utility>
#include <vector>

#include "base/text.hpp"
#include "batra2008/section_4_example_problems.hpp"

namespace batra2008 {

/// Section 4.2, plane strain of a quarter of a plate with a circular hole under tension. Figures 13 to 20.
///
/// | paper | code | meaning |
/// | --- | --- | --- |
/// | \f$b\f$ | `Shape::b` | radius of the hole [m]; its value is lost |
/// | side 3 m | `Shape::side` | side of the quarter, after the penalty 10⁵ E0/3 |
/// | \f$\sigma_0\f$ | `sigma_0` | tension, 1 GPa |
/// | \f$(r, \theta)\f$ | `r`, `theta` | polar coordinates around the hole's centre |
///
/// \eq{B4.7} and \eq{B4.8} are damaged in the text at hand; Kirsch's solution stands here, and the tests prove it: equilibrium, Hooke's law,
/// no traction at the hole. The positions of the particles are lost with the print's figures. What we take instead is in layout().
/// A corner takes, component by component, the displacement where one of its sides gives it, and else the traction of the side
/// that faces that component.
///
/// \image html batra2008_figure_14.svg "Boundaries and 188 particles."
/// \image html batra2008_figure_15.svg "The exact displacements, and what the three methods deviate from them."
/// \image html batra2008_figure_16.svg "Displacement along the x2-axis, 188 particles."
/// \image html batra2008_figure_17.svg "Stress along the x2-axis, 188 particles."
/// \image html batra2008_figure_18.svg "686 particles."
/// \image html batra2008_figure_19.svg "Displacement along the x2-axis, 686 particles."
/// \image html batra2008_figure_20.svg "Stress along the x2-axis, 686 particles."
///
/// What this section claims, and what was measured: \claims{B-4.2}.
namespace hole {

constexpr double sigma_0 = 1e9;           // [Pa]
constexpr double E = 226.9e9, nu = 0.33;  // [Pa]

/// A quarter of a square plate, its hole around the origin.
struct Shape {
    double b = 0.3;   ///< radius of the hole [length]
    double side = 3;  ///< side of the quarter [length]
};

/// Kirsch's stresses around a hole in a plate under tension along \f$x_1\f$, in polar coordinates. \defeq{B4.7}
/// \f[ \begin{aligned}
///     \sigma_{rr} &= \frac{\sigma_0}{2}\left(1 - \frac{b^2}{r^2}\right) + \frac{\sigma_0}{2}\left(1 + 3\frac{b^4}{r^4} - 4\frac{b^2}{r^2}\right)\cos 2\theta
///     \\ \sigma_{\theta\theta} &= \frac{\sigma_0}{2}\left(1 + \frac{b^2}{r^2}\right) - \frac{\sigma_0}{2}\left(1 + 3\frac{b^4}{r^4}\right)\cos 2\theta
///     \\ \sigma_{r\theta} &= -\frac{\sigma_0}{2}\left(1 - 3\frac{b^4}{r^4} + 2\frac{b^2}{r^2}\right)\sin 2\theta
///     \end{aligned} \tag{4.7} \f]
/// \return \f$[\sigma_{rr}, \sigma_{\theta\theta}, \sigma_{r\theta}]\f$
inline Eigen::Vector3d polar_stress(double b, double r, double theta) {
    const double q = b * b / (r * r), c = std::cos(2 * theta), s = std::sin(2 * theta);
    return sigma_0 / 2 *
           Eigen::Vector3d(1 - q + (1 + 3 * q * q - 4 * q) * c, 1 + q - (1 + 3 * q * q) * c,
                           -(1 - 3 * q * q + 2 * q) * s);
}

/// The stress \eq{B4.7} in Cartesian components.
inline Stress stress(const Shape& shape, const Point<2>& x) {
    const double r = x.norm(), theta = std::atan2(x[1], x[0]), c = x[0] / r, s = x[1] / r;
    const Eigen::Vector3d polar = polar_stress(shape.b, r, theta);
    const double rr = polar[0], tt = polar[1], rt = polar[2];
    return {c * c * rr + s * s * tt - 2 * s * c * rt, s * s * rr + c * c * tt + 2 * s * c * rt,
            s * c * (rr - tt) + (c * c - s * s) * rt};
}

/// Kirsch's displacements. \defeq{B4.8}
/// \f[ \begin{aligned}
///     u_r &= \frac{\sigma_0}{4G}\left\{r\left[\frac{\kappa-1}{2} + \cos 2\theta\right] + \frac{b^2}{r}\left[1 + (1+\kappa)\cos 2\theta\right]
///            - \frac{b^4}{r^3}\cos 2\theta\right\}
///     \\ u_\theta &= \frac{\sigma_0}{4G}\left\{(1-\kappa)\frac{b^2}{r} - r - \frac{b^4}{r^3}\right\}\sin 2\theta,
///     \qquad \kappa = \frac{3-\nu_0}{1+\nu_0},\ G = \frac{E_0}{2(1+\nu_0)}
///     \end{aligned} \tag{4.8} \f]
/// \return \f$u_1, u_2\f$ [length]
inline Vector displacement(const elastostatics::Material& of, const Shape& shape, const Point<2>& x) {
    const double nu0 = elastostatics::nu0(of), G = elastostatics::E0(of) / (2 * (1 + nu0));
    const double kappa = (3 - nu0) / (1 + nu0);
    const double r = x.norm(), theta = std::atan2(x[1], x[0]), q = shape.b * shape.b / r, q3 = q * q / r;
    const double c = std::cos(2 * theta);
    const double u_r = r * ((kappa - 1) / 2 + c) + q * (1 + (1 + kappa) * c) - q3 * c;
    const double u_theta = ((1 - kappa) * q - r - q3) * std::sin(2 * theta);
    return sigma_0 / (4 * G * r) * Vector(x[0] * u_r - x[1] * u_theta, x[1] * u_r + x[0] * u_theta);
}

/// Displacement and stress along the x2-axis: at the hole the stress is three times the tension. \defeq{B4.10}
/// \f[ u_2\big|_{\theta=\pi/2} = \frac{\sigma_0}{4G}\left\{r\,\frac{\kappa-3}{2} - \kappa\frac{b^2}{r} + \frac{b^4}{r^3}\right\}, \qquad
///     \frac{\sigma_{11}}{\sigma_0}\bigg|_{\theta=\pi/2} = 1 + \frac12\frac{b^2}{r^2} + \frac32\frac{b^4}{r^4} \tag{4.10} \f]
/// \return u2 [length] and σ11/σ0
inline std::array<double, 2> along_x2_axis(const elastostatics::Material& of, const Shape& shape, double r) {
    const double nu0 = elastostatics::nu0(of), G = elastostatics::E0(of) / (2 * (1 + nu0));
    const double kappa = (3 - nu0) / (1 + nu0), q = shape.b * shape.b / (r * r);
    return {sigma_0 / (4 * G) * r * ((kappa - 3) / 2 - kappa * q + q * q), 1 + q / 2 + 3 * q * q / 2};
}

/// \throws base::InvalidInput unless 0 < b < side
inline Shape checked(const Shape& shape) {
    if (!(shape.b > 0 && shape.b < shape.side && std::isfinite(shape.side)))
        throw base::InvalidInput("the hole's radius must lie between 0 and the side " +
                                 base::shown(shape.side) + ", got " + base::shown(shape.b));
    return shape;
}

/// The example problem: symmetry at the two axes, a free hole, and the exact tractions at the outer edges. \defeq{B4.9}
/// \f[ \begin{aligned} u_1 = 0,\ t_2 = 0 &\ \text{on boundary 1 (the}\ x_2\text{-axis)}; & t_1 = t_2 = 0 &\ \text{on boundary 2 (the hole)};
///     \\ t_1 = 0,\ u_2 = 0 &\ \text{on boundary 3 (the}\ x_1\text{-axis)}; & t_1 = \bar t_1,\ t_2 = \bar t_2 &\ \text{on boundaries 4 and 5}
///     \end{aligned} \tag{4.9} \f]
/// \throws base::InvalidInput unless 0 < b < side
inline Problem problem(const elastostatics::Material& material, const Shape& shape) {
    using particles::Arc, particles::Segment;
    const auto [b, side] = checked(shape);
    Problem of{elastostatics::checked(material), {}, {}, {}, side};
    of.sides = {{Segment{{b, 0}, {side, 0}}, {false, true}},
                {Segment{{side, 0}, {side, side}}},
                {Segment{{side, side}, {0, side}}},
                {Segment{{0, side}, {0, b}}, {true, false}},
                {Arc{{0, 0}, b, 0, std::acos(0.0)}}};
    of.exact.u = [material, shape](const Point<2>& x) { return displacement(material, shape, x); };
    of.exact.stress = [shape](const Point<2>& x) { return stress(shape, x); };
    return of;
}

/// The penalty parameter of the print.
inline double penalty(const elastostatics::Material& material) {
    return 1e5 * elastostatics::E0(material) / 3;
}

/// \f$(\ln(r/b), \theta)\f$: a map that keeps angles, so that equal distances there are distances in proportion to r here.
namespace logarithmic {

inline Point<2> place(const Shape& shape, const Point<2>& at) {
    return shape.b * std::exp(at[0]) * Point<2>(std::cos(at[1]), std::sin(at[1]));
}

/// The outer edge.
inline double edge(const Shape& shape, double theta) {
    return std::log(shape.side / (shape.b * std::max(std::cos(theta), std::sin(theta))));
}

}  // namespace logarithmic

namespace detail {

/// The particles on the boundary, in the logarithmic plane, at nearly equal distances.
inline std::vector<Point<2>> boundary_layout(const Shape& shape, Index on_arc) {
    const double quarter = std::acos(0.0), spacing = quarter / static_cast<double>(on_arc - 1);
    const double depth = logarithmic::edge(shape, 0), half_edge = std::asinh(1.0);
    const auto axis = std::max(std::lround(depth / spacing), 1L),
               outer = std::max(std::lround(half_edge / spacing), 1L);
    std::vector<Point<2>> x;
    for (Index i = 0; i < on_arc; ++i) x.emplace_back(0, spacing * static_cast<double>(i));
    for (long k = 1; k <= axis; ++k)
        for (const double theta : {0.0, quarter})
            x.emplace_back(depth * static_cast<double>(k) / static_cast<double>(axis), theta);
    for (long k = 1; k <= outer; ++k) {  // equal distances along an edge, in proportion to r
        const double theta =
            std::atan(std::sinh(half_edge * static_cast<double>(k) / static_cast<double>(outer)));
        x.emplace_back(logarithmic::edge(shape, theta), theta);
        if (k < outer) x.emplace_back(logarithmic::edge(shape, theta), quarter - theta);
    }
    return x;
}

/// Places all over the quarter, equally dense in the logarithmic plane.
inline std::vector<Point<2>> random_places(const Shape& shape, Index count, unsigned long seed) {
    const std::unique_ptr<gsl_rng, void (*)(gsl_rng*)> random(gsl_rng_alloc(gsl_rng_mt19937), gsl_rng_free);
    if (!random) throw std::bad_alloc();
    gsl_rng_set(random.get(), seed);
    std::vector<Point<2>> places;
    while (static_cast<Index>(places.size()) < count) {
        const double depth = gsl_ran_flat(random.get(), 0, logarithmic::edge(shape, std::atan(1.0)));
        const double theta = gsl_ran_flat(random.get(), 0, std::acos(0.0));
        if (depth < logarithmic::edge(shape, theta)) places.emplace_back(depth, theta);
    }
    return places;
}

/// Positions one after the other as those of a cloud.
inline Points<2> columns(const std::vector<Point<2>>& of) {
    Points<2> all(2, static_cast<Index>(of.size()));
    for (std::size_t j = 0; j < of.size(); ++j) all.col(static_cast<Index>(j)) = of[j];
    return all;
}

/// Adds places to some particles until there are N, each as far from all before it as can be.
inline void add_farthest(std::vector<Point<2>>& x, const std::vector<Point<2>>& places, Index N) {
    const Cloud<2> given(columns(x));
    const particles::Cells<2> near(columns(places));
    std::vector<double> away(places.size());  // distance² from the nearest particle
    base::for_each_index(static_cast<Index>(places.size()), [&](Index k) {
        const Point<2>& place = places[static_cast<std::size_t>(k)];
        away[static_cast<std::size_t>(k)] = (place - given.x().col(given.nearest(place))).squaredNorm();
    });
    // As they were when they were looked at last; they only shrink. Of equals the first.
    std::priority_queue<std::pair<double, Index>> farthest;
    for (std::size_t k = 0; k < places.size(); ++k) farthest.emplace(away[k], -static_cast<Index>(k));
    while (static_cast<Index>(x.size()) < N) {
        const auto [seen, minus_k] = farthest.top();
        const auto k = static_cast<std::size_t>(-minus_k);
        farthest.pop();
        if (away[k] < seen) {
            farthest.emplace(away[k], minus_k);
            continue;
        }
        x.push_back(places[k]);
        near.for_each_within(places[k], 1.001 * std::sqrt(seen), [&](int j, double distance_squared) {
            double& of_j = away[static_cast<std::size_t>(j)];
            of_j = std::min(of_j, distance_squared);
        });
    }
}

/// Moves all particles but the first `fixed` to the centres of the places that are nearest to them (Lloyd).
inline void move_to_centres(std::vector<Point<2>>& x, const std::vector<Point<2>>& places,
                            std::size_t fixed) {
    const Cloud<2> cloud(columns(x));
    std::vector<int> nearest(places.size());
    base::for_each_index(static_cast<Index>(places.size()), [&](Index k) {
        nearest[static_cast<std::size_t>(k)] = cloud.nearest(places[static_cast<std::size_t>(k)]);
    });
    std::vector<Point<2>> sum(x.size(), Point<2>::Zero());
    std::vector<int> count(x.size(), 0);
    for (std::size_t k = 0; k < places.size(); ++k) {
        const auto owner = static_cast<std::size_t>(nearest[k]);
        sum[owner] += places[k];
        ++count[owner];
    }
    for (std::size_t j = fixed; j < x.size(); ++j)
        if (count[j] > 0) x[j] = sum[j] / count[j];
}

}  // namespace detail

/// Particles whose distances grow in proportion to r, so many on the hole and so many in all. In the logarithmic plane those of the
/// boundary are spaced evenly; the inner ones start as far from all others as can be, one after the other, and then move to the centres of
/// the places that are nearest to them, again and again (Lloyd). What results is a hexagonal pattern with faults; no
/// curve of the second degree runs through a neighbourhood, so that C is well conditioned.
/// \param draw seed of the places: another draw, another layout of the same kind
/// \throws base::InvalidInput where the boundary needs more particles than there are
inline Points<2> graded_layout(const Shape& shape, Index N, Index on_arc, unsigned long draw) {
    if (on_arc < 3) throw base::InvalidInput("a graded layout needs at least 3 particles on the hole");
    std::vector<Point<2>> x = detail::boundary_layout(shape, on_arc);
    const std::size_t fixed = x.size();
    if (static_cast<Index>(fixed) + 1 > N)
        throw base::InvalidInput("a graded layout with " + std::to_string(on_arc) +
                                 " particles on the hole has " + std::to_string(fixed) +
                                 " on the boundary; take more than " + std::to_string(N) +
                                 " particles in all");
    const std::vector<Point<2>> places = detail::random_places(shape, 60 * N, draw);
    detail::add_farthest(x, places, N);
    constexpr int rounds = 60;
    for (int round = 0; round < rounds; ++round) detail::move_to_centres(x, places, fixed);
    Points<2> layout(2, N);
    for (Index j = 0; j < N; ++j) layout.col(j) = logarithmic::place(shape, x[static_cast<std::size_t>(j)]);
    return layout;
}

/// Particles on rays through the hole's centre, their distances in geometric progression from the hole to the outer edge.
inline Points<2> polar_layout(const Shape& shape, Index rays, Index rings) {
    if (rays < 3 || rings < 3 || rays % 2 == 0)
        throw base::InvalidInput(
            "a polar layout needs at least 3 rings, and an odd number of rays from 3 on");
    Points<2> x(2, rays * rings);
    for (Index i = 0; i < rays; ++i)
        for (Index k = 0; k < rings; ++k) {
            const double theta = std::acos(0.0) * static_cast<double>(i) / static_cast<double>(rays - 1);
            const double depth =
                logarithmic::edge(shape, theta) * static_cast<double>(k) / static_cast<double>(rings - 1);
            x.col(i * rings + k) = logarithmic::place(shape, {depth, theta});
        }
    return x;
}

/// The background mesh of the error norm, in the logarithmic plane: straight triangles there follow the hole exactly.
inline std::vector<example_problems::MeshPoint> mesh(const Shape& shape, Index rays = 40, Index rings = 40) {
    const double quarter = std::acos(0.0);
    const auto at = [=](const Point<2>& unit) {
        const double theta = quarter * unit[1];
        return Point<2>(logarithmic::edge(shape, theta) * unit[0], theta);
    };
    return example_problems::background_mesh(
        rings, rays, [=](const Point<2>& unit) { return logarithmic::place(shape, at(unit)); },
        [=](const Point<2>& unit) {
            const double r = shape.b * std::exp(at(unit)[0]);
            return r * r * quarter * logarithmic::edge(shape, at(unit)[1]);
        });
}

/// Largest deviations of the displacements at the particles from the exact ones. [length]
inline Vector largest_deviations(const Cloud<2>& cloud, const example_problems::Solution& solution,
                                 const Problem& problem) {
    Vector largest = Vector::Zero();
    for (Index I = 0; I < cloud.size(); ++I) {
        const Point<2> x = cloud.x().col(I);
        const Vector deviation = example_problems::state_at(cloud, solution, x).u - problem.exact.u(x);
        largest = largest.cwiseMax(deviation.cwiseAbs());
    }
    return largest;
}

/// σ11/σ0 at the top of the hole, 3 for the exact solution.
inline double stress_concentration(const Cloud<2>& cloud, const example_problems::Solution& solution,
                                   const Shape& shape) {
    return example_problems::state_at(cloud, solution, {0, shape.b}).stress[0] / sigma_0;
}

}  // namespace hole
}  // namespace batra2008
