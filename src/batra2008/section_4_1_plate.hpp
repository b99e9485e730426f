#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "base/choose.hpp"
#include "batra2008/section_4_example_problems.hpp"

namespace batra2008 {

/// Section 4.1, plane stress of a plate that is held at its left edge and sheared at its right edge. Tables 1
/// and 2, Figures 3 to 12.
///
/// | paper | code | meaning |
/// | --- | --- | --- |
/// | \f$L_1, L_2\f$ | `L1`, `L2` | length and width, 1 m and 0.2 m |
/// | \f$F_0\f$ | `F0` | 10⁶, in N; a force per unit thickness |
/// | \f$E, \nu\f$ | `E`, `nu` | 226.9 GPa and 0.33 |
/// | \f$\alpha\f$ | `penalty` | 10⁵ E0/L1 |
///
/// A particle at a corner belongs to two edges, and collocation takes two of its four conditions. The print
/// numbers the corners clockwise: 1 north-east, 2 south-east, 3 south-west, 4 north-west. Its Table 1 varies
/// corner 3 alone, its Table 2 corner 1 alone; otherwise the displacements are given at 3 and 4, and σ11 =
/// σ22 = 0 at 1 and 2. The largest error of 19.51 % belongs to these conditions, although the text announces
/// σ11 = σ12 = 0 for all results after Table 2.
///
/// \image html batra2008_figure_4.svg "The plate as it deforms, displacements a hundred times enlarged, and the stress in it."
/// \image html batra2008_figure_5.svg "Displacement of the bottom edge."
/// \image html batra2008_figure_6.svg "Axial stress along the top edge."
/// \image html batra2008_figure_7.svg "The same displacement where Poisson's ratio is nearly one half."
/// \image html batra2008_figure_8.svg "Error against the number of Gauss points."
/// \image html batra2008_figure_9.svg "Error against the scaling factor."
/// \image html batra2008_figure_10.svg "Monomials of degree 1 and 2."
/// \image html batra2008_figure_11.svg "Finer grids."
/// \image html batra2008_figure_12.svg "Convergence."
///
/// What this section claims, and what was measured: \claims{B-4.1}.
namespace plate {

constexpr double L1 = 1, L2 = 0.2;        // [m]
constexpr double F0 = 1e6;                // [N]
constexpr double E = 226.9e9, nu = 0.33;  // [Pa]

/// The boundary conditions: the displacement is given at the left, the traction elsewhere. \defeq{B4.1}
/// \f[ \begin{aligned}
///     u_1 &= \bar u_1, & u_2 &= \bar u_2 && \text{on the left};
///     \\ t_1 &= 0, & t_2 &= 0 && \text{at the bottom and the top};
///     \\ t_1 &= \bar t_1, & t_2 &= \bar t_2 && \text{on the right}
///     \end{aligned} \tag{4.1} \f]
/// \return bottom, right, top and left; \f$\bar u\f$ and \f$\bar t\f$ are those of \eq{B4.2} and \eq{B4.3}
inline std::vector<elastostatics::Side> sides() {
    using particles::Segment;
    return {{Segment{{0, 0}, {L1, 0}}},
            {Segment{{L1, 0}, {L1, L2}}},
            {Segment{{L1, L2}, {0, L2}}},
            {Segment{{0, L2}, {0, 0}}, {true, true}}};
}

/// The exact displacement. \defeq{B4.2}
/// \f[ \begin{aligned}
///     u_1 &= -\frac{2F_0}{E_0}\left(\frac{x_2}{L_2}
///            - 0.5\right)\left[3\frac{x_1}{L_2}\left(2\frac{L_1}{L_2} - \frac{x_1}{L_2}\right)
///            + (2+\nu_0)\frac{x_2}{L_2}\left(\frac{x_2}{L_2} - 1\right)\right],
///     \\ u_2 &= \frac{2F_0}{E_0}\left[\left(\frac{x_1}{L_2}\right)^2\left(3\frac{L_1}{L_2}
///            - \frac{x_1}{L_2}\right)
///            + 3\nu_0\left(\frac{L_1}{L_2} - \frac{x_1}{L_2}\right)\left(\frac{x_2}{L_2} - 0.5\right)^2
///            + \frac{4+5\nu_0}{4}\frac{x_1}{L_2}\right]
///     \end{aligned} \tag{4.2} \f]
/// \return [length]
inline Vector displacement(const elastostatics::Material& material, const Point<2>& x) {
    const double E0 = elastostatics::E0(material), nu0 = elastostatics::nu0(material);
    const double x1 = x[0] / L2, x2 = x[1] / L2, l = L1 / L2, y = x2 - 0.5;
    return {-2 * F0 / E0 * y * (3 * x1 * (2 * l - x1) + (2 + nu0) * x2 * (x2 - 1)),
            2 * F0 / E0 * (x1 * x1 * (3 * l - x1) + 3 * nu0 * (l - x1) * y * y + (4 + 5 * nu0) / 4 * x1)};
}

/// The exact stress: bending that decreases linearly, a parabolic shear, and no stress across. \defeq{B4.3}
/// \f[ \begin{bmatrix} \sigma_{11} \\ \sigma_{22} \\ \sigma_{12} \end{bmatrix} = \begin{bmatrix}
///     -12\frac{F_0}{L_2}\left(\frac{L_1}{L_2} - \frac{x_1}{L_2}\right)\left(\frac{x_2}{L_2} - 0.5\right)
///     \\ 0
///     \\ -6\frac{F_0}{L_2}\frac{x_2}{L_2}\left(\frac{x_2}{L_2} - 1\right) \end{bmatrix} \tag{4.3} \f]
inline Stress stress(const Point<2>& x) {
    const double x1 = x[0] / L2, x2 = x[1] / L2, l = L1 / L2;
    return F0 / L2 * Stress(-12 * (l - x1) * (x2 - 0.5), 0, -6 * x2 * (x2 - 1));
}

/// The conditions from which the particle at corner 3 takes two. \defeq{B4.5}
/// \f[ u_1 = \bar u_1,\ u_2 = \bar u_2\ \text{(left)}; \quad t_1 = 0,\ t_2 = 0\ \text{(bottom)} \tag{4.5} \f]
/// \return the pairs in the order of Table 1; the bottom's tractions are −σ12 and −σ22
inline std::array<std::array<std::string, 2>, 6> choices_at_corner_3() {
    return {{{"u1", "u2"}, {"u1", "s12"}, {"u1", "s22"}, {"u2", "s22"}, {"u2", "s12"}, {"s12", "s22"}}};
}

/// The conditions from which the particle at corner 1 takes two; σ12 and σ21 are the same. \defeq{B4.6}
/// \f[ \sigma_{21} = 0,\ \sigma_{22} = 0\ \text{(top)};
///     \quad \sigma_{11} = 0,\ \sigma_{12} = 0\ \text{(right)} \tag{4.6} \f]
/// \return the pairs in the order of Table 2
inline std::array<std::array<std::string, 2>, 3> choices_at_corner_1() {
    return {{{"s11", "s12"}, {"s12", "s22"}, {"s11", "s22"}}};
}

/// A condition at a corner by its name: u1, u2, s11, s22 or s12.
/// \throws base::InvalidInput for another name
inline elastostatics::Condition condition_named(std::string_view wanted) {
    return base::choose<elastostatics::Condition>("condition", wanted,
                                                  {{"u1", {true, 0}},
                                                   {"u2", {true, 1}},
                                                   {"s11", {false, 0, Vector::UnitX()}},
                                                   {"s22", {false, 1, Vector::UnitY()}},
                                                   {"s12", {false, 1, Vector::UnitX()}}});
}

/// The names of the two conditions at each corner, in the print's order.
using Corners = std::array<std::array<std::string, 2>, 4>;
inline Corners default_corners() {
    return {{{"s11", "s22"}, {"s11", "s22"}, {"u1", "u2"}, {"u1", "u2"}}};
}

/// The example problem: the conditions \eq{B4.1} with values from the exact solution; each corner takes two
/// of the conditions of its sides.
inline Problem problem(const elastostatics::Material& material, const Corners& corners = default_corners()) {
    Problem problem{elastostatics::checked(material), sides(), {}, {}, L1};
    const std::array<Point<2>, 4> at{Point<2>(L1, L2), Point<2>(L1, 0), Point<2>(0, 0), Point<2>(0, L2)};
    for (std::size_t k = 0; k < 4; ++k) {
        if (corners[k][0] == corners[k][1])
            throw base::InvalidInput("corner " + std::to_string(k + 1) + " needs two different conditions");
        problem.corners.push_back({at[k], {condition_named(corners[k][0]), condition_named(corners[k][1])}});
    }
    problem.exact.u = [material](const Point<2>& x) { return displacement(material, x); };
    problem.exact.stress = [](const Point<2>& x) { return stress(x); };
    return problem;
}

/// nx × ny particles at equal distances, column by column from the left.
/// \throws base::InvalidInput for fewer than two in a direction
inline Points<2> grid(Index nx, Index ny) {
    if (nx < 2 || ny < 2)
        throw base::InvalidInput("a grid needs at least 2x2 particles, got " + std::to_string(nx) + "x" +
                                 std::to_string(ny));
    Points<2> x(2, nx * ny);
    for (Index i = 0; i < nx; ++i)
        for (Index j = 0; j < ny; ++j)
            x.col(i * ny + j) << L1 * static_cast<double>(i) / static_cast<double>(nx - 1),
                L2 * static_cast<double>(j) / static_cast<double>(ny - 1);
    return x;
}

/// The background mesh of the error norm: triangles between the particles of a grid.
inline std::vector<example_problems::MeshPoint> mesh(Index nx, Index ny) {
    return example_problems::background_mesh(
        nx - 1, ny - 1, [](const Point<2>& at) { return Point<2>(L1 * at[0], L2 * at[1]); },
        [](const Point<2>&) { return L1 * L2; });
}

/// The penalty parameter of the print.
inline double penalty(const elastostatics::Material& material) {
    return 1e5 * elastostatics::E0(material) / L1;
}

/// Largest error of u2 at the particles of the bottom edge, in percent of the largest displacement there.
template <class Solution>
double largest_error_u2(const Cloud<2>& cloud, const Solution& solution, const Problem& problem) {
    double error = 0, largest = 0;
    for (Index I = 0; I < cloud.size(); ++I) {
        const Point<2> x = cloud.x().col(I);
        if (!particles::lies_on(problem.sides.front().curve, x, problem.size)) continue;
        const double exact = problem.exact.u(x)[1];
        error = std::max(error, std::abs(state_at(cloud, solution, x).u[1] - exact));
        largest = std::max(largest, std::abs(exact));
    }
    return 100 * error / largest;
}

}  // namespace plate
}  // namespace batra2008
