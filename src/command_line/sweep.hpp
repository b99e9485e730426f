#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/errors.hpp"
#include "command_line/progress.hpp"
#include "report/table.hpp"

namespace command_line {

/// Why a case could not be computed.
struct Failure {
    std::string reason;
    bool invalid;  ///< whether it was base::InvalidInput, else base::FailedComputation
};

/// The failure of some work; nothing if it succeeds.
template <class Work>
std::optional<Failure> failure_of(const Work& work) {
    try {
        work();
        return {};
    } catch (const base::InvalidInput& error) {
        return Failure{error.what(), true};
    } catch (const base::FailedComputation& error) {
        return Failure{error.what(), false};
    }
}

/// The numbers of a case, or why it has none.
struct Attempt {
    std::vector<report::Cell> numbers;
    std::optional<Failure> failure;
};

/// What `compute` returns for each case, or why it fails; in parallel, with progress on the terminal.
template <class Case, class Compute>
std::vector<Attempt> attempts_in_parallel(const std::vector<Case>& cases, const Compute& compute) {
    return computed_in_parallel(cases, [&](const Case& one) {
        Attempt attempt;
        attempt.failure = failure_of([&] { attempt.numbers = compute(one); });
        return attempt;
    });
}

/// The failure of attempts [first, last) that differ in their seeds only, if one fails.
/// \param seed of the first of them
std::optional<Failure> failure_of_seeds(const std::vector<Attempt>& attempts, std::size_t first,
                                        std::size_t last, unsigned long seed);

/// The rows of a table, case by case. A case that fails has one row with empty numbers; its reason stands in
/// a last column, failure, which a table without failures does not have.
class Sweep {
  public:
    /// \param table with its columns, and without rows \param named how many of the columns name the case
    Sweep(report::Table& table, std::size_t named) : table_(table), named_(named) {}

    /// Adds the rows that `compute` returns for a case; where it fails, the row of a case that failed.
    /// \param cells that name the case
    template <class Compute>
    void attempt(const std::vector<report::Cell>& cells, const Compute& compute) {
        std::vector<std::vector<report::Cell>> rows;
        if (const auto failure = failure_of([&] { rows = compute(); }))
            add_failed(cells, *failure);
        else
            add(rows);
    }

    /// Adds the rows of a case, which has failed if a number is not finite.
    void add(const std::vector<std::vector<report::Cell>>& rows);

    /// Adds the row of a case that failed. \param cells that name the case
    void add_failed(std::vector<report::Cell> cells, const Failure& failure);

    /// Adds the column of reasons, and says in Table::incomplete how many cases failed, which was the first,
    /// and why.
    /// \throws base::InvalidInput or base::FailedComputation where no case succeeded
    void finish();

  private:
    [[nodiscard]] std::string case_of(std::size_t row) const;

    report::Table& table_;
    std::size_t named_, cases_ = 0, failed_ = 0, first_row_ = 0;
    Failure first_{};
};

/// The table of a sweep without the rows of cases that failed, for a figure.
report::Table without_failures(report::Table table);

}  // namespace command_line
