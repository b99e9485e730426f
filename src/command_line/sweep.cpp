#include "command_line/sweep.hpp"

#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

namespace command_line {

using report::Cell;

std::optional<Failure> failure_of_seeds(const std::vector<Attempt>& attempts, std::size_t first,
                                        std::size_t last, unsigned long seed) {
    std::optional<Failure> failure;
    std::size_t count = 0, which = 0;
    for (std::size_t k = first; k < last; ++k)
        if (attempts[k].failure && count++ == 0) {
            failure = attempts[k].failure;
            which = k - first;
        }
    if (failure && last - first > 1)
        failure->reason = std::to_string(count) + " of " + std::to_string(last - first) +
                          " seeds fail, first seed " + std::to_string(seed + which) + ": " + failure->reason;
    return failure;
}

void Sweep::add(const std::vector<std::vector<Cell>>& rows) {
    for (const std::vector<Cell>& row : rows)
        for (std::size_t column = 0; column < row.size(); ++column)
            if (const auto* number = std::get_if<double>(&row[column]); number && !std::isfinite(*number)) {
                const auto named = row.begin() + static_cast<std::ptrdiff_t>(named_);
                add_failed({row.begin(), named}, {table_.columns[column].name + " is not finite", false});
                return;
            }
    ++cases_;
    table_.rows.insert(table_.rows.end(), rows.begin(), rows.end());
}

void Sweep::add_failed(std::vector<Cell> cells, const Failure& failure) {
    ++cases_;
    if (failed_++ == 0) {
        first_ = failure;
        first_row_ = table_.rows.size();
    }
    cells.resize(table_.columns.size());
    const auto* name = std::get_if<std::string>(&cells.front());
    const bool named = name != nullptr && failure.reason.starts_with(*name + ": ");
    cells.emplace_back(named ? failure.reason.substr(name->size() + 2) : failure.reason);
    table_.rows.push_back(std::move(cells));
}

/// The case of a row in words: the columns that tell it from the other rows. Columns that those before them
/// determine are left out.
std::string Sweep::case_of(std::size_t row) const {
    std::vector<std::string> keys(table_.rows.size());
    std::string words;
    for (std::size_t column = 0; column < named_; ++column) {
        const std::string& name = table_.columns[column].name;
        std::map<std::string, std::string> seen;
        bool tells = false;
        for (std::size_t k = 0; k < keys.size(); ++k) {
            const std::string word = table_.word(k, name);
            tells = tells || seen.emplace(keys[k], word).first->second != word;
        }
        if (!tells) continue;
        for (std::size_t k = 0; k < keys.size(); ++k) keys[k] += table_.word(k, name) + ",";
        if (const std::string word = table_.word(row, name); !word.empty())
            words += (words.empty() ? "" : ", ") + name + " " + word;
    }
    return words;
}

void Sweep::finish() {
    if (failed_ == 0) return;
    std::string sentence = first_.reason;
    if (cases_ > 1) {
        const std::string name = case_of(first_row_), all = std::to_string(cases_);
        const std::string& reason = std::get<std::string>(table_.rows[first_row_].back());
        sentence = (failed_ == cases_ ? "none of the " + all + " cases can be computed; "
                                      : std::to_string(failed_) + " of " + all +
                                            " cases failed, as the table's last column says; ") +
                   (name.empty() ? "" : name + ": ") + reason;
    }
    if (failed_ == cases_ && first_.invalid) throw base::InvalidInput(sentence);
    if (failed_ == cases_) throw base::FailedComputation(sentence);
    table_.columns.push_back({"failure"});
    for (std::vector<Cell>& row : table_.rows) row.resize(table_.columns.size());
    table_.incomplete = sentence;
}

report::Table without_failures(report::Table table) {
    if (!table.incomplete.empty())
        std::erase_if(table.rows, [](const std::vector<Cell>& row) { return row.back() != Cell(); });
    return table;
}

}  // namespace command_line
