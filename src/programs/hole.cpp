#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/text.hpp"
#include "batra2008/section_4_2_hole.hpp"
#include "command_line/example_problems.hpp"
#include "command_line/lists.hpp"
#include "command_line/options.hpp"
#include "command_line/positions.hpp"
#include "command_line/progress.hpp"

namespace {

using namespace batra2008;
using command_line::ExampleCase;
using example_problems::Method;
using report::Cell;

/// What the hole can be asked beside what both example problems can.
struct Options : command_line::ExampleOptions {
    std::vector<std::string> layouts{"graded-188-11"};
    std::vector<std::string> columns;  ///< of the positions in files
    std::vector<double> radii{0.3};
    unsigned long draw = 1, draws = 1;
    double snap = 0;
};

/// The particles around the hole.
struct Layout {
    std::string name;
    Points<2> x;
    bool drawn;           ///< whether another draw gives another layout
    std::string about{};  ///< what was done to the particles of a file
};

/// The two counts in the name of a layout, such as polar-16x4; nothing for another name.
/// \param digits how many a count may have
std::optional<std::array<long, 2>> counts(const std::string& name, const std::string& before, char between,
                                          std::size_t digits) {
    const auto middle = name.find(between, before.size());
    if (!name.starts_with(before) || middle == std::string::npos) return {};
    const std::string first = name.substr(before.size(), middle - before.size()),
                      second = name.substr(middle + 1);
    for (const std::string& count : {first, second})
        if (count.empty() || count.size() > digits ||
            count.find_first_not_of("0123456789") != std::string::npos)
            return {};
    return {{std::stol(first), std::stol(second)}};
}

/// A layout of a file, its particles moved onto the boundary as `--snap` says.
Layout layout_of_file(const std::string& name, Points<2> x, const hole::Shape& shape, double snap) {
    if (snap == 0) return {name, std::move(x), false};
    const auto boundary = elastostatics::region(hole::problem({hole::E, hole::nu}, shape));
    auto [there, moved, farthest] = particles::snapped(std::move(x), boundary, snap);
    return {name, std::move(there), false,
            name + ": " + std::to_string(moved) + " particles moved onto the boundary, by " +
                base::shown(farthest, 3) + " m at most"};
}

/// Whether a layout is one of those that the program makes; else it is a file.
bool has_known_name(const std::string& name) {
    return counts(name, "graded-", '-', 6) || counts(name, "polar-", 'x', 5);
}

/// A layout by its name, or of a file.
/// \param rho least scaling factor: the matrices for it must fit into memory
/// \param files the particles of those layouts that are files
Layout layout_named(const std::string& name, const hole::Shape& shape, unsigned long draw, double rho,
                    double snap, const std::map<std::string, Points<2>>& files) {
    if (const auto graded = counts(name, "graded-", '-', 6)) {
        const auto [N, on_arc] = *graded;
        command_line::check_cloud(static_cast<double>(N), rho * rho);
        return {name, hole::graded_layout(shape, N, on_arc, draw), true};
    }
    if (const auto polar = counts(name, "polar-", 'x', 5)) {
        const auto [rays, on_ray] = *polar;
        command_line::check_cloud(static_cast<double>(rays * on_ray), rho * rho);
        return {name, hole::polar_layout(shape, rays, on_ray), false};
    }
    return layout_of_file(name, files.at(name), shape, snap);
}

/// Refuses positions whose largest is about that of the quarter in another unit.
void check_unit(const std::string& name, const Points<2>& x) {
    const double side = hole::Shape().side, largest = x.cols() == 0 ? side : x.cwiseAbs().maxCoeff();
    for (const auto& [unit, metres] : {std::pair{"mm", 1e-3}, {"cm", 1e-2}, {"km", 1e3}})
        if (std::abs(largest * metres / side - 1) < 0.1)
            throw base::InvalidInput("--layout: " + name + " reaches to " + base::shown(largest) +
                                     ", as the quarter does in " + unit + "; write its positions in m");
}

/// The particles of those layouts that are files, each read once.
std::map<std::string, Points<2>> read_layouts(const Options& options) {
    std::map<std::string, Points<2>> files;
    for (const std::string& name : options.layouts) {
        if (has_known_name(name) || files.contains(name)) continue;
        if (name.find('.') == std::string::npos && name.find('/') == std::string::npos)
            throw base::InvalidInput(
                "there is no layout '" + name +
                "'; choose graded-N-A, polar-AxR, or a file (a name with a dot or a slash)");
        files[name] = command_line::read_points(name, options.columns);
        check_unit(name, files[name]);
    }
    if (files.empty() && !options.columns.empty())
        throw base::InvalidInput("--columns belongs to a --layout FILE; name one, or leave --columns out");
    return files;
}

/// The places of `--states`.
std::vector<Point<2>> places(const Options& options, const hole::Shape& shape, const Cloud<2>& cloud) {
    const std::string& where = options.states;
    if (where == "particles") return command_line::places_at(cloud.x());
    if (where == "x2-axis") {
        std::vector<Point<2>> line;
        for (long k = 0; k < options.points; ++k)
            line.emplace_back(0, shape.b + (shape.side - shape.b) * static_cast<double>(k) /
                                               static_cast<double>(options.points - 1));
        return line;
    }
    const auto [rings, rays] = command_line::pair_of("--states", where);
    command_line::check_states(static_cast<double>(rings) * static_cast<double>(rays));
    return command_line::places_at(hole::polar_layout(shape, rays, rings));
}

/// \throws base::InvalidInput unless each method has one stress along the x₂-axis
void check_drawable(const Options& options, const std::vector<ExampleCase>& cases) {
    std::set<Method> methods;
    for (const auto& [how, material] : cases) methods.insert(how.method);
    const std::size_t clouds = options.layouts.size() * options.radii.size() * options.draws;
    if (options.states != "x2-axis" || clouds > 1 || methods.size() < cases.size())
        throw base::InvalidInput(
            "--plot draws the stress along the x2-axis (as Figure 17): add --states x2-axis, and take one layout and one value of everything else");
}

/// Solves all cases on one layout and adds their rows.
void add(command_line::ExampleTable& table, const Options& options, const std::vector<ExampleCase>& cases,
         const hole::Shape& shape, const Layout& layout, unsigned long draw,
         command_line::Progress& progress) {
    const Cloud<2> cloud(layout.x);
    const auto mesh = hole::mesh(shape);
    const auto errors = [&](const command_line::Solved& solved) -> std::vector<Cell> {
        const auto& [problem, particles, solution] = solved;
        const auto [dn, nd] = example_problems::errors(mesh, particles, solution, problem);
        const Vector deviation = 1000 * hole::largest_deviations(particles, solution, problem);
        return {dn, nd, deviation[0], deviation[1], hole::stress_concentration(particles, solution, shape)};
    };
    for (const ExampleCase& one : cases) {
        progress.step();
        table.add(
            one, hole::problem(one.material, shape), cloud,
            {layout.name, shape.b, layout.drawn ? Cell(static_cast<long>(draw)) : Cell()},
            [&](const Cloud<2>& particles) { return places(options, shape, particles); }, errors);
    }
}

report::Table table_of(const Options& options) {
    const auto cases = command_line::cases(options, hole::E, hole::penalty);
    if (!options.figure.path.empty()) check_drawable(options, cases);
    for (const std::string& layout : options.layouts)
        command_line::check_apart({{"--layout", layout},
                                   {"--output", options.output},
                                   {"--field", options.field},
                                   {"--plot", options.figure.path}});
    if (!(std::isfinite(options.snap) && options.snap >= 0))
        throw base::InvalidInput("--snap must be a distance, got " + base::shown(options.snap));
    command_line::ExampleTable table(
        options, cases,
        "Batra and Zhang (2008), Section 4.2: a quarter of a plate with a hole; lengths in m, stresses in Pa",
        {{"layout"}, {"radius"}, {"draw"}},
        {{"log_error_dn", {1e-4, 1e-4}},
         {"log_error_nd", {1e-4, 1e-4}},
         {"deviation_u1_mm", {1e-4, 1e-6}},
         {"deviation_u2_mm", {1e-4, 1e-6}},
         {"stress_concentration", {1e-4, 1e-4}}});
    const auto files = read_layouts(options);
    for (const double radius : options.radii) static_cast<void>(hole::checked({radius, 3}));
    const double rho = *std::min_element(options.scaling.begin(), options.scaling.end());
    command_line::Progress progress(options.layouts.size() * options.radii.size() * options.draws *
                                    cases.size());
    for (const std::string& name : options.layouts)
        for (const double radius : options.radii)
            for (unsigned long draw = options.draw; draw < options.draw + options.draws; ++draw) {
                const hole::Shape shape = hole::checked({radius, 3});
                const Layout layout = layout_named(name, shape, draw, rho, options.snap, files);
                if (!layout.about.empty() && draw == options.draw) table.add_comment(layout.about);
                if (layout.drawn || draw == options.draw)
                    add(table, options, cases, shape, layout, draw, progress);
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
        "Rounded positions: hole --layout body.csv --snap 1e-6");
    Options options;
    options.scaling = {4};
    options.plane = "strain";
    options.figure = {"batra2008/figure_17.gp"};
    app.add_list("--layout", options.layouts,
                 "layouts of particles, separated by commas (default graded-188-11)")
        .type_name("NAME|FILE[,...]");
    app.add_option("--snap", options.snap,
                   "move particles of a file within this distance of the boundary onto it, in m (default 0)")
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
