#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "asprone2010/section_5_1_derivative_test.hpp"
#include "asprone2010/section_5_2_static_test.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "command_line/formulations.hpp"
#include "command_line/options.hpp"
#include "command_line/progress.hpp"
#include "report/statistics.hpp"

namespace {

using namespace asprone2010;

constexpr std::array<Index, 3> numbers{161, 321, 641};

/// A square of the map.
struct Square {
    std::string formulation, kernel;
    double smoothing, perturbation;
};

/// Medians over the seeds of the errors of DB, D²B and u for exp; none where an error cannot be computed for some seed.
std::array<std::optional<double>, 3> errors(const Square& of, Index N, unsigned long seeds) {
    const numerical_tests::Discretisation how{particles::Volumes::equal, particles::kernel_named(of.kernel),
                                              of.smoothing, of.perturbation};
    const auto& formulation = command_line::formulation_named(of.formulation);
    const unsigned long last = of.perturbation == 0 ? 1 : seeds;
    std::array<std::vector<double>, 3> samples;
    for (unsigned long seed = 1; seed <= last; ++seed) {
        const auto discrete = numerical_tests::discretise<double>(how, N, seed);
        try {
            const auto derivatives =
                derivative_test::errors(formulation, discrete, derivative_test::exponential());
            samples[0].push_back(derivatives.first);
            samples[1].push_back(derivatives.second);
            samples[2].push_back(static_test::error(formulation, discrete, static_test::exponential_load()));
        } catch (const base::FailedComputation&) {  // too few neighbours, or no displacement
        }
    }
    std::array<std::optional<double>, 3> medians;
    for (std::size_t k = 0; k < 3; ++k)
        if (samples[k].size() == last) medians[k] = report::quartiles(samples[k]).median;
    return medians;
}

/// Orders of the three errors, then the last error over δ to the rounded order; empty where it cannot be computed.
std::vector<report::Cell> orders(const Square& of, unsigned long seeds) {
    std::vector<double> spacing;
    std::array<std::vector<double>, 3> error;
    for (const Index N : numbers) {
        spacing.push_back(1 / static_cast<double>(N - 1));
        const auto found = errors(of, N, seeds);
        for (std::size_t k = 0; k < 3; ++k)
            if (found[k]) error[k].push_back(*found[k]);
    }
    std::vector<report::Cell> cells(6);
    for (std::size_t k = 0; k < 3; ++k) {
        if (error[k].size() < numbers.size()) continue;
        const double order = report::observed_order(spacing, error[k]);
        cells[k] = order;
        cells[k + 3] = error[k].back() * std::pow(spacing.back(), -std::round(order));
    }
    return cells;
}

}  // namespace

int main(int argc, char** argv) {
    command_line::CommandLine app(
        "Map of orders: the observed order of the errors of DB, D2B and u for exp, by formulation, kernel "
        "and h/delta, "
        "on equidistant and on perturbed particles.",
        "orders", "Example: orders --from 0.8 --to 2 --step 0.05 --output orders.csv");
    double from = 0.6, step = 0.2, to = 4;
    unsigned long seeds = 5;
    int threads = 0;
    std::string output;
    app.add_option("--from", from, "least h/delta (default 0.6)").type_name("RATIO");
    app.add_option("--step", step, "its step (default 0.2)").type_name("RATIO");
    app.add_option("--to", to, "largest h/delta (default 4)").type_name("RATIO");
    app.add_option("--seeds", seeds,
                   "draws of the perturbation, of whose errors medians are taken (default 5)")
        .type_name("K")
        .within(1, 100000);
    app.add_threads(threads);
    app.add_output(output);

    command_line::Figure figure{"asprone2010/figure_orders.gp"};
    command_line::add_plot_option(app, figure);

    return command_line::run(app, argc, argv, threads, output, figure, [&] {
        if (!(from > 0 && to >= from && step > 0 && (to - from) / step <= 1000))  // nor for what is no number
            throw base::InvalidInput("h/delta from " + base::shown(from) + " to " + base::shown(to) +
                                     " in steps of " + base::shown(step) + " is no range of 1 to 1000 steps");
        std::vector<Square> squares;
        for (const auto& formulation : command_line::formulations())
            particles::for_each_kernel([&](const particles::Kernel& kernel) {
                for (const double perturbation : {0.0, 0.25})
                    for (long k = 0; k <= std::lround(std::floor((to - from) / step + 1e-9)); ++k)
                        squares.push_back({std::string(formulation.name), particles::name(kernel),
                                           from + static_cast<double>(k) * step, perturbation});
            });
        report::Table table;
        table.comments = {
            "Beyond Asprone et al. (2010): orders of the errors of DB, D2B (Section 5.1) and u (Section 5.2) "
            "between "
            "161, 321 and 641 particles, volumes equal",
            "perturbed particles: medians over seeds 1 to " + std::to_string(seeds),
            "constant: error at 641 particles over delta to the rounded order; empty where it cannot be "
            "computed"};
        table.columns = {{"formulation"},
                         {"kernel"},
                         {"smoothing"},
                         {"perturbation"},
                         {"order_first", {1e-3, 2e-3}},
                         {"order_second", {1e-3, 2e-3}},
                         {"order_displacement", {1e-3, 2e-2}},
                         {"constant_first", {1e-3, 1e-6}},
                         {"constant_second", {1e-3, 1e-6}},
                         {"constant_displacement", {5e-2, 1e-6}}};
        table.rows.resize(squares.size());
        command_line::Progress progress(squares.size());
        base::for_each_index(static_cast<Index>(squares.size()), [&](Index k) {
            const auto at = static_cast<std::size_t>(k);
            const Square& of = squares[at];
            table.rows[at] = {of.formulation, of.kernel, of.smoothing, of.perturbation};
            for (const report::Cell& cell : orders(of, seeds)) table.rows[at].push_back(cell);
            progress.step();
        });
        return table;
    });
}
