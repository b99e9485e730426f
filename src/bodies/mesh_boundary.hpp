#pragma once

#include <vector>

#include "bodies/mesh_geometry.hpp"

namespace bodies {

/// A facet of the boundary, the body to its left or behind it.
template <int dim>
struct Outer {
    Nodes<dim> nodes;
    int patch = -1;                           ///< that it belongs to; -1 for none
    Edges<dim> normals = Edges<dim>::Zero();  ///< of the shape, a column for each node
};

/// The boundary of a mesh: the facets of one cell only, by increasing nodes.
/// \throws base::InvalidInput for a facet with two cells on one side; for one behind which lies a cell that
///         does not share it; for a named facet inside the body or on no cell; for a facet with two names;
///         and for a part without a name where others have one
template <int dim>
std::vector<Outer<dim>> boundary_of(const Mesh<dim>& mesh);

}  // namespace bodies
