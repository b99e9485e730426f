#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "batra2008/section_4_2_hole.hpp"
#include "command_line/example_problems.hpp"
#include "command_line/options.hpp"
#include "command_line/positions.hpp"
#include "command_line/progress.hpp"

namespace {

using namespace batra2008;

/// The particles of a layout by its name, or of a file. \param rho the least scaling factor: they must be few enough for that
/// \param drawn whether another draw is another layout
Points<2> positions(const std::string& layout, const hole::Shape& shape, unsigned long draw, double rho,
                    bool& drawn) {
    static const std::regex graded("graded-([0-9]{1,6})-([0-9]{1,6})"),
        polar("polar-([0-9]{1,5})x([0-9]{1,5})");
    std::smatch found;
    drawn = std::regex_match(layout, found, graded);
    const auto count = [&](int k) { return std::stol(found[k]); };
    if (drawn) {
        command_line::check_cloud(static_cast<double>(count(1)), rho * rho);
        return hole::graded_layout(shape, count(1), count(2), draw);
    }
    if (std::regex_match(layout, found, polar)) {
        command_line::check_cloud(static_cast<double>(count(1) * count(2)), rho * rho);
        return hole::polar_layout(shape, count(1), count(2));
    }
    if (layout.find('.') == std::string::npos && layout.find('/') == std::string::npos)
        throw base::InvalidInput("there is no layout '" + layout +
                                 "'; choose graded-N-A, polar-AxR, or a file (a name with a dot or a slash)");
    return command_line::read_points(layout);
}

/// The places of `--states`.
std::vector<Point<2>> places(const std::string& where, long points, const hole::Shape& shape,
                             const Cloud<2>& cloud) {
    std::vector<Point<2>> chosen;
    if (where == "x2-axis") {
        for (long k = 0; k < points; ++k)
            chosen.emplace_back(0, shape.b + (shape.side - shape.b) * static_cast<double>(k) /
                                                 static_cast<double>(points - 1));
        return chosen;
    }
    const auto grid = [&] {
        const auto [rings, rays] = command_line::pair_of("--states", where);
        command_line::check_states(static_cast<double>(rings) * static_cast<double>(rays));
        return hole::polar_layout(shape, rays, rings);
    };
    const Points<2> x = where == "particles" ? cloud.x() : grid();
    for (Index k = 0; k < x.cols(); ++k) chosen.emplace_back(x.col(k));
    return chosen;
}

/// \throws base::InvalidInput for what is not one stress of each method along the x₂-axis
void check_drawable(const command_line::ExampleOptions& options,
                    const std::vector<command_line::ExampleCase>& cases, std::size_t clouds) {
    std::set<example_problems::Method> methods;
    for (const command_line::ExampleCase& of : cases) methods.insert(of.how.method);
    if (options.states != "x2-axis" || clouds > 1 || methods.size() < cases.size())
        throw base::InvalidInput(
            "--plot draws the stress along the x2-axis (as Figure 17): add --states x2-axis, and take one "
            "layout and one value of everything else");
}

}  // namespace

int main(int argc, char** argv) {
    command_line::CommandLine app(
        "Section 4.2 of Batra and Zhang (2008): a quarter of a plate with a hole under tension, by "
        "collocation (strong) and "
        "by two local weak forms (weak1, weak2).",
        "hole",
        "A LIST is numbers separated by commas, or a range from:step:to.\n"
        "Layouts: graded-N-A, N particles of which A lie on the hole; polar-AxR, A rays of R particles; or a "
        "file, a "
        "line x1 x2 for each particle.\n"
        "Example: hole --layout graded-188-11,graded-686-21 --draws 4");
    command_line::ExampleOptions options;
    options.scaling = "4";
    options.poisson = "0.33";
    options.plane = "strain";
    std::vector<std::string> layouts{"graded-188-11"};
    std::string radii = "0.3";
    unsigned long draw = 1, draws = 1;
    app.add_option("--layout", layouts, "layouts of particles, separated by commas (default graded-188-11)")
        .separated_by_commas()
        .type_name("NAME|FILE[,...]");
    app.add_option("--radius", radii, "radii of the hole in m, in a quarter of 3 m (default 0.3)")
        .type_name("LIST");
    app.add_option("--draw", draw, "first draw of a graded layout (default 1)")
        .type_name("S")
        .within(1, 4000000000);
    app.add_option("--draws", draws, "how many draws: S, S+1, ... (default 1)")
        .type_name("K")
        .within(1, 100000);
    command_line::add_options(app, options, "or a line: x2-axis");

    command_line::Figure figure{"batra2008/figure_17.gp"};
    command_line::add_plot_option(app, figure);

    return command_line::run(app, argc, argv, options.threads, options.output, figure, [&] {
        const auto cases = command_line::cases(options, hole::E, hole::penalty);
        const std::vector<double> all_radii = command_line::numbers("--radius", radii);
        if (!figure.path.empty()) check_drawable(options, cases, layouts.size() * all_radii.size() * draws);
        double rho = cases.front().how.scaling;
        for (const command_line::ExampleCase& of : cases) rho = std::min(rho, of.how.scaling);
        command_line::check_apart({{"--plot", figure.path}, {"--field", options.field}});
        for (const std::string& layout : layouts)
            command_line::check_apart({{"--layout", layout}, {"--output", options.output}});
        command_line::FieldFile field(options.field, cases);
        report::Table table;
        table.comments = {
            "Batra and Zhang (2008), Section 4.2: a quarter of a plate with a hole; lengths in m, stresses "
            "in Pa",
            "strong (3.12) to (3.14), weak1 (3.22) with (3.21), weak2 (3.22) with (3.26); log_error: log10 "
            "of "
            "(4.4), dn the difference of the norms, nd the norm of the difference"};
        table.columns = command_line::case_columns();
        table.columns.insert(table.columns.end(), {{"layout"}, {"radius"}, {"draw"}});
        const bool states = !options.states.empty();
        const auto results = states ? command_line::state_columns(cases)
                                    : std::vector<report::ColumnHead>{{"log_error_dn", {1e-4, 1e-4}},
                                                                      {"log_error_nd", {1e-4, 1e-4}},
                                                                      {"deviation_u1_mm", {1e-4, 1e-6}},
                                                                      {"deviation_u2_mm", {1e-4, 1e-6}},
                                                                      {"stress_concentration", {1e-4, 1e-4}}};
        table.columns.insert(table.columns.end(), results.begin(), results.end());
        if (options.seconds) command_line::add_cost_columns(table);

        command_line::Progress progress(layouts.size() * all_radii.size() * draws * cases.size(), std::cerr,
                                        isatty(STDERR_FILENO) != 0);
        for (const std::string& layout : layouts)
            for (const double radius : all_radii)
                for (unsigned long seed = draw; seed < draw + draws; ++seed) {
                    const hole::Shape shape = hole::checked({radius, 3});
                    bool drawn = false;
                    const Cloud<2> cloud(positions(layout, shape, seed, rho, drawn));
                    if (!drawn && seed > draw) continue;
                    const auto mesh = hole::mesh(shape);
                    for (const command_line::ExampleCase& of : cases) {
                        progress.step();
                        const Problem problem = hole::problem(of.material, shape);
                        command_line::Cost cost;
                        const example_problems::Solution solution =
                            command_line::solved(problem, cloud, of.how, cost);
                        const command_line::Solved solved{problem, cloud, solution};
                        field.add(of, solved);
                        std::vector<report::Cell> row = command_line::case_cells(of);
                        row[1] = static_cast<long>(cloud.size());
                        row.insert(
                            row.end(),
                            {layout, radius, drawn ? report::Cell(static_cast<long>(seed)) : report::Cell()});
                        if (states) {
                            command_line::add_states(table, row, solved,
                                                     places(options.states, options.points, shape, cloud));
                            continue;
                        }
                        const auto [dn, nd] = example_problems::errors(mesh, cloud, solution, problem);
                        const Vector deviation = 1000 * hole::largest_deviations(cloud, solution, problem);
                        row.insert(row.end(), {dn, nd, deviation[0], deviation[1],
                                               hole::stress_concentration(cloud, solution, shape)});
                        if (options.seconds) command_line::add_cost(row, cost);
                        table.rows.push_back(std::move(row));
                    }
                }
        field.write();
        return table;
    });
}
