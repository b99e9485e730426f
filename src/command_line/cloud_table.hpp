#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "command_line/clouds.hpp"
#include "report/table.hpp"

namespace command_line {

/// The results of a test at one place, such as inside or at a corner: three numbers for each particle.
struct Found {
    std::vector<std::string> keys;  ///< that name the place, in the columns `CloudTest::keys`
    std::vector<particles::Index> particles;
    std::vector<std::array<double, 3>> numbers;
};

/// A test of formulations on particles: its columns, and the function that computes them.
template <int dim>
struct CloudTest {
    std::string largest, states;           ///< what each table holds
    std::vector<report::ColumnHead> keys;  ///< the last one is the place
    std::array<report::ColumnHead, 3> numbers;
    std::string quality;  ///< what the third number is
    /// The results of a formulation on particles. \param spacing δ, one for all or one for each [length]
    std::function<std::vector<Found>(const std::string& formulation, const Placed<dim>&,
                                     const particles::Column<double>& spacing)>
        find;
};

/// A row for each formulation, case and place: the largest numbers there; with --median their medians and
/// quartiles over the seeds. On the standard output grids have the observed orders. With --states, a row for
/// each particle instead: its place, its position and what is found there.
template <int dim>
report::Table table_of(const CloudOptions& options, const CloudTest<dim>& test);

}  // namespace command_line
