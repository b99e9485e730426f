#include "asprone2010/section_5_3_vibration_test.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <string>
#include <utility>
#include <vector>

#include "asprone2010/symbol.hpp"
#include "base/memory.hpp"
#include "command_line/cases.hpp"
#include "command_line/formulations.hpp"
#include "command_line/quality.hpp"
#include "command_line/spectrum.hpp"
#include "command_line/sweep.hpp"

namespace {

using namespace asprone2010;
using command_line::Case;
using command_line::formulation_named;
using command_line::rows_of_modes;
using report::Cell;
using vibration_test::Mass;

const std::vector<std::string> references{"fem_lumped", "fem_consistent"};

/// The options of this test, and those of all numerical tests.
struct Options : command_line::Options {
    long lowest = 0;  ///< the number of modes; 0 for all
};

/// \throws base::InvalidInput for what has no spectrum, no lowest modes, or no figure
void check(const Options& options) {
    const bool drawn = !options.figure.path.empty();
    const auto& asked = options.formulations;
    if (options.lowest > 0 && std::find(asked.begin(), asked.end(), "fem_consistent") != asked.end())
        throw base::InvalidInput(
            "--lowest does not know fem_consistent; leave it out, or leave --lowest out");
    if (drawn && options.particles.size() * options.perturbations.size() > 1)
        throw base::InvalidInput(
            "--plot draws one spectrum for each formulation; take one number of particles and one perturbation");
    if (drawn && options.lowest > 0)
        throw base::InvalidInput("--plot draws whole spectra; leave --lowest out");
    for (const long N : options.particles) {
        if (N == 2)
            throw base::InvalidInput("2 particles fixed at both ends cannot vibrate; take at least 3");
        if (options.lowest > 0 && N < options.lowest + 4)
            throw base::InvalidInput("--lowest " + std::to_string(options.lowest) + " needs at least " +
                                     std::to_string(options.lowest + 4) + " particles, got " +
                                     std::to_string(N));
        const auto rows = static_cast<double>(N);
        if (options.lowest == 0)  // up to four full matrices
            base::require_memory("the eigenvalues on " + std::to_string(N) + " particles",
                                 4 * sizeof(double) * rows * rows, "take fewer particles");
    }
}

using Rows = std::vector<std::vector<Cell>>;

/// The cells that name a case.
std::vector<Cell> named(const Options& options, const Case& one) {
    const auto [perturbation, seed] = command_line::perturbation_and_seed(options, one);
    return {one.formulation, static_cast<long>(one.particles), perturbation, seed};
}

/// D² of a case. \throws base::FailedComputation where it is not worth a table
Operator<double> second_derivative(const Options& options, const Case& one,
                                   const numerical_tests::Particles<double>& discrete) {
    if (one.formulation == "fem_lumped") return vibration_test::lumped_second_derivative(discrete.line);
    const auto operators = formulation_named(one.formulation).operators(discrete.line, discrete.smoothing);
    command_line::require_quality(
        options, one, discrete, operators,
        {options.lowest > 0 ? quality::of_lowest_modes : quality::of_vibration_test});
    return operators.D2;
}

/// The lowest modes of a case, with their residuals.
Rows lowest_modes(const Options& options, const Case& one) {
    const auto modes = vibration_test::lowest_modes(
        second_derivative(options, one, command_line::line_of(options, one)), options.lowest);
    std::vector<std::complex<double>> omega(modes.size());
    std::transform(modes.begin(), modes.end(), omega.begin(),
                   [](const vibration_test::Mode& mode) { return mode.frequency; });
    return rows_of_modes(named(options, one), omega, vibration_test::exact_frequency,
                         [&](Index, std::size_t k) { return modes[k].residual; });
}

std::vector<std::complex<double>> frequencies(const Options& options, const Case& one) {
    const auto discrete = command_line::line_of(options, one);
    if (one.formulation == "fem_lumped")
        return vibration_test::finite_element_frequencies(discrete.line, Mass::lumped);
    if (one.formulation == "fem_consistent")
        return vibration_test::finite_element_frequencies(discrete.line, Mass::consistent);
    return vibration_test::frequencies(vibration_test::stiffness(second_derivative(options, one, discrete)));
}

/// The ratios of the symbol of D²; empty for finite elements and for particles that do not lie on a lattice.
std::vector<Cell> symbol_ratios(const Options& options, const Case& one) {
    std::vector<Cell> ratios(static_cast<std::size_t>(one.particles - 2));
    if (one.formulation.starts_with("fem") || one.perturbation != 0 || options.positions.size() > 0)
        return ratios;
    const numerical_tests::Discretisation lattice{particles::volumes_named(options.volumes),
                                                  particles::kernel_named(options.kernel), options.smoothing};
    const std::vector<double> omega =
        limit_stencils::symbol_frequencies(formulation_named(one.formulation), lattice, one.particles);
    for (std::size_t k = 0; k < omega.size(); ++k)
        ratios[k] = omega[k] / vibration_test::exact_frequency(static_cast<Index>(k + 1));
    return ratios;
}

/// All modes of a case, beside the symbol's.
Rows all_modes(const Options& options, const Case& one) {
    const auto omega = frequencies(options, one);
    const auto ratios = symbol_ratios(options, one);
    return rows_of_modes(named(options, one), omega, vibration_test::exact_frequency,
                         [&](Index n, std::size_t) { return ratios[static_cast<std::size_t>(n - 1)]; });
}

/// "not real: fpm 4 of 98": for each case of which some frequencies have an imaginary part.
std::string not_real(const report::Table& table) {
    std::vector<std::pair<std::string, std::array<int, 2>>> cases;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const auto* imaginary = std::get_if<double>(&table.rows[row][table.column("frequency_imaginary")]);
        if (imaginary == nullptr) continue;
        std::string name =
            table.word(row, "formulation") + ", " + table.word(row, "particles") + " particles";
        if (const std::string seed = table.word(row, "seed");
            table.word(row, "perturbation") != "0" && !seed.empty())
            name += ", seed " + seed;
        if (cases.empty() || cases.back().first != name) cases.push_back({name, {}});
        auto& [some, all] = cases.back().second;
        const double real = std::get<double>(table.rows[row][table.column("frequency")]);
        some += std::abs(*imaginary) > 1e-9 * std::abs(real) ? 1 : 0;
        ++all;
    }
    std::string words;
    for (const auto& [name, counts] : cases)
        if (counts[0] > 0)
            words += (words.empty() ? "not real: " : "; ") + name + " " + std::to_string(counts[0]) + " of " +
                     std::to_string(counts[1]);
    return words;
}

report::Table table_of(const Options& options) {
    check(options);
    const bool all = options.lowest == 0;
    report::Table table;
    table.comments = {
        "Asprone et al. (2010), Section 5.3, Figure 3: frequencies sqrt(-lambda) of (52) against (51), omega_n = pi n",
        "fem_lumped, fem_consistent: linear finite elements between the same particles",
        all ? "ratio_symbol: the same of the symbol of D2 on an infinite lattice, at the waves that fit between the ends; empty where particles do not lie on a lattice"
            : "residual: |x/omega^2 + inverse(K) x| / |x/omega^2|, K of (52)"};
    for (const std::string& comment : command_line::header_comments(options))
        table.comments.push_back(comment);
    table.columns = {{"formulation"}, {"particles"}, {"perturbation"}, {"seed"}};
    for (const report::ColumnHead& column : command_line::columns_of_modes()) table.columns.push_back(column);
    table.columns.push_back(all ? report::ColumnHead{"ratio_symbol", {1e-8, 1e-9}}
                                : report::ColumnHead{"residual", {1, 1e-9}});
    command_line::Sweep sweep(table, 4);
    for (const Case& one :
         command_line::cases(options, all ? references : std::vector<std::string>{"fem_lumped"}))
        sweep.attempt(named(options, one), [&] { return (all ? all_modes : lowest_modes)(options, one); });
    sweep.finish();
    if (const std::string words = not_real(table); !words.empty())
        table.comments.push_back("frequencies that are " + words +
                                 "; those without a real part belong to no mode");
    return table;
}

}  // namespace

int main(int argc, char** argv) {
    command_line::CommandLine app(
        "Section 5.3 of Asprone et al. (2010): natural frequencies of an elastic rod that is fixed at both ends.",
        "vibration_test",
        "Example: vibration_test --formulation second_order_fpm,fem_lumped --particles 50\n"
        "Another: vibration_test --formulation second_order_fpm --particles 100000 --lowest 10\n"
        "A third: vibration_test --particles 50 --perturb 0.2 --smoothing-from largest");
    Options options;
    options.particles = {100};
    options.figure = {"asprone2010/figure_3.gp"};
    command_line::add_options(app, options, references);
    command_line::add_plot_option(app, options.figure);
    app.add_option(
           "--lowest", options.lowest,
           "number of modes, those of least |omega|, with their residuals: for long lines; not for fem_consistent (default: all modes)")
        .type_name("K")
        .within(1, 100);
    return command_line::run(app, argc, argv, options, [&] { return table_of(options); });
}
