#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "bodies/body.hpp"

namespace bodies {

/// A part of the boundary of a mesh that has one name, such as the facets on a curve of the drawing.
template <int dim>
struct Patch {
    int number = 0;                  ///< of the curve or the surface in the drawing, for messages
    std::vector<std::string> sides;  ///< names of its physical groups; more than one is refused
    std::vector<std::array<int, dim>> facets;
    std::map<int, Point<dim>> normals{};  ///< of its nodes, where the shape is known; of either sign
};

/// A mesh of a body as its file has it.
template <int dim>
struct Mesh {
    Points<dim> x;
    std::vector<std::array<int, dim + 1>> cells;
    std::vector<Patch<dim>> patches;
};

/// \throws base::InvalidInput for a mesh without cells, positions that are not finite, and a cell without
///         area or volume
template <int dim>
void check_cells(const Mesh<dim>& mesh);

/// The body that a mesh fills. Its particles are the nodes of the cells, neighbours near to each other in
/// memory; its boundary is the facets of one cell only. A place has the normal of the shape where that is
/// known. Elsewhere it is the mean over the pieces that meet there at less than 40 degrees, with the weights
/// of N. Max, "Weights for computing vertex normals from facet normals", J. Graphics Tools 4 (1999), which
/// are exact on a circle and on a sphere. Normals of one side at a particle that differ by less than 20
/// degrees are one place with their mean. A mesh whose patches have no name has one side, "boundary".
/// \throws base::InvalidInput with the place and a remedy: for a mesh without cells; positions that are not
///         finite; a cell without area or volume; nodes in cells that are not theirs, as where parts overlap
///         or touch without common nodes; a facet with two cells on one side; a named facet inside the body
///         or on no cell; a facet with two names; a boundary of which only parts have names
template <int dim>
Body<dim> body_of(const Mesh<dim>& mesh);

}  // namespace bodies
