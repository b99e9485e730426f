#pragma once

#include <optional>
#include <string>
#include <vector>

#include "asprone2010/quality.hpp"
#include "command_line/cases.hpp"
#include "command_line/command_line.hpp"
#include "report/table.hpp"

namespace command_line {

/// Adds `--quality` to a numerical test.
void add_quality(CommandLine& app, Options& options);

/// The rows that a test uses.
struct TestRows {
    asprone2010::quality::RowsOf rows;  ///< of D and D²
    std::string end{};                  ///< the formulation of D, if it is another one
    bool finer = false;                 ///< whether `--precision` can be asked for
};

/// \param discrete the particles of the case \param operators those of its formulation, as the test uses them
/// \param used the rows that it uses
/// \return the worst row \throws base::FailedComputation as asprone2010::quality::refusal()
template <class Scalar>
asprone2010::quality::Row require_quality(const Options& options, const Case& one,
                                          const asprone2010::numerical_tests::Particles<Scalar>& discrete,
                                          const particles::Operators<Scalar>& operators,
                                          const TestRows& used);

/// Refuses cases that are not worth a table, and shows with `--quality` how good the others are.
class Quality {
  public:
    /// \param rows those that the test uses
    Quality(const Options& options, asprone2010::quality::RowsOf rows) : options_(options), rows_(rows) {}

    /// Cases may come from several threads.
    /// \return a cell with R of the case's worst row; without `--quality` none
    /// \throws base::FailedComputation as require_quality()
    template <class Scalar>
    std::vector<report::Cell> cells(const Case& one,
                                    const asprone2010::numerical_tests::Particles<Scalar>& discrete,
                                    const particles::Operators<Scalar>& operators,
                                    const std::string& end = "");

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
