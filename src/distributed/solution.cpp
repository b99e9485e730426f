#include "distributed/solution.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "base/errors.hpp"
#include "bodies/level.hpp"
#include "bodies/quality.hpp"
#include "distributed/spectrum.hpp"

namespace distributed {

namespace {

/// What a process makes of its part without the others.
template <int dim, int n>
struct Own {
    std::optional<Approximation<dim>> approximation;
    bodies::Conditions<dim, n> conditions;
    bodies::Quality quality;
};

/// The conditions of each particle, ordered so that the i-th is mostly along the i-th unknown where possible:
/// preconditioners treat the unknowns one by one.
template <int dim, int n>
void align(bodies::Conditions<dim, n>& conditions) {
    for (auto& here : conditions) {
        if (here.empty()) continue;
        std::array<std::size_t, static_cast<std::size_t>(n)> order{}, best{};
        std::iota(order.begin(), order.end(), std::size_t{0});
        double most = -1;
        do {
            double product = 1;
            for (std::size_t i = 0; i < order.size(); ++i)
                product *= std::abs(here[order[i]].direction[static_cast<Index>(i)]);
            if (product > most) {
                most = product;
                best = order;
            }
        } while (std::next_permutation(order.begin(), order.end()));
        const auto before = here;
        for (std::size_t i = 0; i < best.size(); ++i) here[i] = before[best[i]];
    }
}

template <int dim, int n>
bodies::Conditions<dim, n> conditions(const Part<dim>& part, const bodies::Problem<dim, n>& problem) {
    bodies::Conditions<dim, n> all = bodies::conditions(problem, part.body);
    align<dim, n>(all);
    return all;
}

template <int dim, int n>
Own<dim, n> own(const Part<dim>& part, bodies::Conditions<dim, n> conditions) {
    Own<dim, n> all;
    all.conditions = std::move(conditions);
    if (part.own.empty()) return all;
    all.approximation.emplace(approximation_of(part));
    const std::vector<int> order = bodies::highest_derivatives<dim, n>(all.conditions, part.how.method);
    std::vector<int> of_own(order.size(), bodies::no_equations);
    for (const int I : part.own) of_own[static_cast<std::size_t>(I)] = order[static_cast<std::size_t>(I)];
    all.quality = bodies::checked_quality(part.body, *all.approximation, of_own);
    return all;
}

void require_collocation(bodies::Method method) {
    if (method != bodies::Method::fpm && method != bodies::Method::strong)
        throw base::InvalidInput(bodies::name(method) +
                                 ": works on one machine only, in the program body; here take fpm or strong");
}

}  // namespace

template <int dim, int n>
Solved<dim, n> solve(const Processes& processes, const Part<dim>& part,
                     const bodies::Problem<dim, n>& problem, const Progress& progress) {
    require_collocation(part.how.method);
    const auto start = std::chrono::steady_clock::now();
    bodies::Conditions<dim, n> given;
    bodies::Range range;
    processes.together([&] {
        given = conditions(part, problem);
        range = bodies::range_of(problem, part.body, given);
    });
    range = {-processes.largest(-range.lowest), processes.largest(range.highest)};
    const double level = range.nearest_to_zero();
    const bodies::Problem<dim, n> above = bodies::above_level(problem, level);
    Own<dim, n> all;
    processes.together([&] {
        if (level != 0) given = conditions(part, above);
        all = own<dim, n>(part, std::move(given));
    });
    const Numbering numbering(processes, part, n);
    const System system = assembled(numbering, part, above, all.conditions, all.approximation,
                                    bodies::Wanted::solution, progress.assembly);
    Solved<dim, n> solved;
    solved.assembly = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const Eigen::MatrixXd u =
        numbering.at_all(distributed::solved(system, n, solved.report, progress.iterations));

    const auto& [R, worst] = all.quality;
    const int first = processes.where_largest(worst.R);
    solved.quality = processes.from(first, worst.R);
    for (Index axis = 0; axis < dim; ++axis)
        solved.worst[axis] = processes.from(first, R.size() > 0 ? part.body.x(axis, worst.particle) : 0);
    if (all.approximation)
        solved.part.emplace(bodies::Solution<dim, n>{
            std::move(*all.approximation), std::move(all.conditions), R, worst.R, worst.particle,
            Eigen::Map<const Eigen::VectorXd>(u.data(), u.size()), level});
    return solved;
}

template <int dim, int n>
std::vector<double> eigenvalues(const Processes& processes, const Part<dim>& part,
                                const bodies::Problem<dim, n>& problem, Index count,
                                const Progress& progress) {
    require_collocation(part.how.method);
    bodies::require_modes(part.extent.particles, count);
    Own<dim, n> all;
    processes.together([&] { all = own<dim, n>(part, conditions(part, problem)); });
    const Numbering numbering(processes, part, n);
    const System system = assembled(numbering, part, problem, all.conditions, all.approximation,
                                    bodies::Wanted::eigenvalues, progress.assembly);
    return bodies::vibrations(smallest_eigenvalues(system, count), part.how.method);
}

template Solved<2, 1> solve(const Processes&, const Part<2>&, const bodies::Problem<2, 1>&, const Progress&);
template Solved<3, 1> solve(const Processes&, const Part<3>&, const bodies::Problem<3, 1>&, const Progress&);
template Solved<2, 2> solve(const Processes&, const Part<2>&, const bodies::Problem<2, 2>&, const Progress&);
template Solved<3, 3> solve(const Processes&, const Part<3>&, const bodies::Problem<3, 3>&, const Progress&);
template std::vector<double> eigenvalues(const Processes&, const Part<2>&, const bodies::Problem<2, 1>&,
                                         Index, const Progress&);
template std::vector<double> eigenvalues(const Processes&, const Part<3>&, const bodies::Problem<3, 1>&,
                                         Index, const Progress&);
template std::vector<double> eigenvalues(const Processes&, const Part<2>&, const bodies::Problem<2, 2>&,
                                         Index, const Progress&);
template std::vector<double> eigenvalues(const Processes&, const Part<3>&, const bodies::Problem<3, 3>&,
                                         Index, const Progress&);

}  // namespace distributed
