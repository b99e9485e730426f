#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bodies/approximation.hpp"
#include "command_line/body_conditions.hpp"
#include "command_line/command_line.hpp"
#include "command_line/plot.hpp"

namespace command_line {

/// The options of the program `body`.
struct BodyOptions {
    std::string mesh, points, boundary;
    std::optional<double> size, snap;
    TypedProblem problem;
    std::vector<std::string> methods;  ///< none: hats for a body with cells, else weak1
    std::optional<long> degree;
    long gauss = 10;
    double scaling = 3, smoothing = 1.2, penalty = 1;
    std::string smoothing_from = "local";
    std::vector<Typed> places;  ///< --at and --along
    long modes = 0, refine = 1;
    bool seconds = false;
    std::string field, output;
    int threads = 0;
    Figure figure{"bodies/body.gp"};
};

/// Adds the options to a command line.
void add_options(CommandLine& app, BodyOptions& options);

/// Some of them: those of the methods.
void add_method_options(CommandLine& app, BodyOptions& options);

/// Those of the methods that collocate, fpm and strong.
void add_collocation_options(CommandLine& app, BodyOptions& options);

std::vector<std::string> names_of_all_methods();

/// \param known the methods that the program has, for a remedy
/// \throws base::InvalidInput for numbers without meaning, and for an option that belongs to none of the
///         methods
void check_methods(const BodyOptions& options, const std::vector<std::string>& known);

/// \throws base::InvalidInput for options that need, exclude or overwrite one another, and numbers without
///         meaning
void check(const BodyOptions& options);

/// A method with its parameters, but for the smoothing lengths and what weak forms need.
bodies::Discretisation discretisation(const BodyOptions& options, const std::string& method, int dim);

/// The methods that are asked for, with their parameters.
/// \throws base::InvalidInput for an option that belongs to other methods, and for smoothing lengths of
///         another number of particles
template <int dim>
std::vector<bodies::Discretisation> discretisations(const BodyOptions& options,
                                                    const bodies::Body<dim>& body);

/// The places of `--at` and `--along`, in the order of the command line.
/// \throws base::InvalidInput for a text that names no place
template <int dim>
std::vector<bodies::Point<dim>> places(const BodyOptions& options);

/// The body, a comment of the table.
std::string comment_on_body(const BodyOptions& options);

/// The equation and the conditions, two comments.
std::vector<std::string> comments(const TypedProblem& problem, int dim);

}  // namespace command_line
