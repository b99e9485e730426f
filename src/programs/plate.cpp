#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "batra2008/section_4_1_plate.hpp"
#include "command_line/example_problems.hpp"
#include "command_line/lists.hpp"
#include "command_line/options.hpp"
#include "command_line/progress.hpp"

namespace {

using namespace batra2008;
using command_line::ExampleCase;
using example_problems::Method;
using report::Cell;
using Pair = std::array<std::string, 2>;

/// What the plate can be asked beside what both example problems can.
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
    std::map<std::pair<Method, double>, std::size_t> rows;
    for (const auto& [how, material] : cases)
        rows[{how.method, how.scaling}] += options.grids.size() * choices;
    const bool scaled = options.scaling.size() > 1;
    const bool one_curve = std::all_of(rows.begin(), rows.end(), [&](const auto& method_and_scaling) {
        return method_and_scaling.second == (scaled ? 1 : options.grids.size());
    });
    const bool one_scaling = scaled && rows.begin()->first.second == std::prev(rows.end())->first.second;
    if (!options.states.empty() || !one_curve || one_scaling)
        throw base::InvalidInput(
            "--plot draws errors: against several --particles (as Figure 12) or against several --scaling (as Figure 9), all else being one value, without --states");
}

/// Refuses a grid that does not fit into memory: the basis sees the particles within ρ times their distance.
void check_grid(long nx, long ny, double rho) {
    if (nx < 2 || ny < 2) return;  // plate::grid() says so
    const auto columns = static_cast<double>(nx), rows = static_cast<double>(ny);
    const double dx = plate::L1 / (columns - 1), dy = plate::L2 / (rows - 1), reach = rho * std::min(dx, dy);
    command_line::check_cloud(columns * rows, std::max(1.0, reach / dx) * std::max(1.0, reach / dy));
}

/// The places of `--states`.
std::vector<Point<2>> places(const Options& options, const Cloud<2>& cloud) {
    const std::string& where = options.states;
    if (where == "particles") return command_line::places_at(cloud.x());
    if (where == "bottom" || where == "top") {
        std::vector<Point<2>> line;
        for (long k = 0; k < options.points; ++k)
            line.emplace_back(plate::L1 * static_cast<double>(k) / static_cast<double>(options.points - 1),
                              where == "top" ? plate::L2 : 0);
        return line;
    }
    const auto [nx, ny] = command_line::pair_of("--states", where);
    command_line::check_states(static_cast<double>(nx) * static_cast<double>(ny));
    return command_line::places_at(plate::grid(nx, ny));
}

/// Solves a case on one grid and adds its rows. The weak forms impose nothing at corners.
void add(command_line::ExampleTable& table, const Options& options, const ExampleCase& one,
         const std::string& grid, const plate::Corners& corners) {
    const auto [nx, ny] = command_line::pair_of("--particles", grid);
    check_grid(nx, ny, one.how.scaling);
    std::vector<Cell> layout{nx, ny};
    for (const auto& [first, second] : corners) {
        layout.emplace_back();
        if (one.how.method == Method::strong) layout.back() = first + " " + second;
    }
    const auto errors = [nx = nx, ny = ny](const command_line::Solved& solved) -> std::vector<Cell> {
        const auto& [problem, cloud, solution] = solved;
        const auto [dn, nd] = example_problems::errors(plate::mesh(nx, ny), cloud, solution, problem);
        return {dn, nd, plate::largest_error_u2(cloud, solution, problem)};
    };
    table.add(
        one, plate::problem(one.material, corners), Cloud<2>(plate::grid(nx, ny)), layout,
        [&](const Cloud<2>& cloud) { return places(options, cloud); }, errors);
}

report::Table table_of(const Options& options) {
    const auto cases = command_line::cases(options, plate::E, plate::penalty);
    const std::vector<plate::Corners> choices = choices_of(options.corners);
    if (!options.figure.path.empty()) check_drawable(options, cases, choices.size());
    for (const std::string& grid : options.grids) {  // before any is solved
        const auto [nx, ny] = command_line::pair_of("--particles", grid);
        check_grid(nx, ny, *std::min_element(options.scaling.begin(), options.scaling.end()));
        static_cast<void>(plate::grid(nx, ny));
    }
    command_line::ExampleTable table(
        options, cases,
        "Batra and Zhang (2008), Section 4.1: a plate under shear; lengths in m, stresses in Pa",
        {{"nx"}, {"ny"}, {"corner_1"}, {"corner_2"}, {"corner_3"}, {"corner_4"}},
        {{"log_error_dn", {1e-5, 1e-5}},
         {"log_error_nd", {1e-5, 1e-5}},
         {"max_error_u2_percent", {1e-5, 1e-6}}});
    command_line::Progress progress(cases.size() * options.grids.size() * choices.size());
    for (const ExampleCase& one : cases)
        for (const std::string& grid : options.grids)
            for (const plate::Corners& corners : choices) {
                progress.step();
                if (one.how.method == Method::strong || &corners == &choices.front())
                    add(table, options, one, grid, corners);
            }
    return table.finished();
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
