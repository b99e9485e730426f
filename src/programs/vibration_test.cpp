#include "asprone2010/section_5_3_vibration_test.hpp"

#include <string>
#include <vector>

#include "asprone2010/limit_stencils.hpp"
#include "base/memory.hpp"
#include "command_line/formulations.hpp"
#include "command_line/options.hpp"

namespace {

using namespace asprone2010;

/// The frequencies of the symbol of D²; none for finite elements and for particles that do not lie on a lattice.
std::vector<double> symbol_frequencies(const command_line::Options& options, const command_line::Case& line) {
    if (line.formulation.starts_with("fem") || line.perturbation != 0 || options.positions.size() > 0)
        return {};
    return limit_stencils::symbol_frequencies(command_line::formulation_named(line.formulation),
                                              {particles::volumes_named(options.volumes),
                                               particles::kernel_named(options.kernel), options.smoothing},
                                              line.particles);
}

}  // namespace

int main(int argc, char** argv) {
    command_line::CommandLine app(
        "Section 5.3 of Asprone et al. (2010): natural frequencies of an elastic rod that is fixed at both "
        "ends.",
        "vibration_test",
        "Example: vibration_test --formulation second_order_fpm,fem_lumped --particles 50\n"
        "Another: vibration_test --formulation second_order_fpm --particles 1000000 --lowest 10\n"
        "A third: vibration_test --particles 50 --perturb 0.2 --smoothing-from largest");
    const std::vector<std::string> references{"fem_lumped", "fem_consistent"};
    command_line::Options options;
    options.particles = {100};
    options.figure = {"asprone2010/figure_3.gp"};
    command_line::add_options(app, options, references);
    long lowest = 0;
    app.add_option(
           "--lowest", lowest,
           "only so many modes, those of least |omega|, with their residuals: for long lines (default: all "
           "modes)")
        .type_name("K")
        .within(1, 100);

    return command_line::run(app, argc, argv, options, [&] {
        using vibration_test::Mass;
        if (options.median)
            throw base::InvalidInput("vibration_test has no --median: a spectrum is a row per mode");
        if (!options.figure.path.empty() && options.particles.size() * options.perturbations.size() > 1)
            throw base::InvalidInput(
                "--plot draws one spectrum for each formulation; take one number of particles and one "
                "perturbation");
        for (const long N : lowest > 0 ? std::vector<long>{} : options.particles)  // up to four full matrices
            base::require_memory("the eigenvalues on " + std::to_string(N) + " particles",
                                 4 * sizeof(double) * static_cast<double>(N) * static_cast<double>(N),
                                 "take fewer particles");
        report::Table table;
        table.comments = {
            "Asprone et al. (2010), Section 5.3, Figure 3: frequencies sqrt(-lambda) of (52) against (51), "
            "omega_n = pi n",
            "fem_lumped, fem_consistent: linear finite elements between the same particles",
            "ratio_symbol: the same of the symbol of D2 on an infinite lattice, at the waves that fit "
            "between the "
            "ends; empty where particles do not lie on a lattice"};
        for (const std::string& comment : command_line::described(options)) table.comments.push_back(comment);
        table.columns = {{"formulation"},
                         {"particles"},
                         {"perturbation"},
                         {"seed"},
                         {"mode"},
                         {"frequency", {1e-8, 1e-8}},
                         {"frequency_imaginary", {1e-8, 1e-8}},
                         {"exact"},
                         {"ratio", {1e-8, 1e-9}},
                         {"ratio_symbol", {1e-8, 1e-9}}};
        if (lowest > 0) {
            if (!options.figure.path.empty())
                throw base::InvalidInput("--plot draws whole spectra; leave --lowest out");
            table.comments[2] = "residual: |x/omega^2 + inverse(K) x| / |x/omega^2|, K of (52)";
            table.columns.back() = {"residual", {1, 1e-9}};
        }
        for (const command_line::Case& of :
             command_line::cases(options, lowest > 0 ? std::vector<std::string>{} : references)) {
            const auto discrete = command_line::discretise(options, of);
            if (of.particles < 3)
                throw base::InvalidInput("2 particles fixed at both ends cannot vibrate; take at least 3");
            if (lowest > 0) {
                if (of.particles < lowest + 4)
                    throw base::InvalidInput("--lowest " + std::to_string(lowest) + " needs at least " +
                                             std::to_string(lowest + 4) + " particles, got " +
                                             std::to_string(of.particles));
                const auto operators = command_line::formulation_named(of.formulation)
                                           .operators(discrete.line, discrete.smoothing);
                const auto [perturbation, seed] = command_line::drawn(options, of);
                long n = 0;
                for (const vibration_test::Mode& mode : vibration_test::lowest_modes(operators.D2, lowest)) {
                    const double exact = vibration_test::exact_frequency(++n);
                    table.rows.push_back({of.formulation, static_cast<long>(of.particles), perturbation, seed,
                                          n, mode.frequency.real(), mode.frequency.imag(), exact,
                                          mode.frequency.real() / exact, mode.residual});
                }
                continue;
            }
            const auto frequencies =
                of.formulation == "fem_lumped"
                    ? vibration_test::finite_element_frequencies(discrete.line, Mass::lumped)
                : of.formulation == "fem_consistent"
                    ? vibration_test::finite_element_frequencies(discrete.line, Mass::consistent)
                    : vibration_test::frequencies(command_line::formulation_named(of.formulation), discrete);
            const std::vector<double> symbol = symbol_frequencies(options, of);
            const auto [perturbation, seed] = command_line::drawn(options, of);
            for (std::size_t k = 0; k < frequencies.size(); ++k) {
                const auto n = static_cast<Index>(k + 1);
                const double exact = vibration_test::exact_frequency(n);
                table.rows.push_back({of.formulation, static_cast<long>(of.particles), perturbation, seed,
                                      static_cast<long>(n), frequencies[k].real(), frequencies[k].imag(),
                                      exact, frequencies[k].real() / exact,
                                      symbol.empty() ? report::Cell() : report::Cell(symbol[k] / exact)});
            }
        }
        return table;
    });
}
