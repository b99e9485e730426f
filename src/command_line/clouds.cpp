#include "command_line/clouds.hpp"

#include <algorithm>
#include <cmath>

#include "base/memory.hpp"
#include "base/text.hpp"
#include "command_line/formulations.hpp"
#include "command_line/layouts.hpp"
#include "command_line/lists.hpp"
#include "command_line/options.hpp"
#include "command_line/positions.hpp"
#include "expressions/parser.hpp"
#include "fpm_in_space/section_1_second_order_fpm.hpp"

namespace command_line {

using base::InvalidInput;
using base::shown;
using fpm_in_space::formulation_named;
using particles::Cloud;
using particles::Column;
using particles::Exponents;
using particles::Point;
using particles::Range;
namespace derivative_test = fpm_in_space::derivative_test;

namespace {

const std::string stretched_mark = "stretched-";

bool is_stretched(const std::string& layout) {
    return layout.starts_with(stretched_mark);
}
bool is_grid(const std::string& layout) {
    return layout == "grid" || is_stretched(layout);
}
/// The factor by which the distances of a grid grow. \throws InvalidInput for a text that names none
double growth_of(const std::string& layout) {
    if (!is_stretched(layout)) return 1;
    const double growth = number("--layout " + layout, layout.substr(stretched_mark.size()));
    if (growth == 1) throw InvalidInput("--layout " + layout + ": distances do not grow; take grid");
    static_cast<void>(derivative_test::stretched(0, growth));
    return growth;
}
bool is_file(const std::string& layout) {
    return !is_grid(layout) && layout.find_first_of("./") != std::string::npos;
}

/// The radius at which the Gaussian is lowered to zero, unless another kernel was asked for.
double cut_of(const CloudOptions& options) {
    if (!options.cut) return options.dimension == 2 ? fpm_in_space::cut<2> : fpm_in_space::cut<3>;
    const double cut = number("--cut", *options.cut);
    if (!(cut > 0)) throw InvalidInput("--cut must be positive, got " + shown(cut));
    return cut;
}

/// Refuses an option that changes nothing.
void refuse_idle(const std::string& option, bool given, const std::string& why) {
    if (given) throw InvalidInput(option + " changes nothing " + why + "; leave it out");
}

/// \throws InvalidInput for an option that changes nothing
void check_effect(const CloudOptions& options, bool grid, bool file) {
    bool drawn = false;
    for (const std::string& layout : options.layouts)
        for (const double a : options.perturbations) drawn = drawn || CloudCase{layout, a, 0, 1}.is_drawn();
    const bool sampled = grid && options.sample > 0;
    const std::string graded = options.on_square ? "" : ", graded layouts";
    refuse_idle("--seeds", options.seeds > 1 && !drawn,
                "where no particles are drawn (--perturb" + graded + ")");
    refuse_idle("--seed", options.seed != 1 && !drawn && !sampled,
                "where no particles are drawn (--perturb" + graded + ")");
    refuse_idle("--columns", !options.columns.empty() && !file, "without a --layout FILE");
    refuse_idle("--sample", options.sample > 0 && !grid, "without a grid");
    refuse_idle("--particles", !options.particles.empty() && !grid, "without a grid");
    refuse_idle("--perturb", options.perturbations != std::vector<double>{0} && !grid, "without a grid");
    refuse_idle("--median", options.median && options.states, "with --states");
}

/// \throws InvalidInput for numbers that have no meaning, and for more particles than fit into memory
void check_numbers(const CloudOptions& options, bool grid) {
    if (!(std::isfinite(options.smoothing) && options.smoothing > 0))
        throw InvalidInput("--smoothing must be positive and finite, got " + shown(options.smoothing));
    static_cast<void>(cut_of(options));
    for (const double a : options.perturbations)
        if (!(a >= 0 && a < 0.5)) throw InvalidInput("--perturb must lie in [0, 1/2), got " + shown(a));
    for (const long n : options.particles) {
        if (n < 3) throw InvalidInput("--particles: a side needs at least 3, got " + std::to_string(n));
        const auto N = std::pow(static_cast<double>(n), options.dimension);
        constexpr double bytes = 200;  // of a particle: position, volume, cell, value, order
        base::require_memory(shown(N, 12) + " particles", bytes * N, "take fewer --particles along a side");
    }
    if (grid && options.spacing.kind == particles::Spacing::given && options.spacing.lengths.size() > 1)
        throw InvalidInput(
            "--smoothing-from " + options.smoothing_from +
            " has a number for each particle, and a grid is in random order; take one length, or a --layout FILE");
    if (grid && options.function)
        expressions::require_smooth("--function", *options.function, axes(options.dimension));
}

/// \throws InvalidInput for what a figure cannot show
void check_drawable(const CloudOptions& options, bool grid) {
    const std::vector<Draws> all = draws(options);
    if (options.states && (cases(all).size() > 1 || formulations_of(options).size() > 1))
        throw InvalidInput(
            "--states --plot draws the errors of one formulation on one cloud; take one --formulation, one number of --particles, one perturbation and one seed");
    if (!options.states && (!grid || options.layouts.size() > 1))
        throw InvalidInput("--plot draws errors against the particles of a grid; for a layout add --states");
    if (!options.states && (options.perturbations.size() > 2 || (options.seeds > 1 && !options.median)))
        throw InvalidInput(
            "--plot draws at most two perturbations, such as 0,0.25, and of seeds the --median");
}

/// The positions in the file of a layout.
template <int dim>
Eigen::MatrixXd positions_in(const CloudOptions& options, const std::string& file) {
    check_apart({{"--layout", file}, {"--output", options.output}, {"--plot", options.figure.path}});
    Eigen::MatrixXd x = read_points<dim>("--layout", file, options.columns,
                                         dim == 2 ? "a layout in the plane" : "a layout in space");
    check_lengths(options.spacing, options.smoothing_from, x.cols());
    for (double& place : x.reshaped())
        if (const double side = std::round(place);
            options.on_square && std::abs(place - side) < end_tolerance)
            place = side;
    return x;
}

/// Whether layouts around a hole are among those that may be asked for.
bool around_a_hole(const CloudOptions& options) {
    return !options.on_square && options.dimension == 2;
}

/// \throws InvalidInput for a name that is no layout of the test
void check_name(const CloudOptions& options, const std::string& layout) {
    if (!is_around_a_hole(layout) || !around_a_hole(options))
        throw InvalidInput("there is no layout '" + layout +
                           "' here; choose grid, stretched-G (such as stretched-4), " +
                           (around_a_hole(options) ? "graded-N-A, polar-AxR, " : "") +
                           "or a file (a name with a dot or a slash)");
}

template <int dim>
Placed<dim> all_of(const std::string& layout, const particles::Points<dim>& x) {
    try {
        return {Cloud<dim>(x), {{"all", {0, x.cols()}}}};
    } catch (const InvalidInput& error) {
        throw InvalidInput("--layout " + layout + ": " + error.what() + "; leave one of them out");
    }
}

}  // namespace

void add_draw_options(CommandLine& app, CloudOptions& options) {
    app.add_list("--perturb", options.perturbations,
                 "amplitudes a, a list: particles of a grid move by U(-1,1) a delta (default 0)");
    app.add_option("--seed", options.seed,
                   std::string("first seed of perturbations") +
                       (options.on_square ? "" : " and graded layouts") + " (default 1)")
        .type_name("S")
        .within(1, 4000000000);
    app.add_option("--seeds", options.seeds, "number of seeds: S, S+1, ... (default 1)")
        .type_name("K")
        .within(1, 100000);
}

void add_kernel_options(CommandLine& app, CloudOptions& options) {
    const auto cut =
        app.add_option("--cut", options.cut,
                       "the kernel is a Gaussian lowered to zero at this many h (default 3.5; in space 3)")
            .type_name("RHO");
    app.add_option("--kernel", options.kernel, "another kernel: one of " + joined(kernel_names()))
        .type_name("NAME")
        .excludes(cut);
    app.add_option("--smoothing", options.smoothing, "smoothing length over spacing, h/delta (default 1.2)")
        .type_name("RATIO");
}

void add_options(CommandLine& app, CloudOptions& options) {
    app.column_width(34);
    app.add_option("--dimension", options.dimension, "2, the plane (default), or 3, space")
        .type_name("2|3")
        .within(2, 3);
    app.add_list("--formulation", options.formulations,
                 "formulations: all, or some of " + joined(fpm_in_space::formulation_names()) +
                     "; definite_fpm is the second-order FPM (default definite_fpm,ssph)");
    app.add_list("--particles", options.particles,
                 "particles along a side of a grid: a list or a range (default 16,31,61; in space 9,13,17)");
    app.add_list(
           "--layout", options.layouts,
           std::string(
               "layouts, separated by commas: grid (default); stretched-G, a grid whose distances grow by a factor G along each axis; ") +
               (options.on_square
                    ? ""
                    : "in the plane graded-N-A or polar-AxR around a hole, as `hole` takes them; ") +
               "or a file with a line x,y or x,y,z for each particle")
        .type_name("NAME|FILE[,...]");
    app.add_list("--columns", options.columns,
                 "the columns of positions in a file, by names or by numbers from 1 (default: x,y,z)")
        .type_name("X,Y[,Z]");
    add_draw_options(app, options);
    app.add_flag("--median", options.median, "one row for all seeds of a case: medians and quartiles");
    app.add_option("--sample", options.sample,
                   "at most so many random particles of each place of a grid (default 0: all)")
        .type_name("K")
        .within(0, 1000000000);
    add_kernel_options(app, options);
    app.add_option(
           "--smoothing-from", options.smoothing_from,
           "the spacing delta of h/delta: mean (default; on a stretched grid, that of the grid, stretched as at each particle) or largest; or one for each particle: local, nearest, K-nearest (such as 8-nearest); a length; or a file with a number for each particle, FILE or FILE:COLUMN")
        .type_name("NAME");
    app.add_option("--function", options.function,
                   "the function B (default " + std::string(derivative_test::function_typed<2>) +
                       "; in space " + std::string(derivative_test::function_typed<3>) + "); made of " +
                       expressions::vocabulary("x, y, z") +
                       "; smooth on the square or cube of a grid; on other layouts finite at the particles")
        .type_name("TEXT");
    app.add_flag("--states", options.states, "the errors at each particle instead of the largest");
    add_plot_option(app, options.figure);
    app.add_threads(options.threads);
    app.add_output(options.output);
}

void check_grids(const CloudOptions& options) {
    check_effect(options, true, false);
    check_numbers(options, true);
}

void complete(CloudOptions& options) {
    const auto& layouts = options.layouts;
    const bool grid = std::any_of(layouts.begin(), layouts.end(), is_grid),
               file = std::any_of(layouts.begin(), layouts.end(), is_file);
    options.spacing = spacing_from(options.smoothing_from);
    if (options.spacing.kind == particles::Spacing::given)
        check_apart({{"--smoothing-from", named_file(options.smoothing_from).path},
                     {"--output", options.output},
                     {"--plot", options.figure.path}});
    for (const std::string& layout : layouts)
        if (!is_grid(layout) && !is_file(layout)) check_name(options, layout);
    check_effect(options, grid, file);
    static_cast<void>(formulations_of(options));
    check_numbers(options, grid);
    if (options.particles.empty())
        options.particles =
            options.dimension == 2 ? std::vector<long>{16, 31, 61} : std::vector<long>{9, 13, 17};
    for (const std::string& layout : layouts) {
        static_cast<void>(growth_of(layout));
        if (is_file(layout) && !options.files.contains(layout))
            options.files[layout] =
                options.dimension == 2 ? positions_in<2>(options, layout) : positions_in<3>(options, layout);
    }
    if (options.states) options.figure.script = "fpm_in_space/states.gp";
    if (!options.figure.path.empty()) check_drawable(options, grid);
}

bool CloudCase::is_grid() const {
    return command_line::is_grid(layout);
}

bool CloudCase::is_drawn() const {
    return is_grid() ? perturbation != 0 : !is_file(layout) && command_line::is_drawn(layout);
}

std::vector<Draws> draws(const CloudOptions& options) {
    std::vector<Draws> all;
    for (const std::string& layout : options.layouts)
        for (const double perturbation : is_grid(layout) ? options.perturbations : std::vector<double>{0})
            for (const long n : is_grid(layout) ? options.particles : std::vector<long>{0}) {
                CloudCase one{layout, perturbation, n, options.seed};
                const unsigned long seeds = one.is_drawn() ? options.seeds : 1;
                if (options.median) all.push_back({one, seeds});
                for (; !options.median && one.seed < options.seed + seeds; ++one.seed)
                    all.push_back({one, 1});
            }
    return all;
}

std::vector<CloudCase> cases(const std::vector<Draws>& draws) {
    std::vector<CloudCase> all;
    for (const auto& [first, seeds] : draws)
        for (unsigned long k = 0; k < seeds; ++k) {
            all.push_back(first);
            all.back().seed += k;
        }
    return all;
}

std::vector<std::string> formulations_of(const CloudOptions& options) {
    return chosen("formulation", options.formulations, fpm_in_space::formulation_names());
}

std::vector<std::string> axes(long dimension) {
    return dimension == 2 ? std::vector<std::string>{"x", "y"} : std::vector<std::string>{"x", "y", "z"};
}

template <int dim>
Placed<dim> placed(const CloudOptions& options, const CloudCase& one) {
    if (is_file(one.layout)) return all_of<dim>(one.layout, options.files.at(one.layout));
    if constexpr (dim == 2)
        if (!one.is_grid())
            return all_of<2>(
                one.layout,
                Layouts({one.layout}, {}, 0, options.smoothing).around({}, one.layout, one.seed).x);
    auto [cloud, on_sides] =
        derivative_test::body<dim>(one.n, one.perturbation, one.seed, growth_of(one.layout));
    std::vector<std::pair<std::string, Range>> places;
    for (int sides = 0; sides <= dim; ++sides) {
        Range range = on_sides[static_cast<std::size_t>(sides)];
        if (options.sample > 0) range.last = std::min(range.last, range.first + options.sample);
        places.emplace_back(fpm_in_space::place<dim>(sides), range);
    }
    return {std::move(cloud), places};
}

template <int dim>
Column<double> spacing(const CloudOptions& options, const CloudCase& one, const Cloud<dim>& cloud) {
    if (options.spacing.kind != particles::Spacing::mean || !is_stretched(one.layout))
        return particles::spacing(cloud, options.spacing);
    Column<double> each(cloud.size());
    for (particles::Index i = 0; i < cloud.size(); ++i)
        each[i] = derivative_test::stretched_spacing<dim>(
            cloud.x().col(i), 1 / static_cast<double>(one.n - 1), growth_of(one.layout));
    return each;
}

template <int dim>
particles::Smoothing<double, dim> smoothing(const CloudOptions& options, const Column<double>& spacing) {
    particles::Kernel<dim> kernel = particles::TruncatedGaussian<dim>(cut_of(options));
    if (options.kernel) kernel = particles::kernel_named<dim>(*options.kernel);
    return {kernel, spacing, options.smoothing};
}

template <int dim>
derivative_test::Function<dim> function(const CloudOptions& options) {
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

std::string kernel_comment(const CloudOptions& options) {
    return "kernel " +
           (options.kernel ? *options.kernel
                           : "gaussian, lowered to zero at " + shown(cut_of(options)) + " h") +
           ", h/" + (options.smoothing_from == "mean" ? "delta" : options.smoothing_from + " spacing") + " " +
           shown(options.smoothing) +
           (options.sample > 0
                ? ", at most " + std::to_string(options.sample) + " random particles of each place"
                : "");
}

std::vector<std::string> comments(const CloudOptions& options, const std::string& what) {
    std::string equations;
    for (const std::string& name : formulations_of(options))
        equations += (equations.empty() ? "" : ", ") + name + " " +
                     std::string(formulation_named<double, 2>(name).equations);
    return {what + " for B = " +
                options.function.value_or(std::string(options.dimension == 2
                                                          ? derivative_test::function_typed<2>
                                                          : derivative_test::function_typed<3>)),
            "equations: " + equations, kernel_comment(options)};
}

template Placed<2> placed(const CloudOptions&, const CloudCase&);
template Placed<3> placed(const CloudOptions&, const CloudCase&);
template Column<double> spacing(const CloudOptions&, const CloudCase&, const Cloud<2>&);
template Column<double> spacing(const CloudOptions&, const CloudCase&, const Cloud<3>&);
template particles::Smoothing<double, 2> smoothing(const CloudOptions&, const Column<double>&);
template particles::Smoothing<double, 3> smoothing(const CloudOptions&, const Column<double>&);
template derivative_test::Function<2> function<2>(const CloudOptions&);
template derivative_test::Function<3> function<3>(const CloudOptions&);

}  // namespace command_line
