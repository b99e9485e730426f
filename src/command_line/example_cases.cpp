#include "command_line/example_cases.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "base/memory.hpp"
#include "base/text.hpp"
#include "command_line/lists.hpp"
#include "command_line/options.hpp"
#include "command_line/positions.hpp"

namespace command_line {

using namespace batra2008;
using base::InvalidInput;
using report::Cell;

void add_options(CommandLine& app, ExampleOptions& options, const std::string& places) {
    app.column_width(34);
    options.given = [&app](const std::string& option) { return app.given(option); };
    app.add_list(
        "--method", options.methods,
        "methods: all of the paper (default), or some of strong (collocation), weak1, weak2 (MLPG), and fpm, collocation by the second-order FPM");
    app.add_list("--scaling", options.scaling,
                 "scaling factors rho of the SSPH basis' kernel (default " +
                     base::shown(options.scaling.front()) + ")");
    app.add_option("--smoothing", options.smoothing,
                   "fpm: smoothing length over that of --smoothing-from (default 1.2)")
        .type_name("RATIO");
    app.add_option(
           "--smoothing-from", options.smoothing_from,
           "smoothing lengths h: nearest (default" +
               (options.fpm_smoothing_from == "nearest" ? std::string()
                                                        : ", but " + options.fpm_smoothing_from + " of fpm") +
               ": each particle's distance to the nearest other one), K-nearest (to the farthest of the K nearest, such as 6-nearest), local (to the farthest of the 4 nearest), mean (the spacing of a grid of as many particles), largest (the largest distance to a nearest particle), a number (for stretched grids), or a file with a number for each particle, FILE or FILE:COLUMN")
        .type_name("NAME");
    app.add_list("--degree", options.degree, "degrees m of the complete monomials, 1 to 3 (default 2)");
    app.add_list("--gauss", options.gauss,
                 "Gauss points n_G along a radius, and 4 n_G in angle, of the weak forms (default 10)");
    app.add_list("--test-scaling", options.test_scaling, "scaling factors of the test function (default 1)");
    app.add_list("--penalty", options.penalty, "penalty parameters, in units of the paper's (default 1)");
    app.add_list("--poisson", options.poisson, "Poisson's ratios (default 0.33)");
    app.add_option("--plane", options.plane, "plane stress or strain (default " + options.plane + ")")
        .type_name("NAME");
    app.add_option(
           "--states", options.states,
           "displacements and stresses at places, instead of errors: particles, a grid such as 46x11, " +
               places)
        .type_name("PLACES");
    app.add_option("--points", options.points, "number of places on a line of --states (default 101)")
        .type_name("N")
        .within(2, 1000000);
    app.add_option("--field", options.field,
                   "file for displacements and stresses at the particles: .vtk for ParaView, else CSV")
        .type_name("FILE");
    app.add_flag("--seconds", options.seconds,
                 "add the seconds for assembly and solution, and the memory in MB");
    app.add_flag(
        "--quality", options.quality,
        "add two columns: R of the worst derivative at a particle, whose error is at most R h^p times a derivative of the displacement; and noise, the largest difference of an unknown from the field, over h and relative to the strains");
    app.add_threads(options.threads);
    app.add_output(options.output);
    add_plot_option(app, options.figure);
}

void check_apart_from_outputs(const ExampleOptions& options, const std::string& option,
                              const std::string& file) {
    check_apart({{option, file},
                 {"--output", options.output},
                 {"--field", options.field},
                 {"--plot", options.figure.path}});
}

void check_cloud(double particles, double neighbours) {
    // Two rows per particle, with two entries for each neighbour. Stored by rows, by columns, and in the
    // factors.
    const double entries = 4 * particles * std::min(neighbours, particles);
    base::require_memory_of_entries(base::shown(particles, 12) + " particles", entries,
                                    3 * entries * (sizeof(double) + sizeof(int)),
                                    "take fewer particles or a smaller --scaling");
}

namespace {

/// The methods by their names: "all" are those of the paper.
std::vector<std::string> method_names(const ExampleOptions& options) {
    if (options.methods == std::vector<std::string>{"all"}) return {"strong", "weak1", "weak2"};
    return chosen("method", options.methods, {"strong", "weak1", "weak2", "fpm"});
}

bool is_weak(const std::string& method) {
    return method.starts_with("weak");
}

/// \throws InvalidInput for an option that changes nothing
void check_effect(const ExampleOptions& options, const std::vector<std::string>& methods) {
    const auto refuse_without = [&](bool asked, const std::string& option, const std::string& whose) {
        if (options.given(option) && !asked)
            throw InvalidInput(option + " belongs to " + whose + " to --method, or leave " + option + " out");
    };
    const bool weak = std::any_of(methods.begin(), methods.end(), is_weak);
    const std::string weak_forms = "the weak forms; add weak1 or weak2";
    refuse_without(weak, "--gauss", weak_forms);
    refuse_without(weak, "--test-scaling", weak_forms);
    refuse_without(weak, "--penalty", weak_forms);
    const auto fpm = std::count(methods.begin(), methods.end(), "fpm");
    refuse_without(fpm > 0, "--smoothing", "fpm; add it");
    for (const char* option : {"--degree", "--scaling"})
        refuse_without(fpm < std::ssize(methods), option,
                       "methods with an SSPH basis; add strong, weak1 or weak2");
    const std::string& states = options.states;
    const bool on_a_line = !states.empty() && states != "particles" &&
                           std::isalpha(static_cast<unsigned char>(states.front())) != 0;
    if (options.given("--points") && !on_a_line)
        throw InvalidInput("--points belongs to a line of --states; name one, or leave --points out");
}

}  // namespace

std::vector<ExampleCase> cases(const ExampleOptions& options, double E,
                               const std::function<double(const elastostatics::Material&)>& penalty) {
    if (options.seconds && !options.states.empty())
        throw InvalidInput("--seconds stand beside errors; leave --states out");
    if (options.quality && !options.states.empty())
        throw InvalidInput("--quality stands beside errors; leave --states out");
    check_apart({{"--output", options.output}, {"--field", options.field}});
    check_apart({{"--plot", options.figure.path}, {"--field", options.field}});
    const std::vector<std::string> methods = method_names(options);
    check_effect(options, methods);
    const auto plane = elastostatics::plane_named(options.plane);
    const particles::Spacing smoothing_from = spacing_from(options.smoothing_from.value_or("nearest")),
                             smoothing_of_fpm_from = spacing_from(options.smoothing_of_fpm_from());
    if (smoothing_from.kind == particles::Spacing::given)
        check_apart_from_outputs(options, "--smoothing-from", named_file(*options.smoothing_from).path);
    double count = 1;
    for (const std::size_t choices :
         {methods.size(), options.poisson.size(), options.degree.size(), options.scaling.size(),
          options.test_scaling.size(), options.gauss.size(), options.penalty.size()})
        count *= static_cast<double>(choices);
    base::require_memory(
        base::shown(count) + " cases",
        count * (sizeof(ExampleCase) + sizeof(Cell) * static_cast<double>(case_columns().size())),
        "take shorter lists");
    for (const long gauss : options.gauss)
        if (gauss < 1 || gauss > 1000)
            throw InvalidInput("--gauss must lie between 1 and 1000, got " + std::to_string(gauss));
    for (const long degree : options.degree)
        if (degree < 1 || degree > 3)
            throw InvalidInput("--degree must be 1, 2 or 3, got " + std::to_string(degree));
    for (const double factor : options.penalty)
        if (!(factor > 0)) throw InvalidInput("--penalty must be positive, got " + base::shown(factor));
    if (!(std::isfinite(options.smoothing) && options.smoothing > 0))
        throw InvalidInput("--smoothing must be positive and finite, got " + base::shown(options.smoothing));

    std::vector<ExampleCase> all;
    for (const std::string& method : methods)
        for (const double nu : options.poisson) {
            const auto material = elastostatics::checked({E, nu, plane});
            if (method == "fpm") {
                all.push_back({method, {}, {options.smoothing, smoothing_of_fpm_from}, material});
                continue;
            }
            for (const long degree : options.degree)
                for (const double scaling : options.scaling)
                    for (const double test_scaling : options.test_scaling)
                        for (const long gauss : options.gauss)
                            for (const double factor : options.penalty) {
                                const bool first = test_scaling == options.test_scaling.front() &&
                                                   gauss == options.gauss.front() &&
                                                   factor == options.penalty.front();
                                if (!first && !is_weak(method)) continue;  // collocation takes none of them
                                all.push_back({method,
                                               {example_problems::method_named(method), scaling,
                                                static_cast<int>(degree), factor * penalty(material),
                                                test_scaling, gauss, smoothing_from},
                                               {},
                                               material});
                            }
        }
    return all;
}

std::vector<report::ColumnHead> case_columns() {
    return {{"method"}, {"particles"}, {"scaling"}, {"test_scaling"}, {"gauss"},
            {"degree"}, {"poisson"},   {"plane"},   {"penalty"}};
}

std::vector<Cell> case_cells(const ExampleCase& one) {
    const auto& how = one.ssph;
    const bool weak = is_weak(one.method), ssph = !one.is_fpm();
    return {one.method,
            Cell(),
            ssph ? Cell(how.scaling) : Cell(),
            weak ? Cell(how.test_scaling) : Cell(),
            weak ? Cell(static_cast<long>(how.gauss)) : Cell(),
            ssph ? Cell(static_cast<long>(how.degree)) : Cell(),
            one.material.nu,
            std::string(one.material.plane == elastostatics::Plane::stress ? "stress" : "strain"),
            weak ? Cell(how.penalty) : Cell()};
}

}  // namespace command_line
