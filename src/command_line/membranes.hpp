#pragma once

#include <string>
#include <vector>

#include "command_line/clouds.hpp"
#include "fpm_in_space/section_6_vibration_test.hpp"

namespace command_line {

namespace vibration_test = fpm_in_space::vibration_test;

/// The options of the vibration test in the plane and in space.
struct MembraneOptions : CloudOptions {
    long lowest = 0;  ///< the number of modes; 0 for all
};

/// A formulation, or finite elements, on the particles of a grid.
struct MembraneCase {
    std::string formulation;
    CloudCase cloud;

    [[nodiscard]] bool is_elements() const;
};

/// The names of all that the test knows: original, the formulations in space, and in the plane fem_lumped and
/// fem_consistent.
std::vector<std::string> membrane_formulations(long dimension);

/// Sets the default particles and formulations.
/// \throws base::InvalidInput for options without effect, and for what has no spectrum, does not fit into
///         memory or cannot be drawn
void complete(MembraneOptions& options);

std::vector<MembraneCase> cases(const MembraneOptions& options);

/// All frequencies of a case, or the lowest.
/// \throws base::FailedComputation where they are not found
template <int dim>
vibration_test::Frequencies frequencies(const MembraneOptions& options, const MembraneCase& one);

/// Those of the symbol; none for finite elements and for particles that do not lie on a lattice.
template <int dim>
std::vector<double> symbol_frequencies(const MembraneOptions& options, const MembraneCase& one);

}  // namespace command_line
