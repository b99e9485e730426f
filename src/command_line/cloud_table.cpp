#include "command_line/cloud_table.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "command_line/options.hpp"
#include "command_line/orders.hpp"
#include "command_line/progress.hpp"
#include "command_line/sweep.hpp"
#include "report/statistics.hpp"

namespace command_line {

using particles::Column;
using particles::Index;
using report::Cell;

namespace {

const std::vector<report::ColumnHead> naming{{"formulation"}, {"layout"},       {"particles"},
                                             {"spacing"},     {"perturbation"}, {"seed"}};

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
    Cell spacing;
    if (one.is_grid()) spacing = 1 / static_cast<double>(one.n - 1);
    return named(formulation, one, spacing);
}

/// A table with its comments, and the columns that name a case, and what is found in it.
/// \param between columns before those of the numbers
template <int dim>
report::Table begun(const CloudOptions& options, const CloudTest<dim>& test, const std::string& what,
                    const std::vector<report::ColumnHead>& between) {
    report::Table table;
    table.comments = comments(options, what);
    table.comments.push_back("quality: " + test.quality);
    for (const auto* const columns : {&naming, &test.keys, &between})
        table.columns.insert(table.columns.end(), columns->begin(), columns->end());
    table.columns.insert(table.columns.end(), test.numbers.begin(), test.numbers.end());
    return table;
}

/// What each formulation finds on the particles of a case, or why not: for each place its keys, the number of
/// its particles, and the largest numbers.
template <int dim>
std::vector<Attempt> attempts_at(const CloudOptions& options, const CloudTest<dim>& test,
                                 const CloudCase& one) {
    std::optional<Placed<dim>> particles;
    const auto failure = failure_of([&] { particles = placed<dim>(options, one); });
    std::vector<Attempt> attempts;
    for (const std::string& formulation : formulations_of(options)) {
        Attempt& attempt = attempts.emplace_back();
        attempt.failure = failure ? failure : failure_of([&] {
            const Column<double> spacing = command_line::spacing(options, one, particles->cloud);
            for (const Found& at : test.find(formulation, *particles, spacing)) {
                attempt.numbers.insert(attempt.numbers.end(), at.keys.begin(), at.keys.end());
                attempt.numbers.emplace_back(static_cast<long>(at.particles.size()));
                for (std::size_t k = 0; k < 3; ++k) {
                    double most = 0;
                    for (const auto& numbers : at.numbers) most = std::max(most, numbers[k]);
                    attempt.numbers.emplace_back(most);
                }
            }
        });
    }
    return attempts;
}

/// The rows of some draws, one for each place: the largest numbers, or with --median medians and quartiles.
/// \param attempts those at its cases \param keys how many columns name a place
std::vector<std::vector<Cell>> rows(const CloudOptions& options, const std::vector<Cell>& name,
                                    const std::vector<Attempt>& attempts, std::size_t keys) {
    std::vector<std::vector<Cell>> table;
    const std::vector<Cell>& first = attempts.front().numbers;
    for (auto at = first.begin(); at < first.end(); at += static_cast<Index>(keys) + 4) {
        std::vector<Cell> row = name, spread{static_cast<long>(attempts.size())};
        row.insert(row.end(), at, at + static_cast<Index>(keys) + 1);
        const auto numbers = static_cast<std::size_t>(at - first.begin()) + keys + 1;
        for (std::size_t column = numbers; column < numbers + 3; ++column) {
            std::vector<double> sample;
            sample.reserve(attempts.size());
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

/// A row for each particle of a case.
template <int dim>
std::vector<std::vector<Cell>> states(const CloudOptions& options, const CloudTest<dim>& test,
                                      const std::string& formulation, const CloudCase& one) {
    const auto particles = placed<dim>(options, one);
    const Column<double> spacing = command_line::spacing(options, one, particles.cloud);
    std::vector<std::vector<Cell>> rows;
    for (const Found& at : test.find(formulation, particles, spacing))
        for (std::size_t k = 0; k < at.particles.size(); ++k) {
            const Index i = at.particles[k];
            std::vector<Cell> row = named(formulation, one, spacing[spacing.size() == 1 ? 0 : i]);
            row.insert(row.end(), at.keys.begin(), at.keys.end());
            row.emplace_back(static_cast<long>(i));
            for (const double x : particles.cloud.x().col(i)) row.emplace_back(x);
            row.insert(row.end(), at.numbers[k].begin(), at.numbers[k].end());
            rows.push_back(std::move(row));
        }
    return rows;
}

template <int dim>
report::Table table_of_largest(const CloudOptions& options, const CloudTest<dim>& test) {
    report::Table table = begun(options, test, test.largest, {{"count"}});
    if (options.median) {
        table.columns.push_back({"seeds"});
        for (const auto& column : test.numbers)
            for (const char* quartile : {"_lower", "_upper"})
                table.columns.push_back({column.name + quartile, column.tolerance});
    }
    const std::vector<Draws> all = draws(options);
    const auto attempts = computed_in_parallel(
        cases(all), [&](const CloudCase& one) { return attempts_at<dim>(options, test, one); });
    const std::vector<std::string> formulations = formulations_of(options);
    Sweep sweep(table, naming.size());
    for (std::size_t f = 0; f < formulations.size(); ++f) {
        std::size_t at = 0;
        for (const auto& [first, seeds] : all) {
            std::vector<Attempt> drawn;
            for (unsigned long k = 0; k < seeds; ++k) drawn.push_back(attempts[at++][f]);
            const std::vector<Cell> name = named(formulations[f], first);
            if (const auto failure = failure_of_seeds(drawn, 0, drawn.size(), first.seed))
                sweep.add_failed(name, *failure);
            else
                sweep.add(rows(options, name, drawn, test.keys.size()));
        }
    }
    sweep.finish();
    const bool grids =
        std::all_of(all.begin(), all.end(), [](const Draws& draws) { return draws.first.is_grid(); });
    if (grids && is_standard_output(options.output)) {
        const std::size_t spacing = table.column("spacing");
        std::vector<std::string> same{"formulation", "layout", "perturbation", "seed"};
        for (const auto& column : test.keys) same.push_back(column.name);
        add_orders(table, same, [&](std::size_t row) { return std::get<double>(table.rows[row][spacing]); });
    }
    return table;
}

template <int dim>
report::Table table_of_states(const CloudOptions& options, const CloudTest<dim>& test) {
    std::vector<report::ColumnHead> where{{"particle"}};
    for (const std::string& axis : axes(dim)) where.push_back({axis});
    report::Table table = begun(options, test, test.states, where);
    const std::vector<CloudCase> all = cases(draws(options));
    const std::vector<std::string> formulations = formulations_of(options);
    Sweep sweep(table, naming.size());
    Progress progress(formulations.size() * all.size());
    for (const std::string& formulation : formulations)
        for (const CloudCase& one : all) {
            sweep.attempt(named(formulation, one),
                          [&] { return states<dim>(options, test, formulation, one); });
            progress.step();
        }
    sweep.finish();
    return table;
}

}  // namespace

template <int dim>
report::Table table_of(const CloudOptions& options, const CloudTest<dim>& test) {
    return options.states ? table_of_states(options, test) : table_of_largest(options, test);
}

template report::Table table_of(const CloudOptions&, const CloudTest<2>&);
template report::Table table_of(const CloudOptions&, const CloudTest<3>&);

}  // namespace command_line
