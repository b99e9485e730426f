#pragma once

#include <map>
#include <string>

#include "report/table.hpp"

namespace command_line {

/// A figure of a table: the script that draws it, the columns that are drawn, and what the script is told beside them.
struct Figure {
    std::string script;       ///< below the folder figures/, such as asprone2010/figure_1.gp
    std::string curve, x, y;  ///< columns: a word for each curve, and numbers
    bool logarithmic = true;  ///< only positive y can be drawn
    std::map<std::string, std::string> told = {};  ///< variables of the script by their names
    std::string path = {};                         ///< the file to write, empty for none
};

/// The folder of the source tree, in which gnuplot runs: scripts load others from there.
std::string source_folder();

/// Refuses before anything is computed what could not be drawn.
/// \throws base::InvalidInput for a path that is no .svg
/// \throws base::FailedComputation where gnuplot, the script or the folder of the file is missing
void check_plot(const Figure& figure, const std::string& folder = source_folder());

/// The script's variables for a table: its columns, its curves and values of x in the order of their rows, and the ranges that hold
/// them.
/// \throws base::FailedComputation for a table without a number to draw
std::map<std::string, std::string> variables(const Figure& figure, const report::Table& table);

/// Draws a table into the figure's file, which is replaced as a whole.
/// \throws base::FailedComputation with gnuplot's complaint; then no file is written
void plot(const Figure& figure, const report::Table& table);

}  // namespace command_line
