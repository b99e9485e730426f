#include "bodies/judgement.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "bodies/hats.hpp"
#include "bodies/integrals.hpp"

namespace bodies {

namespace {

/// The reactions of each given side by the weak form: what the equations of its particles leave.
template <int dim, int n>
std::vector<Values<n>> consistent_reactions(const Problem<dim, n>& problem, const Body<dim>& body,
                                            const Solution<dim, n>& solution) {
    const Hats<dim, n> hats(problem, body, solution.approximation);
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
                .solve(D.transpose() * hats.residual(static_cast<Index>(I), solution.u));
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
    Eigen::Matrix<double, n, n> valued = Eigen::Matrix<double, n, n>::Zero();  ///< onto given values
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

/// The integral of a vector, and that of its size.
template <int n>
struct Integral {
    Values<n> vector = Values<n>::Zero();
    double size = 0;

    void add(double weight, const Values<n>& value) {
        vector += weight * value;
        size += weight * value.stableNorm();
    }
};

/// What acts on a side or in the volume.
template <int n>
struct Forces {
    Integral<n> load;      ///< that is given
    Integral<n> reaction;  ///< the solution's own load where a value is given
    double parts = 0;  ///< the sizes of what is subtracted in a load, such as a u0 and a u, as an integral
    double area = 0;   ///< of the side
};

/// A solution that hardly varies has nothing but round-off in F; this is its share of size_of_terms().
constexpr double negligible = 1e-9;

/// The size of the terms whose sum is F.
template <int dim, int n>
double size_of_terms(const Problem<dim, n>& problem, const Body<dim>& body,
                     const Solution<dim, n>& solution) {
    return problem.equation.A(body.x.col(0)).norm() * solution.u.cwiseAbs().maxCoeff() /
           solution.approximation.cloud().spacing();
}

template <int dim, int n>
Forces<n> forces_on(const Given<dim, n>& given, const Problem<dim, n>& problem, const Body<dim>& body,
                    const Solution<dim, n>& solution) {
    Forces<n> all;
    for (const auto& at : rule_on(side_named(body, given.side), solution.approximation.cloud().spacing())) {
        const State<dim, n> state = state_at(problem, solution, at.x);
        const auto [applied, valued] = acting<dim, n>(&given, at, state.u);
        all.area += at.weight;
        all.load.add(at.weight, applied - valued * applied);
        all.reaction.add(at.weight, valued * (state.F * at.normal));
        if (given.exchange)
            all.parts += at.weight * given.exchange(at.x) *
                         (std::abs(given.surroundings(at.x)) + state.u.stableNorm());
    }
    return all;
}

template <int dim, int n>
Forces<n> forces_in(const Body<dim>& body, const Problem<dim, n>& problem, const Solution<dim, n>& solution) {
    Forces<n> all;
    const double c = problem.equation.c;
    if (!problem.equation.b && c == 0) return all;
    for (const auto& at : rule_in(body)) {
        const Values<n> of_b = source(problem.equation, at.x);
        const Values<n> of_u =
            c == 0 ? Values<n>(Values<n>::Zero()) : Values<n>(c * state_at(problem, solution, at.x).u);
        all.load.add(at.weight, of_b - of_u);
        all.parts += at.weight * (of_b.stableNorm() + of_u.stableNorm());
    }
    return all;
}

/// The sizes of forces whose sum is zero at rest.
struct Sizes {
    double loads = 0, reactions = 0;  ///< the latter of each side as a whole
    double reaction_integrals = 0, parts = 0;
    double terms = 0;  ///< size_of_terms() as an integral

    /// Where nothing is left but differences, their sum is round-off of its parts, or of the terms of F.
    [[nodiscard]] double total(bool is_scalar) const {
        constexpr double round_off = 1e-6, of_terms = 1e-11;
        const bool may_cancel = is_scalar || loads == 0;
        return std::max(loads + (may_cancel ? reaction_integrals : reactions),
                        std::max(round_off * (parts + reaction_integrals), of_terms * terms));
    }
};

}  // namespace

template <int dim, int n>
Balance<n> balance(const Problem<dim, n>& problem, const Body<dim>& body, const Solution<dim, n>& solution) {
    const bool of_hats = solution.approximation.how().method == Method::hats;
    std::vector<Values<n>> consistent;
    if (of_hats) consistent = consistent_reactions(problem, body, solution);
    Balance<n> all;
    Sizes sizes;
    const double terms = size_of_terms(problem, body, solution);
    Values<n> sum = Values<n>::Zero();
    for (std::size_t k = 0; k < problem.given.size(); ++k) {
        const Given<dim, n>& given = problem.given[k];
        const auto [load, integral, parts, area] = forces_on(given, problem, body, solution);
        const Values<n> reaction = of_hats ? consistent[k] : integral.vector;
        if (!given.loads.empty() || given.exchange) all.loads.emplace_back(given.side, load.vector);
        if (reaction.stableNorm() > 0) all.reactions.emplace_back(given.side, reaction);
        sum += load.vector + reaction;
        sizes.loads += load.size;
        sizes.reactions += reaction.stableNorm();
        sizes.reaction_integrals += integral.size;
        sizes.parts += parts;
        sizes.terms += terms * area;
    }
    const auto [volume, none, parts, area] = forces_in(body, problem, solution);
    all.volume = volume.vector;
    sum += volume.vector;
    sizes.loads += volume.size;
    sizes.parts += parts;
    const double total = sizes.total(n != dim);
    all.defect = total > 0 ? 2 * sum.stableNorm() / total : 0;
    return all;
}

template <int dim, int n>
double missed_loads(const Problem<dim, n>& problem, const Body<dim>& body, const Solution<dim, n>& solution) {
    double missed = 0, sizes = 0, length = 0;
    for (const Side<dim>& side : body.sides)
        for (const auto& at : rule_on(side, solution.approximation.cloud().spacing())) {
            const State<dim, n> state = state_at(problem, solution, at.x);
            const auto [applied, valued] = acting<dim, n>(problem.given_on(side), at, state.u);
            const Values<n> gap = state.F * at.normal - applied;
            missed += at.weight * (gap - valued * gap).squaredNorm();
            sizes += at.weight * state.F.squaredNorm();
            length += at.weight;
        }
    return std::sqrt(sizes / length) > negligible * size_of_terms(problem, body, solution)
               ? std::sqrt(missed / sizes)
               : 0;
}

template <int dim, int n>
double noise(const Solution<dim, n>& solution) {
    const Approximation<dim>& approximation = solution.approximation;
    const Index N = approximation.cloud().size();
    Column<double> unseen(N), gradient(N);
    base::for_each_index(N, [&](Index I) {
        const Weights<dim> at = approximation.at_particle(I, Derivatives::first);
        const Values<n> u_I = solution.u.template segment<n>(n * I);
        unseen[I] = (u_I - combined<n>(at.particle, at.value, solution.u)).norm() / approximation.h()[I];
        gradient[I] = combined<n>(at.particle, at.first, solution.u).norm();
    });
    constexpr double round_off = 1e-9;  // a solution that hardly varies over the body has no noise
    const auto& x = approximation.cloud().x();
    const Point<dim> extent = x.rowwise().maxCoeff() - x.rowwise().minCoeff();
    const double size = std::max(std::sqrt(gradient.square().mean()),
                                 round_off * solution.u.cwiseAbs().maxCoeff() / extent.maxCoeff());
    return size > 0 ? unseen.maxCoeff() / size : 0;
}

template <int dim, int n>
std::vector<Index> across_gaps(const Body<dim>& body, const Solution<dim, n>& solution) {
    if (body.cells.empty()) return {};
    const auto N = static_cast<std::size_t>(body.x.cols());
    std::vector<std::vector<int>> joined(N);
    for (const auto& cell : body.cells)
        for (const int a : cell)
            for (const int b : cell)
                if (a != b) joined[static_cast<std::size_t>(a)].push_back(b);
    std::vector<char> across(N, 0);
    base::for_each_index(body.x.cols(), [&](Index I) {
        const std::vector<int> near = solution.approximation.neighbours(I);
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

template Balance<1> balance(const Problem<2, 1>&, const Body<2>&, const Solution<2, 1>&);
template double missed_loads(const Problem<2, 1>&, const Body<2>&, const Solution<2, 1>&);
template double noise(const Solution<2, 1>&);
template std::vector<Index> across_gaps(const Body<2>&, const Solution<2, 1>&);

template Balance<1> balance(const Problem<3, 1>&, const Body<3>&, const Solution<3, 1>&);
template double missed_loads(const Problem<3, 1>&, const Body<3>&, const Solution<3, 1>&);
template double noise(const Solution<3, 1>&);
template std::vector<Index> across_gaps(const Body<3>&, const Solution<3, 1>&);

template Balance<2> balance(const Problem<2, 2>&, const Body<2>&, const Solution<2, 2>&);
template double missed_loads(const Problem<2, 2>&, const Body<2>&, const Solution<2, 2>&);
template double noise(const Solution<2, 2>&);
template std::vector<Index> across_gaps(const Body<2>&, const Solution<2, 2>&);

template Balance<3> balance(const Problem<3, 3>&, const Body<3>&, const Solution<3, 3>&);
template double missed_loads(const Problem<3, 3>&, const Body<3>&, const Solution<3, 3>&);
template double noise(const Solution<3, 3>&);
template std::vector<Index> across_gaps(const Body<3>&, const Solution<3, 3>&);

}  // namespace bodies
