#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "report/table.hpp"

namespace command_line {

/// Adds the observed orders to a table of errors: between a row with error e₂ and spacing δ₂ and the previous
/// row of the same case, with e₁ and δ₁
/// \f[ p = \frac{\log(e_1/e_2)}{\log(\delta_1/\delta_2)} \f]
/// Each column of errors has one: error_first has order_first, log_error_dn, which holds log10 of errors, has
/// order_dn. Orders are rounded to a thousandth. A row without a previous one has empty
/// orders; a table without any order stays as it is.
/// \param same columns that name a case, without those that tell the particles
/// \param spacing δ of a row
void add_orders(report::Table& table, const std::vector<std::string>& same,
                const std::function<double(std::size_t)>& spacing);

}  // namespace command_line
