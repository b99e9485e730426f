#include "bodies/judgement.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/parallel.hpp"
#include "bodies/hats.hpp"
#include "bodies/level.hpp"
#include "particles/cloud.hpp"

namespace bodies {

namespace {

/// The reactions of each given side by the weak form: what the equations of its particles leave.
template <int dim, int n>
std::vector<Values<n>> consistent_reactions(const Problem<dim, n>& problem, const Body<dim>& body,
                                            const Solution<dim, n>& solution) {
    const Problem<dim, n> above = above_level(problem, solution.level);
    const Hats<dim, n> hats(above, body, solution.approximation);
    std::vector<Values<n>> all(problem.given.size(), Values<n>::Zero());
    for (std::size_t I = 0; I < solution.conditions.size(); ++I) {
        std::vector<Condition<dim, n>> values;
        for (const auto& one : solution.conditions[I])
            if (one.of_value) values.push_back(one);
        if (values.empty()) continue;
        Eigen::Matrix<double, n, Eigen::Dynamic> D(n, static_cast<Index>(values.size()));
        for (std::size_t k = 0; k < values.size(); ++k) D.col(static_cast<Index>(k)) = values[k].direction;
        const Eigen::VectorXd along =
            (D.transpose() * D)
                .ldlt()
                .solve(D.transpose() * hats.residual(static_cast<Index>(I), solution.above));
        for (std::size_t k = 0; k < values.size(); ++k)
            all[static_cast<std::size_t>(values[k].from)] +=
                along[static_cast<Index>(k)] * values[k].direction;
    }
    return all;
}

/// What acts at a place of the boundary.
template <int n>
struct Acting {
    Values<n> applied = Values<n>::Zero();                                     ///< the load
    Eigen::Matrix<double, n, n> valued = Eigen::Matrix<double, n, n>::Zero();  ///< projection on given values
};

/// \param given of the side, or null for a free one \param u the solution there
template <int dim, int n>
Acting<n> acting(const Given<dim, n>* given, const IntegrationPoint<dim>& at, const Values<n>& u) {
    Acting<n> here;
    if (given == nullptr) return here;
    for (int i = 0; i < n; ++i)
        if (given->value[static_cast<std::size_t>(i)]) here.valued(i, i) = 1;
    if constexpr (n == dim)
        if (given->symmetry) here.valued += at.normal * at.normal.transpose();
    for (const Load<dim, n>& one : given->loads) here.applied += one(at.x, at.normal);
    if (given->exchange)
        here.applied += given->exchange(at.x) * (Values<n>::Constant(given->surroundings(at.x)) - u);
    return here;
}

/// Relative tolerance below which a sum of loads counts as round-off of its parts.
constexpr double cancelled = 1e-6;

/// Relative error of a given value or surroundings, as the user writes them.
constexpr double of_given = 1e-14;

/// The size of F where the values of neighbouring particles differ by u. [force/area]
template <int dim, int n>
double size_of_F(const Sums<n>& sums, const Extent<dim>& extent, double u) {
    return sums.coefficient * u / extent.spacing();
}

/// The load on the boundary that is in balance with the error of the source.
template <int n>
double load_of_error(const Sums<n>& sums) {
    return sums.error_of_source * sums.in.area / sums.area;
}

/// The size of the terms whose sum is F, at least that of which the errors of what is given are a negligible
/// share.
template <int dim, int n>
double size_of_terms(const Sums<n>& sums, const Extent<dim>& extent) {
    const double errors = size_of_F(sums, extent, sums.error_of_values) + load_of_error(sums);
    return std::max(size_of_F(sums, extent, sums.largest_u), errors / round_off_of_terms);
}

/// Size below which a load is round-off of the terms of F. [force/area]
template <int dim, int n>
double least_load(const Sums<n>& sums, const Extent<dim>& extent) {
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    const double u = std::max(epsilon * sums.largest_u, sums.error_of_values);
    return size_of_F(sums, extent, u) + load_of_error(sums);
}

template <int dim, int n>
double share_of_terms(const Sums<n>& sums, const Extent<dim>& extent) {
    const double terms = size_of_terms(sums, extent);
    return terms > 0 ? std::sqrt(sums.sizes / sums.area) / terms : 0;
}

template <int dim, int n>
void add_side(Sums<n>& sums, const Side<dim>& side, const Problem<dim, n>& problem,
              const Solution<dim, n>& solution, double spacing) {
    const Given<dim, n>* given = problem.given_on(side);
    for (const auto& at : rule_on(side, spacing)) {
        const State<dim, n> state = state_above_level(problem, solution, at.x);
        const auto [applied, valued] = acting<dim, n>(given, at, state.u);
        const Values<n> own = state.F * at.normal, gap = own - applied;
        sums.missed += at.weight * (gap - valued * gap).squaredNorm();
        sums.sizes += at.weight * state.F.squaredNorm();
        sums.applied += at.weight * applied.squaredNorm();
        sums.area += at.weight;
        if (given == nullptr) continue;
        Forces<n>& here = sums.on[static_cast<std::size_t>(given - problem.given.data())];
        here.area += at.weight;
        here.load.add(at.weight, applied - valued * applied);
        here.reaction.add(at.weight, valued * own);
        if (given->exchange)
            here.parts += at.weight * given->exchange(at.x) *
                          (std::abs(given->surroundings(at.x)) + state.u.stableNorm() +
                           sums.error_of_values / cancelled);
    }
}

/// \param error of the source
template <int dim, int n>
Forces<n> forces_in(const std::vector<IntegrationPoint<dim>>& volume, const Problem<dim, n>& problem,
                    const Solution<dim, n>& solution, double error) {
    Forces<n> all;
    const double c = problem.equation.c;
    if (!problem.equation.b && c == 0) return all;
    for (const auto& at : volume) {
        const Values<n> of_b = source(problem.equation, at.x);
        const Values<n> of_u = c == 0 ? Values<n>(Values<n>::Zero())
                                      : Values<n>(c * state_above_level(problem, solution, at.x).u);
        all.load.add(at.weight, of_b - of_u);
        all.parts += at.weight * (of_b.stableNorm() + of_u.stableNorm() + error / cancelled);
        all.area += at.weight;
    }
    return all;
}

/// Sizes of the forces that balance.
struct Sizes {
    double loads = 0, reactions = 0;  ///< the latter of each side as a whole
    double reaction_integrals = 0, parts = 0;
    double terms = 0, least_load = 0;  ///< as integrals

    /// Sum of the sizes; at least the round-off of their parts and, without loads, of the terms of F.
    [[nodiscard]] double total(bool is_scalar) const {
        const bool may_cancel = is_scalar || loads == 0;
        const double least = loads > least_load ? 0 : round_off_of_terms * terms;
        return std::max(loads + (may_cancel ? reaction_integrals : reactions),
                        std::max(cancelled * (parts + reaction_integrals), least));
    }
};

template <int dim, int n>
void add_particles(Sums<n>& sums, const Solution<dim, n>& solution, const std::vector<int>& own) {
    const Approximation<dim>& approximation = solution.approximation;
    const auto N = static_cast<Index>(own.size());
    Column<double> unseen(N), gradient(N);
    base::for_each_index(N, [&](Index k) {
        const Index I = own[static_cast<std::size_t>(k)];
        const Weights<dim> at = approximation.at_particle(I, Derivatives::first);
        const Values<n> u_I = solution.above.template segment<n>(n * I);
        unseen[k] = (u_I - combined<n>(at.particle, at.value, solution.above)).norm() / approximation.h()[I];
        gradient[k] = combined<n>(at.particle, at.first, solution.above).norm();
    });
    if (N == 0) return;
    sums.unseen = unseen.maxCoeff();
    sums.gradients = gradient.square().sum();
    sums.largest_u = solution.above.cwiseAbs().maxCoeff();
}

template <int dim, int n>
Balance<n> balance(const Problem<dim, n>& problem, const Sums<n>& sums, const Extent<dim>& extent,
                   const std::vector<Values<n>>& reactions) {
    Balance<n> all;
    Sizes sizes;
    const double terms = size_of_terms(sums, extent), least = least_load(sums, extent);
    Values<n> sum = Values<n>::Zero();
    for (std::size_t k = 0; k < problem.given.size(); ++k) {
        const Given<dim, n>& given = problem.given[k];
        const auto& [load, integral, parts, area] = sums.on[k];
        const Values<n>& reaction = reactions[k];
        if (!given.loads.empty() || given.exchange) all.loads.emplace_back(given.side, load.vector);
        if (reaction.stableNorm() > 0) all.reactions.emplace_back(given.side, reaction);
        sum += load.vector + reaction;
        sizes.loads += load.size;
        sizes.reactions += reaction.stableNorm();
        sizes.reaction_integrals += integral.size;
        sizes.parts += parts;
        sizes.terms += terms * area;
        sizes.least_load += least * area;
    }
    const auto& [volume, none, parts, area] = sums.in;
    all.volume = volume.vector;
    sum += volume.vector;
    sizes.loads += volume.size;
    sizes.parts += parts;
    const double total = sizes.total(n != dim);
    all.defect = total > 0 ? 2 * sum.stableNorm() / total : 0;
    return all;
}

template <int dim, int n>
double missed_loads(const Sums<n>& sums, const Extent<dim>& extent) {
    if (share_of_terms(sums, extent) > round_off_of_terms) return std::sqrt(sums.missed / sums.sizes);
    const double load = std::sqrt(sums.applied / sums.area);
    return load > least_load(sums, extent) ? std::sqrt(sums.missed / std::max(sums.sizes, sums.applied)) : 0;
}

template <int dim, int n>
double noise(const Sums<n>& sums, const Extent<dim>& extent) {
    if (share_of_terms(sums, extent) <= round_off_of_terms) return 0;
    return sums.unseen / std::sqrt(sums.gradients / static_cast<double>(extent.particles));
}

template <int dim, int n>
Judgement<n> judgement(const Problem<dim, n>& problem, const Sums<n>& sums, const Extent<dim>& extent,
                       const std::vector<Values<n>>& reactions) {
    return {noise(sums, extent), missed_loads(sums, extent), balance(problem, sums, extent, reactions),
            share_of_terms(sums, extent)};
}

/// The reactions as integrals.
template <int n>
std::vector<Values<n>> integrals(const Sums<n>& sums) {
    std::vector<Values<n>> all;
    for (const Forces<n>& here : sums.on) all.push_back(here.reaction.vector);
    return all;
}

}  // namespace

template <int dim>
double Extent<dim>::spacing() const {
    return particles::spacing_of_grid<dim>(high - low, particles);
}

template <int dim>
Extent<dim> extent_of(const Body<dim>& body) {
    return {body.x.rowwise().minCoeff(), body.x.rowwise().maxCoeff(), body.x.cols()};
}

template <int dim, int n>
Sums<n> sums(const Problem<dim, n>& problem, const Body<dim>& body, const Solution<dim, n>& solution,
             const std::vector<IntegrationPoint<dim>>& volume, double spacing, const std::vector<int>& own) {
    Sums<n> all{std::vector<Forces<n>>(problem.given.size())};
    const Problem<dim, n> above = above_level(problem, solution.level);
    // If all given values are the level, their difference from it is exact.
    const Range range = range_of(above, body, solution.conditions);
    if (range.lowest < 0 || range.highest > 0) all.error_of_values = of_given * std::abs(solution.level);
    all.error_of_source = of_given * std::abs(problem.equation.c * solution.level);
    for (const Side<dim>& side : body.sides) add_side(all, side, above, solution, spacing);
    all.in = forces_in(volume, above, solution, all.error_of_source);
    add_particles(all, solution, own);
    if (body.x.cols() > 0) all.coefficient = problem.equation.A(body.x.col(0)).norm();
    return all;
}

template <int dim, int n>
Judgement<n> judgement(const Problem<dim, n>& problem, const Sums<n>& sums, const Extent<dim>& extent) {
    return judgement(problem, sums, extent, integrals(sums));
}

template <int dim, int n>
Judgement<n> judgement(const Problem<dim, n>& problem, const Body<dim>& body,
                       const Solution<dim, n>& solution) {
    const Extent<dim> extent = extent_of(body);
    std::vector<int> all(static_cast<std::size_t>(body.x.cols()));
    std::iota(all.begin(), all.end(), 0);
    std::vector<IntegrationPoint<dim>> volume;
    if (problem.equation.b || problem.equation.c != 0) volume = rule_in(body);
    const Sums<n> of_body = sums(problem, body, solution, volume, extent.spacing(), all);
    return judgement(problem, of_body, extent,
                     solution.approximation.how().method == Method::hats
                         ? consistent_reactions(problem, body, solution)
                         : integrals(of_body));
}

template <int dim>
std::vector<Index> across_gaps(const Body<dim>& body, const Approximation<dim>& approximation) {
    if (body.cells.empty()) return {};
    const auto N = static_cast<std::size_t>(body.x.cols());
    std::vector<std::vector<int>> joined(N);
    for (const auto& cell : body.cells)
        for (const int a : cell)
            for (const int b : cell)
                if (a != b) joined[static_cast<std::size_t>(a)].push_back(b);
    std::vector<char> across(N, 0);
    base::for_each_index(body.x.cols(), [&](Index I) {
        const std::vector<int> near = approximation.neighbours(I);
        std::vector<char> reached(near.size(), 0);
        std::vector<int> next{static_cast<int>(I)};
        std::size_t count = 0;
        while (!next.empty()) {
            const int a = next.back();
            next.pop_back();
            for (const int b : joined[static_cast<std::size_t>(a)]) {
                const auto found = std::lower_bound(near.begin(), near.end(), b);
                if (found == near.end() || *found != b) continue;
                char& known = reached[static_cast<std::size_t>(found - near.begin())];
                if (known) continue;
                known = 1;
                ++count;
                next.push_back(b);
            }
        }
        across[static_cast<std::size_t>(I)] = count < near.size() ? 1 : 0;
    });
    std::vector<Index> all;
    for (std::size_t I = 0; I < N; ++I)
        if (across[I]) all.push_back(static_cast<Index>(I));
    return all;
}

template struct Extent<2>;
template struct Extent<3>;
template Extent<2> extent_of(const Body<2>&);
template Extent<3> extent_of(const Body<3>&);
template std::vector<Index> across_gaps(const Body<2>&, const Approximation<2>&);
template std::vector<Index> across_gaps(const Body<3>&, const Approximation<3>&);

template Sums<1> sums(const Problem<2, 1>&, const Body<2>&, const Solution<2, 1>&,
                      const std::vector<IntegrationPoint<2>>&, double, const std::vector<int>&);
template Judgement<1> judgement(const Problem<2, 1>&, const Sums<1>&, const Extent<2>&);
template Judgement<1> judgement(const Problem<2, 1>&, const Body<2>&, const Solution<2, 1>&);

template Sums<1> sums(const Problem<3, 1>&, const Body<3>&, const Solution<3, 1>&,
                      const std::vector<IntegrationPoint<3>>&, double, const std::vector<int>&);
template Judgement<1> judgement(const Problem<3, 1>&, const Sums<1>&, const Extent<3>&);
template Judgement<1> judgement(const Problem<3, 1>&, const Body<3>&, const Solution<3, 1>&);

template Sums<2> sums(const Problem<2, 2>&, const Body<2>&, const Solution<2, 2>&,
                      const std::vector<IntegrationPoint<2>>&, double, const std::vector<int>&);
template Judgement<2> judgement(const Problem<2, 2>&, const Sums<2>&, const Extent<2>&);
template Judgement<2> judgement(const Problem<2, 2>&, const Body<2>&, const Solution<2, 2>&);

template Sums<3> sums(const Problem<3, 3>&, const Body<3>&, const Solution<3, 3>&,
                      const std::vector<IntegrationPoint<3>>&, double, const std::vector<int>&);
template Judgement<3> judgement(const Problem<3, 3>&, const Sums<3>&, const Extent<3>&);
template Judgement<3> judgement(const Problem<3, 3>&, const Body<3>&, const Solution<3, 3>&);

}  // namespace bodies
