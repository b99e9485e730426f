#pragma once

#include <string>
#include <vector>

#include "particles/cells.hpp"
#include "particles/spacing.hpp"

namespace command_line {

/// What is nearer than this to an end of [0, 1], or to a side of the unit square or cube, lies on it.
inline constexpr double end_tolerance = 1e-8;

/// Positions of particles on a line from a file, as Columns reads it: in its only column, that of the name x,
/// or the first.
/// \param columns the name of another column, or its number from 1; empty for none
/// \return strictly increasing, from 0 to 1 [length]; a first and a last one nearer to 0 and 1 than 1e-8 are
///         put there
/// \throws base::InvalidInput naming file, line and value of any other position, and a first column that
///         counts the lines
particles::Column<double> read_positions(const std::string& path,
                                         const std::vector<std::string>& columns = {});

/// Positions of particles in the plane from a file, as Columns reads it: x₁ and x₂ in its only two columns,
/// or in those that the header names x1 and x2, or x and y.
/// \param columns names of two other columns, or their numbers from 1; empty for none
/// \return in the order of the file [length]
/// \throws base::InvalidInput naming file, line and value of any line that is not two numbers, or has not the
///         header's columns; and for fewer than two positions
particles::Points<2> read_points(const std::string& path, const std::vector<std::string>& columns = {});

/// The same for the file of any option, in the plane or in space: x₁, x₂ and x₃, or x, y and z.
/// \param what the particles are, for messages: "a layout"
template <int dim>
particles::Points<dim> read_points(const std::string& option, const std::string& path,
                                   const std::vector<std::string>& columns, const std::string& what);

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
/// \throws base::InvalidInput for another name, a file that cannot be read, and a number that is not
///         positive, naming file and line
particles::Spacing spacing_from(const std::string& text);

/// \param text what `--smoothing-from` said
/// \throws base::InvalidInput unless there is one number or one for each of N particles, if they were given
void check_lengths(const particles::Spacing& spacing, const std::string& text, particles::Index N);

}  // namespace command_line
