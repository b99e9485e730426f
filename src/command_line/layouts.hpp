#pragma once

#include <map>
#include <string>
#include <vector>

#include "particles/cells.hpp"
#include "particles/layouts.hpp"

namespace command_line {

/// Particles of the quarter plate with a hole.
struct Layout {
    std::string name;
    particles::Points<2> x;
    bool drawn;           ///< whether another draw gives another layout
    std::string about{};  ///< what was done to its particles
};

/// Whether the name is one of a layout around a hole: graded-N-A or polar-AxR.
bool is_around_a_hole(const std::string& name);

/// Whether another draw of the layout of this name is another layout.
bool is_drawn(const std::string& name);

/// The layouts that `--layout` names: graded-N-A, N particles of which A lie on the hole; polar-AxR, A rays
/// of R particles; or a file of positions.
class Layouts {
  public:
    /// Reads the files, each once.
    /// \param columns of the positions in a file, as read_points() takes them
    /// \param snap particles within this distance of the boundary are moved onto it [m]
    /// \param scaling the largest scaling factor: matrices for it must fit into memory
    /// \throws base::InvalidInput for a name that is neither; for positions in another unit than the
    ///         quarter's; for columns without a file; and for a snap that is no distance
    Layouts(const std::vector<std::string>& names, const std::vector<std::string>& columns, double snap,
            double scaling);

    /// The particles of a layout around a hole.
    /// \throws base::InvalidInput for counts that have no layout, and that do not fit into memory
    [[nodiscard]] Layout around(const particles::QuarterWithHole& shape, const std::string& name,
                                unsigned long draw) const;

  private:
    std::map<std::string, particles::Points<2>> files_;
    double snap_, scaling_;
};

}  // namespace command_line
