#pragma once

#include <string>
#include <vector>

#include "command_line/body_options.hpp"
#include "distributed/petsc.hpp"
#include "distributed/whole.hpp"
#include "report/table.hpp"

namespace distributed {

/// The body and what is asked of it.
struct Options : command_line::BodyOptions {
    std::string grid, lengths;  ///< as typed; empty for a drawing or a mesh
};

/// The table of the program `distributed`: the rows of all methods, and of one that failed, a row that says
/// why. Writes the fields, too.
/// \param notes on the body, for the table's comments
/// \throws base::InvalidInput and base::FailedComputation on all processes
template <int dim>
report::Table table(const Petsc& petsc, const Processes& processes, const Options& options, Whole<dim> whole,
                    const std::vector<std::string>& notes = {});

}  // namespace distributed
