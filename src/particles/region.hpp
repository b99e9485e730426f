#pragma once

#include <array>
#include <variant>
#include <vector>

#include "base/index.hpp"
#include "particles/points.hpp"

namespace particles {

using base::Index;

/// A straight part of a boundary; the region lies to its left, seen along the way from one end to the other.
struct Segment {
    Point<2> from, to;
};

/// A part of the edge of a circular hole, between two angles, the smaller one first [radian].
struct Arc {
    Point<2> centre;
    double radius, from, to;
};

/// A smooth part of the boundary of a region.
using Curve = std::variant<Segment, Arc>;

/// A convex polygon with circular holes, which may cut its corners and sides.
using Region = std::vector<Curve>;

/// Share of a body's size below which a length counts as zero: positions may come from a file with ten
/// digits.
constexpr double negligible = 1e-8;

/// A point of a quadrature rule over an area or along a boundary.
struct QuadraturePoint {
    Point<2> x;
    double weight;
    Point<2> normal = Point<2>::Zero();  ///< unit outward normal, on a boundary
};

/// Unit outward normal of a boundary at a place on it.
Point<2> normal_at(const Curve& curve, const Point<2>& x);

/// Both ends of a part of the boundary.
std::array<Point<2>, 2> ends(const Curve& curve);

/// The point of a part of the boundary that is nearest to a place.
Point<2> closest(const Curve& curve, const Point<2>& x);

/// Does a place lie on a part of the boundary, its ends included? \param size a length of the body
bool lies_on(const Curve& curve, const Point<2>& x, double size);

/// Is a place one of the ends of a part of the boundary? \param size a length of the body
bool lies_at_end(const Curve& curve, const Point<2>& x, double size);

/// Does a place lie beyond a side's line, or in a hole? \param size a length of the body
bool lies_beyond(const Curve& curve, const Point<2>& x, double size);

/// Does a place lie in the region or on its boundary?
bool contains(const Region& region, const Point<2>& x, double size);

/// Gauss rule in polar coordinates over the part of a disc that lies in the region. The angles of rays that
/// meet the region are cut into pieces on which the boundary is smooth: a whole disc, a half at a side and a
/// quarter at a corner are one piece. Each piece has its share of the angular points.
/// \param x centre, in the region
/// \param reach radius of the disc
/// \param radial number of points along a ray
/// \param angular number of points over all these angles
/// \return points with weights that sum to the area
std::vector<QuadraturePoint> polar_rule(const Region& region, const Point<2>& x, double reach, Index radial,
                                        Index angular);

/// Gauss rule along the part of a boundary that lies in a disc.
/// \param x centre of the disc
/// \return points with normals and weights that sum to the length
std::vector<QuadraturePoint> boundary_rule(const Curve& curve, const Point<2>& x, double reach, Index points);

}  // namespace particles
