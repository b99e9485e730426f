#include <unistd.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "batra2008/section_4_1_plate.hpp"
#include "command_line/example_problems.hpp"
#include "command_line/options.hpp"
#include "command_line/progress.hpp"

namespace {

using namespace batra2008;
using Pair = std::array<std::string, 2>;

/// The pairs of conditions that an option names; "all" stands for those that the print compares.
std::vector<Pair> pairs_of(const std::string& option, const std::string& text, const std::vector<Pair>& all) {
    if (text == "all" && !all.empty()) return all;
    const std::size_t comma = text.find(',');
    if (comma == std::string::npos)
        throw base::InvalidInput(option + ": '" + text + "' is no pair of conditions such as u1,u2" +
                                 (all.empty() ? "" : ", nor all"));
    return {{text.substr(0, comma), text.substr(comma + 1)}};
}

/// All combinations of what the four options name.
std::vector<plate::Corners> choices_of(const std::array<std::string, 4>& corners) {
    const auto at_1 = plate::choices_at_corner_1();
    const auto at_3 = plate::choices_at_corner_3();
    const std::array<std::vector<Pair>, 4> all{
        std::vector<Pair>(at_1.begin(), at_1.end()), {}, std::vector<Pair>(at_3.begin(), at_3.end()), {}};
    std::vector<plate::Corners> choices{plate::default_corners()};
    for (std::size_t k = 0; k < 4; ++k) {
        std::vector<plate::Corners> more;
        for (const Pair& pair : pairs_of("--corner-" + std::to_string(k + 1), corners[k], all[k]))
            for (plate::Corners choice : choices) {
                choice[k] = pair;
                more.push_back(choice);
            }
        choices = more;
    }
    return choices;
}

/// What --plot draws: the error against the scaling factors, if there are several, or against the distance of the particles.
command_line::Figure figure_of(const std::string& path, bool scaled) {
    command_line::Figure figure{"batra2008/figure_12.gp"};
    if (scaled) figure = {"batra2008/figure_9.gp"};
    figure.path = path;
    return figure;
}

/// \throws base::InvalidInput for what is no error of each method against either grids or scaling factors
void check_drawable(const command_line::ExampleOptions& options,
                    const std::vector<command_line::ExampleCase>& cases, std::size_t grids,
                    std::size_t choices) {
    std::map<std::pair<example_problems::Method, double>, std::size_t> rows;
    for (const command_line::ExampleCase& of : cases)
        rows[{of.how.method, of.how.scaling}] += grids * choices;
    const bool scaled = options.scaling.find_first_of(",:") != std::string::npos;
    const bool one_curve = std::all_of(rows.begin(), rows.end(), [&](const auto& method_and_scaling) {
        return method_and_scaling.second == (scaled ? 1 : grids);
    });
    const bool one_scaling = scaled && rows.begin()->first.second == std::prev(rows.end())->first.second;
    if (!options.states.empty() || !one_curve || one_scaling)
        throw base::InvalidInput(
            "--plot draws errors: against several --particles (as Figure 12) or against several --scaling "
            "(as Figure 9), all else being one value, without --states");
}

/// Refuses a grid that cannot be held: the basis sees the particles within ρ times their distance.
void check_grid(long nx, long ny, double rho) {
    if (nx < 2 || ny < 2) return;  // plate::grid() says so
    const auto columns = static_cast<double>(nx), rows = static_cast<double>(ny);
    const double dx = plate::L1 / (columns - 1), dy = plate::L2 / (rows - 1), reach = rho * std::min(dx, dy);
    command_line::check_cloud(columns * rows, std::max(1.0, reach / dx) * std::max(1.0, reach / dy));
}

/// The places of `--states`.
std::vector<Point<2>> places(const std::string& where, long points, const Cloud<2>& cloud) {
    std::vector<Point<2>> chosen;
    if (where == "bottom" || where == "top") {
        for (long k = 0; k < points; ++k)
            chosen.emplace_back(plate::L1 * static_cast<double>(k) / static_cast<double>(points - 1),
                                where == "top" ? plate::L2 : 0);
        return chosen;
    }
    const auto grid = [&] {
        const auto [nx, ny] = command_line::pair_of("--states", where);
        command_line::check_states(static_cast<double>(nx) * static_cast<double>(ny));
        return plate::grid(nx, ny);
    };
    const Points<2> x = where == "particles" ? cloud.x() : grid();
    for (Index k = 0; k < x.cols(); ++k) chosen.emplace_back(x.col(k));
    return chosen;
}

}  // namespace

int main(int argc, char** argv) {
    command_line::CommandLine app(
        "Section 4.1 of Batra and Zhang (2008): a plate under shear by collocation (strong) and by two local "
        "weak forms "
        "(weak1, weak2).",
        "plate",
        "A LIST is numbers separated by commas, or a range from:step:to.\n"
        "Corners: 1 north-east, 2 south-east, 3 south-west, 4 north-west; conditions u1, u2, s11, s22, s12.\n"
        "Example: plate --method strong,weak1 --particles 16x4,31x7 --scaling 3:0.5:4");
    command_line::ExampleOptions options;
    options.scaling = "3";
    options.poisson = "0.33";
    options.plane = "stress";
    std::vector<std::string> grids{"16x4"};
    std::array<std::string, 4> corners{"s11,s22", "s11,s22", "u1,u2", "u1,u2"};
    app.add_option("--particles", grids, "grids of particles, separated by commas (default 16x4)")
        .separated_by_commas()
        .type_name("NXxNY[,...]");
    command_line::add_options(app, options, "or a line: bottom, top");
    for (std::size_t k = 0; k < 4; ++k)
        app.add_option("--corner-" + std::to_string(k + 1), corners[k],
                       "what collocation imposes at corner " + std::to_string(k + 1) + " (default " +
                           corners[k] + ")" +
                           (k == 0 || k == 2 ? "; all: each pair that the paper compares" : ""))
            .type_name("A,B");

    command_line::Figure figure;
    command_line::add_plot_option(app, figure);
    app.after_reading([&] {
        const bool scaled = options.scaling.find_first_of(",:") != std::string::npos;
        figure = figure_of(figure.path, scaled);
    });

    return command_line::run(app, argc, argv, options.threads, options.output, figure, [&] {
        const auto cases = command_line::cases(options, plate::E, plate::penalty);
        const std::vector<plate::Corners> choices = choices_of(corners);
        if (!figure.path.empty()) check_drawable(options, cases, grids.size(), choices.size());
        command_line::check_apart({{"--plot", figure.path}, {"--field", options.field}});
        command_line::FieldFile field(options.field, cases);
        report::Table table;
        table.comments = {
            "Batra and Zhang (2008), Section 4.1: a plate under shear; lengths in m, stresses in Pa",
            "strong (3.12) to (3.14), weak1 (3.22) with (3.21), weak2 (3.22) with (3.26); log_error: log10 "
            "of "
            "(4.4), dn the difference of the norms, nd the norm of the difference"};
        table.columns = command_line::case_columns();
        for (const char* name : {"nx", "ny", "corner_1", "corner_2", "corner_3", "corner_4"})
            table.columns.push_back({name});
        const bool states = !options.states.empty();
        const auto results = states ? command_line::state_columns(cases)
                                    : std::vector<report::ColumnHead>{{"log_error_dn", {1e-5, 1e-5}},
                                                                      {"log_error_nd", {1e-5, 1e-5}},
                                                                      {"max_error_u2_percent", {1e-5, 1e-6}}};
        table.columns.insert(table.columns.end(), results.begin(), results.end());
        if (options.seconds) command_line::add_cost_columns(table);

        command_line::Progress progress(cases.size() * grids.size() * choices.size(), std::cerr,
                                        isatty(STDERR_FILENO) != 0);
        for (const command_line::ExampleCase& of : cases)
            for (const std::string& text : grids)
                for (const plate::Corners& corner : choices) {
                    const bool strong = of.how.method == example_problems::Method::strong;
                    progress.step();
                    if (!strong && &corner != &choices.front()) continue;
                    const auto [nx, ny] = command_line::pair_of("--particles", text);
                    check_grid(nx, ny, of.how.scaling);
                    const Problem problem = plate::problem(of.material, corner);
                    const Cloud<2> cloud(plate::grid(nx, ny));
                    command_line::Cost cost;
                    const example_problems::Solution solution =
                        command_line::solved(problem, cloud, of.how, cost);
                    const command_line::Solved solved{problem, cloud, solution};
                    field.add(of, solved);

                    std::vector<report::Cell> row = command_line::case_cells(of);
                    row[1] = static_cast<long>(cloud.size());
                    row.insert(row.end(), {nx, ny});
                    for (const Pair& pair : corner)
                        row.push_back(strong ? report::Cell(pair[0] + " " + pair[1]) : report::Cell());
                    if (states) {
                        command_line::add_states(table, row, solved,
                                                 places(options.states, options.points, cloud));
                        continue;
                    }
                    const auto [dn, nd] =
                        example_problems::errors(plate::mesh(nx, ny), cloud, solution, problem);
                    row.insert(row.end(), {dn, nd, plate::largest_error_u2(cloud, solution, problem)});
                    if (options.seconds) command_line::add_cost(row, cost);
                    table.rows.push_back(std::move(row));
                }
        field.write();
        return table;
    });
}
