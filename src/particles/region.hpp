#pragma once

#include <Eigen/Geometry>
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

/// A part of a circle, between two angles, the smaller one first [radian]. The region lies outside of the
/// circle, as around a hole, or within it, as in a disc.
struct Arc {
    Point<2> centre;
    double radius = 0, from = 0, to = 0;
    bool bulges = false;  ///< outward: the region lies within the circle
};

/// A smooth part of the boundary of a region.
using Curve = std::variant<Segment, Arc>;

/// A part of the plane, by its boundary: closed loops of curves, of which none meets another or itself.
using Region = std::vector<Curve>;

/// A rectangle along the axes.
using Box = Eigen::AlignedBox<double, 2>;

/// Share of a body's size below which a length counts as zero: positions may come from a file with ten
/// digits.
constexpr double negligible = 1e-8;

/// The unit vector at an angle. [radian]
Point<2> direction(double angle);

/// The angle of a vector, from −π to π. [radian]
double angle_of(const Point<2>& v);

/// Unit outward normal of a boundary at a place on it.
Point<2> normal_at(const Curve& curve, const Point<2>& x);

/// Both ends of a part of the boundary; of an arc, that at the smaller angle first.
std::array<Point<2>, 2> ends(const Curve& curve);

/// The same in the order in which they are passed with the region to the left.
std::array<Point<2>, 2> way(const Curve& curve);

/// Does an arc pass through the point of its circle at an angle?
bool holds(const Arc& arc, double angle);

/// The point of a part of the boundary that is nearest to a place.
Point<2> closest(const Curve& curve, const Point<2>& x);

/// The smallest rectangle around a part of the boundary.
Box box(const Curve& curve);

/// Does a place lie on a part of the boundary, its ends included? \param size a length of the body
bool lies_on(const Curve& curve, const Point<2>& x, double size);

/// Is a place one of the ends of a part of the boundary? \param size a length of the body
bool lies_at_end(const Curve& curve, const Point<2>& x, double size);

}  // namespace particles
