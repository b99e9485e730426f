#include <chrono>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/text.hpp"
#include "command_line/body_files.hpp"
#include "command_line/body_judgement.hpp"
#include "command_line/body_options.hpp"
#include "command_line/body_table.hpp"
#include "command_line/options.hpp"
#include "command_line/progress.hpp"
#include "command_line/sweep.hpp"
#include "meshes/gmsh.hpp"

namespace {

using base::shown;
using bodies::Body;
using bodies::Discretisation;
using bodies::Index;
using bodies::Point;
using bodies::Problem;
using command_line::BodyOptions;
using command_line::Quantity;
using report::Cell;

/// A cloud of `--refine` and the next one have particles at distances of this ratio.
constexpr double ratio = std::numbers::sqrt2;

/// The body that the options name. \param cloud how many clouds of `--refine` are coarser
meshes::Model model(const BodyOptions& options, long cloud) {
    if (!options.mesh.empty()) {
        std::optional<double> size = options.size;
        if (size) *size /= std::pow(ratio, cloud);
        return meshes::read(options.mesh, size);
    }
    const auto [body, moved, farthest] =
        command_line::read_body(options.points, options.boundary, options.snap);
    meshes::Model found{body, {}};
    if (moved > 0)
        found.notes.push_back(std::to_string(moved) + " particles were moved onto the boundary, by " +
                              shown(farthest, 3) + " at most");
    return found;
}

/// What a method says of a body on one cloud.
template <int dim>
struct Found {
    std::vector<Quantity<dim>> quantities;
    std::vector<std::string> comments;
};

/// A method on each cloud, up to that on which it fails.
template <int dim>
struct Results {
    Discretisation how;
    std::vector<Found<dim>> clouds{};
    std::optional<command_line::Failure> failure{};
};

/// The lowest eigenvalues.
template <int dim, int n>
Found<dim> modes(const BodyOptions& options, const Problem<dim, n>& problem, const Body<dim>& body,
                 const Discretisation& how) {
    Found<dim> found;
    const auto all = bodies::eigenvalues<dim, n>(problem, body, how, options.modes);
    for (std::size_t k = 0; k < all.size(); ++k)
        found.quantities.push_back({"eigenvalue" + std::to_string(k + 1), {}, all[k]});
    return found;
}

/// Order, extrapolated value and uncertainty from the last three clouds; empty for what has no limit.
template <int dim>
std::vector<Cell> limit(const std::vector<Found<dim>>& clouds, std::size_t quantity) {
    constexpr double formal = 2;  // of all methods
    const auto value = [&](std::size_t before_last) {
        return clouds[clouds.size() - 1 - before_last].quantities[quantity].value;
    };
    if (!clouds.back().quantities[quantity].has_limit) return {Cell(), Cell(), Cell()};
    const auto [order, extrapolated, uncertainty] =
        bodies::extrapolated(value(2), value(1), value(0), ratio, formal);
    const auto cell = [](double number) { return std::isfinite(number) ? Cell(number) : Cell(); };
    return {cell(order), cell(extrapolated), cell(uncertainty)};
}

template <int dim, int n>
class BodyTable {
  public:
    explicit BodyTable(BodyOptions& options)
        : options_(options),
          places_(command_line::places<dim>(options)),
          material_(n == 1 ? batra2008::elastostatics::Material{1, 0}
                           : command_line::material(options.problem)) {}

    /// Computes all methods on a cloud.
    void add(const Body<dim>& body, bool finest, command_line::Progress& progress) {
        command_line::require_inside(body, places_);
        const auto problem = command_line::problem<dim, n>(options_.problem, body);
        const auto methods = command_line::discretisations(options_, body);
        results_.resize(methods.size());
        particles_.push_back(body.x.cols());
        for (std::size_t k = 0; k < methods.size(); ++k) {
            Results<dim>& here = results_[k];
            here.how = methods[k];
            if (!here.failure)
                here.failure = command_line::failure_of([&] {
                    here.clouds.push_back(options_.modes > 0 ? modes(options_, problem, body, methods[k])
                                                             : solved(problem, body, methods[k], finest));
                });
            progress.step();
        }
        if (!finest) return;
        std::vector<Index> counts;
        for (const auto& side : body.sides) counts.push_back(static_cast<Index>(side.places.size()));
        sides_ = command_line::about_sides(problem, body, counts);
        if (!fields_.empty()) bodies::write_field(options_.field, body, fields_, comments(body));
        comments_ = comments(body);
    }

    /// The rows of all methods; of one that failed, a row that says why.
    /// \throws base::InvalidInput or base::FailedComputation where all failed
    [[nodiscard]] report::Table table(const std::vector<std::string>& notes) const {
        report::Table table{comments_, command_line::columns<dim>(), {}};
        table.comments.insert(table.comments.end(), notes.begin(), notes.end());
        const bool refined = options_.refine > 1;
        if (refined)
            table.columns.insert(
                table.columns.end(),
                {{"order", {1e-3, 0}}, {"extrapolated", {1e-6, 0}}, {"uncertainty", {1e-3, 0}}});
        command_line::Sweep sweep(table, 1);
        for (const auto& [how, clouds, failure] : results_) {
            const std::string method = bodies::name(how.method);
            if (failure) {
                sweep.add_failed({method, static_cast<long>(particles_[clouds.size()])}, *failure);
                continue;
            }
            const Found<dim>& last = clouds.back();
            table.comments.insert(table.comments.end(), last.comments.begin(), last.comments.end());
            std::vector<std::vector<Cell>> rows;
            for (std::size_t q = 0; q < last.quantities.size(); ++q) {
                rows.push_back(command_line::row(method, particles_.back(), last.quantities[q]));
                const auto more = refined ? limit(clouds, q) : std::vector<Cell>();
                rows.back().insert(rows.back().end(), more.begin(), more.end());
            }
            sweep.add(rows);
        }
        sweep.finish();
        return table;
    }

  private:
    /// What may mend a solution out of equilibrium.
    [[nodiscard]] std::string remedy(const Body<dim>& body, const Discretisation& how) const {
        const std::string finer = body.cells.empty() ? "more particles"
                                  : options_.size    ? "a smaller --size"
                                                     : "a finer mesh";
        return how.method == bodies::Method::hats || body.cells.empty() ? finer : "--method hats or " + finer;
    }

    /// What is asked of the solution by a method.
    Found<dim> solved(const Problem<dim, n>& problem, const Body<dim>& body, const Discretisation& how,
                      bool finest) {
        const std::string method = bodies::name(how.method);
        const auto start = std::chrono::steady_clock::now();
        const auto solution = bodies::solve(problem, body, how);
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        command_line::SolvedBody<dim, n> all{problem, body, solution, material_};
        all.at_particles = command_line::states(problem, solution, body.x);
        Found<dim> found{command_line::quantities(all, places_), {}};
        const auto judged = bodies::judgement(problem, body, solution);
        for (const auto& quantity : command_line::quantities<dim>(judged))
            found.quantities.push_back(quantity);
        if (options_.seconds) found.quantities.push_back({"seconds", {}, seconds.count(), false});
        if (!finest) return found;
        found.comments = command_line::about_round_off(how, judged);
        for (const std::string& remark :
             command_line::remarks(solution.approximation.how(), judged, command_line::particles_of(all),
                                   how.degree, remedy(body, how)))
            found.comments.push_back(remark);
        if (!options_.field.empty()) {
            const std::string suffix = results_.size() > 1 ? "_" + method : "";
            for (auto& field : command_line::fields(all.at_particles, solution.R, material_, suffix))
                fields_.push_back(std::move(field));
        }
        if (!options_.figure.path.empty()) options_.figure.table = command_line::drawing(all);
        return found;
    }

    [[nodiscard]] std::vector<std::string> comments(const Body<dim>& body) const {
        std::vector<std::string> all{command_line::comment_on_body(options_)};
        for (const std::string& comment : command_line::comments(options_.problem, dim))
            all.push_back(comment);
        std::string particles;
        for (const Index N : particles_) particles += (particles.empty() ? "" : ", ") + std::to_string(N);
        all.push_back(particles + " particles, " + std::to_string(body.cells.size()) + " cells, from " +
                      particles::shown_point(Point<dim>(body.x.rowwise().minCoeff())) + " to " +
                      particles::shown_point(Point<dim>(body.x.rowwise().maxCoeff())));
        all.insert(all.end(), sides_.begin(), sides_.end());
        if (body.gap > 0)
            all.emplace_back("gap between the straight pieces of the boundary and the shape: " +
                             shown(body.gap, 3) + " at most");
        const std::string numbers = command_line::about_numbers(n == 1, dim, options_.modes > 0);
        if (!numbers.empty()) all.push_back(numbers);
        if (options_.refine > 1)
            all.emplace_back(
                "clouds of --size, size/sqrt(2), ...; from the last three: the observed order, the extrapolated value, and its uncertainty 1.25 |f3 - f2|/(r^p - 1), or three times the range where no order can be observed");
        return all;
    }

    BodyOptions& options_;
    std::vector<Point<dim>> places_;
    batra2008::elastostatics::Material material_;
    std::vector<Results<dim>> results_;  // of each method
    std::vector<Index> particles_;
    std::vector<std::string> sides_, comments_;
    std::vector<bodies::NamedField> fields_;
};

template <int dim, int n>
report::Table table_of(BodyOptions& options, const meshes::Model& first) {
    BodyTable<dim, n> all(options);
    const auto methods = command_line::discretisations(options, std::get<Body<dim>>(first.body));
    command_line::Progress progress(methods.size() * static_cast<std::size_t>(options.refine));
    std::vector<std::string> notes;
    for (long cloud = 0; cloud < options.refine; ++cloud) {
        const meshes::Model here = cloud == 0 ? first : model(options, cloud);
        notes = here.notes;
        all.add(std::get<Body<dim>>(here.body), cloud == options.refine - 1, progress);
    }
    return all.table(notes);
}

template <int dim>
report::Table table_of(BodyOptions& options, const meshes::Model& first) {
    command_line::check(options.problem, dim);
    return command_line::is_scalar(options.problem) ? table_of<dim, 1>(options, first)
                                                    : table_of<dim, dim>(options, first);
}

}  // namespace

int main(int argc, char** argv) {
    command_line::CommandLine app(
        "A body of your own, in the plane or in space: its displacements and stresses, or a scalar such as a temperature, by collocation (fpm, strong) or by local weak forms (weak1, weak2, hats).",
        "body",
        "Functions are made of numbers, x, y, z, pi, e, + - * / ^ ( ) and functions such as sin, sqrt, abs, min, max.\n"
        "Example: body --mesh bracket.geo --size 2e-3 --young 210e9 --poisson 0.3 --fix wall --traction \"tip: 0, -1e6*(1-x)\" --at 0.02,0.01 --field bracket.vtu\n"
        "Another: body --mesh heat_sink.geo --equation poisson --conductivity 200 --flux \"base: 1e4\" --convection \"fins: 50, 293\" --plot sink.svg");
    BodyOptions options;
    command_line::add_options(app, options);
    return command_line::run(app, argc, argv, options.threads, options.output, options.figure, [&] {
        command_line::check(options);
        const meshes::Model first = model(options, 0);
        return first.body.index() == 0 ? table_of<2>(options, first) : table_of<3>(options, first);
    });
}
