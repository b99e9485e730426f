#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "asprone2010/section_5_1_derivative_test.hpp"
#include "asprone2010/section_5_2_static_test.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "command_line/cases.hpp"
#include "command_line/formulations.hpp"
#include "command_line/lists.hpp"
#include "command_line/options.hpp"
#include "command_line/sweep.hpp"
#include "report/statistics.hpp"

namespace {

using namespace asprone2010;

/// Which lines of particles are drawn.
struct Draws {
    std::vector<std::string> formulations{"all"};
    long particles = 160;
    double perturbation = 0.25;
    unsigned long seeds = 1000;
};

/// Errors of DB, D²B and u for exp on one draw of perturbed particles.
std::array<double, 3> errors_of(const Formulation<double>& formulation, const Draws& draws,
                                unsigned long seed) {
    numerical_tests::Discretisation how;
    how.perturbation = draws.perturbation;
    const auto discrete = numerical_tests::discretise<double>(how, draws.particles, seed);
    const auto derivatives = derivative_test::errors(formulation, discrete, derivative_test::exponential());
    return {derivatives.first, derivatives.second,
            static_test::error(formulation, discrete, static_test::exponential_load())};
}

/// These errors on every draw, each in increasing order. \throws base::FailedComputation naming the seed
std::array<std::vector<double>, 3> sorted_errors(const std::string& name, const Draws& draws) {
    const auto& formulation = command_line::formulation_named(name);
    std::array<std::vector<double>, 3> errors;
    for (auto& sample : errors) sample.resize(draws.seeds);
    base::for_each_index(static_cast<Index>(draws.seeds), [&](Index k) {
        const auto at = static_cast<std::size_t>(k);
        try {
            const auto found = errors_of(formulation, draws, at + 1);
            for (std::size_t which = 0; which < 3; ++which) errors[which][at] = found[which];
        } catch (const base::FailedComputation& error) {
            throw base::FailedComputation("seed " + std::to_string(at + 1) + ": " + error.what());
        }
    });
    for (auto& sample : errors) std::sort(sample.begin(), sample.end());
    return errors;
}

/// A row for each percentile of the three errors of a formulation.
std::vector<std::vector<report::Cell>> percentiles(const std::string& formulation, const Draws& draws) {
    const auto errors = sorted_errors(formulation, draws);
    std::vector<std::vector<report::Cell>> rows;
    for (long percent = 0; percent <= 100; ++percent) {
        const auto quantile = [&](const std::vector<double>& sample) {
            return report::quantile_of_sorted(sample, static_cast<double>(percent) / 100);
        };
        rows.push_back({formulation, percent, quantile(errors[0]), quantile(errors[1]), quantile(errors[2])});
    }
    return rows;
}

report::Table table_of(const Draws& draws) {
    const numerical_tests::Discretisation how;
    command_line::check_line(draws.particles, particles::support<double>(how.kernel) * how.smoothing);
    report::Table table;
    table.comments = {
        "Beyond Asprone et al. (2010): percentiles of the errors of DB, D2B (Section 5.1) and u (Section 5.2) over seeds 1 to " +
            std::to_string(draws.seeds),
        std::to_string(draws.particles) + " particles, perturbed by " + base::shown(draws.perturbation) +
            " delta, kernel gaussian, h/delta 1, volumes equal"};
    table.columns = {{"formulation"},
                     {"percentile"},
                     {"error_first", {1e-6, 1e-12}},
                     {"error_second", {1e-6, 2e-10}},
                     {"error_displacement", {1e-6, 5e-10}}};
    command_line::Sweep sweep(table, 1);
    for (const std::string& name :
         command_line::chosen("formulation", draws.formulations, command_line::formulation_names(),
                              command_line::names_beside_all()))
        sweep.attempt({name}, [&] { return percentiles(name, draws); });
    sweep.finish();
    return table;
}

}  // namespace

int main(int argc, char** argv) {
    command_line::CommandLine app(
        "The distribution of the errors of DB, D2B and u for exp over many draws of perturbed particles: percentiles.",
        "draws", "Example: draws --formulation modified_fpm,second_order_fpm --particles 160 --seeds 1000");
    Draws draws;
    int threads = 0;
    std::string output;
    app.add_list("--formulation", draws.formulations, "which formulations (default all)");
    app.add_option("--particles", draws.particles, "number of particles (default 160)").type_name("N");
    app.add_option("--perturb", draws.perturbation,
                   "amplitude of the perturbation in spacings (default 0.25)")
        .type_name("A");
    app.add_option("--seeds", draws.seeds, "number of draws, with the seeds 1, 2, ... (default 1000)")
        .type_name("K")
        .within(2, 1000000);
    app.add_threads(threads);
    app.add_output(output);
    command_line::Figure figure{"asprone2010/figure_draws.gp"};
    command_line::add_plot_option(app, figure);

    return command_line::run(app, argc, argv, threads, output, figure, [&] { return table_of(draws); });
}
