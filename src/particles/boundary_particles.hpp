#pragma once

#include "base/index.hpp"
#include "particles/boundary.hpp"
#include "particles/cloud.hpp"

namespace particles {

/// Share of a particle's distance to the nearest other one within which it may not lie beside the boundary:
/// it is then meant to be on it.
constexpr double boundary_margin = 1e-3;

/// Checks that the particles tell what boundary they have. Particles on it, within 1e-8 of the body's size,
/// carry its conditions; the others are inner ones. What is asked of a part of the boundary is asked of the
/// run of parts between two sharp corners: a curve cut into many sides needs no particle on each of them.
/// \param size a length of the body
/// \throws base::InvalidInput with a remedy, naming a particle, for one that lies outside the body; beside a
///         part of the boundary within the boundary_margin; or within a quarter of its spacing, where that
///         part has no particle of its own. Naming a part of the boundary, for one without a particle on it
void check_particles(const Cloud<2>& cloud, const Boundary& boundary, double size);

/// Particles some of which were moved onto the boundary.
struct Snapped {
    Points<2> x;
    Index moved = 0;      ///< how many, by more than round-off
    double farthest = 0;  ///< largest distance by which one was moved [length]
};

/// Moves particles within a distance of the boundary to its nearest point; to the end of a part, a corner, if
/// that is within the distance.
/// \throws base::InvalidInput unless the distance is positive and finite
Snapped snapped(Points<2> x, const Boundary& boundary, double distance);

}  // namespace particles
