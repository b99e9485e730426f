#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/text.hpp"
#include "batra2008/section_4_example_problems.hpp"
#include "particles/layouts.hpp"

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
/// \eq{B4.7} and \eq{B4.8} are damaged in the available text; here is Kirsch's solution, which the tests
/// prove: equilibrium, Hooke's law, no traction at the hole. The positions of the particles are lost with the
/// print's figures; graded_layout() and polar_layout() take their place. At a corner, the displacement of a
/// component is given if one of its sides gives it; otherwise the traction of the side that faces that
/// component is given.
///
/// \image html batra2008_figure_14.svg "Boundaries and 188 particles."
/// \image html batra2008_figure_15.svg "The exact displacements, and the deviations of the three methods."
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
using Shape = particles::QuarterWithHole;
using particles::graded_layout;
using particles::polar_layout;

/// Kirsch's stresses around a hole in a plate under tension along \f$x_1\f$, in polar coordinates.
/// \defeq{B4.7}
/// \f[ \begin{aligned}
///     \sigma_{rr} &= \frac{\sigma_0}{2}\left(1 - \frac{b^2}{r^2}\right) + \frac{\sigma_0}{2}\left(1
///            + 3\frac{b^4}{r^4} - 4\frac{b^2}{r^2}\right)\cos 2\theta
///     \\ \sigma_{\theta\theta} &= \frac{\sigma_0}{2}\left(1 + \frac{b^2}{r^2}\right)
///            - \frac{\sigma_0}{2}\left(1 + 3\frac{b^4}{r^4}\right)\cos 2\theta
///     \\ \sigma_{r\theta} &= -\frac{\sigma_0}{2}\left(1 - 3\frac{b^4}{r^4}
///            + 2\frac{b^2}{r^2}\right)\sin 2\theta
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
///     u_r &= \frac{\sigma_0}{4G}\left\{r\left[\frac{\kappa-1}{2} + \cos 2\theta\right]
///            + \frac{b^2}{r}\left[1 + (1+\kappa)\cos 2\theta\right]
///            - \frac{b^4}{r^3}\cos 2\theta\right\}
///     \\ u_\theta &= \frac{\sigma_0}{4G}\left\{(1-\kappa)\frac{b^2}{r} - r
///            - \frac{b^4}{r^3}\right\}\sin 2\theta,
///     \qquad \kappa = \frac{3-\nu_0}{1+\nu_0},\ G = \frac{E_0}{2(1+\nu_0)}
///     \end{aligned} \tag{4.8} \f]
/// \return \f$u_1, u_2\f$ [length]
inline Vector displacement(const elastostatics::Material& material, const Shape& shape, const Point<2>& x) {
    const double nu0 = elastostatics::nu0(material), G = elastostatics::E0(material) / (2 * (1 + nu0));
    const double kappa = (3 - nu0) / (1 + nu0);
    const double r = x.norm(), theta = std::atan2(x[1], x[0]), q = shape.b * shape.b / r, q3 = q * q / r;
    const double c = std::cos(2 * theta);
    const double u_r = r * ((kappa - 1) / 2 + c) + q * (1 + (1 + kappa) * c) - q3 * c;
    const double u_theta = ((1 - kappa) * q - r - q3) * std::sin(2 * theta);
    return sigma_0 / (4 * G * r) * Vector(x[0] * u_r - x[1] * u_theta, x[1] * u_r + x[0] * u_theta);
}

/// \throws base::InvalidInput unless 0 < b < side
inline Shape checked(const Shape& shape) {
    if (!(shape.b > 0 && shape.b < shape.side && std::isfinite(shape.side)))
        throw base::InvalidInput("the hole's radius must lie between 0 and the side " +
                                 base::shown(shape.side) + ", got " + base::shown(shape.b));
    return shape;
}

/// The example problem: symmetry at the two axes, a free hole, and the exact tractions at the outer edges.
/// \defeq{B4.9}
/// \f[ \begin{aligned}
///     u_1 &= 0, & t_2 &= 0 && \text{on boundary 1 (the}\ x_2\text{-axis)};
///     \\ t_1 &= 0, & t_2 &= 0 && \text{on boundary 2 (the hole)};
///     \\ t_1 &= 0, & u_2 &= 0 && \text{on boundary 3 (the}\ x_1\text{-axis)};
///     \\ t_1 &= \bar t_1, & t_2 &= \bar t_2 && \text{on boundaries 4 and 5}
///     \end{aligned} \tag{4.9} \f]
/// \throws base::InvalidInput unless 0 < b < side
inline Problem problem(const elastostatics::Material& material, const Shape& shape) {
    using particles::Arc, particles::Segment;
    const auto [b, side] = checked(shape);
    Problem problem{elastostatics::checked(material), {}, {}, {}, side};
    problem.sides = {{Segment{{b, 0}, {side, 0}}, {false, true}},
                     {Segment{{side, 0}, {side, side}}},
                     {Segment{{side, side}, {0, side}}},
                     {Segment{{0, side}, {0, b}}, {true, false}},
                     {Arc{{0, 0}, b, 0, std::acos(0.0)}}};
    problem.exact.u = [material, shape](const Point<2>& x) { return displacement(material, shape, x); };
    problem.exact.stress = [shape](const Point<2>& x) { return stress(shape, x); };
    return problem;
}

/// Displacement and stress along the x2-axis: at the hole the stress is three times the tension.
/// \defeq{B4.10}
/// \f[ u_2\big|_{\theta=\pi/2} = \frac{\sigma_0}{4G}\left\{r\,\frac{\kappa-3}{2} - \kappa\frac{b^2}{r}
///     + \frac{b^4}{r^3}\right\}, \qquad
///     \frac{\sigma_{11}}{\sigma_0}\bigg|_{\theta=\pi/2} = 1 + \frac12\frac{b^2}{r^2}
///     + \frac32\frac{b^4}{r^4} \tag{4.10} \f]
/// \return u2 [length] and σ11/σ0
inline std::array<double, 2> along_x2_axis(const elastostatics::Material& material, const Shape& shape,
                                           double r) {
    const double nu0 = elastostatics::nu0(material), G = elastostatics::E0(material) / (2 * (1 + nu0));
    const double kappa = (3 - nu0) / (1 + nu0), q = shape.b * shape.b / (r * r);
    return {sigma_0 / (4 * G) * r * ((kappa - 3) / 2 - kappa * q + q * q), 1 + q / 2 + 3 * q * q / 2};
}

/// The penalty parameter of the print.
inline double penalty(const elastostatics::Material& material) {
    return 1e5 * elastostatics::E0(material) / 3;
}

/// The background mesh of the error norm, in the logarithmic plane: straight triangles there follow the hole
/// exactly.
inline std::vector<example_problems::MeshPoint> mesh(const Shape& shape, Index rays = 40, Index rings = 40) {
    const double quarter = std::acos(0.0);
    const auto at = [=](const Point<2>& unit) {
        const double theta = quarter * unit[1];
        return Point<2>(particles::logarithmic::edge(shape, theta) * unit[0], theta);
    };
    return example_problems::background_mesh(
        rings, rays, [=](const Point<2>& unit) { return particles::logarithmic::place(shape, at(unit)); },
        [=](const Point<2>& unit) {
            const double r = shape.b * std::exp(at(unit)[0]);
            return r * r * quarter * particles::logarithmic::edge(shape, at(unit)[1]);
        });
}

/// The largest deviation of a displacement from the exact one, and where it is. [length]
struct Deviation {
    double size = 0;
    Point<2> x = Point<2>::Zero();
};

/// The largest deviations at the particles, of u1 and of u2.
template <class Solution>
std::array<Deviation, 2> largest_deviations(const Cloud<2>& cloud, const Solution& solution,
                                            const Problem& problem) {
    std::array<Deviation, 2> largest;
    for (Index I = 0; I < cloud.size(); ++I) {
        const Point<2> x = cloud.x().col(I);
        const Vector deviation = state_at(cloud, solution, x).u - problem.exact.u(x);
        for (std::size_t i = 0; i < 2; ++i)
            if (const double size = std::abs(deviation[static_cast<Index>(i)]); size > largest[i].size)
                largest[i] = {size, x};
    }
    return largest;
}

/// The largest deviations from the exact solution at 101 places along the x2-axis, as Figures 16 and 17 show
/// them.
/// \return of u2 [length] and of σ11/σ0
template <class Solution>
std::array<double, 2> largest_deviations_on_axis(const Cloud<2>& cloud, const Solution& solution,
                                                 const Problem& problem, const Shape& shape) {
    std::array<double, 2> largest{};
    for (int k = 0; k <= 100; ++k) {
        const double r = shape.b + (shape.side - shape.b) * k / 100.0;
        const auto [u, stress] = state_at(cloud, solution, {0, r});
        const auto [u2, s11] = along_x2_axis(problem.material, shape, r);
        largest[0] = std::max(largest[0], std::abs(u[1] - u2));
        largest[1] = std::max(largest[1], std::abs(stress[0] / sigma_0 - s11));
    }
    return largest;
}

/// σ11/σ0 at the top of the hole, 3 for the exact solution.
template <class Solution>
double stress_concentration(const Cloud<2>& cloud, const Solution& solution, const Shape& shape) {
    return state_at(cloud, solution, {0, shape.b}).stress[0] / sigma_0;
}

}  // namespace hole
}  // namespace batra2008
