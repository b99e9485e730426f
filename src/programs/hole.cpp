#include "batra2008/section_4_2_hole.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "command_line/example_problems.hpp"
#include "command_line/layouts.hpp"
#include "command_line/lists.hpp"
#include "command_line/options.hpp"
#include "command_line/progress.hpp"

namespace {

using namespace batra2008;
using command_line::ExampleCase;
using report::Cell;

/// The options of the hole, and those of both example problems.
struct Options : command_line::ExampleOptions {
    std::vector<std::string> layouts{"graded-188-11"};
    std::vector<std::string> columns;  ///< of the positions in files
    std::vector<double> radii{0.3};
    unsigned long draw = 1, draws = 1;
    double snap = 0;
};

/// \throws base::InvalidInput unless each method has one stress along the x₂-axis
void check_drawable(const Options& options, const std::vector<ExampleCase>& cases) {
    std::set<std::string> methods;
    for (const ExampleCase& one : cases) methods.insert(one.method);
    const std::size_t clouds = options.layouts.size() * options.radii.size() * options.draws;
    if (options.states != "x2-axis" || clouds > 1 || methods.size() < cases.size())
        throw base::InvalidInput(
            "--plot draws the stress along the x2-axis (as Figure 17): add --states x2-axis, and take one layout and one value of everything else");
}

/// The places of `--states` other than the particles.
std::vector<Point<2>> places(const Options& options, const hole::Shape& shape) {
    if (options.states == "x2-axis")
        return command_line::places_between({0, shape.b}, {0, shape.side}, options.points);
    const auto [rings, rays] = command_line::grid_of_places(options.states);
    if (rings < 3 || rays < 3 || rays % 2 == 0)
        throw base::InvalidInput(
            "--states " + options.states +
            ": a grid around the hole has rings x rays, three of each at least and an odd number of rays, such as 46x11");
    return command_line::places_at(hole::polar_layout(shape, rays, rings));
}

/// Errors of a solution as the columns below name them.
std::vector<Cell> errors(const command_line::Solved& solved, const hole::Shape& shape) {
    const auto& [problem, cloud, solution] = solved;
    const auto [dn, nd] = example_problems::errors(hole::mesh(shape), cloud, solution, problem);
    const auto [u1, u2] = hole::largest_deviations(cloud, solution, problem);
    const auto [axis_u2, axis_s11] = hole::largest_deviations_on_axis(cloud, solution, problem, shape);
    // A particle on an axis may stand beside it by round-off.
    const auto coordinate = [](double x) { return std::abs(x) < 1e-12 ? 0 : x; };
    return {dn,
            nd,
            1000 * u1.size,
            1000 * u2.size,
            hole::stress_concentration(cloud, solution, shape),
            coordinate(u1.x[0]),
            coordinate(u1.x[1]),
            coordinate(u2.x[0]),
            coordinate(u2.x[1]),
            1000 * axis_u2,
            axis_s11};
}

report::Table table_of(const Options& options) {
    const auto cases = command_line::cases(options, hole::E, hole::penalty);
    if (!options.figure.path.empty()) check_drawable(options, cases);
    for (const std::string& layout : options.layouts)
        command_line::check_apart_from_outputs(options, "--layout", layout);
    const command_line::Layouts layouts(options.layouts, options.columns, options.snap,
                                        *std::max_element(options.scaling.begin(), options.scaling.end()));
    const bool any_drawn =
        std::any_of(options.layouts.begin(), options.layouts.end(), command_line::is_drawn);
    if (!any_drawn && (options.draw != 1 || options.draws != 1))
        throw base::InvalidInput(
            std::string(options.draws != 1 ? "--draws" : "--draw") +
            " changes nothing without a graded layout; add one, such as --layout graded-188-11");
    for (const double radius : options.radii) static_cast<void>(hole::checked({radius}));
    command_line::ExampleTable table(
        options, cases,
        "Batra and Zhang (2008), Section 4.2: a quarter of a plate with a hole; lengths in m, stresses in Pa",
        {{"layout"}, {"radius"}, {"draw"}},
        {{"log_error_dn", {1e-4, 1e-4}},
         {"log_error_nd", {1e-4, 1e-4}},
         {"deviation_u1_mm", {1e-4, 1e-6}},
         {"deviation_u2_mm", {1e-4, 1e-6}},
         {"stress_concentration", {1e-4, 1e-4}},
         {"deviation_u1_x1", {1e-9, 1e-9}},
         {"deviation_u1_x2", {1e-9, 1e-9}},
         {"deviation_u2_x1", {1e-9, 1e-9}},
         {"deviation_u2_x2", {1e-9, 1e-9}},
         {"axis_deviation_u2_mm", {1e-4, 1e-6}},
         {"axis_deviation_s11", {1e-4, 1e-6}}});
    command_line::Progress progress(options.layouts.size() * options.radii.size() * options.draws *
                                    cases.size());
    for (const std::string& name : options.layouts)
        for (const double radius : options.radii)
            for (unsigned long draw = options.draw; draw < options.draw + options.draws; ++draw) {
                const hole::Shape shape{radius};
                const auto [layout, x, drawn, about] = layouts.around(shape, name, draw);
                if (!drawn && draw > options.draw) continue;
                if (!about.empty()) table.add_comment(about);
                const std::vector<Cell> named{layout, radius, drawn ? Cell(static_cast<long>(draw)) : Cell()};
                for (const ExampleCase& one : cases) {
                    progress.step();
                    table.add(
                        one, hole::problem(one.material, shape), Cloud<2>(x), named,
                        [&] { return places(options, shape); },
                        [&](const command_line::Solved& solved) { return errors(solved, shape); });
                }
            }
    return table.finished();
}

}  // namespace

int main(int argc, char** argv) {
    command_line::CommandLine app(
        "Section 4.2 of Batra and Zhang (2008): a quarter of a plate with a hole under tension, by collocation (strong) and by two local weak forms (weak1, weak2).",
        "hole",
        "A LIST is numbers separated by commas, or a range from:step:to.\n"
        "Layouts: graded-N-A, N particles of which A lie on the hole; polar-AxR, A rays of R particles; or a file with a line x1 x2 for each particle.\n"
        "Example: hole --layout graded-188-11,graded-686-21 --draws 4\n"
        "Another: hole --states x2-axis --plot /tmp/hole.svg\n"
        "By the second-order FPM: hole --method strong,fpm --quality\n"
        "Rounded positions: hole --layout body.csv --snap 1e-6");
    Options options;
    options.scaling = {4};
    options.plane = "strain";
    options.fpm_smoothing_from = "local";  // around the hole, nearest errs three times as much
    options.figure = {"batra2008/figure_17.gp"};
    app.add_list("--layout", options.layouts,
                 "layouts of particles, separated by commas (default graded-188-11)")
        .type_name("NAME|FILE[,...]");
    app.add_option("--snap", options.snap,
                   "move particles within this distance of the boundary onto it, in m (default 0)")
        .type_name("D");
    app.add_list(
           "--columns", options.columns,
           "the columns of positions in a file, by names or by numbers from 1 (default: x1,x2 or x,y, else the only two)")
        .type_name("X,Y");
    app.add_list("--radius", options.radii,
                 "radii of the hole in m; the quarter has a side of 3 m (default 0.3)");
    app.add_option("--draw", options.draw, "first draw of a graded layout (default 1)")
        .type_name("S")
        .within(1, 4000000000);
    app.add_option("--draws", options.draws, "number of draws: S, S+1, ... (default 1)")
        .type_name("K")
        .within(1, 100000);
    command_line::add_options(app, options, "or a line: x2-axis");
    return command_line::run(app, argc, argv, options.threads, options.output, options.figure,
                             [&] { return table_of(options); });
}
