#pragma once

#include <string>
#include <vector>

#include "report/table.hpp"

namespace report {

/// What a choice changes: one quantity of a formulation, with the one and with the other choice.
struct Choice {
    std::string choice, one, other, quantity, formulation;
    double with_one, with_other;
};

/// The table of the choices that the print of a paper leaves open, a row for each.
/// \param section the paper and its section, as the first comment names them
inline Table table_of(const std::string& section, const std::vector<Choice>& choices) {
    Table table;
    table.comments = {section + ": what the print leaves open, and what another choice changes",
                      "a row: the same quantity with the one and with the other choice"};
    table.columns = {{"choice"},
                     {"one"},
                     {"other"},
                     {"quantity"},
                     {"formulation"},
                     {"with_one", {1e-4, 1e-9}},
                     {"with_other", {1e-4, 1e-9}}};
    for (const auto& [choice, one, other, quantity, formulation, with_one, with_other] : choices)
        table.rows.push_back({choice, one, other, quantity, formulation, with_one, with_other});
    return table;
}

}  // namespace report
