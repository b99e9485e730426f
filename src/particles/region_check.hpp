#pragma once

#include <string>

#include "particles/region.hpp"

namespace particles {

/// A part of a boundary in words: "the side from (0, 0) to (2, 0)", "the arc of radius 0.3 around (0, 0)".
std::string shown_curve(const Curve& curve);

/// A region with the body to the left of each part of its boundary: outer loops run counter-clockwise, holes
/// clockwise, islands in holes counter-clockwise. The parts keep their order. Ends of sides that meet up to
/// round-off are made to meet.
/// \param region the parts of a boundary in any order; sides in any direction, arcs bulging or not
/// \param size a length of the body, beside which a gap of 1e-8 does not count
/// \throws base::InvalidInput naming the part where the boundary is not closed, crosses or touches itself or
///         encloses no area, and for a part that is not finite or without length
Region checked(Region region, double size);

}  // namespace particles
