#pragma once

#include <cstddef>
#include <vector>

#include "bodies/mesh_boundary.hpp"

namespace bodies {

/// A facet of the boundary and one of its corners.
struct FacetCorner {
    std::size_t facet, corner;
};

/// The normals at a node where facets of one side meet. Sets the normals of the shape at the facets' corners
/// there. \return the normals, similar ones merged
template <int dim>
std::vector<Point<dim>> normals_at(const Mesh<dim>& mesh, std::vector<Outer<dim>>& outer,
                                   const std::vector<FacetCorner>& corners);

/// The distance between a facet and the shape, from the turn of the shape's normal along the edges: half way
/// along an edge of length L with a turn by θ it is Lθ/8, and in the middle of a triangle 4/9 of the sum.
template <int dim>
double gap_at(const Mesh<dim>& mesh, const Outer<dim>& one);

}  // namespace bodies
