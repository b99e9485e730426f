#include "command_line/orders.hpp"

#include <cmath>
#include <map>
#include <optional>
#include <variant>

namespace command_line {

using report::Cell;

namespace {

/// A column of errors, and the name of its orders.
struct Errors {
    std::size_t column;
    std::string order;
    bool logarithm;  ///< whether it holds log10 of the errors
};

std::vector<Errors> columns_of_errors(const report::Table& table) {
    std::vector<Errors> all;
    for (std::size_t column = 0; column < table.columns.size(); ++column) {
        const std::string& name = table.columns[column].name;
        const std::size_t at = name.find("error_");
        if (at != std::string::npos && !name.ends_with("_lower") && !name.ends_with("_upper"))
            all.push_back({column, "order_" + name.substr(at + 6), name.starts_with("log_")});
    }
    return all;
}

/// log e of a row; nothing without an error, or for one below 1 % of its tolerance, which is round-off.
std::optional<double> logarithm(const report::Table& table, std::size_t row, const Errors& errors) {
    const auto* const found = std::get_if<double>(&table.rows[row][errors.column]);
    const double round_off = table.columns[errors.column].tolerance.absolute / 100;
    if (found == nullptr || (!errors.logarithm && !(*found > round_off))) return {};
    return errors.logarithm ? *found * std::log(10) : std::log(*found);
}

}  // namespace

void add_orders(report::Table& table, const std::vector<std::string>& same,
                const std::function<double(std::size_t)>& spacing) {
    const std::vector<Errors> all = columns_of_errors(table);
    std::vector<std::vector<Cell>> orders(table.rows.size(), std::vector<Cell>(all.size()));
    std::map<std::string, std::size_t> before;
    bool any = false;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        std::string key;
        for (const std::string& name : same) key += table.word(row, name) + ",";
        const auto [found, is_first] = before.emplace(key, row);
        const double finer = is_first ? 0 : std::log(spacing(found->second) / spacing(row));
        for (std::size_t k = 0; finer != 0 && k < all.size(); ++k) {
            const auto coarse = logarithm(table, found->second, all[k]), fine = logarithm(table, row, all[k]);
            if (!coarse || !fine) continue;
            orders[row][k] = std::round(1000 * (*coarse - *fine) / finer) / 1000;
            any = true;
        }
        found->second = row;
    }
    if (!any) return;

    table.comments.emplace_back(
        "order: log(e1/e2) / log(delta1/delta2) of a row's error e2 and that of the row before it of the same case; in tables on the standard output, not in files");
    const std::size_t place = table.columns.size() - (table.incomplete.empty() ? 0 : 1);  // before failure
    const auto insert = [&](auto& into, const auto& what) {
        into.insert(into.begin() + static_cast<std::ptrdiff_t>(place), what.begin(), what.end());
    };
    std::vector<report::ColumnHead> heads;
    heads.reserve(all.size());
    for (const Errors& errors : all) heads.push_back({errors.order});
    insert(table.columns, heads);
    for (std::size_t row = 0; row < table.rows.size(); ++row) insert(table.rows[row], orders[row]);
}

}  // namespace command_line
