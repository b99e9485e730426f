#pragma once

#include <vector>

#include "bodies/body.hpp"

namespace bodies {

/// A point of a quadrature rule in a body or on its boundary.
template <int dim>
struct IntegrationPoint {
    Point<dim> x;
    double weight = 0;
    Point<dim> normal = Point<dim>::Zero();  ///< unit outward normal, on the boundary
};

/// Points on a side, whose weights sum to its length or area.
/// \param spacing largest length of a panel of a segment or an arc; triangles are not divided [length]
template <int dim>
std::vector<IntegrationPoint<dim>> rule_on(const Side<dim>& side, double spacing);

/// Points in a body: the centres of its cells; without cells, in polar coordinates around its first particle.
template <int dim>
std::vector<IntegrationPoint<dim>> rule_in(const Body<dim>& body);

}  // namespace bodies
