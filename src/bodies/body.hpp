#pragma once

#include <array>
#include <string>
#include <type_traits>
#include <vector>

#include "base/index.hpp"
#include "particles/points.hpp"
#include "particles/region.hpp"

/// Boundary-value problems on a user's body: any shape in the plane or in space, with named sides.
///
/// A Problem on a Body has n unknowns at each particle, a displacement or one scalar. Its Equation is a
/// balance,
/// \f[ \sum_a \partial_a F_{ia} + b_i = c\,u_i, \qquad F_{ia} = \sum_{jb} A_{ia,jb}\,\partial_b u_j, \f]
/// and on a side each component has a given value, or a Given load \f$\sum_a F_{ia} n_a = t_i\f$. solve()
/// makes one linear system of it, n rows for each particle, by a Method:
///
/// | | inside | on the boundary |
/// | --- | --- | --- |
/// | `fpm`, `strong` | the balance at the particle | value or load at the particle |
/// | `weak1`, `weak2` | the balance, weighted on a disc | loads as integrals, values by a penalty |
/// | `hats` | the balance, weighted by a hat of the cells | loads as integrals, values at the particle |
///
/// state_at() has the solution anywhere, judgement() the loads and reactions, eigenvalues() the lowest modes,
/// and extrapolated() the error bar from three clouds.
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
    int particle = 0;
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
    std::vector<std::array<int, dim + 1>> cells{};  ///< triangles or tetrahedra; empty without a mesh
    double gap = 0;  ///< largest distance between the pieces and the true shape, estimated [length]
};

/// The side of this name. \throws base::InvalidInput with the names of all sides
template <int dim>
const Side<dim>& side_named(const Body<dim>& body, const std::string& name);

/// Whether a side is the rest of the boundary, which has no name and can carry no condition.
inline bool is_unnamed(const std::string& name) {
    return name.empty();
}

}  // namespace bodies
