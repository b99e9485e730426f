#include "command_line/example_problems.hpp"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cmath>
#include <fstream>
#include <utility>

#include "base/memory.hpp"
#include "base/text.hpp"
#include "command_line/lists.hpp"
#include "command_line/options.hpp"
#include "command_line/positions.hpp"
#include "report/file.hpp"

namespace command_line {

using namespace batra2008;
using base::InvalidInput;
using report::Cell;
namespace plate_and_hole = fpm_in_space::plate_and_hole;

namespace {

/// Largest memory of this process since reset_peak(), in MB; zero where the system does not say.
double peak() {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
        if (double kilobytes = 0; word == "VmHWM:" && status >> kilobytes) return kilobytes / 1024;
    return 0;
}
void reset_peak() {
    std::ofstream("/proc/self/clear_refs") << "5";
}

/// What is told of a solution beside its errors.
struct About {
    double assembly = 0, solution = 0;  ///< [s]
    double megabytes = 0;               ///< largest memory meanwhile
    particles::WorstRow worst;          ///< of the derivatives at the particles
};

/// The solution of a problem, timed.
/// \param assembled makes the equations \param solved solves them
template <class Assembled, class Solved>
auto timed(const Assembled& assembled, const Solved& solved, About& about) {
    using Clock = std::chrono::steady_clock;
    using Seconds = std::chrono::duration<double>;
    reset_peak();
    const auto start = Clock::now();
    auto equations = assembled();
    const auto middle = Clock::now();
    auto solution = solved(std::move(equations));
    about.assembly = Seconds(middle - start).count();
    about.solution = Seconds(Clock::now() - middle).count();
    about.megabytes = peak();
    return solution;
}

/// What is asked of a solution, as a function of the place.
template <class AnySolution, class At>
auto of_place(const Cloud<2>& cloud, const AnySolution& solution, const At& at) {
    return [&cloud, solution, at](const Point<2>& x) { return at(cloud, solution, x); };
}

/// By the methods of the paper.
Solution solved_by_ssph(const Problem& problem, const Cloud<2>& cloud,
                        const example_problems::Discretisation& how, About& about) {
    const auto solution = timed(
        [&] {
            System system = example_problems::system(problem, cloud, how);
            about.worst = system.worst;
            return system;
        },
        [&](System system) {
            return example_problems::Solution{how, problem.material,
                                              example_problems::smoothing_lengths(cloud, how),
                                              batra2008::solved(std::move(system))};
        },
        about);
    return {of_place(cloud, solution, example_problems::displacement_at),
            of_place(cloud, solution, example_problems::state_at), example_problems::noise(cloud, solution)};
}

/// By the second-order FPM.
Solution solved_by_fpm(const Problem& problem, const Cloud<2>& cloud,
                       const plate_and_hole::Discretisation& how, About& about) {
    const auto solution = timed(
        [&] {
            auto equations = plate_and_hole::collocated(problem, cloud, how);
            about.worst = equations.system.worst;
            return equations;
        },
        [&](plate_and_hole::Collocated equations) {
            return plate_and_hole::solved(std::move(equations), problem.material);
        },
        about);
    return {of_place(cloud, solution, plate_and_hole::displacement_at),
            of_place(cloud, solution, plate_and_hole::state_at),
            {}};
}

using Rows = std::vector<std::vector<Cell>>;

/// A row for each place: the cells that name the case, then displacements and stresses, computed and exact.
Rows state_rows(const std::vector<Cell>& named, const Solved& solved, const std::vector<Point<2>>& places) {
    const Problem& problem = solved.problem;
    std::vector<example_problems::State> states(places.size());
    base::for_each_index(static_cast<Index>(places.size()), [&](Index k) {
        const auto at = static_cast<std::size_t>(k);
        states[at] = solved.solution.state(places[at]);
    });
    Rows rows;
    for (std::size_t k = 0; k < places.size(); ++k) {
        std::vector<Cell> row = named;
        const Vector u = problem.exact.u(places[k]);
        const Stress stress = problem.exact.stress(places[k]);
        for (const double number : places[k]) row.emplace_back(number);
        for (const double number : states[k].u) row.emplace_back(number);
        for (const double number : states[k].stress) row.emplace_back(number);
        for (const double number : u) row.emplace_back(number);
        for (const double number : stress) row.emplace_back(number);
        rows.push_back(std::move(row));
    }
    return rows;
}

}  // namespace

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
        "add two columns: R of the worst derivative at a particle, which errs by at most R h^p times a derivative of the displacement; and noise, how much of the unknowns the field does not show, in strains");
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
    const std::vector<std::string> of_paper{"strong", "weak1", "weak2"};
    if (options.methods == std::vector<std::string>{"all"}) return of_paper;
    return chosen("method", options.methods, {"strong", "weak1", "weak2", "fpm"});
}

std::string fpm_smoothing_from_of(const ExampleOptions& options) {
    return options.smoothing_from.value_or(options.fpm_smoothing_from);
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
    const bool on_a_line =
        !states.empty() && states != "particles" && std::isalpha(static_cast<unsigned char>(states.front()));
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
                             fpm_smoothing_from = spacing_from(fpm_smoothing_from_of(options));
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
            throw InvalidInput("monomials of degree 1, 2 or 3 are known, not " + std::to_string(degree));
    for (const double factor : options.penalty)
        if (!(factor > 0)) throw InvalidInput("--penalty must be positive");
    if (!(std::isfinite(options.smoothing) && options.smoothing > 0))
        throw InvalidInput("--smoothing must be positive and finite, got " + base::shown(options.smoothing));

    std::vector<ExampleCase> all;
    for (const std::string& method : methods)
        for (const double nu : options.poisson) {
            const auto material = elastostatics::checked({E, nu, plane});
            if (method == "fpm") {
                all.push_back({method, {}, {options.smoothing, fpm_smoothing_from}, material});
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

std::vector<report::ColumnHead> state_columns(const std::vector<ExampleCase>& cases) {
    constexpr report::Tolerance length{1e-6, 1e-10};
    report::Tolerance pressure{1e-6, 10};
    for (const ExampleCase& one : cases)
        pressure.absolute = std::max(pressure.absolute, 1e-12 * elastostatics::D(one.material)(0, 0));
    std::vector<report::ColumnHead> columns{{"x1"}, {"x2"}};
    for (const char* name : {"u1", "u2"}) columns.push_back({name, length});
    for (const char* name : {"s11", "s22", "s12"}) columns.push_back({name, pressure});
    for (const char* name : {"u1_exact", "u2_exact"}) columns.push_back({name, length});
    for (const char* name : {"s11_exact", "s22_exact", "s12_exact"}) columns.push_back({name, pressure});
    return columns;
}

std::vector<Point<2>> places_at(const Points<2>& x) {
    std::vector<Point<2>> places;
    for (Index I = 0; I < x.cols(); ++I) places.emplace_back(x.col(I));
    return places;
}

std::vector<Point<2>> places_between(const Point<2>& from, const Point<2>& to, long count) {
    std::vector<Point<2>> places;
    for (long k = 0; k < count; ++k)
        places.emplace_back(from + (to - from) * static_cast<double>(k) / static_cast<double>(count - 1));
    return places;
}

std::array<long, 2> grid_of_places(const std::string& states) {
    const std::array<long, 2> counts = pair_of("--states", states);
    const double places = static_cast<double>(counts[0]) * static_cast<double>(counts[1]);
    const auto columns = static_cast<double>(case_columns().size() + state_columns({}).size());
    base::require_memory(base::shown(places, 12) + " places of --states", places * columns * sizeof(Cell),
                         "take fewer");
    return counts;
}

FieldFile::FieldFile(std::string path, const std::vector<ExampleCase>& cases) : path_(std::move(path)) {
    report::check_writable(path_);
    table_.comments = {"displacements u [m] and stresses s [Pa] at the particles x [m], computed and exact"};
    table_.columns = case_columns();
    for (const auto& column : state_columns(cases)) table_.columns.push_back(column);
}

void FieldFile::require_same(const Points<2>& x) {
    if (path_.empty()) return;
    if (x_.cols() == 0) x_ = x;
    if (x.cols() != x_.cols() || x != x_)
        throw InvalidInput("--field holds one set of particles; ask for one at a time");
}

void FieldFile::add(const ExampleCase& one, const Solved& solved) {
    if (path_.empty()) return;
    std::vector<Cell> cells = case_cells(one);
    cells[1] = static_cast<long>(x_.cols());
    const std::vector<Point<2>> places = places_at(x_);
    const std::size_t first = table_.rows.size();
    const Rows rows = state_rows(cells, solved, places);
    table_.rows.insert(table_.rows.end(), rows.begin(), rows.end());

    const auto array = [&](const std::string& name, const std::string& kind,
                           const std::vector<const char*>& from, std::size_t zeros) {
        vtk_ += kind == "SCALARS" ? "SCALARS " + name + " double 1\nLOOKUP_TABLE default\n"
                                  : kind + " " + name + " double\n";
        for (std::size_t row = first; row < table_.rows.size(); ++row) {
            for (const char* column : from)
                vtk_ += base::shown(std::get<double>(table_.rows[row][table_.column(column)]), 10) + " ";
            for (std::size_t k = 0; k < zeros; ++k) vtk_ += "0 ";
            vtk_.back() = '\n';
        }
    };
    const auto arrays = [&](const std::string& name, const std::string& suffix) {
        const std::string u1 = "u1" + suffix, u2 = "u2" + suffix;
        array("u_" + name, "VECTORS", {u1.c_str(), u2.c_str()}, 1);
        for (const char* component : {"s11", "s22", "s12"}) {
            const std::string column = component + suffix;
            array(std::string(component) + "_" + name, "SCALARS", {column.c_str()}, 0);
        }
    };
    const auto numbered = [&](const std::string& name) {
        const bool taken = vtk_.find("u_" + name + " ") != std::string::npos;
        return taken ? name + "_" + std::to_string(first / places.size()) : name;
    };
    // The exact states are written again where the material is another one.
    const auto exact = [&](std::size_t row) {
        const std::vector<Cell>& cells_of = table_.rows[row];
        return std::vector<Cell>(cells_of.begin() + static_cast<Index>(table_.column("u1_exact")),
                                 cells_of.end());
    };
    bool another = first == 0;
    for (std::size_t k = 0; !another && k < places.size(); ++k)
        another = exact(first + k) != exact(first - places.size() + k);
    if (another) arrays(numbered("exact"), "_exact");
    arrays(numbered(one.method), "");
}

void FieldFile::write() const {
    if (path_.empty()) return;
    if (!path_.ends_with(".vtk")) {
        report::write_whole(path_, report::csv(table_));
        return;
    }
    const std::string count = std::to_string(x_.cols());
    std::string text = "# vtk DataFile Version 3.0\n" + table_.comments.front() +
                       "\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS " + count + " double\n";
    for (Index I = 0; I < x_.cols(); ++I)
        text += base::shown(x_(0, I), 17) + " " + base::shown(x_(1, I), 17) + " 0\n";
    text += "CELLS " + count + " " + std::to_string(2 * x_.cols()) + "\n";  // a vertex for each particle
    for (Index I = 0; I < x_.cols(); ++I) text += "1 " + std::to_string(I) + "\n";
    text += "CELL_TYPES " + count + "\n";
    for (Index I = 0; I < x_.cols(); ++I) text += "1\n";
    report::write_whole(path_, text + "POINT_DATA " + count + "\n" + vtk_);
}

ExampleTable::ExampleTable(const ExampleOptions& options, const std::vector<ExampleCase>& cases,
                           const std::string& about, const std::vector<report::ColumnHead>& layout,
                           const std::vector<report::ColumnHead>& errors)
    : options_(options), field_(options.field, cases), sweep_(table_, case_columns().size() + layout.size()) {
    table_.comments = {
        about,
        "strong (3.12) to (3.14), weak1 (3.22) with (3.21), weak2 (3.22) with (3.26); log_error: log10 of (4.4), dn the difference of the norms, nd the norm of the difference"};
    if (std::any_of(cases.begin(), cases.end(), [](const ExampleCase& one) { return one.is_fpm(); }))
        table_.comments.push_back("fpm: (3.12) to (3.14) with (F24), h/" + fpm_smoothing_from_of(options) +
                                  " spacing " + base::shown(options.smoothing) + ", support of " +
                                  base::shown(plate_and_hole::cut) + " h; between particles (F25)");
    if (options.smoothing_from.value_or("nearest") != "nearest")
        table_.comments.push_back("smoothing lengths from " + *options.smoothing_from);
    table_.columns = case_columns();
    for (const auto& column : layout) table_.columns.push_back(column);
    for (const auto& column : options.states.empty() ? errors : state_columns(cases))
        table_.columns.push_back(column);
    if (options.seconds)
        for (const char* name : {"seconds_assembly", "seconds_solution", "megabytes"})
            table_.columns.push_back({name, {1e-2, 0}});
    if (options.quality)
        for (const char* name : {"quality", "noise"}) table_.columns.push_back({name, {1e-4, 1e-6}});
}

void ExampleTable::add(const ExampleCase& one, const Problem& problem, const Cloud<2>& cloud,
                       const std::vector<Cell>& layout, const Places& places, const Errors& errors) {
    field_.require_same(cloud.x());
    std::vector<Cell> named = case_cells(one);
    named[1] = static_cast<long>(cloud.size());
    named.insert(named.end(), layout.begin(), layout.end());
    std::vector<Point<2>> at;
    if (!options_.states.empty()) at = options_.states == "particles" ? places_at(cloud.x()) : places();
    sweep_.attempt(named, [&] {
        check_lengths(one.is_fpm() ? one.fpm.smoothing_from : one.ssph.smoothing_from,
                      options_.smoothing_from.value_or(""), cloud.size());
        About about;
        const Solution solution = one.is_fpm() ? solved_by_fpm(problem, cloud, one.fpm, about)
                                               : solved_by_ssph(problem, cloud, one.ssph, about);
        const Solved found{problem, cloud, solution};
        if (solution.noise) warn_of(*solution.noise, named);
        note_quality(about.worst, named, cloud);
        Rows rows{named};
        if (!options_.states.empty()) {
            rows = state_rows(named, found, at);
        } else {
            for (const Cell& cell : errors(found)) rows[0].push_back(cell);
            if (options_.seconds)
                rows[0].insert(rows[0].end(), {about.assembly, about.solution, about.megabytes});
            if (options_.quality)
                rows[0].insert(rows[0].end(),
                               {about.worst.R, solution.noise ? Cell(*solution.noise) : Cell()});
        }
        field_.add(one, found);
        return rows;
    });
}

std::string ExampleTable::in_words(const std::vector<Cell>& named) const {
    const report::Table one{{}, table_.columns, {named}};
    std::string words = one.word(0, "method") + ", " + one.word(0, "particles") + " particles";
    if (const std::string scaling = one.word(0, "scaling"); !scaling.empty()) words += ", scaling " + scaling;
    std::vector<std::string> others{"poisson"};
    for (std::size_t k = case_columns().size(); k < named.size(); ++k)
        others.push_back(table_.columns[k].name);
    for (const std::string& name : options_.quality ? others : std::vector<std::string>{})
        if (const std::string word = one.word(0, name); !word.empty()) words += ", " + name + " " + word;
    return words;
}

void ExampleTable::warn_of(double noise, const std::vector<Cell>& named) {
    if (!(noise > example_problems::most_noise)) return;
    ++noisy_;
    if (noise <= most_noise_) return;
    most_noise_ = noise;
    noisiest_ = in_words(named);
}

void ExampleTable::note_quality(const particles::WorstRow& row, const std::vector<Cell>& named,
                                const Cloud<2>& cloud) {
    if (row.R <= largest_R_) return;
    largest_R_ = row.R;
    constexpr std::array derivatives{"value", "first derivative", "second derivative"};
    worst_row_ = base::shown(row.R, 3) + ", " + in_words(named) + ", " +
                 derivatives[static_cast<std::size_t>(row.derivative)] + " at particle " +
                 std::to_string(row.particle) +
                 " (x = " + particles::shown_point(cloud.x().col(row.particle)) + ")";
}

report::Table ExampleTable::finished() {
    sweep_.finish();
    if (options_.quality)
        table_.comments.push_back(
            "quality: R of the worst derivative at a particle of a case, the factor in the bound of its error in powers of h; the largest is " +
            worst_row_);
    if (noisy_ > 0)
        table_.comments.push_back(
            "noise: the unknowns alternate between neighbours, and stresses may be wrong, in " +
            std::to_string(noisy_) + (noisy_ == 1 ? " case: " : " cases, most of all in: ") + noisiest_ +
            " (noise " + base::shown(most_noise_, 3) + ", where " +
            base::shown(example_problems::most_noise) + " is the most)");
    field_.write();
    return std::move(table_);
}

}  // namespace command_line
