#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

namespace report {

/// How closely a column of numbers is reproducible on another processor or with another compiler: two values
/// agree if they differ by no more than relative · the larger one + absolute.
struct Tolerance {
    double relative = 0, absolute = 0;
};

/// A column by its name. Real numbers are written with as many digits as the relative tolerance lets stand.
struct ColumnHead {
    std::string name;
    Tolerance tolerance = {};
};

/// An entry: empty, a word, an integer or a real number.
using Cell = std::variant<std::monostate, std::string, long, double>;

/// A table with the comments that say what it shows.
struct Table {
    std::vector<std::string> comments;
    std::vector<ColumnHead> columns;
    std::vector<std::vector<Cell>> rows;
    std::string incomplete = {};  ///< why rows have no numbers, for the user; no part of the CSV

    /// The word in a row's column; a number as it is shown. \throws as column()
    [[nodiscard]] std::string word(std::size_t row, const std::string& name) const;

    /// Index of a column. \throws base::FailedComputation where there is none of that name
    [[nodiscard]] std::size_t column(const std::string& name) const;
};

/// The table as CSV: a block of comments (#), among them the tolerances, then a row of names, then the rows.
/// Numbers are written in the C locale.
/// \throws base::FailedComputation for a number that is not finite or a row of another length, naming row and
///         column
std::string csv(const Table& table);

/// The inverse of csv(): entries that read as numbers become real numbers, empty ones stay empty. Words in
/// quotes may hold commas and doubled quotes, not line breaks.
/// \throws base::FailedComputation naming the line that is no row of the table
Table parsed(const std::string& csv);

/// The same with every entry as it is written, for keys that only look like numbers: 4.10 is not 4.1.
Table parsed_words(const std::string& csv);

/// Where two tables differ in comments, names or words, or by more than the tolerances that the first one
/// states; empty if they agree.
std::vector<std::string> differences(const Table& committed, const Table& regenerated);

/// A number that differs between two tables.
struct Move {
    std::size_t row = 0;
    std::string column;
    double by = 0;     ///< the difference's absolute value; zero if nothing moved
    double share = 0;  ///< of the difference that the tolerance allows
};

/// Of two tables of the same columns and as many rows, the number that moved most against what its tolerance
/// allows.
Move largest_move(const Table& committed, const Table& regenerated);

}  // namespace report
