#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/memory.hpp"
#include "base/text.hpp"
#include "command_line/formulations.hpp"
#include "command_line/layouts.hpp"
#include "command_line/lists.hpp"
#include "command_line/options.hpp"
#include "command_line/orders.hpp"
#include "command_line/positions.hpp"
#include "command_line/progress.hpp"
#include "command_line/sweep.hpp"
#include "expressions/parser.hpp"
#include "fpm_in_space/section_4_derivative_test.hpp"
#include "particles/spacing.hpp"
#include "report/statistics.hpp"

namespace {

using namespace fpm_in_space;
using base::InvalidInput;
using base::shown;
using command_line::Attempt;
using derivative_test::AtParticle;
using particles::Cloud;
using particles::Column;
using particles::Exponents;
using particles::Index;
using particles::Point;
using particles::Range;
using report::Cell;

struct Options {
    long dimension = 2;
    std::vector<std::string> formulations{"definite_fpm", "ssph"}, layouts{"grid"}, columns;
    std::vector<long> particles;
    std::vector<double> perturbations{0};
    unsigned long seed = 1, seeds = 1;
    bool median = false, states = false;
    long sample = 0;
    std::optional<std::string> kernel, function;
    std::optional<std::string> cut;
    double smoothing = 1.2;
    std::string smoothing_from = "mean";
    particles::Spacing spacing = particles::Spacing::mean;
    int threads = 0;
    std::string output;
    command_line::Figure figure{"fpm_in_space/errors.gp"};
    std::map<std::string, Eigen::MatrixXd> files;  ///< positions, a column for each particle, once read
};

/// Names of the coordinates.
std::vector<std::string> axes(long dimension) {
    return dimension == 2 ? std::vector<std::string>{"x", "y"} : std::vector<std::string>{"x", "y", "z"};
}

bool is_grid(const std::string& layout) {
    return layout == "grid";
}
bool is_file(const std::string& layout) {
    return layout.find_first_of("./") != std::string::npos;
}
/// Whether another seed gives other particles.
bool is_drawn(const std::string& layout, double perturbation) {
    return is_grid(layout) ? perturbation != 0 : !is_file(layout) && command_line::is_drawn(layout);
}

/// Particles of which all formulations are computed.
struct Case {
    std::string layout;
    double perturbation;
    long n;  ///< particles along a side of a grid
    unsigned long seed;
};

/// The cases that differ in their seeds only: one row with --median.
struct Group {
    Case first;
    unsigned long seeds;
};

std::vector<Group> groups(const Options& options) {
    std::vector<Group> all;
    for (const std::string& layout : options.layouts)
        for (const double perturbation : is_grid(layout) ? options.perturbations : std::vector<double>{0})
            for (const long n : is_grid(layout) ? options.particles : std::vector<long>{0}) {
                const unsigned long seeds = is_drawn(layout, perturbation) ? options.seeds : 1;
                for (unsigned long k = 0; k < (options.median ? 1 : seeds); ++k)
                    all.push_back({{layout, perturbation, n, options.seed + k}, options.median ? seeds : 1});
            }
    return all;
}

/// The cases of all groups.
std::vector<Case> cases(const std::vector<Group>& groups) {
    std::vector<Case> all;
    for (const auto& [first, seeds] : groups)
        for (unsigned long k = 0; k < seeds; ++k) {
            all.push_back(first);
            all.back().seed += k;
        }
    return all;
}

std::vector<std::string> wanted(const Options& options) {
    return command_line::chosen("formulation", options.formulations, formulation_names());
}

/// Particles, and those that lie at each place.
template <int dim>
struct Placed {
    Cloud<dim> cloud;
    std::vector<std::pair<std::string, Range>> places;
};

/// \throws base::InvalidInput naming the layout, where its particles are no cloud
template <int dim>
Placed<dim> all_of(const std::string& layout, const particles::Points<dim>& x) {
    try {
        return {Cloud<dim>(x), {{"all", {0, x.cols()}}}};
    } catch (const InvalidInput& error) {
        throw InvalidInput("--layout " + layout + ": " + error.what() + "; leave one of them out");
    }
}

/// The particles of a case; of a grid's places, those of the sample.
template <int dim>
Placed<dim> placed(const Options& options, const Case& one) {
    if (is_file(one.layout)) return all_of<dim>(one.layout, options.files.at(one.layout));
    if (!is_grid(one.layout)) {
        const command_line::Layouts layouts({one.layout}, {}, 0, options.smoothing);
        if constexpr (dim == 2) return all_of<2>(one.layout, layouts.around({}, one.layout, one.seed).x);
    }
    auto [cloud, on_sides] = derivative_test::body<dim>(one.n, one.perturbation, one.seed);
    std::vector<std::pair<std::string, Range>> places;
    for (int sides = 0; sides <= dim; ++sides) {
        Range range = on_sides[static_cast<std::size_t>(sides)];
        if (options.sample > 0) range.last = std::min(range.last, range.first + options.sample);
        places.emplace_back(fpm_in_space::place<dim>(sides), range);
    }
    return {std::move(cloud), places};
}

/// The radius at which the Gaussian is lowered to zero, unless another kernel was asked for.
double cut_of(const Options& options) {
    if (!options.cut) return options.dimension == 2 ? 3.5 : 3;
    const double cut = command_line::number("--cut", *options.cut);
    if (!(cut > 0)) throw InvalidInput("--cut must be positive, got " + shown(cut));
    return cut;
}

template <int dim>
particles::Kernel<dim> kernel_of(const Options& options) {
    if (options.kernel) return particles::kernel_named<dim>(*options.kernel);
    return particles::TruncatedGaussian<dim>(cut_of(options));
}

/// The user's function, or that of the text. A second derivative in two coordinates follows from those along
/// the axes and between them:
/// \f[ 2\,\partial_{12} f = \partial^2_{1+2} f - \partial_{11} f - \partial_{22} f \f]
template <int dim>
derivative_test::Function<dim> function_of(const Options& options) {
    if (!options.function) return derivative_test::exponential_and_wave<dim>;
    const auto f = expressions::directional("--function", *options.function, axes(dim));
    return [f](const Point<dim>& x, const Exponents<dim>& a) {
        const auto along = [&](const Point<dim>& direction) {
            return f({x.data(), dim}, {direction.data(), dim});
        };
        Point<dim> sum = Point<dim>::Zero();
        double pure = 0;  // the sum of the second derivatives along the axes in a
        int count = 0;
        for (int axis = 0; axis < dim; ++axis)
            if (a[static_cast<std::size_t>(axis)] > 0) {
                sum[axis] = 1;
                pure += along(Point<dim>::Unit(axis)).second;
                ++count;
            }
        const auto found = along(sum);
        const int order = particles::order<dim>(a);
        if (order < 2) return order == 0 ? found.value : found.first;
        return count == 1 ? pure : (found.second - pure) / 2;
    };
}

/// What a formulation finds at each place.
template <int dim>
std::vector<std::vector<AtParticle>> found(const Options& options, const std::string& formulation,
                                           const Placed<dim>& particles,
                                           const derivative_test::Function<dim>& B) {
    const Column<double> spacing = particles::spacing(particles.cloud, options.spacing);
    const particles::Smoothing<double, dim> smoothing(kernel_of<dim>(options), spacing, options.smoothing);
    std::vector<Range> ranges;
    for (const auto& [name, range] : particles.places) ranges.push_back(range);
    return derivative_test::errors(formulation_named<double, dim>(formulation), particles.cloud, smoothing,
                                   spacing, B, ranges);
}

/// Cells that name a formulation on the particles of a case.
std::vector<Cell> named(const std::string& formulation, const Case& one) {
    const bool grid = is_grid(one.layout);
    return {formulation,
            one.layout,
            grid ? Cell(one.n) : Cell(),
            grid ? Cell(1 / static_cast<double>(one.n - 1)) : Cell(),
            grid ? Cell(one.perturbation) : Cell(),
            is_drawn(one.layout, one.perturbation) ? Cell(static_cast<long>(one.seed)) : Cell()};
}
const std::vector<report::ColumnHead> naming{{"formulation"}, {"layout"},       {"particles"},
                                             {"spacing"},     {"perturbation"}, {"seed"}};
const std::vector<report::ColumnHead> measured{
    {"error_first", {1e-6, 1e-12}}, {"error_second", {1e-6, 2e-10}}, {"quality", {1e-6, 1e-9}}};

/// The comments of a table.
std::vector<std::string> comments(const Options& options, const std::string& what) {
    std::string equations;
    for (const std::string& name : wanted(options))
        equations += (equations.empty() ? "" : ", ") + name + " " +
                     std::string(formulation_named<double, 2>(name).equations);
    return {"FPM in space, Section 4: " + what + " for B = " +
                options.function.value_or(options.dimension == 2 ? "exp(x+y/2)+sin(x+2*y)"
                                                                 : "exp(x+y/2-0.3*z)+sin(x+2*y+1.5*z)"),
            "equations: " + equations,
            "kernel " +
                (options.kernel ? *options.kernel
                                : "gaussian, lowered to zero at " + shown(cut_of(options)) + " h") +
                ", h/" + (options.smoothing_from == "mean" ? "delta" : options.smoothing_from + " spacing") +
                " " + shown(options.smoothing) +
                (options.sample > 0
                     ? ", at most " + std::to_string(options.sample) + " random particles of each place"
                     : ""),
            "quality: R, the factor in the bound of the error of second derivatives in powers of delta"};
}

/// Names of the places of a layout.
template <int dim>
std::vector<std::string> places_of(const std::string& layout) {
    if (!is_grid(layout)) return {"all"};
    std::vector<std::string> names;
    for (int sides = 0; sides <= dim; ++sides) names.push_back(fpm_in_space::place<dim>(sides));
    return names;
}

/// How many particles there are at each place, and the largest of what is found there, in the columns
/// `measured`: for each formulation.
template <int dim>
std::vector<Attempt> attempts_at(const Options& options, const Case& one,
                                 const derivative_test::Function<dim>& B) {
    std::optional<Placed<dim>> particles;
    const auto failure = command_line::failure_of([&] { particles = placed<dim>(options, one); });
    std::vector<Attempt> attempts;
    for (const std::string& formulation : wanted(options)) {
        Attempt& attempt = attempts.emplace_back();
        attempt.failure = failure ? failure : command_line::failure_of([&] {
            for (const std::vector<AtParticle>& there : found<dim>(options, formulation, *particles, B)) {
                const AtParticle most = derivative_test::largest(there);
                attempt.numbers.insert(attempt.numbers.end(),
                                       {static_cast<long>(there.size()), most.first, most.second, most.R});
            }
        });
    }
    return attempts;
}

/// The rows of a group, one for each place: the largest errors, with --median their medians and quartiles.
/// \param attempts those at its cases
template <int dim>
std::vector<std::vector<Cell>> rows(const Options& options, const std::string& formulation,
                                    const Group& group, const std::vector<Attempt>& attempts) {
    std::vector<std::vector<Cell>> table;
    const std::vector<std::string> places = places_of<dim>(group.first.layout);
    for (std::size_t place = 0; place < places.size(); ++place) {
        const std::size_t at = place * (1 + measured.size());
        std::vector<Cell> row = named(formulation, group.first), spread{static_cast<long>(group.seeds)};
        row.insert(row.end(), {places[place], attempts.front().numbers[at]});
        for (std::size_t column = 1; column <= measured.size(); ++column) {
            std::vector<double> sample;
            for (const Attempt& attempt : attempts)
                sample.push_back(std::get<double>(attempt.numbers[at + column]));
            const auto [lower, median, upper] = report::quartiles(sample);
            row.emplace_back(median);
            spread.insert(spread.end(), {lower, upper});
        }
        if (options.median) row.insert(row.end(), spread.begin(), spread.end());
        table.push_back(std::move(row));
    }
    return table;
}

/// Reads the files of layouts, each once, and checks what is said of their particles.
/// \throws base::InvalidInput for files that cannot be read, or that would be written
template <int dim>
void read_files(Options& options) {
    for (const std::string& layout : options.layouts) {
        if (!is_file(layout) && !is_grid(layout))
            static_cast<void>(
                command_line::Layouts({layout}, {}, 0, options.smoothing));  // a name that it knows
        if (!is_file(layout) || options.files.contains(layout)) continue;
        command_line::check_apart(
            {{"--layout", layout}, {"--output", options.output}, {"--plot", options.figure.path}});
        options.files[layout] = command_line::read_points<dim>(
            "--layout", layout, options.columns, dim == 2 ? "a layout in the plane" : "a layout in space");
        if (options.files[layout].cols() < 2)
            throw InvalidInput("--layout: " + layout + " has " +
                               std::to_string(options.files[layout].cols()) +
                               " particles; a cloud needs some, on a line each");
        command_line::check_lengths(options.spacing, options.smoothing_from, options.files[layout].cols());
    }
}

template <int dim>
report::Table table_of(Options& options) {
    read_files<dim>(options);
    report::Table table;
    table.comments = comments(options, "largest errors of the first and second derivatives by place");
    table.columns = naming;
    table.columns.insert(table.columns.end(), {{"place"}, {"count"}});
    table.columns.insert(table.columns.end(), measured.begin(), measured.end());
    if (options.median) {
        table.columns.push_back({"seeds"});
        for (const auto& column : measured)
            for (const char* quartile : {"_lower", "_upper"})
                table.columns.push_back({column.name + quartile, column.tolerance});
    }
    const std::vector<Group> all = groups(options);
    const auto B = function_of<dim>(options);
    const auto attempts = command_line::computed_in_parallel(
        cases(all), [&](const Case& one) { return attempts_at<dim>(options, one, B); });
    const std::vector<std::string> formulations = wanted(options);
    command_line::Sweep sweep(table, naming.size());
    for (std::size_t f = 0; f < formulations.size(); ++f) {
        std::size_t at = 0;
        for (const Group& group : all) {
            std::vector<Attempt> of_group;
            for (unsigned long k = 0; k < group.seeds; ++k) of_group.push_back(attempts[at++][f]);
            if (const auto failure =
                    command_line::failure_of_seeds(of_group, 0, of_group.size(), group.first.seed))
                sweep.add_failed(named(formulations[f], group.first), *failure);
            else
                sweep.add(rows<dim>(options, formulations[f], group, of_group));
        }
    }
    sweep.finish();
    const bool grids = std::all_of(options.layouts.begin(), options.layouts.end(), is_grid);
    if (grids && command_line::is_standard_output(options.output)) {
        const std::size_t spacing = table.column("spacing");
        command_line::add_orders(table, {"formulation", "perturbation", "seed", "place"},
                                 [&](std::size_t row) { return std::get<double>(table.rows[row][spacing]); });
    }
    return table;
}

/// A row for each particle: its place, its position and what is found there.
template <int dim>
report::Table states_of(Options& options) {
    read_files<dim>(options);
    report::Table table;
    table.comments = comments(options, "errors of the derivatives at each particle");
    table.columns = naming;
    table.columns.insert(table.columns.end(), {{"place"}, {"particle"}});
    for (const std::string& axis : axes(dim)) table.columns.push_back({axis});
    table.columns.insert(table.columns.end(), measured.begin(), measured.end());
    const std::vector<Case> all = cases(groups(options));
    const std::vector<std::string> formulations = wanted(options);
    const auto B = function_of<dim>(options);
    command_line::Sweep sweep(table, naming.size());
    command_line::Progress progress(formulations.size() * all.size());
    for (const std::string& formulation : formulations)
        for (const Case& one : all) {
            const std::vector<Cell> name = named(formulation, one);
            sweep.attempt(name, [&] {
                const auto particles = placed<dim>(options, one);
                const Column<double> spacing = particles::spacing(particles.cloud, options.spacing);
                const auto at = found<dim>(options, formulation, particles, B);
                std::vector<std::vector<Cell>> states;
                for (std::size_t place = 0; place < at.size(); ++place)
                    for (const auto& [i, first, second, R] : at[place]) {
                        std::vector<Cell> row = name;
                        row[3] = spacing[spacing.size() == 1 ? 0 : i];
                        row.insert(row.end(), {particles.places[place].first, static_cast<long>(i)});
                        for (const double x : particles.cloud.x().col(i)) row.emplace_back(x);
                        row.insert(row.end(), {first, second, R});
                        states.push_back(std::move(row));
                    }
                return states;
            });
            progress.step();
        }
    sweep.finish();
    return table;
}

/// \throws base::InvalidInput for what changes nothing, has no meaning, or cannot be drawn
void check(const Options& options) {
    const auto& layouts = options.layouts;
    const bool grid = std::any_of(layouts.begin(), layouts.end(), is_grid),
               file = std::any_of(layouts.begin(), layouts.end(), is_file);
    bool drawn = false;
    for (const std::string& layout : layouts) {
        if (!is_grid(layout) && !is_file(layout) && options.dimension == 3)
            throw InvalidInput("--layout " + layout + " is none in space; choose grid or a file");
        for (const double a : options.perturbations) drawn = drawn || is_drawn(layout, a);
    }
    const auto refuse_idle = [](const std::string& option, bool given, const std::string& why) {
        if (given) throw InvalidInput(option + " changes nothing " + why + "; leave it out");
    };
    const bool sampled = grid && options.sample > 0;
    refuse_idle("--seeds", options.seeds > 1 && !drawn,
                "where no particles are drawn (--perturb, graded layouts)");
    refuse_idle("--seed", options.seed != 1 && !drawn && !sampled,
                "where no particles are drawn (--perturb, --sample, graded layouts)");
    refuse_idle("--columns", !options.columns.empty() && !file, "without a --layout FILE");
    refuse_idle("--sample", options.sample > 0 && !grid, "without a grid");
    refuse_idle("--particles", !options.particles.empty() && !grid, "without a grid");
    refuse_idle("--perturb", options.perturbations != std::vector<double>{0} && !grid, "without a grid");
    refuse_idle("--median", options.median && options.states, "with --states");
    if (!(std::isfinite(options.smoothing) && options.smoothing > 0))
        throw InvalidInput("--smoothing must be positive and finite, got " + shown(options.smoothing));
    static_cast<void>(cut_of(options));
    static_cast<void>(wanted(options));
    if (options.spacing.kind == particles::Spacing::given) {
        if (grid && options.spacing.lengths.size() > 1)
            throw InvalidInput(
                "--smoothing-from " + options.smoothing_from +
                " has a number for each particle, and a grid is in random order; take one length, or a --layout FILE");
        command_line::check_apart(
            {{"--smoothing-from", command_line::named_file(options.smoothing_from).path},
             {"--output", options.output},
             {"--plot", options.figure.path}});
    }
    for (const double a : options.perturbations)
        if (!(a >= 0 && a < 0.5)) throw InvalidInput("--perturb must lie in [0, 1/2), got " + shown(a));
    for (const long n : options.particles)
        if (n < 3) throw InvalidInput("--particles: a side needs at least 3, got " + std::to_string(n));
    if (grid && options.function)
        expressions::require_smooth("--function", *options.function, axes(options.dimension));
    for (const long n : options.particles) {
        const auto N = std::pow(static_cast<double>(std::max(n, 0L)), options.dimension);
        base::require_memory(shown(N, 12) + " particles", 200 * N, "take fewer --particles along a side");
    }
    if (options.figure.path.empty()) return;
    const std::size_t clouds =
        layouts.size() * options.perturbations.size() * options.seeds *
        (grid ? std::max<std::size_t>(options.particles.size(), options.particles.empty() ? 3 : 1) : 1);
    if (options.states && (clouds > 1 || wanted(options).size() > 1))
        throw InvalidInput(
            "--states --plot draws the errors of one formulation on one cloud; take one --formulation, one number of --particles, one perturbation and one seed");
    if (!options.states && (!grid || layouts.size() > 1))
        throw InvalidInput("--plot draws errors against the particles of a grid; for a layout add --states");
    if (!options.states && (options.perturbations.size() > 2 || (options.seeds > 1 && !options.median)))
        throw InvalidInput(
            "--plot draws at most two perturbations, such as 0,0.25, and of seeds the --median");
}

}  // namespace

int main(int argc, char** argv) {
    command_line::CommandLine app(
        "The second-order FPM in the plane and in space, Section 4: largest errors of the first and second derivatives inside and at faces, edges and corners of the unit square or cube.",
        "derivative_test_in_space",
        "Example: derivative_test_in_space --formulation definite_fpm --particles 31,61,121 --perturb 0.25 --plot /tmp/plane.svg\n"
        "In space: derivative_test_in_space --dimension 3 --function \"sin(x+2*y)*exp(z)\" --particles 9,17\n"
        "Particles of your own: derivative_test_in_space --layout body.csv --smoothing-from local --formulation definite_fpm --states --plot /tmp/body.svg");
    Options options;
    app.column_width(34);
    app.add_option("--dimension", options.dimension, "2, the plane (default), or 3, space")
        .type_name("2|3")
        .within(2, 3);
    app.add_list("--formulation", options.formulations,
                 "formulations: all, or some of " + command_line::joined(formulation_names()) +
                     "; definite_fpm is the second-order FPM (default definite_fpm,ssph)");
    app.add_list("--particles", options.particles,
                 "particles along a side of a grid: a list or a range (default 16,31,61; in space 9,13,17)");
    app.add_list(
           "--layout", options.layouts,
           "layouts, separated by commas: grid (default); in the plane graded-N-A or polar-AxR around a hole, as `hole` takes them; or a file with a line x,y or x,y,z for each particle")
        .type_name("NAME|FILE[,...]");
    app.add_list("--columns", options.columns,
                 "the columns of positions in a file, by names or by numbers from 1 (default: x,y,z)")
        .type_name("X,Y[,Z]");
    app.add_list("--perturb", options.perturbations,
                 "amplitudes a, a list: particles of a grid move by U(-1,1) a delta (default 0)");
    app.add_option("--seed", options.seed, "first seed of perturbations and graded layouts (default 1)")
        .type_name("S")
        .within(1, 4000000000);
    app.add_option("--seeds", options.seeds, "number of seeds: S, S+1, ... (default 1)")
        .type_name("K")
        .within(1, 100000);
    app.add_flag("--median", options.median, "one row for all seeds of a case: medians and quartiles");
    app.add_option("--sample", options.sample,
                   "at most so many random particles of each place of a grid (default 0: all)")
        .type_name("K")
        .within(0, 1000000000);
    const auto cut =
        app.add_option("--cut", options.cut,
                       "the kernel is a Gaussian lowered to zero at this many h (default 3.5; in space 3)")
            .type_name("RHO");
    app.add_option("--kernel", options.kernel,
                   "another kernel: one of " + command_line::joined(command_line::kernel_names()))
        .type_name("NAME")
        .excludes(cut);
    app.add_option("--smoothing", options.smoothing, "smoothing length over spacing, h/delta (default 1.2)")
        .type_name("RATIO");
    app.add_option(
           "--smoothing-from", options.smoothing_from,
           "the spacing delta of h/delta: mean (default) or largest; or one for each particle: local, nearest, K-nearest (such as 8-nearest); a length; or a file with a number for each particle, FILE or FILE:COLUMN")
        .type_name("NAME");
    app.add_option(
           "--function", options.function,
           "the function B (default exp(x+y/2)+sin(x+2*y); in space exp(x+y/2-0.3*z)+sin(x+2*y+1.5*z)); made of " +
               expressions::vocabulary("x, y, z") +
               "; smooth on the square or cube of a grid; on other layouts finite at the particles")
        .type_name("TEXT");
    app.add_flag("--states", options.states, "the errors at each particle instead of the largest");
    command_line::add_plot_option(app, options.figure);
    app.add_threads(options.threads);
    app.add_output(options.output);
    return command_line::run(app, argc, argv, options.threads, options.output, options.figure, [&] {
        options.spacing = command_line::spacing_from(options.smoothing_from);
        check(options);
        if (options.particles.empty())
            options.particles =
                options.dimension == 2 ? std::vector<long>{16, 31, 61} : std::vector<long>{9, 13, 17};
        if (options.states) options.figure.script = "fpm_in_space/states.gp";
        if (options.dimension == 2) return options.states ? states_of<2>(options) : table_of<2>(options);
        return options.states ? states_of<3>(options) : table_of<3>(options);
    });
}
