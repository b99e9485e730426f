#include "distributed/table.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <utility>

#include "base/text.hpp"
#include "command_line/body_judgement.hpp"
#include "command_line/body_table.hpp"
#include "command_line/positions.hpp"
#include "command_line/sweep.hpp"
#include "distributed/field_file.hpp"
#include "distributed/solution.hpp"
#include "distributed/terminal.hpp"

namespace distributed {

namespace {

using base::shown;
using bodies::Problem;
using bodies::State;
using command_line::Quantity;
using report::Cell;

/// The largest memory that this process has had. [bytes]
double memory() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) * 1024;
    return 0;
}

template <int dim, int n>
class TableOfBody {
  public:
    TableOfBody(const Petsc& petsc, const Processes& processes, const Options& options, Whole<dim>& whole)
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
        if (!fields_.empty()) write_field(processes_, options_.field, drawn_, fields_);
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
        const Progress progress{
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
                                     const Progress& progress) {
        std::vector<Quantity<dim>> all;
        for (const double lambda : eigenvalues(processes_, part, problem, Index{options_.modes}, progress))
            all.push_back({"eigenvalue" + std::to_string(all.size() + 1), {}, lambda});
        return all;
    }

    std::vector<Quantity<dim>> solved(const Problem<dim, n>& problem, const Part<dim>& part,
                                      const Progress& progress) {
        const std::string method = bodies::name(part.how.method);
        const auto solution = distributed::solve(processes_, part, problem, progress);
        terminal_.show(method + ": what the solution says");
        bodies::Sums<n> sums{std::vector<bodies::Forces<n>>(problem.given.size())};
        std::vector<State<dim, n>> at_own;
        const Body<dim> own{part.body.x(Eigen::all, part.own), {}};
        processes_.together([&] {
            if (!solution.part) return;
            at_own = command_line::states(problem, *solution.part, own.x);
            sums = bodies::sums(problem, part.body, *solution.part, rule_in(part), part.extent.spacing(),
                                part.own);
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
    void add_costs(std::vector<Quantity<dim>>& all, const Solved<dim, n>& solution) const {
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
                                         const Solved<dim, n>& solution) {
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
                                        const Solved<dim, n>& solution) {
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

    void add_fields(const Part<dim>& part, const Solved<dim, n>& solution,
                    const std::vector<State<dim, n>>& at_own) {
        bodies::Column<double> R(static_cast<Index>(part.own.size()));
        for (Index k = 0; k < R.size(); ++k) R[k] = solution.part->R[part.own[static_cast<std::size_t>(k)]];
        const Numbering numbering(processes_, part, n);
        const Drawn<dim> drawn(part);
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

    const Petsc& petsc_;
    const Processes& processes_;
    const Options& options_;
    Whole<dim>& whole_;
    Terminal terminal_;
    batra2008::elastostatics::Material material_;
    std::vector<Point<dim>> places_;
    particles::Spacing spacing_ = particles::Spacing::local;
    std::string suffix_;  // of the names of fields
    std::vector<std::string> sides_, remarks_;
    std::vector<bodies::NamedField> fields_;
    Body<dim> drawn_;
};

}  // namespace

template <int dim>
report::Table table(const Petsc& petsc, const Processes& processes, const Options& options, Whole<dim> whole,
                    const std::vector<std::string>& notes) {
    command_line::check(options.problem, dim);
    if (command_line::is_scalar(options.problem))
        return TableOfBody<dim, 1>(petsc, processes, options, whole).table(notes);
    return TableOfBody<dim, dim>(petsc, processes, options, whole).table(notes);
}

template report::Table table(const Petsc&, const Processes&, const Options&, Whole<2>,
                             const std::vector<std::string>&);
template report::Table table(const Petsc&, const Processes&, const Options&, Whole<3>,
                             const std::vector<std::string>&);

}  // namespace distributed
