#pragma once

#include <string>
#include <variant>

#include "report/table.hpp"
#include "tests/programs/run.hpp"
#include "tests/support/relative.hpp"

/// What tests of programs in space ask of a table that a program wrote.
namespace programs {

using support::relative;

/// The number in a row and in a column of this name.
inline double number(const report::Table& table, std::size_t row, const std::string& column) {
    return std::get<double>(table.rows[row][table.column(column)]);
}

}  // namespace programs
