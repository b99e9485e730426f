#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "asprone2010/section_5_numerical_tests.hpp"
#include "base/choose.hpp"
#include "base/quad.hpp"
#include "command_line/command_line.hpp"
#include "command_line/plot.hpp"
#include "report/table.hpp"

/// One main per numerical test: it reads options, calls one section and writes one table.
namespace command_line {

/// What the three numerical tests of asprone2010 can be asked.
struct Options {
    std::vector<std::string> formulations{"all"};
    std::vector<long> particles;
    std::optional<std::string> positions_file;
    particles::Column<double> positions;  ///< those of the file, once it is read
    std::string volumes = "equal";
    std::string kernel = "gaussian";
    double smoothing = 1;
    std::string smoothing_from = "mean";
    std::string precision = "double";
    std::vector<double> perturbations{0};
    unsigned long seed = 1;
    unsigned long seeds = 1;
    bool median = false;
    int threads = 0;
    std::string output;
    Figure figure;  ///< what --plot draws: the program knows the script, the options the file
};

/// Numbers of particles from 10 to 2560, four for each doubling.
std::vector<long> four_a_doubling();

/// The options of a numerical test, added to its command line.
/// \param extra formulation names that the program knows beside those of formulations.hpp
void add_options(CommandLine& app, Options& options, const std::vector<std::string>& extra = {});

/// The option --precision, for a program that computes in any.
void add_precision(CommandLine& app, Options& options);

/// Calls `work(Scalar())` with the scalar of a precision: double, long (double) or quad. A zero has the type to compute with.
/// \throws base::InvalidInput for another name
template <class Work>
auto in_precision(const std::string& name, const Work& work) {
    using Zero = std::variant<double, long double, base::Quad>;
    return std::visit(work, base::choose<Zero>("precision", name,
                                               {{"double", 0.0}, {"long", 0.0L}, {"quad", base::Quad(0)}}));
}

/// One thing to compute: a formulation on one line of particles.
struct Case {
    std::string formulation;
    double perturbation;
    Eigen::Index particles;
    unsigned long seed;
};

/// All cases that the options ask for: formulation by formulation, then perturbation, particles and seed.
/// Without a perturbation there is one seed only.
/// \throws base::InvalidInput for what has no meaning, and for more cases or particles than can be held
std::vector<Case> cases(const Options& options, const std::vector<std::string>& extra = {});

/// Perturbation and seed of a case, for a table; empty where the particles lie at the positions of a file.
std::array<report::Cell, 2> drawn(const Options& options, const Case& of);

/// The discretisation of a case.
template <class Scalar = double>
asprone2010::numerical_tests::Particles<Scalar> discretise(const Options& options, const Case& of) {
    const asprone2010::numerical_tests::Discretisation how{
        particles::volumes_named(options.volumes), particles::kernel_named(options.kernel), options.smoothing,
        of.perturbation, particles::spacing_named(options.smoothing_from)};
    if (options.positions.size() == 0)
        return asprone2010::numerical_tests::discretise<Scalar>(how, of.particles, of.seed);
    const particles::Column<Scalar> x = options.positions.cast<Scalar>();
    return asprone2010::numerical_tests::discretise<Scalar>(how, x);
}

/// Computes the numbers of every case in parallel, with progress on a terminal, and appends them to the table behind the
/// columns formulation, particles, spacing, perturbation and seed. With --median, the seeds of a case become one row: the
/// medians, then how many seeds, then the lower and upper quartile of each number.
/// \param compute numbers of a case, as many as the table has further columns; an empty cell stays empty
void tabulate(report::Table& table, const Options& options,
              const std::function<std::vector<report::Cell>(const Case&)>& compute);

/// Comments of the table: the equations of the formulations, and of the options what is the same in all rows.
std::vector<std::string> described(const Options& options);

/// The number of particles as options give it. \throws base::InvalidInput for fewer than a line needs, and for operators
/// of so many that cannot be held
/// \param reach of the kernel, in spacings \param scalar bytes of a number
void check_line(long N, double reach, std::size_t scalar = sizeof(double));

/// Options with the files that they name, none of which may be another's: neither may be lost. A device may be.
/// \throws base::InvalidInput for two that are the same
void check_apart(const std::vector<std::pair<std::string, std::string>>& files);

/// The body of main for a table: options are read, the table is computed and written.
/// \return 0; 2 for a bad invocation; 1 for a failed computation, with one line on standard error
/// \param threads how many, 0 for all \param output the file to write \param figure what to draw of the table besides; all are
///        read once the options are
int run(CommandLine& app, int argc, char** argv, const int& threads, const std::string& output,
        const Figure& figure, const std::function<report::Table()>& compute);

/// The same for a numerical test, whose file of positions is read into its options first.
int run(CommandLine& app, int argc, char** argv, Options& options,
        const std::function<report::Table()>& compute);

}  // namespace command_line
