#pragma once

#include <string>

#include "particles/cells.hpp"
#include "particles/line.hpp"

namespace command_line {

/// Positions of particles from a file: one per line, or in the first column of a CSV. # starts a comment; a
/// first line that begins with a letter or a quote is a header.
/// \return strictly increasing, from 0 to 1 [length]
/// \throws base::InvalidInput naming file, line and value of any other position
/// \throws base::FailedComputation where the file cannot be read
particles::Column<double> read_positions(const std::string& path);

/// Positions of particles in the plane from a file: x₁ and x₂ per line, separated by a comma or blanks;
/// comments and header as above.
/// \return in the order of the file [length]
/// \throws base::InvalidInput naming file, line and value of any line that is not two numbers
/// \throws base::FailedComputation where the file cannot be read
particles::Points<2> read_points(const std::string& path);

}  // namespace command_line
