#pragma once

#include <array>
#include <string>
#include <vector>

#include "command_line/example_cases.hpp"
#include "command_line/timed_solutions.hpp"
#include "report/table.hpp"

namespace command_line {

/// Columns of displacements and stresses, computed and exact.
/// Stresses are reproducible to 10 Pa; where a material is nearly incompressible, to the stress of a strain
/// of 1e-12.
std::vector<report::ColumnHead> state_columns(const std::vector<ExampleCase>& cases);

/// A row for each place: the cells that name the case, then displacements and stresses, computed and exact.
std::vector<std::vector<report::Cell>> state_rows(const std::vector<report::Cell>& named,
                                                  const Solved& solved,
                                                  const std::vector<batra2008::Point<2>>& places);

/// The places that a set of positions holds.
std::vector<batra2008::Point<2>> places_at(const batra2008::Points<2>& x);

/// Places at equal distances on a line, its ends among them.
std::vector<batra2008::Point<2>> places_between(const batra2008::Point<2>& from,
                                                const batra2008::Point<2>& to, long count);

/// The two counts of a grid that `--states` names, such as 46x11.
/// \throws base::InvalidInput for another text, and for more places than fit into memory
std::array<long, 2> grid_of_places(const std::string& states);

}  // namespace command_line
