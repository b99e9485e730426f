#pragma once

#include <vector>

#include "base/index.hpp"
#include "particles/boundary.hpp"
#include "particles/points.hpp"
#include "particles/region.hpp"

namespace particles {

/// A point of a quadrature rule over an area or along a boundary.
struct QuadraturePoint {
    Point<2> x;
    double weight;
    Point<2> normal = Point<2>::Zero();  ///< unit outward normal, on a boundary
};

/// Gauss rule in polar coordinates over the part of a disc that lies in the region, also beyond a gap or
/// behind a hole. The angles of rays that meet the region are cut into pieces on which the boundary is
/// smooth: a whole disc, a half at a side and a quarter at a corner are one piece. Each piece has its share
/// of the angular points. A ray that meets the region several times has all radial points in each part of it.
/// \param x centre, in the region or on its boundary
/// \param reach radius of the disc
/// \param radial number of points along a ray
/// \param angular number of points over all these angles
/// \return points with weights that sum to the area
std::vector<QuadraturePoint> polar_rule(const Boundary& boundary, const Point<2>& x, double reach,
                                        Index radial, Index angular);

/// Gauss rule along the part of a boundary that lies in a disc.
/// \param x centre of the disc
/// \return points with normals and weights that sum to the length
std::vector<QuadraturePoint> boundary_rule(const Curve& curve, const Point<2>& x, double reach, Index points);

}  // namespace particles
