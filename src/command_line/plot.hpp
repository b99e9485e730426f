#pragma once

#include <optional>
#include <string>

#include "command_line/command_line.hpp"
#include "report/table.hpp"

namespace command_line {

/// A figure of a table.
struct Figure {
    std::string script;     ///< gnuplot's, below the folder figures/, such as asprone2010/figure_1.gp
    std::string path = {};  ///< the file to write; empty for none
    std::optional<report::Table> table{};  ///< of the figure, if it is not the table that is written
};

/// `--plot`, added to a command line.
void add_plot_option(CommandLine& app, Figure& figure);

/// The folder of the source tree, where the scripts lie.
std::string source_folder();

/// Checks before any computation that a figure can be drawn.
/// \throws base::InvalidInput for a path that is no .svg
/// \throws base::FailedComputation where gnuplot, the script or the folder of the file is missing
void check_plot(const Figure& figure, const std::string& folder = source_folder());

/// Draws a table into the figure's file, which is replaced as a whole: gnuplot -e "table='…'; output='…'"
/// script.
/// \throws base::FailedComputation with gnuplot's complaint; then no file is written
void plot(const Figure& figure, const report::Table& table);

}  // namespace command_line
