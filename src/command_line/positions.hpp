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

/// Positions of particles in the plane from a file: x₁ and x₂ per line, separated by a comma or blanks; or
/// the columns x1 and x2, or x and y, that a header names among others. Comments as above.
/// \return in the order of the file [length]
/// \throws base::InvalidInput naming file, line and value of any line that is not two numbers, or has not the
///         header's columns
/// \throws base::FailedComputation where the file cannot be read
particles::Points<2> read_points(const std::string& path);

/// A file, and a column in it; no column where it has but one.
struct NamedFile {
    std::string path, column;
};

/// FILE, or FILE:COLUMN. A file whose name has a colon is taken whole.
NamedFile named_file(const std::string& text);

/// The unit of smoothing lengths that an option names: a number [length]; a name of
/// particles::spacing_named(); or a file with a number for each particle in their order, FILE or FILE:COLUMN
/// with the column's name in the header or its number from 1. What has a slash, or begins with a letter and
/// has a dot, is a file.
/// \throws base::InvalidInput for another name, and for a number that is not positive, naming file and line
/// \throws base::FailedComputation where the file cannot be read
particles::Spacing spacing_from(const std::string& text);

/// \param text what `--smoothing-from` said
/// \throws base::InvalidInput unless there is one number or one for each of N particles, if they were given
void check_lengths(const particles::Spacing& spacing, const std::string& text, particles::Index N);

}  // namespace command_line
