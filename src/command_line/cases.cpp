#include "command_line/cases.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <variant>

#include "base/errors.hpp"
#include "base/memory.hpp"
#include "base/text.hpp"
#include "command_line/formulations.hpp"
#include "command_line/lists.hpp"
#include "command_line/orders.hpp"
#include "command_line/positions.hpp"
#include "command_line/sweep.hpp"
#include "report/file.hpp"
#include "report/statistics.hpp"

namespace command_line {

using base::Index;
using base::InvalidInput;
using report::Cell;

namespace {

/// The generator takes seeds of 32 bits: larger ones would repeat draws.
constexpr unsigned long largest_seed = 4294967295UL;

std::vector<std::string> known_formulations(const std::vector<std::string>& extra) {
    std::vector<std::string> names;
    for (const auto& formulation : formulations()) names.emplace_back(formulation.name);
    names.insert(names.end(), extra.begin(), extra.end());
    return names;
}

/// "50", "10 to 2560, 33 numbers"
std::string counts_in_words(const std::vector<long>& N) {
    return std::to_string(N.front()) +
           (N.size() == 1 ? ""
                          : " to " + std::to_string(N.back()) + ", " + std::to_string(N.size()) + " numbers");
}

/// "h/delta 1", "h/largest spacing 1.5", "h = 0.06", "h 2 times the numbers of h.txt"
std::string smoothing_in_words(const Options& options) {
    const std::string ratio = base::shown(options.smoothing);
    if (options.smoothing_from == "mean") return "h/delta " + ratio;
    if (options.spacing.kind != particles::Spacing::given)
        return "h/" + options.smoothing_from + " spacing " + ratio;
    const auto& lengths = options.spacing.lengths;
    if (lengths.size() == 1) return "h = " + base::shown(options.smoothing * lengths[0]);
    return "h " + (options.smoothing == 1 ? "" : ratio + " times ") + "the numbers of " +
           options.smoothing_from;
}

/// The options that all rows share.
std::string parameters(const Options& options) {
    std::string text =
        "kernel " + options.kernel + ", " + smoothing_in_words(options) + ", volumes " + options.volumes;
    if (const auto& x = options.positions; x.size() > 0) {
        const particles::Column<double> apart = x.tail(x.size() - 1) - x.head(x.size() - 1);
        text += ", positions of a file, " + base::shown(apart.minCoeff()) + " to " +
                base::shown(apart.maxCoeff()) + " apart";
    }
    if (std::any_of(options.perturbations.begin(), options.perturbations.end(),
                    [](double a) { return a != 0; }))
        text += ", perturbed particles: mt19937, seeds " + std::to_string(options.seed) + " to " +
                std::to_string(options.seed + options.seeds - 1);
    if (options.precision != "double") text += ", precision " + options.precision;
    return text;
}

}  // namespace

void check_line(long N, double reach, std::size_t scalar) {
    if (N < 2) throw InvalidInput("--particles: a line needs at least 2 particles, got " + std::to_string(N));
    const auto count = static_cast<double>(N), size = static_cast<double>(scalar + sizeof(int));
    // Rows of D, and of D², which are twice as wide where D is applied twice.
    const double once = count * std::min(2 * reach + 1, count),
                 twice = count * std::min(4 * reach + 1, count);
    base::require_memory_of_entries(std::to_string(N) + " particles", twice, (once + twice) * size,
                                    "take fewer particles or a smaller --smoothing");
}

std::vector<long> four_a_doubling() {
    std::vector<long> N;
    for (int k = 0; k <= 32; ++k) N.push_back(std::lround(10 * std::exp2(k / 4.0)));
    return N;
}

void add_options(CommandLine& app, Options& options, const std::vector<std::string>& extra) {
    app.column_width(34);
    app.add_list("--formulation", options.formulations,
                 "formulations: all (default), or some of " + joined(known_formulations(extra)) +
                     "; by its name only: " + joined(names_beside_all()));
    const auto counts =
        app.add_list("--particles", options.particles,
                     "numbers of particles N: a list such as 10,20,40 or a range from:step:to (default " +
                         counts_in_words(options.particles) + ")");
    const auto positions =
        app.add_option(
               "--positions", options.positions_file,
               "particles of a file instead: one position per line, or in a column of a CSV, increasing from 0 to 1")
            .type_name("FILE")
            .excludes(counts);
    app.add_list(
           "--columns", options.columns,
           "the column of these positions, by its name or its number from 1 (default: x, else the first)")
        .type_name("NAME|NUMBER");
    app.add_option(
           "--volumes", options.volumes,
           "particle volumes: equal (the spacing for each; default) or partition (half of it at the ends)")
        .type_name("NAME");
    app.add_option("--kernel", options.kernel, "one of " + joined(kernel_names()) + " (default gaussian)")
        .type_name("NAME");
    app.add_option("--smoothing", options.smoothing, "smoothing length over spacing, h/delta (default 1)")
        .type_name("RATIO");
    app.add_option(
           "--smoothing-from", options.smoothing_from,
           "the spacing delta of h/delta: mean (default) or largest; or one for each particle: local (to the farther of its two neighbours), nearest, K-nearest (to the farthest of the K nearest, such as 4-nearest); or a length: a number, or a file with a number for each particle, FILE or FILE:COLUMN")
        .type_name("NAME");
    app.add_list("--perturb", options.perturbations,
                 "amplitudes a, a list: inner particles move by U(-1,1) a delta (default 0; the paper: 0.25)")
        .excludes(positions);
    app.add_option("--seed", options.seed, "first seed of the perturbations (default 1)")
        .type_name("S")
        .excludes(positions)
        .within(1, largest_seed);
    app.add_option("--seeds", options.seeds, "number of seeds: S, S+1, ... (default 1)")
        .type_name("K")
        .excludes(positions)
        .within(1, 1000000);
    app.add_threads(options.threads);
    app.add_output(options.output);
}

void add_median(CommandLine& app, Options& options) {
    app.add_flag("--median", options.median, "one row for all seeds of a case: medians and quartiles");
}

void add_states(CommandLine& app, Options& options) {
    app.add_flag(
        "--states", options.states,
        "the values at each particle, computed and exact, instead of the largest errors; with --plot, for one number of particles");
}

void add_precision(CommandLine& app, Options& options) {
    app.add_option(
           "--precision", options.precision,
           "precision of the computation: double (default), long (about 19 digits) or quad (34 digits, about fifty times slower); positions of a file are doubles")
        .type_name("NAME");
}

namespace {

/// \throws InvalidInput for an option that changes nothing
/// \param wanted formulations \param extra names beside those of formulations: finite elements
void check_effect(const Options& options, const std::vector<std::string>& wanted,
                  const std::vector<std::string>& extra) {
    const auto moved = [](double a) { return a != 0; };
    if (std::none_of(options.perturbations.begin(), options.perturbations.end(), moved))
        for (const auto& [option, given] :
             {std::pair{"--seeds", options.seeds > 1}, {"--seed", options.seed != 1}})
            if (given)
                throw InvalidInput(std::string(option) +
                                   " changes nothing without a perturbation; add --perturb 0.25, say");
    const Options untouched;
    const bool volumes = options.volumes != untouched.volumes;
    const auto all = [&](const auto& holds) { return std::all_of(wanted.begin(), wanted.end(), holds); };
    if (all([&](const std::string& name) {
            return std::find(extra.begin(), extra.end(), name) != extra.end();
        }))
        for (const auto& [option, given] :
             {std::pair{"--kernel", options.kernel != untouched.kernel},
              {"--smoothing", options.smoothing != untouched.smoothing},
              {"--smoothing-from", options.smoothing_from != untouched.smoothing_from},
              {"--volumes", volumes}})
            if (given)
                throw InvalidInput(
                    std::string(option) +
                    " changes nothing for finite elements; add a --formulation of particles, or leave " +
                    option + " out");
    if (volumes && all([](const std::string& name) { return name == "ssph"; }))
        throw InvalidInput("--volumes changes nothing for ssph; leave it out, or add another --formulation");
}

}  // namespace

std::vector<Case> cases(const Options& options, const std::vector<std::string>& extra) {
    const std::vector<std::string> wanted =
        chosen("formulation", options.formulations, known_formulations(extra), names_beside_all());
    check_effect(options, wanted, extra);
    if (options.seeds - 1 > largest_seed - options.seed)
        throw InvalidInput("seeds beyond " + std::to_string(largest_seed) +
                           " repeat others; take a smaller --seed");

    if (!(options.smoothing > 0))
        throw InvalidInput("--smoothing must be positive and finite, got " + base::shown(options.smoothing));
    const double support =
        particles::support<double>(particles::kernel_named(options.kernel)) * options.smoothing;
    const auto spacings = [&](long N) {  // h/δ, at most
        return options.spacing.kind == particles::Spacing::given
                   ? options.spacing.lengths.maxCoeff() * static_cast<double>(N - 1)
                   : std::ceil(static_cast<double>(options.spacing.k) / 2);
    };
    const std::size_t scalar =
        in_precision(options.precision, [](auto zero) { return sizeof(decltype(zero)); });
    for (const long N : options.particles) {
        check_line(N, support * spacings(N), scalar);
        check_lengths(options.spacing, options.smoothing_from, N);
    }
    const double count = static_cast<double>(wanted.size() * options.particles.size()) *
                         static_cast<double>(options.perturbations.size()) *
                         static_cast<double>(options.seeds);
    constexpr double cells = 12;  // least number of cells that a case takes, in its row and its results
    base::require_memory(
        base::shown(count) + " cases",
        count * (sizeof(Case) + sizeof(std::vector<Cell>) + (options.median ? 4 : cells) * sizeof(Cell)),
        "take fewer --seeds, --particles or perturbations");

    std::vector<Case> all;
    for (const std::string& formulation : wanted)
        for (const double perturbation : options.perturbations)
            for (const long N : options.particles)
                for (unsigned long k = 0; k < (perturbation == 0 ? 1 : options.seeds); ++k)
                    all.push_back({formulation, perturbation, N, options.seed + k});
    return all;
}

std::array<Cell, 2> perturbation_and_seed(const Options& options, const Case& one) {
    if (options.positions.size() > 0) return {};
    return {one.perturbation, static_cast<long>(one.seed)};
}

asprone2010::numerical_tests::Discretisation discretisation_of(const Options& options, const Case& one) {
    return {particles::volumes_named(options.volumes), particles::kernel_named(options.kernel),
            options.smoothing, one.perturbation, options.spacing};
}

void tabulate(report::Table& table, const Options& options,
              const std::function<std::vector<Cell>(const Case&)>& compute) {
    const std::vector<Case> all = cases(options);
    const std::vector<Attempt> attempts = attempts_in_parallel(all, compute);

    const std::vector<report::ColumnHead> measured = table.columns;
    table.columns = {{"formulation"}, {"particles"}, {"spacing"}, {"perturbation"}, {"seed"}};
    Sweep sweep(table, table.columns.size());
    table.columns.insert(table.columns.end(), measured.begin(), measured.end());
    if (options.median) {
        table.columns.push_back({"seeds"});
        for (const auto& column : measured) {
            table.columns.push_back({column.name + "_lower", column.tolerance});
            table.columns.push_back({column.name + "_upper", column.tolerance});
        }
    }

    for (std::size_t k = 0; k < all.size();) {
        const Case& one = all[k];
        const unsigned long seeds = !options.median || one.perturbation == 0 ? 1 : options.seeds;
        const auto [perturbation, seed] = perturbation_and_seed(options, one);
        std::vector<Cell> row{one.formulation, static_cast<long>(one.particles),
                              1.0 / static_cast<double>(one.particles - 1), perturbation, seed};
        const std::size_t first = k;
        k += seeds;
        if (const auto failure = failure_of_seeds(attempts, first, k, one.seed)) {
            sweep.add_failed(std::move(row), *failure);
            continue;
        }
        std::vector<Cell> spread{static_cast<long>(seeds)};
        for (std::size_t column = 0; column < measured.size(); ++column) {
            std::vector<double> sample;
            for (std::size_t s = first; s < k; ++s)
                if (const auto* number = std::get_if<double>(&attempts[s].numbers[column]))
                    sample.push_back(*number);
            if (sample.size() < seeds) {  // no interior particle, say
                row.emplace_back();
                spread.insert(spread.end(), 2, Cell());
                continue;
            }
            const auto [lower, median, upper] = report::quartiles(sample);
            row.emplace_back(median);
            spread.insert(spread.end(), {lower, upper});
        }
        if (options.median) row.insert(row.end(), spread.begin(), spread.end());
        sweep.add({row});
    }
    sweep.finish();
}

void tabulate_states(report::Table& table, const Options& options,
                     const std::function<std::vector<std::vector<Cell>>(const Case&)>& compute) {
    const std::vector<Case> all = cases(options);
    const std::vector<report::ColumnHead> measured = table.columns;
    table.columns = {{"formulation"}, {"particles"}, {"perturbation"}, {"seed"}};
    Sweep sweep(table, table.columns.size());
    table.columns.insert(table.columns.end(), {{"particle"}, {"x"}});
    table.columns.insert(table.columns.end(), measured.begin(), measured.end());
    double rows = 0;
    for (const Case& one : all) rows += static_cast<double>(one.particles);
    base::require_memory(base::shown(rows, 12) + " rows of --states",
                         rows * static_cast<double>(table.columns.size()) * sizeof(Cell),
                         "take fewer particles or cases");
    for (const Case& one : all) {
        const auto [perturbation, seed] = perturbation_and_seed(options, one);
        const std::vector<Cell> named{one.formulation, static_cast<long>(one.particles), perturbation, seed};
        sweep.attempt(named, [&] {
            std::vector<std::vector<Cell>> states;
            for (const std::vector<Cell>& numbers : compute(one)) {
                std::vector<Cell> row = named;
                row.emplace_back(static_cast<long>(states.size()));
                row.insert(row.end(), numbers.begin(), numbers.end());
                states.push_back(std::move(row));
            }
            return states;
        });
    }
    sweep.finish();
}

report::Table errors_or_states(Options& options, const std::function<report::Table()>& errors,
                               const std::function<report::Table()>& states, const std::string& script) {
    const bool along_x = options.states || options.positions.size() > 0;
    if (along_x) options.figure.script = script;
    if (options.states) return states();
    if (along_x && !options.figure.path.empty()) options.figure.table = states();
    report::Table table = errors();
    if (is_standard_output(options.output)) {
        const std::size_t spacing = table.column("spacing");
        add_orders(table, {"formulation", "perturbation", "seed"},
                   [&table, spacing](std::size_t row) { return std::get<double>(table.rows[row][spacing]); });
    }
    return table;
}

std::vector<std::string> header_comments(const Options& options) {
    std::string equations;
    const auto& wanted = options.formulations;
    std::vector<std::string> named = formulation_names();
    if (wanted != std::vector<std::string>{"all"}) {
        for (const std::string& name : names_beside_all()) named.push_back(name);
        std::erase_if(named, [&](const std::string& name) {
            return std::find(wanted.begin(), wanted.end(), name) == wanted.end();
        });
    }
    for (const std::string& name : named)
        equations += (equations.empty() ? "equations: " : ", ") + name + " " +
                     std::string(formulation_named<double>(name).equations);
    std::vector<std::string> comments{parameters(options)};
    if (!equations.empty()) comments.insert(comments.begin(), equations);
    return comments;
}

int run(CommandLine& app, int argc, char** argv, Options& options,
        const std::function<report::Table()>& compute) {
    return run(app, argc, argv, options.threads, options.output, options.figure, [&] {
        if (options.states && (options.median || options.quality))
            throw InvalidInput(std::string(options.median ? "--median" : "--quality") +
                               " stands beside largest errors; leave --states out");
        if (options.states && !options.figure.path.empty() &&
            options.particles.size() * options.perturbations.size() * options.seeds > 1 &&
            !options.positions_file)
            throw InvalidInput(
                "--states --plot draws errors along one line of particles; take one number of particles, one perturbation and one seed");
        if (!options.figure.path.empty() && options.seeds > 1 && !options.median)
            throw InvalidInput("--plot draws one line of particles for each N; take one seed" +
                               std::string(app.name() == "vibration_test" ? "" : ", or --median"));
        if (!options.figure.path.empty() && options.perturbations.size() > 2)
            throw InvalidInput("--plot draws at most two perturbations, such as 0,0.25");
        options.spacing = spacing_from(options.smoothing_from);
        if (options.spacing.kind == particles::Spacing::given)
            check_apart({{"--output", options.output},
                         {"--plot", options.figure.path},
                         {"--smoothing-from", named_file(options.smoothing_from).path}});
        if (!options.columns.empty() && !options.positions_file)
            throw InvalidInput(
                "--columns belongs to the file of --positions; add it, or leave --columns out");
        if (options.positions_file) {
            check_apart({{"--output", options.output},
                         {"--plot", options.figure.path},
                         {"--positions", *options.positions_file}});
            options.positions = read_positions(*options.positions_file, options.columns);
            options.particles = {static_cast<long>(options.positions.size())};
        }
        return compute();
    });
}

}  // namespace command_line
