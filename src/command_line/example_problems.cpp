#include "command_line/example_problems.hpp"
#include "base/text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

#include "base/memory.hpp"
#include "command_line/options.hpp"
#include "report/file.hpp"

namespace command_line {

using namespace batra2008;
using base::InvalidInput;
using report::Cell;

namespace {

/// Largest memory of this process since forget_peak(), in MB; zero where the system does not say.
double peak() {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
        if (double kilobytes = 0; word == "VmHWM:" && status >> kilobytes) return kilobytes / 1024;
    return 0;
}
void forget_peak() {
    std::ofstream("/proc/self/clear_refs") << "5";
}

}  // namespace

void add_options(CommandLine& app, ExampleOptions& options, const std::string& places) {
    app.column_width(34);
    app.add_option(
           "--method", options.methods,
           "which methods, separated by commas: all, or some of strong (collocation), weak1, weak2 (MLPG)")
        .separated_by_commas()
        .type_name("NAME[,NAME...]");
    app.add_option("--scaling", options.scaling,
                   "scaling factors rho of the SSPH basis' kernel (default " + options.scaling + ")")
        .type_name("LIST");
    app.add_option("--degree", options.degree, "degrees m of the complete monomials, 1 to 3 (default 2)")
        .type_name("LIST");
    app.add_option("--gauss", options.gauss,
                   "Gauss points n_G along a radius, and 4 n_G in angle, of the weak forms (default 10)")
        .type_name("LIST");
    app.add_option("--test-scaling", options.test_scaling, "scaling factors of the test function (default 1)")
        .type_name("LIST");
    app.add_option("--penalty", options.penalty, "penalty parameters, in units of the paper's (default 1)")
        .type_name("LIST");
    app.add_option("--poisson", options.poisson, "Poisson's ratios (default 0.33)").type_name("LIST");
    app.add_option("--plane", options.plane, "plane stress or strain (default " + options.plane + ")")
        .type_name("NAME");
    app.add_option("--states", options.states,
                   "instead of errors, write displacements and stresses at places: particles, a grid such as "
                   "46x10, " +
                       places)
        .type_name("PLACES");
    app.add_option("--points", options.points, "number of places on a line of --states (default 101)")
        .type_name("N")
        .within(2, 1000000);
    app.add_option("--field", options.field,
                   "write displacements and stresses at the particles too: .vtk for ParaView, else CSV")
        .type_name("FILE");
    app.add_flag("--seconds", options.seconds,
                 "add the seconds for assembly and solution, and the memory in MB");
    app.add_threads(options.threads);
    app.add_output(options.output);
}

void check_cloud(double particles, double neighbours) {
    // Two rows for each particle, two entries in each for a neighbour: by rows, by columns, and in factors that fill in.
    const double entries = 4 * particles * std::min(neighbours, particles);
    base::require_memory_of_entries(base::shown(particles, 12) + " particles", entries,
                                    3 * entries * (sizeof(double) + sizeof(int)),
                                    "take fewer particles or a smaller --scaling");
}

void check_states(double places) {
    const auto columns = static_cast<double>(case_columns().size() + state_columns({}).size());
    base::require_memory(base::shown(places, 12) + " places of --states", places * columns * sizeof(Cell),
                         "take fewer");
}

std::vector<ExampleCase> cases(const ExampleOptions& options, double E,
                               const std::function<double(const elastostatics::Material&)>& penalty) {
    using example_problems::Method;
    if (options.seconds && !options.states.empty())
        throw InvalidInput("--seconds stand beside errors; leave --states out");
    check_apart({{"--output", options.output}, {"--field", options.field}});
    std::vector<Method> methods;
    for (const std::string& name : chosen("method", options.methods, {"strong", "weak1", "weak2"}))
        methods.push_back(example_problems::method_named(name));
    auto count = static_cast<double>(methods.size());
    for (const auto& [option, list] : {std::pair("--poisson", options.poisson),
                                       {"--degree", options.degree},
                                       {"--scaling", options.scaling},
                                       {"--test-scaling", options.test_scaling},
                                       {"--gauss", options.gauss},
                                       {"--penalty", options.penalty}})
        if (!list.empty()) count *= static_cast<double>(numbers(option, list).size());
    base::require_memory(
        base::shown(count) + " cases",
        count * (sizeof(ExampleCase) + sizeof(Cell) * static_cast<double>(case_columns().size())),
        "take shorter lists");

    std::vector<ExampleCase> all;
    for (const Method method : methods)
        for (const double nu : numbers("--poisson", options.poisson))
            for (const long degree : whole_numbers("--degree", options.degree))
                for (const double scaling : numbers("--scaling", options.scaling))
                    for (const double test_scaling : numbers("--test-scaling", options.test_scaling))
                        for (const long gauss : whole_numbers("--gauss", options.gauss))
                            for (const double factor :
                                 numbers("--penalty", options.penalty.empty() ? "1" : options.penalty)) {
                                const auto material = elastostatics::checked(
                                    {E, nu, elastostatics::plane_named(options.plane)});
                                if (gauss < 1 || gauss > 1000)
                                    throw InvalidInput("--gauss must lie between 1 and 1000, got " +
                                                       std::to_string(gauss));
                                if (!(factor > 0)) throw InvalidInput("--penalty must be positive");
                                all.push_back({{method, scaling, static_cast<int>(degree),
                                                factor * penalty(material), test_scaling, gauss},
                                               material});
                            }
    return all;
}

std::vector<report::ColumnHead> case_columns() {
    return {{"method"}, {"particles"}, {"scaling"}, {"test_scaling"}, {"gauss"},
            {"degree"}, {"poisson"},   {"plane"},   {"penalty"}};
}

std::vector<Cell> case_cells(const ExampleCase& of) {
    const auto& [how, material] = of;
    const bool weak = how.method != example_problems::Method::strong;
    return {example_problems::name(how.method),
            Cell(),
            how.scaling,
            weak ? Cell(how.test_scaling) : Cell(),
            weak ? Cell(static_cast<long>(how.gauss)) : Cell(),
            static_cast<long>(how.degree),
            material.nu,
            std::string(material.plane == elastostatics::Plane::stress ? "stress" : "strain"),
            weak ? Cell(how.penalty) : Cell()};
}

example_problems::Solution solved(const Problem& problem, const Cloud<2>& cloud,
                                  const example_problems::Discretisation& how, Cost& cost) {
    elastostatics::check_inside(cloud, problem);
    forget_peak();
    const auto start = std::chrono::steady_clock::now();
    System system = example_problems::system(problem, cloud, how);
    const auto assembled = std::chrono::steady_clock::now();
    example_problems::Solution solution{how, problem.material, batra2008::solved(std::move(system))};
    const auto done = std::chrono::steady_clock::now();
    cost.assembly = std::chrono::duration<double>(assembled - start).count();
    cost.solution = std::chrono::duration<double>(done - assembled).count();
    cost.megabytes = peak();
    return solution;
}

void add_cost_columns(report::Table& table) {
    for (const char* name : {"seconds_assembly", "seconds_solution", "megabytes"})
        table.columns.push_back({name, {1e-2, 0}});
}

void add_cost(std::vector<Cell>& row, const Cost& cost) {
    row.insert(row.end(), {cost.assembly, cost.solution, cost.megabytes});
}

std::vector<report::ColumnHead> state_columns(const std::vector<ExampleCase>& cases) {
    constexpr report::Tolerance length{1e-6, 1e-10};
    report::Tolerance pressure{1e-6, 10};
    for (const ExampleCase& of : cases)
        pressure.absolute = std::max(pressure.absolute, 1e-12 * elastostatics::D(of.material)(0, 0));
    std::vector<report::ColumnHead> columns{{"x1"}, {"x2"}};
    for (const char* name : {"u1", "u2"}) columns.push_back({name, length});
    for (const char* name : {"s11", "s22", "s12"}) columns.push_back({name, pressure});
    for (const char* name : {"u1_exact", "u2_exact"}) columns.push_back({name, length});
    for (const char* name : {"s11_exact", "s22_exact", "s12_exact"}) columns.push_back({name, pressure});
    return columns;
}

void add_states(report::Table& table, const std::vector<Cell>& of, const Solved& solved,
                const std::vector<Point<2>>& places) {
    const Problem& problem = solved.problem;
    std::vector<example_problems::State> states(places.size());
    base::for_each_index(static_cast<Index>(places.size()), [&](Index k) {
        const auto at = static_cast<std::size_t>(k);
        states[at] = example_problems::state_at(solved.cloud, solved.solution, places[at]);
    });
    for (std::size_t k = 0; k < places.size(); ++k) {
        std::vector<Cell> row = of;
        const Vector u = problem.exact.u(places[k]);
        const Stress stress = problem.exact.stress(places[k]);
        for (const double number : places[k]) row.emplace_back(number);
        for (const double number : states[k].u) row.emplace_back(number);
        for (const double number : states[k].stress) row.emplace_back(number);
        for (const double number : u) row.emplace_back(number);
        for (const double number : stress) row.emplace_back(number);
        table.rows.push_back(std::move(row));
    }
}

FieldFile::FieldFile(std::string path, const std::vector<ExampleCase>& cases) : path_(std::move(path)) {
    report::check_writable(path_);
    table_.comments = {"displacements u [m] and stresses s [Pa] at the particles x [m], computed and exact"};
    table_.columns = case_columns();
    for (const auto& column : state_columns(cases)) table_.columns.push_back(column);
}

void FieldFile::add(const ExampleCase& of, const Solved& solved) {
    if (path_.empty()) return;
    const Points<2>& x = solved.cloud.x();
    if (table_.rows.empty()) x_ = x;
    if (x.cols() != x_.cols() || x != x_)
        throw InvalidInput("--field holds one set of particles; ask for one at a time");
    std::vector<Cell> cells = case_cells(of);
    cells[1] = static_cast<long>(x.cols());
    std::vector<Point<2>> places;
    for (Index I = 0; I < x.cols(); ++I) places.emplace_back(x.col(I));
    const std::size_t first = table_.rows.size();
    add_states(table_, cells, solved, places);

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
    // Another material has other exact states.
    const auto exact = [&](std::size_t row) {
        const std::vector<Cell>& cells_of = table_.rows[row];
        return std::vector<Cell>(cells_of.begin() + static_cast<Index>(table_.column("u1_exact")),
                                 cells_of.end());
    };
    bool another = first == 0;
    for (std::size_t k = 0; !another && k < places.size(); ++k)
        another = exact(first + k) != exact(first - places.size() + k);
    if (another) arrays(numbered("exact"), "_exact");
    arrays(numbered(example_problems::name(of.how.method)), "");
}

void FieldFile::write() const {
    if (path_.empty()) return;
    if (!path_.ends_with(".vtk")) {
        report::write_whole(path_, report::csv(table_));
        return;
    }
    const std::string count = std::to_string(x_.cols());
    std::string text = "# vtk DataFile Version 3.0\n" + table_.comments.front() +
                       "\nASCII\nDATASET POLYDATA\nPOINTS " + count + " double\n";
    for (Index I = 0; I < x_.cols(); ++I)
        text += base::shown(x_(0, I), 17) + " " + base::shown(x_(1, I), 17) + " 0\n";
    text += "VERTICES " + count + " " + std::to_string(2 * x_.cols()) + "\n";
    for (Index I = 0; I < x_.cols(); ++I) text += "1 " + std::to_string(I) + "\n";
    report::write_whole(path_, text + "POINT_DATA " + count + "\n" + vtk_);
}

}  // namespace command_line
