#include "command_line/clouds.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "command_line/options.hpp"
#include "command_line/orders.hpp"
#include "command_line/progress.hpp"
#include "command_line/sweep.hpp"
#include "report/statistics.hpp"

namespace {

using namespace fpm_in_space;
using command_line::Attempt;
using command_line::CloudCase;
using command_line::CloudOptions;
using command_line::Draws;
using command_line::Placed;
using derivative_test::AtParticle;
using particles::Column;
using particles::Range;
using report::Cell;

/// What a formulation finds at each place. \param spacing δ of the particles
template <int dim>
std::vector<std::vector<AtParticle>> found(const CloudOptions& options, const std::string& formulation,
                                           const Placed<dim>& particles, const Column<double>& spacing,
                                           const derivative_test::Function<dim>& B) {
    std::vector<Range> ranges;
    for (const auto& [name, range] : particles.places) ranges.push_back(range);
    return derivative_test::errors(formulation_named<double, dim>(formulation), particles.cloud,
                                   command_line::smoothing<dim>(options, spacing), spacing, B, ranges);
}

const std::vector<report::ColumnHead> naming{{"formulation"}, {"layout"},       {"particles"},
                                             {"spacing"},     {"perturbation"}, {"seed"}};
const std::vector<report::ColumnHead> measured{
    {"error_first", {1e-6, 1e-12}}, {"error_second", {1e-6, 2e-10}}, {"quality", {1e-6, 1e-9}}};

/// Cells that name a formulation on the particles of a case, in the columns `naming`.
/// \param spacing δ, or empty
std::vector<Cell> named(const std::string& formulation, const CloudCase& one, const Cell& spacing) {
    return {formulation,
            one.layout,
            one.is_grid() ? Cell(one.n) : Cell(),
            spacing,
            one.is_grid() ? Cell(one.perturbation) : Cell(),
            one.is_drawn() ? Cell(static_cast<long>(one.seed)) : Cell()};
}

/// The same with the distance of a grid's particles.
std::vector<Cell> named(const std::string& formulation, const CloudCase& one) {
    return named(formulation, one, one.is_grid() ? Cell(1 / static_cast<double>(one.n - 1)) : Cell());
}

/// A table with its comments, and the columns that name a case, and what is found in it.
/// \param between columns before those that are measured
report::Table begun(const CloudOptions& options, const std::string& what,
                    const std::vector<report::ColumnHead>& between) {
    report::Table table;
    table.comments = command_line::comments(options, what);
    for (const auto* const columns : {&naming, &between, &measured})
        table.columns.insert(table.columns.end(), columns->begin(), columns->end());
    return table;
}

/// What each formulation finds on the particles of a case, or why not: for each place its name, the number of
/// its particles, and the largest in the columns `measured`.
template <int dim>
std::vector<Attempt> attempts_at(const CloudOptions& options, const CloudCase& one,
                                 const derivative_test::Function<dim>& B) {
    std::optional<Placed<dim>> particles;
    const auto failure =
        command_line::failure_of([&] { particles = command_line::placed<dim>(options, one); });
    std::vector<Attempt> attempts;
    for (const std::string& formulation : command_line::formulations_of(options)) {
        Attempt& attempt = attempts.emplace_back();
        attempt.failure = failure ? failure : command_line::failure_of([&] {
            const Column<double> spacing = particles::spacing(particles->cloud, options.spacing);
            const auto all = found<dim>(options, formulation, *particles, spacing, B);
            for (std::size_t place = 0; place < all.size(); ++place) {
                const AtParticle most = derivative_test::largest(all[place]);
                attempt.numbers.insert(attempt.numbers.end(),
                                       {particles->places[place].first, static_cast<long>(all[place].size()),
                                        most.first, most.second, most.R});
            }
        });
    }
    return attempts;
}

/// The rows of some draws, one for each place: the largest errors, with --median their medians and quartiles.
/// \param attempts those at its cases
std::vector<std::vector<Cell>> rows(const CloudOptions& options, const std::vector<Cell>& name,
                                    const std::vector<Attempt>& attempts) {
    std::vector<std::vector<Cell>> table;
    const std::vector<Cell>& first = attempts.front().numbers;
    for (std::size_t at = 0; at < first.size(); at += 2 + measured.size()) {
        std::vector<Cell> row = name, spread{static_cast<long>(attempts.size())};
        row.insert(row.end(), {first[at], first[at + 1]});
        for (std::size_t column = at + 2; column < at + 2 + measured.size(); ++column) {
            std::vector<double> sample;
            for (const Attempt& attempt : attempts)
                sample.push_back(std::get<double>(attempt.numbers[column]));
            const auto [lower, median, upper] = report::quartiles(sample);
            row.emplace_back(median);
            spread.insert(spread.end(), {lower, upper});
        }
        if (options.median) row.insert(row.end(), spread.begin(), spread.end());
        table.push_back(std::move(row));
    }
    return table;
}

template <int dim>
report::Table table_of(const CloudOptions& options) {
    report::Table table =
        begun(options, "largest errors of the first and second derivatives by place", {{"place"}, {"count"}});
    if (options.median) {
        table.columns.push_back({"seeds"});
        for (const auto& column : measured)
            for (const char* quartile : {"_lower", "_upper"})
                table.columns.push_back({column.name + quartile, column.tolerance});
    }
    const std::vector<Draws> all = command_line::draws(options);
    const auto B = command_line::function<dim>(options);
    const auto attempts = command_line::computed_in_parallel(
        command_line::cases(all), [&](const CloudCase& one) { return attempts_at<dim>(options, one, B); });
    const std::vector<std::string> formulations = command_line::formulations_of(options);
    command_line::Sweep sweep(table, naming.size());
    for (std::size_t f = 0; f < formulations.size(); ++f) {
        std::size_t at = 0;
        for (const auto& [first, seeds] : all) {
            std::vector<Attempt> drawn;
            for (unsigned long k = 0; k < seeds; ++k) drawn.push_back(attempts[at++][f]);
            const std::vector<Cell> name = named(formulations[f], first);
            if (const auto failure = command_line::failure_of_seeds(drawn, 0, drawn.size(), first.seed))
                sweep.add_failed(name, *failure);
            else
                sweep.add(rows(options, name, drawn));
        }
    }
    sweep.finish();
    const bool grids =
        std::all_of(all.begin(), all.end(), [](const Draws& draws) { return draws.first.is_grid(); });
    if (grids && command_line::is_standard_output(options.output)) {
        const std::size_t spacing = table.column("spacing");
        command_line::add_orders(table, {"formulation", "perturbation", "seed", "place"},
                                 [&](std::size_t row) { return std::get<double>(table.rows[row][spacing]); });
    }
    return table;
}

/// A row for each particle: its place, its position and what is found there.
template <int dim>
std::vector<std::vector<Cell>> states(const CloudOptions& options, const std::string& formulation,
                                      const CloudCase& one, const derivative_test::Function<dim>& B) {
    const auto particles = command_line::placed<dim>(options, one);
    const Column<double> spacing = particles::spacing(particles.cloud, options.spacing);
    const auto all = found<dim>(options, formulation, particles, spacing, B);
    std::vector<std::vector<Cell>> rows;
    for (std::size_t place = 0; place < all.size(); ++place)
        for (const auto& [i, first, second, R] : all[place]) {
            std::vector<Cell> row = named(formulation, one, spacing[spacing.size() == 1 ? 0 : i]);
            row.insert(row.end(), {particles.places[place].first, static_cast<long>(i)});
            for (const double x : particles.cloud.x().col(i)) row.emplace_back(x);
            row.insert(row.end(), {first, second, R});
            rows.push_back(std::move(row));
        }
    return rows;
}

template <int dim>
report::Table states_of(const CloudOptions& options) {
    std::vector<report::ColumnHead> where{{"place"}, {"particle"}};
    for (const std::string& axis : command_line::axes(dim)) where.push_back({axis});
    report::Table table = begun(options, "errors of the derivatives at each particle", where);
    const std::vector<CloudCase> all = command_line::cases(command_line::draws(options));
    const std::vector<std::string> formulations = command_line::formulations_of(options);
    const auto B = command_line::function<dim>(options);
    command_line::Sweep sweep(table, naming.size());
    command_line::Progress progress(formulations.size() * all.size());
    for (const std::string& formulation : formulations)
        for (const CloudCase& one : all) {
            sweep.attempt(named(formulation, one), [&] { return states<dim>(options, formulation, one, B); });
            progress.step();
        }
    sweep.finish();
    return table;
}

}  // namespace

int main(int argc, char** argv) {
    command_line::CommandLine app(
        "The second-order FPM in the plane and in space, Section 4: largest errors of the first and second derivatives inside and at faces, edges and corners of the unit square or cube.",
        "derivative_test_in_space",
        "Example: derivative_test_in_space --formulation definite_fpm --particles 31,61,121 --perturb 0.25 --plot /tmp/plane.svg\n"
        "In space: derivative_test_in_space --dimension 3 --function \"sin(x+2*y)*exp(z)\" --particles 9,17\n"
        "Particles of your own: derivative_test_in_space --layout body.csv --smoothing-from local --formulation definite_fpm --states --plot /tmp/body.svg");
    CloudOptions options;
    command_line::add_options(app, options);
    return command_line::run(app, argc, argv, options.threads, options.output, options.figure, [&] {
        command_line::complete(options);
        if (options.dimension == 2) return options.states ? states_of<2>(options) : table_of<2>(options);
        return options.states ? states_of<3>(options) : table_of<3>(options);
    });
}
