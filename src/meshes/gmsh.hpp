#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "bodies/body.hpp"

/// Bodies from drawings and meshes.
namespace meshes {

/// A body in the plane or in space, and what was made of its file.
struct Model {
    std::variant<bodies::Body<2>, bodies::Body<3>> body;
    std::vector<std::string> notes;  ///< sentences for the first lines of a table
};

/// Reads what Gmsh reads: a drawing, such as .geo or .step, which is meshed, or a mesh, such as .msh.
/// Surfaces in a plane z = const are a body in the plane, volumes one in space; if some of them are in
/// physical groups, only those. The nodes are the particles, the physical groups of curves or surfaces the
/// sides. Elements of second order count by their corners. Drawings are meshed by triangles and tetrahedra,
/// the same each time.
/// \param size of the cells of a drawing, in place of all sizes in the drawing [length]; else those hold
/// \throws base::InvalidInput in one line with the file, the cause and a remedy: for a file that cannot be
///         read or meshed, in Gmsh's words; for a size that is not positive, gives more than 5 million
///         particles or comes with a mesh; for a mesh of the wrong dimension or with other cells than
///         triangles, quadrangles and tetrahedra; and where bodies::body_of() throws
Model read(const std::string& path, std::optional<double> size = {});

}  // namespace meshes
