#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "asprone2010/section_5_numerical_tests.hpp"
#include "command_line/command_line.hpp"
#include "command_line/options.hpp"
#include "report/table.hpp"

namespace command_line {

/// The options of the three numerical tests of asprone2010.
struct Options {
    std::vector<std::string> formulations{"all"};
    std::vector<long> particles;
    std::optional<std::string> positions_file;
    std::vector<std::string> columns;     ///< of the positions in the file
    particles::Column<double> positions;  ///< from the file, once it is read
    std::string volumes = "equal";
    std::string kernel = "gaussian";
    double smoothing = 1;
    std::string smoothing_from = "mean";
    particles::Spacing spacing = particles::Spacing::mean;  ///< of this name, once a file is read
    std::string precision = "double";
    std::vector<double> perturbations{0};
    unsigned long seed = 1;
    unsigned long seeds = 1;
    bool median = false;
    bool quality = false;
    bool states = false;
    int threads = 0;
    std::string output;
    Figure figure;  ///< the program sets the script, --plot the file
};

/// Numbers of particles from 10 to 2560, four for each doubling.
std::vector<long> four_a_doubling();

/// Adds the options of a numerical test to its command line. The numbers of particles have their default.
/// \param extra names that the program takes beside those of the formulations, such as fem_lumped
void add_options(CommandLine& app, Options& options, const std::vector<std::string>& extra = {});

/// Adds --median, for a program whose cases have one row each.
void add_median(CommandLine& app, Options& options);

/// Adds --states, for a program that has values at each particle.
void add_states(CommandLine& app, Options& options);

/// Adds --precision, for a program that computes in any.
void add_precision(CommandLine& app, Options& options);

/// One thing to compute: a formulation on one line of particles.
struct Case {
    std::string formulation;
    double perturbation;
    Eigen::Index particles;
    unsigned long seed;
};

/// All cases of the options: formulation by formulation, then perturbation, number of particles and seed.
/// Without a perturbation there is one seed only.
/// \throws base::InvalidInput for what has no meaning, and for more cases or particles than fit into memory
std::vector<Case> cases(const Options& options, const std::vector<std::string>& extra = {});

/// Perturbation and seed of a case, for a table; empty for the positions of a file.
std::array<report::Cell, 2> perturbation_and_seed(const Options& options, const Case& one);

/// How the line of a case is made and smoothed.
asprone2010::numerical_tests::Discretisation discretisation_of(const Options& options, const Case& one);

/// The line of particles of a case, with the kernel that smooths over it.
template <class Scalar = double>
asprone2010::numerical_tests::Particles<Scalar> line_of(const Options& options, const Case& one) {
    const auto how = discretisation_of(options, one);
    if (options.positions.size() == 0)
        return asprone2010::numerical_tests::discretise<Scalar>(how, one.particles, one.seed);
    const particles::Column<Scalar> x = options.positions.cast<Scalar>();
    return asprone2010::numerical_tests::discretise<Scalar>(how, x);
}

/// Computes the numbers of every case in parallel, with progress on a terminal, and adds a row for each to
/// the table, behind the columns formulation, particles, spacing, perturbation and seed. With --median, the
/// seeds of a case become one row: medians, the number of seeds, then lower and upper quartile of each
/// number. Cases that fail keep their rows, as Sweep says.
/// \param compute the numbers of a case, one for each column of the table; an empty cell stays empty
void tabulate(report::Table& table, const Options& options,
              const std::function<std::vector<report::Cell>(const Case&)>& compute);

/// Adds rows for the particles of every case to the table, behind the columns formulation, particles,
/// perturbation, seed, particle and x. Cases that fail keep a row, as Sweep says.
/// \param compute a row for each particle of a case: x, and a number for each column of the table
void tabulate_states(report::Table& table, const Options& options,
                     const std::function<std::vector<std::vector<report::Cell>>(const Case&)>& compute);

/// The table that is asked for: of largest errors, or with --states of each particle. Where positions come
/// from a file, --plot draws the states, since the largest errors are one point. Largest errors that go to
/// the standard output have their observed orders beside them.
/// \param script of a figure of states
report::Table errors_or_states(Options& options, const std::function<report::Table()>& errors,
                               const std::function<report::Table()>& states, const std::string& script);

/// Comments of the table: the equations of the formulations, and the options that all rows share.
std::vector<std::string> header_comments(const Options& options);

/// Checks the number of particles of a line.
/// \param reach of the kernel, in spacings \param scalar bytes of a number
/// \throws base::InvalidInput for fewer than 2, and for so many that their operators do not fit into memory
void check_line(long N, double reach, std::size_t scalar = sizeof(double));

/// The body of main for a numerical test. As run() for a table; a file of positions is read first.
int run(CommandLine& app, int argc, char** argv, Options& options,
        const std::function<report::Table()>& compute);

}  // namespace command_line
