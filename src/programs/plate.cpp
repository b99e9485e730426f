#include "batra2008/section_4_1_plate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "command_line/example_problems.hpp"
#include "command_line/lists.hpp"
#include "command_line/options.hpp"
#include "command_line/orders.hpp"
#include "command_line/progress.hpp"

namespace {

using namespace batra2008;
using command_line::ExampleCase;
using report::Cell;
using Pair = std::array<std::string, 2>;

/// The options of the plate, and those of both example problems.
struct Options : command_line::ExampleOptions {
    std::vector<std::string> grids{"16x4"};
    std::array<std::string, 4> corners{"s11,s22", "s11,s22", "u1,u2", "u1,u2"};
};

/// The pairs of conditions of an option; "all" stands for those that the paper compares.
std::vector<Pair> pairs_of(const std::string& option, const std::string& text, const std::vector<Pair>& all) {
    if (text == "all" && !all.empty()) return all;
    const std::size_t comma = text.find(',');
    if (comma == std::string::npos)
        throw base::InvalidInput(option + ": '" + text + "' is no pair of conditions such as u1,u2" +
                                 (all.empty() ? "" : ", nor all"));
    return {{text.substr(0, comma), text.substr(comma + 1)}};
}

/// All combinations of the pairs at the four corners.
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

/// \throws base::InvalidInput unless each method has one error for each grid, or one for each scaling factor
void check_drawable(const Options& options, const std::vector<ExampleCase>& cases, std::size_t choices) {
    std::set<std::pair<std::string, double>> curves;
    for (const ExampleCase& one : cases) curves.insert({one.method, one.ssph.scaling});
    if (!options.states.empty() || curves.size() < cases.size() || choices > 1 ||
        std::min(options.scaling.size(), options.grids.size()) > 1)
        throw base::InvalidInput(
            "--plot draws errors: against several --particles (as Figure 12) or against several --scaling (as Figure 9), all else being one value, without --states");
}

/// The grids of `--particles`. Their matrices must fit into memory: the basis sees the particles within ρ
/// times their distance.
std::vector<std::array<long, 2>> grids_of(const Options& options) {
    const double rho = *std::max_element(options.scaling.begin(), options.scaling.end());
    std::vector<std::array<long, 2>> grids;
    for (const std::string& grid : options.grids) {
        grids.push_back(command_line::pair_of("--particles", grid));
        const auto [nx, ny] = grids.back();
        if (nx > 1 && ny > 1) {
            const auto columns = static_cast<double>(nx), rows = static_cast<double>(ny);
            const double dx = plate::L1 / (columns - 1), dy = plate::L2 / (rows - 1),
                         reach = rho * std::min(dx, dy);
            command_line::check_cloud(columns * rows, std::max(1.0, reach / dx) * std::max(1.0, reach / dy));
        }
        static_cast<void>(plate::grid(nx, ny));
    }
    return grids;
}

/// The places of `--states` other than the particles.
std::vector<Point<2>> places(const Options& options) {
    using plate::L1, plate::L2;
    if (options.states == "bottom") return command_line::places_between({0, 0}, {L1, 0}, options.points);
    if (options.states == "top") return command_line::places_between({0, L2}, {L1, L2}, options.points);
    const auto [nx, ny] = command_line::grid_of_places(options.states);
    return command_line::places_at(plate::grid(nx, ny));
}

/// Cells that name a grid and, for collocation, the conditions at the corners; the weak forms impose none.
std::vector<Cell> named(long nx, long ny, const ExampleCase& one, const plate::Corners& corners) {
    std::vector<Cell> cells{nx, ny};
    for (const auto& [first, second] : corners)
        cells.push_back(one.is_collocation() ? Cell(first + " " + second) : Cell());
    return cells;
}

/// Errors of a solution as the columns below name them.
std::vector<Cell> errors(const command_line::Solved& solved, long nx, long ny) {
    const auto& [problem, cloud, solution] = solved;
    const auto [dn, nd] = example_problems::errors(plate::mesh(nx, ny), cloud, solution, problem);
    return {dn, nd, plate::largest_error_u2(cloud, solution, problem)};
}

/// \throws base::InvalidInput for conditions at the corners without collocation, which alone imposes them
void check_corners(const Options& options, const std::vector<ExampleCase>& cases) {
    const bool collocation =
        std::any_of(cases.begin(), cases.end(), [](const ExampleCase& one) { return one.is_collocation(); });
    for (std::size_t k = 0; k < options.corners.size(); ++k)
        if (const std::string option = "--corner-" + std::to_string(k + 1);
            !collocation && options.corners[k] != Options().corners[k])
            throw base::InvalidInput(option +
                                     " belongs to collocation; add strong or fpm to --method, or leave " +
                                     option + " out");
}

/// Adds the observed orders between grids, of which both distances between particles change.
void add_orders(report::Table& table) {
    std::vector<std::string> same;
    for (const auto& column : command_line::case_columns())
        if (column.name != "particles") same.push_back(column.name);
    for (const char* corner : {"corner_1", "corner_2", "corner_3", "corner_4"}) same.emplace_back(corner);
    const std::size_t nx = table.column("nx"), ny = table.column("ny");
    command_line::add_orders(table, same, [&table, nx, ny](std::size_t row) {
        const auto gaps = [&](std::size_t n) {
            return static_cast<double>(std::get<long>(table.rows[row][n]) - 1);
        };
        return 1 / std::sqrt(gaps(nx) * gaps(ny));
    });
}

report::Table table_of(const Options& options) {
    const auto cases = command_line::cases(options, plate::E, plate::penalty);
    check_corners(options, cases);
    const std::vector<plate::Corners> choices = choices_of(options.corners);
    if (!options.figure.path.empty()) check_drawable(options, cases, choices.size());
    const auto grids = grids_of(options);
    command_line::ExampleTable table(
        options, cases,
        "Batra and Zhang (2008), Section 4.1: a plate under shear; lengths in m, stresses in Pa",
        {{"nx"}, {"ny"}, {"corner_1"}, {"corner_2"}, {"corner_3"}, {"corner_4"}},
        {{"log_error_dn", {1e-5, 1e-5}},
         {"log_error_nd", {1e-5, 1e-5}},
         {"max_error_u2_percent", {1e-5, 1e-6}}});
    command_line::Progress progress(cases.size() * grids.size() * choices.size());
    for (const ExampleCase& one : cases)
        for (const auto& [nx, ny] : grids)
            for (const plate::Corners& corners : choices) {
                progress.step();
                if (!one.is_collocation() && &corners != &choices.front()) continue;
                table.add(
                    one, plate::problem(one.material, corners), Cloud<2>(plate::grid(nx, ny)),
                    named(nx, ny, one, corners), [&] { return places(options); },
                    [nx = nx, ny = ny](const command_line::Solved& solved) {
                        return errors(solved, nx, ny);
                    });
            }
    report::Table found = table.finished();
    if (options.states.empty() && command_line::is_standard_output(options.output)) add_orders(found);
    return found;
}

}  // namespace

int main(int argc, char** argv) {
    command_line::CommandLine app(
        "Section 4.1 of Batra and Zhang (2008): a plate under shear by collocation (strong) and by two local weak forms (weak1, weak2).",
        "plate",
        "A LIST is numbers separated by commas, or a range from:step:to.\n"
        "Corners: 1 north-east, 2 south-east, 3 south-west, 4 north-west; conditions u1, u2, s11, s22, s12.\n"
        "Example: plate --method strong,weak1 --particles 16x4,31x7 --scaling 3:0.5:4\n"
        "Another: plate --method strong,weak1 --particles 16x4,31x7,61x13 --plot /tmp/plate.svg");
    Options options;
    app.add_list("--particles", options.grids, "grids of particles, separated by commas (default 16x4)")
        .type_name("NXxNY[,...]");
    command_line::add_options(app, options, "or a line: bottom, top");
    for (std::size_t k = 0; k < 4; ++k) {
        const std::string corner = std::to_string(k + 1);
        app.add_option("--corner-" + corner, options.corners[k],
                       "what collocation imposes at corner " + corner + " (default " + options.corners[k] +
                           ")" + (k == 0 || k == 2 ? "; all: each pair that the paper compares" : ""))
            .type_name("A,B");
    }
    return command_line::run(app, argc, argv, options.threads, options.output, options.figure, [&] {
        options.figure.script =
            options.scaling.size() > 1 ? "batra2008/figure_9.gp" : "batra2008/figure_12.gp";
        return table_of(options);
    });
}
