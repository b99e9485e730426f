#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "command_line/command_line.hpp"
#include "command_line/plot.hpp"
#include "fpm_in_space/section_4_derivative_test.hpp"
#include "particles/spacing.hpp"

namespace command_line {

/// The options of a test in the plane and in space.
struct CloudOptions {
    long dimension = 2;
    std::vector<std::string> formulations{"definite_fpm", "ssph"}, layouts{"grid"}, columns;
    std::vector<long> particles;  ///< along a side of a grid
    std::vector<double> perturbations{0};
    unsigned long seed = 1, seeds = 1;
    bool median = false, states = false;
    long sample = 0;
    std::optional<std::string> kernel, cut, function;
    bool on_square = false;  ///< whether the test is one of the unit square or cube
    double smoothing = 1.2;
    std::string smoothing_from = "mean";
    int threads = 0;
    std::string output;
    Figure figure{"fpm_in_space/errors.gp"};

    particles::Spacing spacing = particles::Spacing::mean;  ///< of the name `smoothing_from`, once read
    std::map<std::string, Eigen::MatrixXd> files;  ///< positions, a column for each particle, once read
};

/// Adds the options to a command line.
void add_options(CommandLine& app, CloudOptions& options);

/// Some of them: those of draws, of the kernel and of its smoothing length.
void add_draw_options(CommandLine& app, CloudOptions& options);
void add_kernel_options(CommandLine& app, CloudOptions& options);

/// \throws base::InvalidInput for options of a grid that have no effect or no meaning
void check_grids(const CloudOptions& options);

/// Sets the defaults that depend on other options, and reads each file once.
/// \throws base::InvalidInput for options without effect or meaning, for a figure that cannot be drawn, and
///         for files that cannot be read or would be overwritten
void complete(CloudOptions& options);

/// Particles of which all formulations are computed.
struct CloudCase {
    std::string layout;
    double perturbation;
    long n;  ///< particles along a side of a grid
    unsigned long seed;

    [[nodiscard]] bool is_grid() const;
    /// Whether another seed gives other particles.
    [[nodiscard]] bool is_drawn() const;
};

/// Cases that differ in their seeds only: with --median, one row.
struct Draws {
    CloudCase first;
    unsigned long seeds = 1;
};

std::vector<Draws> draws(const CloudOptions& options);

/// The cases of all draws.
std::vector<CloudCase> cases(const std::vector<Draws>& draws);

/// The names of the formulations that are asked for.
std::vector<std::string> formulations_of(const CloudOptions& options);

/// "x" and "y", in space "z", too.
std::vector<std::string> axes(long dimension);

/// Particles, and those that lie at each place: of a grid, at most as many of a place as --sample says.
template <int dim>
struct Placed {
    particles::Cloud<dim> cloud;
    std::vector<std::pair<std::string, particles::Range>> places;
};

/// The particles of a case.
/// \throws base::InvalidInput naming the layout, where its particles are no cloud
template <int dim>
Placed<dim> placed(const CloudOptions& options, const CloudCase& one);

/// δ of h/δ: one for all particles, or one for each. For `mean` on a stretched grid it is the spacing of the
/// grid times the local stretch at each particle, the larger one where axes differ. [length]
template <int dim>
particles::Column<double> spacing(const CloudOptions& options, const CloudCase& one,
                                  const particles::Cloud<dim>& cloud);

/// The kernel, with its smoothing lengths.
/// \param spacing δ of h/δ, one for all particles, or one for each [length]
template <int dim>
particles::Smoothing<double, dim> smoothing(const CloudOptions& options,
                                            const particles::Column<double>& spacing);

/// The function B: that of --function, or the default. A mixed second derivative follows from the second
/// derivatives along the axes and along their sum:
/// \f[ 2\,\partial_{12} f = \partial^2_{1+2} f - \partial_{11} f - \partial_{22} f \f]
template <int dim>
fpm_in_space::derivative_test::Function<dim> function(const CloudOptions& options);

/// "kernel gaussian, lowered to zero at 3.5 h, h/delta 1.2"
std::string kernel_comment(const CloudOptions& options);

/// Comments of a table. \param what it holds
std::vector<std::string> comments(const CloudOptions& options, const std::string& what);

}  // namespace command_line
