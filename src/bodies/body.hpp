#pragma once

#include <array>
#include <string>
#include <type_traits>
#include <vector>

#include "base/index.hpp"
#include "particles/points.hpp"
#include "particles/region.hpp"

/// Boundary-value problems on a body of the reader's: any shape in the plane or in space, with named sides.
namespace bodies {

using base::Index;
using particles::Point;
using particles::Points;

/// A flat piece of a surface in space. Seen from outside, its corners run counter-clockwise.
struct Triangle {
    std::array<Point<3>, 3> corners;
};

/// A piece of the boundary: in the plane a segment or an arc, with the body to its left; in space a triangle.
template <int dim>
using Piece = std::conditional_t<dim == 2, particles::Curve, Triangle>;

/// A particle on the boundary, and the unit outward normal there. A particle at a corner has several places.
template <int dim>
struct Place {
    int particle;
    Point<dim> normal;
};

/// A named part of the boundary.
template <int dim>
struct Side {
    std::string name;
    std::vector<Piece<dim>> pieces;
    std::vector<Place<dim>> places;
};

/// A body: its particles and its boundary.
template <int dim>
struct Body {
    Points<dim> x;                                  ///< positions, a column for each particle [length]
    std::vector<Side<dim>> sides;                   ///< all of the boundary, each part once
    std::vector<std::array<int, dim + 1>> cells{};  ///< triangles or tetrahedra, for drawings only
    double gap = 0;  ///< largest distance between the pieces and the shape that was meant [length]
};

/// Whether a side is what remains of the boundary when all names are given: it can carry no condition.
inline bool is_unnamed(const std::string& name) {
    return name.empty();
}

}  // namespace bodies
