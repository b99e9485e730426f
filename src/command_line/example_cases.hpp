#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "batra2008/section_4_example_problems.hpp"
#include "command_line/command_line.hpp"
#include "command_line/plot.hpp"
#include "fpm_in_space/section_7_plate_and_hole.hpp"
#include "report/table.hpp"

namespace command_line {

/// The options of both example problems of batra2008.
struct ExampleOptions {
    std::vector<std::string> methods{"all"};
    std::vector<double> scaling{3}, test_scaling{1}, penalty{1}, poisson{0.33};
    std::vector<long> gauss{10}, degree{2};
    double smoothing = 1.2;
    std::string plane = "stress";
    std::optional<std::string> smoothing_from;
    std::string fpm_smoothing_from = "nearest";  ///< where --smoothing-from is not given; SSPH takes nearest
    std::string states, field;
    long points = 101;
    bool seconds = false, quality = false;
    int threads = 0;
    std::string output;
    Figure figure;  ///< the program sets the script, --plot the file
    /// Whether an option is on the command line.
    std::function<bool(const std::string& option)> given = [](const std::string&) { return false; };

    [[nodiscard]] std::string smoothing_of_fpm_from() const {
        return smoothing_from.value_or(fpm_smoothing_from);
    }
};

/// Adds the options of an example problem to its command line.
/// \param places what `--states` takes beside particles and a grid
void add_options(CommandLine& app, ExampleOptions& options, const std::string& places);

/// Refuses an option that names the same file as one of the outputs. \throws base::InvalidInput
void check_apart_from_outputs(const ExampleOptions& options, const std::string& option,
                              const std::string& file);

/// Refuses particles whose matrices do not fit into memory. \throws base::InvalidInput
/// \param neighbours least number of a particle's neighbours within the support of the basis
void check_cloud(double particles, double neighbours);

/// One thing to solve: a method with its parameters, and a material.
struct ExampleCase {
    std::string method;
    batra2008::example_problems::Discretisation ssph;  ///< of strong, weak1 and weak2
    fpm_in_space::plate_and_hole::Discretisation fpm;
    batra2008::elastostatics::Material material;

    [[nodiscard]] bool is_fpm() const { return method == "fpm"; }
    /// Whether the method imposes conditions at the particles of the boundary, corners among them.
    [[nodiscard]] bool is_collocation() const { return method == "strong" || is_fpm(); }
};

/// All cases of the options, method by method.
/// \param E Young's modulus \param penalty the print's penalty parameter, which `--penalty` multiplies
/// \throws base::InvalidInput for what has no meaning, and for more cases than fit into memory
std::vector<ExampleCase> cases(
    const ExampleOptions& options, double E,
    const std::function<double(const batra2008::elastostatics::Material&)>& penalty);

/// Columns that name a case, and the cells that fill them.
std::vector<report::ColumnHead> case_columns();
std::vector<report::Cell> case_cells(const ExampleCase& one);

}  // namespace command_line
