#pragma once

#include <string>

#include "particles/cells.hpp"
#include "particles/spacing.hpp"

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

/// The unit of smoothing lengths that an option names: a number [length]; a file (a name with a dot or a slash)
/// with a number for each particle, in their order; or a name of particles::spacing_named().
/// \throws base::InvalidInput for another name, and for a number that is not positive
/// \throws base::FailedComputation where the file cannot be read
particles::Spacing spacing_from(const std::string& text);

}  // namespace command_line
