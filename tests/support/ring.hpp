#pragma once

#include <cmath>

#include "tests/support/bodies.hpp"

/// A thick ring under pressure, whose stresses are those of Lamé.
namespace support {

/// Its radii, and the pressure from within.
inline constexpr double inner = 1, outer = 2, pressure = 3;

/// A quarter of the ring, between planes of symmetry. Its left side is the hole.
inline Body<2> quarter_ring(int n) {
    return block<2>({{n, 2 * n}, 0, 1, [](const Point<2>& s) {
                         const double r = inner * std::pow(outer / inner, s[0]), angle = std::acos(0) * s[1];
                         return Point<2>(r * std::cos(angle), r * std::sin(angle));
                     }});
}

inline Problem<2, 2> lame() {
    Problem<2, 2> problem{bodies::elasticity<2>({5, 0.3, batra2008::elastostatics::Plane::strain})};
    problem.given = {{"left"}, {"bottom"}, {"top"}};
    problem.given[0].loads.push_back(
        [](const Point<2>&, const Point<2>& n) { return Values<2>(-pressure * n); });
    problem.given[1].symmetry = problem.given[2].symmetry = true;
    return problem;
}

}  // namespace support
