#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "base/text.hpp"
#include "command_line/lists.hpp"
#include "command_line/membranes.hpp"
#include "command_line/options.hpp"
#include "command_line/progress.hpp"
#include "command_line/spectrum.hpp"
#include "command_line/sweep.hpp"

namespace {

using namespace fpm_in_space;
using command_line::MembraneCase;
using command_line::MembraneOptions;
using particles::Index;
using report::Cell;

/// The rows of a case, or why it has none.
struct Result {
    std::vector<std::vector<Cell>> rows;
    std::string pairs;  ///< how many are complex, in words
    std::optional<command_line::Failure> failure;
};

std::vector<Cell> named(const MembraneCase& one) {
    const auto& [layout, perturbation, n, seed] = one.cloud;
    return {one.formulation, n, perturbation, one.cloud.is_drawn() ? Cell(static_cast<long>(seed)) : Cell()};
}

template <int dim>
Result result(const MembraneOptions& options, const MembraneCase& one) {
    Result found;
    found.failure = command_line::failure_of([&] {
        const vibration_test::Frequencies omega = command_line::frequencies<dim>(options, one);
        const auto exact = vibration_test::exact_frequencies<dim>(static_cast<Index>(omega.size()));
        const std::vector<double> waves = command_line::symbol_frequencies<dim>(options, one);
        const auto exact_of = [&](Index m) { return exact[static_cast<std::size_t>(m - 1)]; };
        found.rows = command_line::rows_of_modes(named(one), omega, exact_of, [&](Index m, std::size_t) {
            return waves.empty() ? Cell() : Cell(waves[static_cast<std::size_t>(m - 1)] / exact_of(m));
        });
        found.pairs = std::to_string(vibration_test::complex_pairs(omega)) + ", of " +
                      std::to_string(omega.size()) + " modes";
    });
    return found;
}

template <int dim>
report::Table table_of(const MembraneOptions& options) {
    report::Table table;
    table.comments = {
        "FPM in space, Section 6: frequencies sqrt(-lambda) of (F20) and (F22) against (F21), pi sqrt(m^2 + ...) in order",
        "ratio_symbol: the same of the symbol on an infinite lattice, at the waves that vanish on the sides; empty where particles do not lie on a lattice",
        command_line::kernel_comment(options)};
    const std::vector<MembraneCase> all = command_line::cases(options);
    if (std::any_of(all.begin(), all.end(), [](const MembraneCase& one) { return one.is_elements(); }))
        table.comments.emplace_back(
            "fem_lumped, fem_consistent: (F23), linear triangles between the same particles");
    table.columns = {{"formulation"}, {"particles"}, {"perturbation"}, {"seed"}};
    for (const report::ColumnHead& column : command_line::columns_of_modes()) table.columns.push_back(column);
    table.columns.push_back({"ratio_symbol", {1e-8, 1e-9}});
    command_line::Sweep sweep(table, 4);
    const auto results = command_line::computed_in_parallel(
        all, [&](const MembraneCase& one) { return result<dim>(options, one); });
    for (std::size_t k = 0; k < all.size(); ++k) {
        const auto& [formulation, cloud] = all[k];
        if (results[k].failure) {
            sweep.add_failed(named(all[k]), *results[k].failure);
            continue;
        }
        sweep.add(results[k].rows);
        table.comments.push_back("complex pairs: " + formulation + ", " + std::to_string(cloud.n) +
                                 " particles along a side" +
                                 (cloud.is_drawn() ? ", perturbation " + base::shown(cloud.perturbation) +
                                                         ", seed " + std::to_string(cloud.seed)
                                                   : "") +
                                 ": " + results[k].pairs);
    }
    sweep.finish();
    return table;
}

}  // namespace

int main(int argc, char** argv) {
    command_line::CommandLine app(
        "Section 6 of our own text: natural frequencies of a membrane on the unit square that is held at its sides; in space, of the air in a cube.",
        "vibration_test_in_space",
        "Example: vibration_test_in_space --formulation definite_fpm,fem_lumped --particles 20 --perturb 0,0.25 --plot /tmp/membrane.svg\n"
        "Another: vibration_test_in_space --formulation definite_fpm --particles 31,61,121 --lowest 10\n"
        "In space: vibration_test_in_space --dimension 3 --particles 9 --lowest 4 --formulation definite_fpm");
    MembraneOptions options;
    options.formulations.clear();
    options.on_square = true;
    options.figure.script = "fpm_in_space/figure_membrane.gp";
    app.column_width(34);
    app.add_option("--dimension", options.dimension, "2, the plane (default), or 3, space")
        .type_name("2|3")
        .within(2, 3);
    app.add_list("--formulation", options.formulations,
                 "formulations: all, or some of " +
                     command_line::joined(command_line::membrane_formulations(2)) +
                     " (default original,ssph,cubic_ssph,definite_fpm)");
    app.add_list("--particles", options.particles,
                 "particles along a side: a list or a range (default 30; in space 9)");
    command_line::add_draw_options(app, options);
    command_line::add_kernel_options(app, options);
    app.add_option("--lowest", options.lowest,
                   "number of modes, those of least |omega|: for large grids (default: all modes)")
        .type_name("K")
        .within(1, 100);
    command_line::add_plot_option(app, options.figure);
    app.add_threads(options.threads);
    app.add_output(options.output);
    return command_line::run(app, argc, argv, options.threads, options.output, options.figure, [&] {
        command_line::complete(options);
        return options.dimension == 2 ? table_of<2>(options) : table_of<3>(options);
    });
}
