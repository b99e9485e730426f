#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "asprone2010/section_5_1_derivative_test.hpp"
#include "asprone2010/section_5_2_static_test.hpp"
#include "base/text.hpp"
#include "command_line/formulations.hpp"
#include "command_line/options.hpp"
#include "command_line/progress.hpp"
#include "report/statistics.hpp"

namespace {

using namespace asprone2010;

constexpr std::array<Index, 3> numbers{161, 321, 641};

/// The smoothing lengths of the map, h/δ, and how many draws a perturbed line has.
struct Range {
    double from = 0.6, step = 0.2, to = 4;
    unsigned long seeds = 5;
};

/// A square of the map.
struct Square {
    std::string formulation, kernel;
    double smoothing, perturbation;
};

std::vector<Square> squares(const Range& range) {
    const auto& [from, step, to, seeds] = range;
    if (!(from > 0 && to >= from && step > 0 &&
          (to - from) / step <= 1000))  // false where one is not a number
        throw base::InvalidInput("h/delta from " + base::shown(from) + " to " + base::shown(to) +
                                 " in steps of " + base::shown(step) + " is no range of 1 to 1000 steps");
    const long steps = std::lround(std::floor((to - from) / step + 1e-9));
    std::vector<Square> all;
    for (const auto& formulation : command_line::formulations())
        particles::for_each_kernel([&, from = from, step = step](const particles::Kernel<>& kernel) {
            for (const double perturbation : {0.0, 0.25})
                for (long k = 0; k <= steps; ++k)
                    all.push_back({std::string(formulation.name), particles::name(kernel),
                                   from + static_cast<double>(k) * step, perturbation});
        });
    return all;
}

/// Errors of DB, D²B and u.
using Errors = std::array<std::optional<double>, 3>;

/// Medians over the seeds of the errors for B = exp; none where an error cannot be computed for some seed.
Errors median_errors(const Square& square, Index N, unsigned long seeds) {
    const numerical_tests::Discretisation how{particles::Volumes::equal,
                                              particles::kernel_named(square.kernel), square.smoothing,
                                              square.perturbation};
    const auto& formulation = command_line::formulation_named(square.formulation);
    const unsigned long draws = square.perturbation == 0 ? 1 : seeds;
    std::array<std::vector<double>, 3> samples;
    for (unsigned long seed = 1; seed <= draws; ++seed) {
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
    Errors medians;
    for (std::size_t k = 0; k < 3; ++k)
        if (samples[k].size() == draws) medians[k] = report::quartiles(samples[k]).median;
    return medians;
}

/// The square, the orders of its three errors, and the last errors over δ to the power of the rounded order.
std::vector<report::Cell> row(const Square& square, unsigned long seeds) {
    std::vector<double> spacings;
    std::array<std::vector<double>, 3> errors;
    for (const Index N : numbers) {
        spacings.push_back(1 / static_cast<double>(N - 1));
        const Errors medians = median_errors(square, N, seeds);
        for (std::size_t k = 0; k < 3; ++k)
            if (medians[k]) errors[k].push_back(*medians[k]);
    }
    std::array<report::Cell, 3> orders, constants;
    for (std::size_t k = 0; k < 3; ++k) {
        if (errors[k].size() < numbers.size()) continue;
        const double order = report::observed_order(spacings, errors[k]);
        orders[k] = order;
        constants[k] = errors[k].back() * std::pow(spacings.back(), -std::round(order));
    }
    return {square.formulation, square.kernel, square.smoothing, square.perturbation, orders[0],
            orders[1],          orders[2],     constants[0],     constants[1],        constants[2]};
}

report::Table map_of_orders(const Range& range) {
    report::Table table;
    table.comments = {
        "Beyond Asprone et al. (2010): orders of the errors of DB, D2B (Section 5.1) and u (Section 5.2) between 161, 321 and 641 particles, volumes equal",
        "perturbed particles: medians over seeds 1 to " + std::to_string(range.seeds),
        "constant: error at 641 particles over delta to the rounded order; empty where it cannot be computed"};
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
    table.rows = command_line::computed_in_parallel(
        squares(range), [&](const Square& square) { return row(square, range.seeds); });
    return table;
}

}  // namespace

int main(int argc, char** argv) {
    command_line::CommandLine app(
        "Map of orders: the observed order of the errors of DB, D2B and u for exp, by formulation, kernel and h/delta, on equidistant and on perturbed particles.",
        "orders", "Example: orders --from 0.8 --to 2 --step 0.05 --output orders.csv");
    Range range;
    int threads = 0;
    std::string output;
    app.add_option("--from", range.from, "smallest h/delta (default 0.6)").type_name("RATIO");
    app.add_option("--step", range.step, "step of h/delta (default 0.2)").type_name("RATIO");
    app.add_option("--to", range.to, "largest h/delta (default 4)").type_name("RATIO");
    app.add_option("--seeds", range.seeds,
                   "draws of the perturbation; the errors are medians over them (default 5)")
        .type_name("K")
        .within(1, 100000);
    app.add_threads(threads);
    app.add_output(output);
    command_line::Figure figure{"asprone2010/figure_orders.gp"};
    command_line::add_plot_option(app, figure);

    return command_line::run(app, argc, argv, threads, output, figure, [&] { return map_of_orders(range); });
}
