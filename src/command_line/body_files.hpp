#pragma once

#include <optional>
#include <string>

#include "bodies/body.hpp"

namespace command_line {

/// A body in the plane, and how many of its particles were moved onto its boundary.
struct BodyFromFiles {
    bodies::Body<2> body;
    particles::Index moved = 0;  ///< by more than round-off
    double farthest = 0;         ///< largest distance by which one was moved [length]
};

/// A body in the plane from two files, as Columns reads them: its particles, and its sides, each a polyline
/// through places of the boundary. Sides come in any order and direction; one whose ends meet no other side
/// is closed by a straight piece. Loops within a loop are holes. A particle within 1e-8 of the body's size
/// from a side lies on it. Its normal goes over from that at one end of the piece to that at the other. The
/// normal at a place of the file is given, or the mean over the two pieces with the weights of
/// bodies::body_of(); where a side without given normals turns by 40 degrees or more it has a corner.
/// Normals of one side at a particle that differ by less than 20 degrees are one.
/// \param points file of particles, with the columns x and y
/// \param boundary file of sides, with the columns name, order, x and y, and perhaps nx and ny, a vector that
///        points outward. The places of a side follow one another by the numbers of `order`
/// \param snap particles within this distance of the boundary are moved onto it, and ends of sides within
///        this distance meet [length]
/// \throws base::InvalidInput in one line with file and line or place, and a remedy: for missing columns and
///         files without rows; for places of a side with the same number, and equal ones in succession; for a
///         boundary that is open or crosses itself; for normals that do not point outward; for particles that
///         coincide, lie outside the body or a little beside its boundary; and for a side without particles
BodyFromFiles read_body(const std::string& points, const std::string& boundary,
                        std::optional<double> snap = {});

}  // namespace command_line
