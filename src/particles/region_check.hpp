#pragma once

#include <string>

#include "particles/region.hpp"

namespace particles {

/// A part of a boundary in words: "the side from (0, 0) to (2, 0)", "the arc of radius 0.3 around (0, 0)".
std::string shown_curve(const Curve& curve);

/// A region that the quadrature rules can use: its curves in the same order, each side with the region to its
/// left.
/// \param region the parts of a boundary in any order; sides in any direction
/// \param size a length of the body, beside which a gap of 1e-8 does not count
/// \throws base::InvalidInput naming the part where the boundary is not closed, crosses itself or turns
///         inward, and for a part that is not finite, without length, or an arc that bulges outward
Region checked(Region region, double size);

}  // namespace particles
