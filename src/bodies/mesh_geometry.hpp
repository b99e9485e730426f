#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>

#include "bodies/mesh.hpp"

// Places, areas and edges of the cells of a mesh and of their facets.
namespace bodies {

template <int dim>
using Nodes = std::array<int, static_cast<std::size_t>(dim)>;

template <int dim>
auto at(const Mesh<dim>& mesh, int node) {
    return mesh.x.col(node);
}

template <int dim, std::size_t count>
Point<dim> middle(const Mesh<dim>& mesh, const std::array<int, count>& nodes) {
    Point<dim> sum = Point<dim>::Zero();
    for (const int node : nodes) sum += at(mesh, node);
    return sum / static_cast<double>(count);
}

/// Length or area of a facet times its unit normal. The normal points to the right of a segment; from its tip
/// the corners of a triangle run counter-clockwise.
template <int dim>
Point<dim> area(const Mesh<dim>& mesh, const Nodes<dim>& facet) {
    const Point<dim> a = at(mesh, facet[1]) - at(mesh, facet[0]);
    if constexpr (dim == 2) {
        return {a[1], -a[0]};
    } else {
        return a.cross(at(mesh, facet[2]) - at(mesh, facet[0])) / 2;
    }
}

template <int dim>
using Edges = Eigen::Matrix<double, dim, dim>;

/// The way from a cell's first corner to each of the others.
template <int dim>
Edges<dim> edges(const Mesh<dim>& mesh, const Nodes<dim + 1>& cell) {
    Edges<dim> all;
    for (int k = 0; k < dim; ++k)
        all.col(k) = at(mesh, cell[static_cast<std::size_t>(k) + 1]) - at(mesh, cell[0]);
    return all;
}

}  // namespace bodies
