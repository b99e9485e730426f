#pragma once

#include <array>
#include <vector>

#include "particles/cloud.hpp"

namespace particles {

/// Delaunay's triangles with a corner at a particle: no other particle lies in their circumcircle. Of four
/// particles on a circle, two triangles are chosen, the same ones by each of the four. Left out are triangles
/// whose circumcircle is larger than the distances between the particles there: they lie outside of the body,
/// or nearly on a straight part of its boundary.
/// \return numbers of the other two corners, counterclockwise, in any order of the triangles
std::vector<std::array<int, 2>> triangles_at(const Cloud<2>& cloud, Index particle);

}  // namespace particles
