#pragma once

#include <array>

namespace particles {

/// A point of a quadrature rule on a triangle.
struct TrianglePoint {
    std::array<double, 3> barycentric;  ///< coordinates, which sum to one
    double weight;                      ///< share of the area
};

/// Cowper's rule with 13 points, exact on polynomials of degree 7. The weights sum to one. Source: G. R.
/// Cowper (1973), Gaussian quadrature formulas for triangles, Int. J. Numer. Meth. Eng. 7, 405–408.
std::array<TrianglePoint, 13> triangle_rule();

}  // namespace particles
