#include "report/table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>
#include <system_error>
#include <utility>

#include "base/errors.hpp"
#include "base/text.hpp"

namespace report {

using base::FailedComputation;
using base::shown;

namespace {

constexpr const char* tolerance_mark = "tolerance of ";

/// Digits beyond the tolerance say nothing; one more keeps rounding out of the comparison.
int digits(const Tolerance& tolerance) {
    if (!(tolerance.relative > 0)) return 10;
    return static_cast<int>(std::clamp(1 + std::ceil(-std::log10(tolerance.relative)), 1.0, 17.0));
}

/// A word as CSV holds it: in quotes where it has a comma, a quote or a line break.
std::string quoted(const std::string& word) {
    if (word.find_first_of(",\"\n") == std::string::npos) return word;
    std::string inside;
    for (const char c : word) inside += c == '"' ? std::string("\"\"") : std::string(1, c);
    return '"' + inside + '"';
}

std::string text(const Cell& cell, const Tolerance& tolerance) {
    if (const auto* word = std::get_if<std::string>(&cell)) return quoted(*word);
    if (const auto* integer = std::get_if<long>(&cell)) return std::to_string(*integer);
    if (const auto* real = std::get_if<double>(&cell))
        return shown(*real + 0.0, digits(tolerance));  // no minus zero
    return "";
}

Cell parsed_cell(const std::string& text) {
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error == std::errc() && end == text.data() + text.size()) return number;
    return text;
}

std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> parts(1);
    bool inside = false;
    for (std::size_t k = 0; k < line.size(); ++k) {
        const bool quote = line[k] == '"';
        if (quote && inside && k + 1 < line.size() && line[k + 1] == '"')
            parts.back() += line[++k];
        else if (quote)
            inside = !inside;
        else if (line[k] == ',' && !inside)
            parts.emplace_back();
        else
            parts.back() += line[k];
    }
    return parts;
}

double allowed(double x, double y, const Tolerance& tolerance) {
    return tolerance.relative * std::max(std::abs(x), std::abs(y)) + tolerance.absolute;
}

bool agree(const Cell& a, const Cell& b, const Tolerance& tolerance) {
    const auto* x = std::get_if<double>(&a);
    const auto* y = std::get_if<double>(&b);
    if (!x || !y) return a == b;
    return std::abs(*x - *y) <= allowed(*x, *y, tolerance);
}

}  // namespace

std::size_t Table::column(const std::string& name) const {
    for (std::size_t k = 0; k < columns.size(); ++k)
        if (columns[k].name == name) return k;
    throw FailedComputation("the table has no column '" + name + "'");
}

std::string Table::word(std::size_t row, const std::string& name) const {
    const Cell& cell = rows.at(row)[column(name)];
    const auto* word = std::get_if<std::string>(&cell);
    return word ? *word : text(cell, {});
}

std::string csv(const Table& table) {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    for (const std::string& comment : table.comments) out << "# " << comment << '\n';
    for (const ColumnHead& column : table.columns)
        if (column.tolerance.relative > 0 || column.tolerance.absolute > 0)
            out << "# " << tolerance_mark << column.name << ": relative " << shown(column.tolerance.relative)
                << ", absolute " << shown(column.tolerance.absolute) << '\n';
    for (std::size_t k = 0; k < table.columns.size(); ++k) out << (k ? "," : "") << table.columns[k].name;
    out << '\n';
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const std::vector<Cell>& cells = table.rows[row];
        if (cells.size() != table.columns.size())
            throw FailedComputation("row " + std::to_string(row + 1) + " has " +
                                    std::to_string(cells.size()) + " entries for " +
                                    std::to_string(table.columns.size()) + " columns");
        for (std::size_t k = 0; k < cells.size(); ++k) {
            const auto* real = std::get_if<double>(&cells[k]);
            if (real && !std::isfinite(*real)) {
                const std::string of = text(cells[0], {});
                throw FailedComputation("row " + std::to_string(row + 1) + " (" + of +
                                        "): " + table.columns[k].name + " is not finite");
            }
            out << (k ? "," : "") << text(cells[k], table.columns[k].tolerance);
        }
        out << '\n';
    }
    return out.str();
}

Table parsed_words(const std::string& csv) {
    Table table;
    std::vector<std::string> tolerances;
    std::istringstream in(csv);
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
        if (line.starts_with("# ")) {
            const std::string comment = line.substr(2);
            (comment.starts_with(tolerance_mark) ? tolerances : table.comments).push_back(comment);
        } else if (table.columns.empty()) {
            for (const std::string& name : split(line)) table.columns.push_back({name, {}});
        } else {
            std::vector<Cell> row;
            for (const std::string& part : split(line)) row.push_back(part.empty() ? Cell() : Cell(part));
            if (row.size() != table.columns.size())
                throw FailedComputation("line " + std::to_string(number) + " has " +
                                        std::to_string(row.size()) + " entries for " +
                                        std::to_string(table.columns.size()) + " columns");
            table.rows.push_back(std::move(row));
        }
    }
    if (table.columns.empty()) throw FailedComputation("the table has no row of column names");
    for (const std::string& tolerance : tolerances) {
        const std::size_t colon = tolerance.find(": relative ");
        const std::size_t comma = tolerance.find(", absolute ");
        if (colon == std::string::npos || comma == std::string::npos)
            throw FailedComputation("'" + tolerance + "' is no tolerance");
        const std::size_t start = std::string(tolerance_mark).size();
        const auto number = [&](std::size_t from, std::size_t to) {
            double value = 0;
            const auto [end, error] =
                std::from_chars(tolerance.data() + std::min(from, to), tolerance.data() + to, value);
            if (error != std::errc() || end != tolerance.data() + to || !std::isfinite(value) || value < 0)
                throw FailedComputation("'" + tolerance + "' is no tolerance");
            return value;
        };
        const std::size_t words = std::string(": relative ").size();
        table.columns[table.column(tolerance.substr(start, colon - start))].tolerance = {
            number(colon + words, comma), number(comma + words, tolerance.size())};
    }
    return table;
}

Table parsed(const std::string& csv) {
    Table table = parsed_words(csv);
    for (std::vector<Cell>& row : table.rows)
        for (Cell& cell : row)
            if (const auto* word = std::get_if<std::string>(&cell)) cell = parsed_cell(*word);
    for (std::size_t row = 0; row < table.rows.size(); ++row)
        for (std::size_t k = 0; k < table.columns.size(); ++k)
            if (const auto* real = std::get_if<double>(&table.rows[row][k]); real && !std::isfinite(*real))
                throw FailedComputation("row " + std::to_string(row + 1) + ": " + table.columns[k].name +
                                        " is not finite");
    return table;
}

std::vector<std::string> differences(const Table& committed, const Table& regenerated) {
    std::vector<std::string> found;
    const auto names = [](const Table& table) {
        std::string joined;
        for (const ColumnHead& column : table.columns) {
            if (!joined.empty()) joined += ',';
            joined += quoted(column.name);
        }
        return joined;
    };
    if (committed.comments != regenerated.comments)
        found.emplace_back("the comments, which say what was computed");
    if (names(committed) != names(regenerated))
        return {"columns: " + names(committed) + " != " + names(regenerated)};
    if (committed.rows.size() != regenerated.rows.size())
        return {"rows: " + std::to_string(committed.rows.size()) +
                " != " + std::to_string(regenerated.rows.size())};
    for (std::size_t k = 0; k < committed.columns.size(); ++k) {
        const Tolerance &a = committed.columns[k].tolerance, &b = regenerated.columns[k].tolerance;
        if (a.relative != b.relative || a.absolute != b.absolute)
            found.push_back("the tolerance of " + committed.columns[k].name);
    }
    for (std::size_t row = 0; row < committed.rows.size(); ++row)
        for (std::size_t k = 0; k < committed.columns.size(); ++k) {
            const Cell& a = committed.rows[row][k];
            const Cell& b = regenerated.rows[row][k];
            if (!agree(a, b, committed.columns[k].tolerance))
                found.push_back("row " + std::to_string(row + 1) + " (" + text(committed.rows[row][0], {}) +
                                "), " + committed.columns[k].name + ": " + text(a, {}) +
                                " != " + text(b, {}));
        }
    return found;
}

Move largest_move(const Table& committed, const Table& regenerated) {
    Move largest;
    for (std::size_t row = 0; row < committed.rows.size(); ++row)
        for (std::size_t k = 0; k < committed.columns.size(); ++k) {
            const auto* x = std::get_if<double>(&committed.rows[row][k]);
            const auto* y = std::get_if<double>(&regenerated.rows[row][k]);
            if (!x || !y || *x == *y) continue;
            const double by = std::abs(*x - *y), share = by / allowed(*x, *y, committed.columns[k].tolerance);
            if (largest.by == 0 || share > largest.share)
                largest = {row, committed.columns[k].name, by, share};
        }
    return largest;
}

}  // namespace report
