#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "asprone2010/quality.hpp"
#include "command_line/cases.hpp"
#include "command_line/command_line.hpp"
#include "report/table.hpp"

namespace command_line {

/// Adds `--quality` to a numerical test.
void add_quality(CommandLine& app, Options& options);

/// \param precision that of the program
/// \throws base::FailedComputation as asprone2010::quality::require(), for a case of one of formulations()
asprone2010::quality::Row require_quality(const Options& options, const Case& one,
                                          asprone2010::quality::RowsOf rows,
                                          const asprone2010::quality::Precision& precision = {});

/// Refuses cases that are not worth a table in the precision that was asked for, and shows with `--quality` how good the others are.
class Quality {
  public:
    /// \param rows those that the test uses
    Quality(const Options& options, asprone2010::quality::RowsOf rows) : options_(options), rows_(rows) {}

    /// The numbers of a case; with `--quality`, R of its worst row follows. Cases may come from several
    /// threads.
    /// \throws base::FailedComputation as require_quality()
    std::vector<report::Cell> numbers(const Case& one,
                                      const std::function<std::vector<report::Cell>()>& compute);

    /// The column of R, last of those that are measured.
    void add_column(report::Table& table) const;
    /// A comment that names the worst row of all cases.
    void add_comment(report::Table& table) const;

  private:
    const Options& options_;
    asprone2010::quality::RowsOf rows_;
    std::optional<Case> case_;  ///< with the worst row
    asprone2010::quality::Row worst_;
};

}  // namespace command_line
