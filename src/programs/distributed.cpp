#include <omp.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/number.hpp"
#include "base/text.hpp"
#include "command_line/body_judgement.hpp"
#include "command_line/body_options.hpp"
#include "command_line/body_table.hpp"
#include "command_line/options.hpp"
#include "command_line/positions.hpp"
#include "command_line/sweep.hpp"
#include "distributed/field_file.hpp"
#include "distributed/grid.hpp"
#include "distributed/solution.hpp"
#include "distributed/whole.hpp"
#include "meshes/gmsh.hpp"
#include "report/file.hpp"

namespace {

using base::InvalidInput;
using base::shown;
using bodies::Body;
using bodies::Discretisation;
using bodies::Index;
using bodies::Point;
using bodies::Problem;
using bodies::State;
using command_line::BodyOptions;
using command_line::Quantity;
using distributed::Grid;
using distributed::Part;
using distributed::Processes;
using report::Cell;

struct Options : BodyOptions {
    std::string grid, lengths;
};

/// While it lives, what other processes than the first write goes nowhere.
class FirstSpeaks : std::streambuf {
  public:
    explicit FirstSpeaks(const Processes& processes) {
        if (processes.is_first()) return;
        output_ = std::cout.rdbuf(this);
        errors_ = std::cerr.rdbuf(this);
    }
    FirstSpeaks(const FirstSpeaks&) = delete;
    FirstSpeaks& operator=(const FirstSpeaks&) = delete;
    ~FirstSpeaks() override {
        if (output_ != nullptr) std::cout.rdbuf(output_);
        if (errors_ != nullptr) std::cerr.rdbuf(errors_);
    }

  private:
    int overflow(int letter) override { return letter == EOF ? 0 : letter; }

    std::streambuf *output_ = nullptr, *errors_ = nullptr;
};

/// The text on a terminal that says how far the work is; the first process writes it.
class Terminal {
  public:
    explicit Terminal(bool writes) : writes_(writes && isatty(STDERR_FILENO) != 0) {}
    Terminal(const Terminal&) = delete;
    Terminal& operator=(const Terminal&) = delete;
    ~Terminal() { show(""); }
    void show(const std::string& text) const {
        if (writes_) std::cerr << "\r\033[K" << text << std::flush;
    }

  private:
    bool writes_;
};

/// The largest memory that this process has had. [bytes]
double memory() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) * 1024;
    return 0;
}

template <int dim, int n>
class DistributedTable {
  public:
    DistributedTable(const distributed::Petsc& petsc, const Processes& processes, const Options& options,
                     distributed::Whole<dim>& whole)
        : petsc_(petsc),
          processes_(processes),
          options_(options),
          whole_(whole),
          terminal_(processes.is_first()),
          material_(n == 1 ? batra2008::elastostatics::Material{1, 0}
                           : command_line::material(options.problem)) {
        processes_.together([&] {
            places_ = command_line::places<dim>(options_);
            if (const auto body = whole_.small()) command_line::require_inside(*body, places_);
            spacing_ = command_line::spacing_from(options_.smoothing_from);
            command_line::check_lengths(spacing_, options_.smoothing_from, whole_.particles());
            if (const auto body = whole_.small()) {
                const auto problem = command_line::problem<dim, n>(options_.problem, *body);
                bodies::require_corners(problem, *body);
                bodies::require_held(problem, *body, bodies::conditions(problem, *body));
            }
        });
    }

    /// The rows of all methods; of one that failed, a row that says why.
    report::Table table(const std::vector<std::string>& notes) {
        report::Table table{{}, command_line::columns<dim>(), {}};
        command_line::Sweep sweep(table, 1);
        for (const std::string& method : options_.methods) {
            suffix_ = options_.methods.size() > 1 ? "_" + method : "";
            Discretisation how = command_line::discretisation(options_, method, dim);
            how.spacing = spacing_;
            sweep.attempt({method, static_cast<long>(whole_.particles())}, [&] {
                std::vector<std::vector<Cell>> rows;
                for (const auto& quantity : quantities(how))
                    rows.push_back(command_line::row(method, whole_.particles(), quantity));
                return rows;
            });
        }
        sweep.finish();
        if (table.incomplete.empty()) petsc_.require_used();
        if (!fields_.empty()) distributed::write_field(processes_, options_.field, drawn_, fields_);
        table.comments = comments();
        table.comments.insert(table.comments.end(), notes.begin(), notes.end());
        table.comments.insert(table.comments.end(), remarks_.begin(), remarks_.end());
        return table;
    }

  private:
    std::vector<Quantity<dim>> quantities(const Discretisation& how) {
        const std::string method = bodies::name(how.method);
        terminal_.show(method + ": parts of the body");
        const Part<dim> part = whole_.part(how, places_);
        Problem<dim, n> problem;
        processes_.together([&] { problem = command_line::problem<dim, n>(options_.problem, part.body); });
        sides_ = about_sides(problem, part);
        const distributed::Progress progress{
            [&](double share) {
                terminal_.show(method + ": " + shown(std::floor(100 * share)) + " % of the equations");
            },
            [&](int iterations, double residual) {
                terminal_.show(method + ": iteration " + std::to_string(iterations) + ", residual " +
                               shown(residual, 2));
            }};
        try {
            return options_.modes > 0 ? modes(problem, part, progress) : solved(problem, part, progress);
        } catch (const base::FailedComputation&) {
            processes_.together([&] { whole_.require_quality(problem); });
            throw;
        }
    }

    std::vector<std::string> about_sides(const Problem<dim, n>& problem, const Part<dim>& part) const {
        std::vector<Index> counts;
        for (const auto& side : part.body.sides) {
            const auto own = std::count_if(side.places.begin(), side.places.end(), [&](const auto& place) {
                return std::binary_search(part.own.begin(), part.own.end(), place.particle);
            });
            counts.push_back(static_cast<Index>(processes_.sum(static_cast<double>(own))));
        }
        return command_line::about_sides(problem, part.body, counts);
    }

    std::vector<Quantity<dim>> modes(const Problem<dim, n>& problem, const Part<dim>& part,
                                     const distributed::Progress& progress) {
        std::vector<Quantity<dim>> all;
        for (const double lambda :
             distributed::eigenvalues(processes_, part, problem, Index{options_.modes}, progress))
            all.push_back({"eigenvalue" + std::to_string(all.size() + 1), {}, lambda});
        return all;
    }

    std::vector<Quantity<dim>> solved(const Problem<dim, n>& problem, const Part<dim>& part,
                                      const distributed::Progress& progress) {
        const std::string method = bodies::name(part.how.method);
        const auto solution = distributed::solve(processes_, part, problem, progress);
        terminal_.show(method + ": what the solution says");
        bodies::Sums<n> sums{std::vector<bodies::Forces<n>>(problem.given.size())};
        std::vector<State<dim, n>> at_own;
        const Body<dim> own{part.body.x(Eigen::all, part.own), {}};
        processes_.together([&] {
            if (!solution.part) return;
            at_own = command_line::states(problem, *solution.part, own.x);
            sums = bodies::sums(problem, part.body, *solution.part, distributed::rule_in(part),
                                part.extent.spacing(), part.own);
        });
        processes_.combine(sums);
        const auto judged = bodies::judgement(problem, sums, part.extent);

        std::vector<Quantity<dim>> all = at_places(problem, part, solution);
        for (Quantity<dim>& most : extremes(problem, own, at_own, solution)) all.push_back(std::move(most));
        all.push_back({"quality", solution.worst, solution.quality, false});
        for (const auto& quantity : command_line::quantities<dim>(judged)) all.push_back(quantity);
        if (options_.seconds) add_costs(all, solution);

        command_line::Particles<dim> particles{solution.quality, solution.worst};
        const std::vector<Point<dim>> across = whole_.across_gaps();
        particles.across = static_cast<Index>(across.size());
        if (!across.empty()) particles.one = across.front();
        const std::string finer = !options_.grid.empty() ? "more particles, or body with --method hats"
                                  : options_.size        ? "a smaller --size, or body with --method hats"
                                                         : "a finer mesh, or body with --method hats";
        remarks_.push_back(method + ": " + solution.report.method);
        for (const auto& note : command_line::about_round_off(part.how, judged)) remarks_.push_back(note);
        for (const auto& remark :
             command_line::remarks(part.how, judged, particles, static_cast<int>(part.how.degree), finer))
            remarks_.push_back(remark);
        if (!options_.field.empty()) add_fields(part, solution, at_own);
        return all;
    }

    /// Seconds of the slowest process, and the memory of all.
    void add_costs(std::vector<Quantity<dim>>& all, const distributed::Solved<dim, n>& solution) const {
        const auto& [by, iterations, preparation, iteration] = solution.report;
        const auto add = [&](const std::string& name, double number) {
            all.push_back({name, {}, number, false});
        };
        add("seconds", processes_.largest(solution.assembly + preparation + iteration));
        add("seconds_equations", processes_.largest(solution.assembly));
        add("seconds_preconditioner", processes_.largest(preparation));
        add("seconds_iterations", processes_.largest(iteration));
        add("iterations", iterations);
        const double bytes = memory();
        add("memory", processes_.sum(bytes));
        add("memory_of_largest", processes_.largest(bytes));
    }

    /// All numbers at the places; of each, by the process that has the nearest particle.
    std::vector<Quantity<dim>> at_places(const Problem<dim, n>& problem, const Part<dim>& part,
                                         const distributed::Solved<dim, n>& solution) {
        std::vector<Quantity<dim>> all;
        for (const Point<dim>& x : places_) {
            double distance = std::numeric_limits<double>::infinity(), number = distance;
            if (solution.part) {
                const int nearest = solution.part->approximation.cloud().nearest(x);
                if (std::binary_search(part.own.begin(), part.own.end(), nearest)) {
                    distance = (part.body.x.col(nearest) - x).squaredNorm();
                    number = static_cast<double>(part.number[static_cast<std::size_t>(nearest)]);
                }
            }
            const bool is_nearest = distance == -processes_.largest(-distance);
            const int has =
                processes_.where_least(is_nearest ? number : std::numeric_limits<double>::infinity());
            State<dim, n> state{bodies::Values<n>::Zero(), {}, Eigen::Matrix<double, n, dim>::Zero()};
            processes_.together([&] {
                if (processes_.rank() != has) return;
                particles::Points<dim> place(dim, 1);
                place.col(0) = x;
                state = command_line::states(problem, *solution.part, place).front();
            });
            for (const auto& [name, value] : command_line::named(state, material_))
                all.push_back({name, x, processes_.from(has, value)});
        }
        return all;
    }

    /// The largest of the largest numbers of all processes, and of the smallest the smallest.
    std::vector<Quantity<dim>> extremes(const Problem<dim, n>& problem, const Body<dim>& own,
                                        const std::vector<State<dim, n>>& at_own,
                                        const distributed::Solved<dim, n>& solution) {
        std::vector<Quantity<dim>> all;
        if (solution.part)
            all = command_line::extremes(
                command_line::SolvedBody<dim, n>{problem, own, *solution.part, material_, at_own});
        std::vector<std::string> names{"max_displacement", "max_von_mises"};
        if (n == 1) names = {"max_u", "min_u"};
        all.resize(names.size());
        for (std::size_t k = 0; k < names.size(); ++k) {
            const double sign = names[k] == "min_u" ? -1 : 1;
            const int has = processes_.where_largest(
                solution.part ? sign * all[k].value : -std::numeric_limits<double>::infinity());
            all[k].name = names[k];
            all[k].value = processes_.from(has, all[k].value);
            Point<dim> place = all[k].place.value_or(Point<dim>::Zero());
            for (double& coordinate : place) coordinate = processes_.from(has, coordinate);
            all[k].place = place;
        }
        return all;
    }

    void add_fields(const Part<dim>& part, const distributed::Solved<dim, n>& solution,
                    const std::vector<State<dim, n>>& at_own) {
        bodies::Column<double> R(static_cast<Index>(part.own.size()));
        for (Index k = 0; k < R.size(); ++k) R[k] = solution.part->R[part.own[static_cast<std::size_t>(k)]];
        const distributed::Numbering numbering(processes_, part, n);
        const distributed::Drawn<dim> drawn(part);
        for (auto& field : command_line::fields<dim, n>(at_own, R, material_, suffix_)) {
            field.values = numbering.at_all(field.values)(Eigen::all, drawn.particle).eval();
            fields_.push_back(std::move(field));
        }
        drawn_ = drawn.body;
    }

    [[nodiscard]] std::vector<std::string> comments() const {
        std::vector<std::string> all;
        if (options_.grid.empty())
            all.push_back(command_line::comment_on_body(options_));
        else
            all.push_back("grid of " + options_.grid + " particles, lengths " + options_.lengths +
                          "; lengths, forces and stresses in the user's units");
        for (const std::string& comment : command_line::comments(options_.problem, dim))
            all.push_back(comment);
        all.push_back(std::to_string(whole_.particles()) + " particles on " +
                      std::to_string(processes_.count()) +
                      (processes_.count() == 1 ? " process" : " processes"));
        all.insert(all.end(), sides_.begin(), sides_.end());
        const std::string numbers = command_line::about_numbers(n == 1, dim, options_.modes > 0);
        if (!numbers.empty()) all.push_back(numbers);
        return all;
    }

    const distributed::Petsc& petsc_;
    const Processes& processes_;
    const Options& options_;
    distributed::Whole<dim>& whole_;
    Terminal terminal_;
    batra2008::elastostatics::Material material_;
    std::vector<Point<dim>> places_;
    particles::Spacing spacing_ = particles::Spacing::local;
    std::string suffix_;  // of the names of fields
    std::vector<std::string> sides_, remarks_;
    std::vector<bodies::NamedField> fields_;
    Body<dim> drawn_;
};

template <int dim>
report::Table table_of(const distributed::Petsc& petsc, const Processes& processes, const Options& options,
                       distributed::Whole<dim> whole, const std::vector<std::string>& notes) {
    command_line::check(options.problem, dim);
    if (command_line::is_scalar(options.problem))
        return DistributedTable<dim, 1>(petsc, processes, options, whole).table(notes);
    return DistributedTable<dim, dim>(petsc, processes, options, whole).table(notes);
}

/// The numbers of a text such as 101x51.
std::vector<std::string> sizes(const std::string& option, const std::string& text,
                               const std::string& example) {
    const std::vector<std::string> all = command_line::parts(text, 'x');
    if (all.size() != 2 && all.size() != 3)
        throw InvalidInput(option + ": " + base::quoted(text) +
                           " is not a size along each of 2 or 3 axes; write " + option + " " + example);
    return all;
}

template <int dim>
Grid<dim> grid(const Options& options, const std::vector<std::string>& counts) {
    Grid<dim> found{};
    const std::vector<std::string> lengths = sizes("--lengths", options.lengths, dim == 2 ? "2x1" : "2x1x1");
    if (lengths.size() != dim)
        throw InvalidInput("--lengths " + options.lengths + " has " + std::to_string(lengths.size()) +
                           " lengths, and --grid " + options.grid + " " + std::to_string(dim) + " numbers");
    for (std::size_t axis = 0; axis < dim; ++axis) {
        found.count[axis] = command_line::whole_number("--grid", counts[axis]);
        found.length[static_cast<Index>(axis)] = command_line::number("--lengths", lengths[axis]);
    }
    command_line::of_option("--grid", [&] { return distributed::checked_size(found); });
    return found;
}

report::Table table_of(const distributed::Petsc& petsc, const Processes& processes, Options& options) {
    if (!options.grid.empty()) {
        const auto counts = sizes("--grid", options.grid, "101x51");
        if (options.lengths.empty()) options.lengths = counts.size() == 2 ? "1x1" : "1x1x1";
        if (counts.size() == 2)
            return table_of<2>(petsc, processes, options, {processes, grid<2>(options, counts)}, {});
        return table_of<3>(petsc, processes, options, {processes, grid<3>(options, counts)}, {});
    }
    meshes::Model model;
    processes.together([&] {
        if (processes.is_first()) model = meshes::read(options.mesh, options.size);
    });
    const bool in_plane = processes.from(0, static_cast<double>(model.body.index())) == 0;
    const auto read = [&]<int dim>() {
        auto* body = processes.is_first() ? &std::get<Body<dim>>(model.body) : nullptr;
        return distributed::Whole<dim>(processes,
                                       body ? std::make_unique<Body<dim>>(std::move(*body)) : nullptr);
    };
    if (in_plane) return table_of<2>(petsc, processes, options, read.operator()<2>(), model.notes);
    return table_of<3>(petsc, processes, options, read.operator()<3>(), model.notes);
}

/// Refuses options that need, exclude or overwrite one another; names the methods.
void check(Options& options, int processes) {
    if (options.mesh.empty() == options.grid.empty())
        throw InvalidInput(options.mesh.empty() ? "there is no body; give --mesh FILE, or --grid 101x51"
                                                : "--mesh and --grid are two bodies; leave one out");
    if (options.size && options.mesh.empty())
        throw InvalidInput("--size belongs to a drawing, --mesh; a grid has the particles of --grid");
    if (!options.lengths.empty() && options.grid.empty())
        throw InvalidInput("--lengths belongs to --grid; leave it out beside --mesh");
    const std::vector<std::string> known{"fpm", "strong"};
    if (options.methods.empty()) options.methods = {"fpm"};
    options.methods = command_line::chosen("method", options.methods, known);
    command_line::check_methods(options, known);
    if (!options.field.empty()) distributed::check_field_path(options.field);
    const std::string why = " shows a solution, and --modes asks for eigenvalues; leave one of them out";
    if (options.modes > 0 && !options.places.empty()) throw InvalidInput(options.places.front().option + why);
    if (options.modes > 0 && options.seconds) throw InvalidInput("--seconds" + why);
    if (options.modes > 0 && !options.field.empty()) throw InvalidInput("--field" + why);
    const auto check_apart = [&](const std::string& field) {
        command_line::check_apart(
            {{"--output", options.output}, {"--field", field}, {"--mesh", options.mesh}});
    };
    check_apart(options.field);
    for (int process = 0; process < processes && !options.field.empty(); ++process)
        check_apart(distributed::piece_of(options.field, process));
}

void add_options(command_line::CommandLine& app, Options& options) {
    app.column_width(34);
    app.add_option(
           "--grid", options.grid,
           "a rectangle or a box of so many particles along each axis, its sides named left, right, bottom, top, back, front")
        .type_name("NXxNY[xNZ]");
    app.add_option("--lengths", options.lengths, "with --grid: its lengths (default 1 along each axis)")
        .type_name("LXxLY[xLZ]");
    app.add_option(
           "--mesh", options.mesh,
           "instead, a drawing or a mesh that Gmsh reads, on the first process; its physical groups name the sides")
        .type_name("FILE");
    app.add_option("--size", options.size, "size of the cells of a drawing (default: that of the drawing)")
        .type_name("D");
    command_line::add_options(app, options.problem);
    command_line::add_collocation_options(app, options);
    app.add_repeated("--at", options.places, "a place where all quantities are wanted").type_name("X,Y[,Z]");
    app.add_repeated("--along", options.places, "N places on a line, its ends among them")
        .type_name("X0,Y0:X1,Y1:N");
    app.add_option("--modes", options.modes, "the K lowest eigenvalues instead; loads count as zero")
        .type_name("K")
        .within(1, 1000);
    app.add_flag("--seconds", options.seconds, "add seconds, iterations and bytes of memory");
    app.add_option("--field", options.field,
                   "file for the fields, .pvtu for ParaView, with a piece of each process beside it")
        .type_name("FILE");
    app.add_option("--threads", options.threads, "threads of each process (default 1)")
        .type_name("N")
        .within(1, 1024);
    app.add_output(options.output);
}

}  // namespace

int main(int argc, char** argv) {
    auto [own, of_petsc] = distributed::divided(argc, argv, {"--seconds"});
    const distributed::Petsc petsc(of_petsc);
    const Processes processes(PETSC_COMM_WORLD);
    const FirstSpeaks first_speaks(processes);
    command_line::CommandLine app(
        "A body on many processes, in the plane or in space, by collocation: the table of `body`, with the equations of PETSc and the eigenvalues of SLEPc. Each process has a part of the particles; one process has all.",
        "distributed",
        "PETSc's options have one dash: -ksp_rtol 1e-10, -ksp_monitor, -pc_type asm, -log_view.\n"
        "Example: mpirun -n 4 distributed --grid 1001x1001 --equation poisson --source 1 --value \"left: 0\" --at 0.5,0.5\n"
        "Another: mpirun -n 4 distributed --mesh strip.geo --size 1e-3 --young 210e9 --poisson 0.3 --symmetry middle --symmetry neck --traction \"end: 1e6, 0\" --field strip.pvtu");
    Options options;
    add_options(app, options);
    return command_line::run(app, static_cast<int>(own.size()), own.data(), [&] {
        check(options, processes.count());
        processes.together([&] {
            if (!processes.is_first()) return;
            report::check_writable(options.output);
            if (!options.field.empty()) report::check_writable(options.field);
        });
        // Each process has a core of its own.
        omp_set_num_threads(options.threads > 0 ? options.threads : 1);
        const report::Table table = table_of(petsc, processes, options);
        processes.together([&] {
            if (processes.is_first()) report::write_whole(options.output, report::csv(table));
        });
        if (!table.incomplete.empty()) throw base::FailedComputation(table.incomplete);
        return 0;
    });
}
