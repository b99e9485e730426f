#pragma once

#include <functional>
#include <string>
#include <vector>

#include "command_line/example_cases.hpp"
#include "command_line/field_file.hpp"
#include "command_line/states.hpp"
#include "command_line/sweep.hpp"
#include "command_line/timed_solutions.hpp"
#include "report/table.hpp"

namespace command_line {

/// The table of an example problem: for each solution one row of errors, or with `--states` one row for each
/// place.
class ExampleTable {
  public:
    using Places = std::function<std::vector<batra2008::Point<2>>()>;
    using Errors = std::function<std::vector<report::Cell>(const Solved&)>;

    /// \param about first comment of the table \param layout columns that name the particles \param errors
    ///         columns of the errors
    ExampleTable(const ExampleOptions& options, const std::vector<ExampleCase>& cases,
                 const std::string& about, const std::vector<report::ColumnHead>& layout,
                 const std::vector<report::ColumnHead>& errors);

    /// Adds a line above the table.
    void add_comment(const std::string& words) { table_.comments.push_back(words); }

    /// Solves a problem on a cloud, and adds its rows; where that fails, one row with the reason, as Sweep
    /// says.
    /// \param layout cells of the columns that name the particles \param places those of `--states` other
    ///         than the particles \param errors cells of the columns of the errors
    void add(const ExampleCase& one, const batra2008::Problem& problem, const batra2008::Cloud<2>& cloud,
             const std::vector<report::Cell>& layout, const Places& places, const Errors& errors);

    /// The whole table, with a comment where solutions are noisy; the file of `--field` is written with what
    /// could be solved.
    /// \throws as Sweep::finish()
    report::Table finished();

  private:
    [[nodiscard]] std::string in_words(const std::vector<report::Cell>& named) const;
    void warn_of(double noise, const std::vector<report::Cell>& named);
    void note_quality(const particles::WorstRow& row, const std::vector<report::Cell>& named,
                      const batra2008::Cloud<2>& cloud);

    ExampleOptions options_;
    FieldFile field_;
    report::Table table_;
    Sweep sweep_;
    long noisy_ = 0;  ///< number of cases
    double most_noise_ = 0;
    std::string noisiest_;  ///< the case of it
    double largest_R_ = 0;
    std::string worst_row_;  ///< of it, with its case and its place
};

}  // namespace command_line
