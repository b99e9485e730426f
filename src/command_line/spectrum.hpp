#pragma once

#include <complex>
#include <cstddef>
#include <functional>
#include <vector>

#include "base/index.hpp"
#include "report/table.hpp"

namespace command_line {

/// The columns of a mode: mode, frequency, frequency_imaginary, exact, ratio.
std::vector<report::ColumnHead> columns_of_modes();

/// A row for each frequency: the case, the columns of its mode, and a last column. Modes are counted by the
/// real parts. A displacement whose frequency has none grows or decays without vibration: such a frequency
/// belongs to no mode, and has no exact one beside it.
/// \param named cells of the case \param exact frequency of a mode, from 1
/// \param last cell of a mode, from 1, and of its row, from 0
std::vector<std::vector<report::Cell>> rows_of_modes(
    const std::vector<report::Cell>& named, const std::vector<std::complex<double>>& frequencies,
    const std::function<double(base::Index)>& exact,
    const std::function<report::Cell(base::Index, std::size_t)>& last);

}  // namespace command_line
