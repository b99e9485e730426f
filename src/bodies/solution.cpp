#include "bodies/solution.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/errors.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "batra2008/basis_at.hpp"
#include "bodies/collocation.hpp"
#include "bodies/discs.hpp"
#include "bodies/hats.hpp"
#include "bodies/integrals.hpp"
#include "particles/multi_index.hpp"
#include "solvers/spectrum.hpp"

namespace bodies {

namespace {

namespace ssph_basis = batra2008::ssph_basis;

template <int dim, int n>
using Conditions = std::vector<std::vector<Condition<dim, n>>>;

/// The order of the highest derivative in the equations of each particle.
template <int dim, int n>
std::vector<int> highest_derivatives(const Conditions<dim, n>& conditions, Method method) {
    std::vector<int> order;
    for (const auto& here : conditions)
        order.push_back(here.empty() && (method == Method::strong || method == Method::fpm) ? 2 : 1);
    return order;
}

/// R of the derivatives of order k at a particle, in units of h.
template <int dim>
double quality_of_row(const Approximation<dim>& approximation, Index I, int k) {
    const int exact = approximation.how().method == Method::fpm ? 3 : approximation.how().degree;
    const Weights<dim> at = approximation.at_particle(I);
    const double h = approximation.h()[I];
    Offsets<double, dim> r(static_cast<Index>(at.particle.size()), dim);
    for (std::size_t j = 0; j < at.particle.size(); ++j)
        r.row(static_cast<Index>(j)) =
            (approximation.cloud().x().col(at.particle[j]) - approximation.cloud().x().col(I)).transpose() /
            h;
    double largest = 0;
    if (k == 1)
        for (int axis = 0; axis < dim; ++axis)
            largest = std::max(largest, particles::quality<double, dim>(h * at.first.col(axis), r, exact));
    else
        for (int pair = 0; pair < second_derivatives<dim>; ++pair)
            largest =
                std::max(largest, particles::quality<double, dim>(h * h * at.second.col(pair), r, exact));
    return largest;
}

/// R of each particle.
template <int dim>
Column<double> qualities(const Approximation<dim>& approximation, const std::vector<int>& order) {
    Column<double> R(approximation.cloud().size());
    base::for_each_index(R.size(), [&](Index I) {
        R[I] = quality_of_row(approximation, I, order[static_cast<std::size_t>(I)]);
    });
    return R;
}

/// The worst row. \throws base::FailedComputation where it is too bad for a solution
template <int dim>
particles::WorstRow checked_quality(const Approximation<dim>& approximation, const std::vector<int>& order) {
    const Discretisation& how = approximation.how();
    const particles::TruncatedGaussian<dim> kernel(how.scaling);
    if (how.method != Method::fpm)
        return how.degree == 2 ? ssph_basis::require_quality<2, dim>(approximation.cloud(), kernel,
                                                                     approximation.h(), order)
                               : ssph_basis::require_quality<3, dim>(approximation.cloud(), kernel,
                                                                     approximation.h(), order);
    const Column<double> R = qualities(approximation, order);
    particles::WorstRow worst;
    worst.R = R.maxCoeff(&worst.particle);
    worst.derivative = order[static_cast<std::size_t>(worst.particle)];
    if (worst.R > ssph_basis::most)
        throw base::FailedComputation("fpm: particle " + std::to_string(worst.particle) + " at " +
                                      particles::shown_point(approximation.cloud().x().col(worst.particle)) +
                                      " has the quality number " + base::shown(worst.R, 3) + ", more than " +
                                      base::shown(ssph_basis::most, 3) +
                                      ": its derivatives cannot be trusted; try --smoothing " +
                                      base::shown(1.2 * how.smoothing, 3) + ", or the method hats");
    return worst;
}

template <int dim, int n>
System system_of(const Problem<dim, n>& problem, const Body<dim>& body,
                 const Approximation<dim>& approximation, const Conditions<dim, n>& conditions,
                 Wanted wanted) {
    const Method method = approximation.how().method;
    if (method == Method::hats) return Hats<dim, n>(problem, body, approximation).system(conditions, wanted);
    if (method == Method::strong || method == Method::fpm)
        return collocated(problem, conditions, approximation, wanted);
    if constexpr (dim == 2) return on_discs(problem, body, approximation, wanted);
    throw base::InvalidInput(name(method) + ": works in the plane; in space take hats, fpm or strong");
}

}  // namespace

namespace {

/// Quality number above which hats do without monomials of degree 3. It is 2 to 3 in the plane, 10 to 20 in
/// space, and 287 in a fin of two cells, whose temperature is then wrong.
constexpr double most_for_cubic_hats = 50;

/// \throws base::FailedComputation where it does
void require_for_hats(const particles::WorstRow& worst, const Discretisation& how) {
    if (how.method == Method::hats && how.degree == 3 && worst.R > most_for_cubic_hats)
        throw base::FailedComputation("hats: monomials of degree 3 have the quality number " +
                                      base::shown(worst.R, 3));
}

/// Calls `work` with a discretisation; for hats whose neighbours do not determine monomials of degree 3 well,
/// with those of degree 2.
template <class Work>
auto with_lower_degree_for_hats(Discretisation how, const Work& work) {
    if (how.method == Method::hats && how.degree == 3) try {
            return work(how);
        } catch (const base::FailedComputation&) {
            how.degree = 2;
        }
    return work(how);
}

template <int dim, int n>
Solution<dim, n> solve_as_asked(const Problem<dim, n>& problem, const Body<dim>& body,
                                const Conditions<dim, n>& all, const Discretisation& how) {
    Solution<dim, n> solution{Approximation<dim>(Cloud<dim>(body.x), how), {}};
    const auto worst = checked_quality(solution.approximation, highest_derivatives(all, how.method));
    require_for_hats(worst, how);
    solution.R = qualities(solution.approximation, highest_derivatives(all, how.method));
    solution.quality = worst.R;
    solution.worst = worst.particle;
    System system = system_of(problem, body, solution.approximation, all, Wanted::solution);
    solution.u = solvers::solve_sparse(std::move(system.A), std::move(system.b), std::move(system.nearest));
    return solution;
}

}  // namespace

template <int dim, int n>
Solution<dim, n> solve(const Problem<dim, n>& problem, const Body<dim>& body, const Discretisation& how) {
    const auto all = conditions(problem, body);
    require_held(problem, body, all);
    return with_lower_degree_for_hats(
        how, [&](const Discretisation& chosen) { return solve_as_asked(problem, body, all, chosen); });
}

template <int dim, int n>
State<dim, n> state_at(const Problem<dim, n>& problem, const Solution<dim, n>& solution,
                       const Point<dim>& x) {
    const Weights<dim> at = solution.approximation.at(x);
    State<dim, n> state;
    state.u.setZero();
    state.gradient.setZero();
    for (std::size_t j = 0; j < at.particle.size(); ++j) {
        const Values<n> u_J = solution.u.template segment<n>(n * at.particle[j]);
        const auto row = static_cast<Index>(j);
        state.u += at.value[row] * u_J;
        state.gradient += u_J * at.first.row(row).matrix();
    }
    const auto A = problem.equation.A(x);
    for (int i = 0; i < n; ++i)
        for (int a = 0; a < dim; ++a) {
            double sum = 0;
            for (int j = 0; j < n; ++j)
                for (int b = 0; b < dim; ++b) sum += A(dim * i + a, dim * j + b) * state.gradient(j, b);
            state.F(i, a) = sum;
        }
    return state;
}

template <int dim>
double von_mises(const Eigen::Matrix<double, dim, dim>& stress,
                 const batra2008::elastostatics::Material& material) {
    Eigen::Matrix3d all = Eigen::Matrix3d::Zero();
    all.topLeftCorner<dim, dim>() = stress;
    if (dim == 2 && material.plane == batra2008::elastostatics::Plane::strain)
        all(2, 2) = material.nu * (stress(0, 0) + stress(1, 1));
    const Eigen::Matrix3d deviator = all - all.trace() / 3 * Eigen::Matrix3d::Identity();
    return std::sqrt(1.5 * deviator.squaredNorm());
}

namespace {

/// The reactions of each given side by the weak form: what the equations of its particles leave.
template <int dim, int n>
std::vector<Values<n>> consistent_reactions(const Problem<dim, n>& problem, const Body<dim>& body,
                                            const Solution<dim, n>& solution) {
    const Hats<dim, n> hats(problem, body, solution.approximation);
    std::vector<Values<n>> all(problem.given.size(), Values<n>::Zero());
    const auto conditions_of = conditions(problem, body);
    for (std::size_t I = 0; I < conditions_of.size(); ++I) {
        std::vector<Condition<dim, n>> values;
        for (const auto& one : conditions_of[I])
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

}  // namespace

template <int dim, int n>
Balance<n> balance(const Problem<dim, n>& problem, const Body<dim>& body, const Solution<dim, n>& solution) {
    Balance<n> all;
    all.volume = Values<n>::Zero();
    Values<n> sum = Values<n>::Zero();
    double loads = 0, reactions = 0,
           tractions = 0;  // sizes: the last as an integral, stresses of a moment and all
    double parts = 0;      // of differences, each as an integral: their sum at rest is round-off
    const bool of_hats = solution.approximation.how().method == Method::hats;
    std::vector<Values<n>> consistent;
    if (of_hats) consistent = consistent_reactions(problem, body, solution);
    for (std::size_t k = 0; k < problem.given.size(); ++k) {
        const auto& given = problem.given[k];
        Values<n> load = Values<n>::Zero(), reaction = load;
        for (const auto& at :
             rule_on(side_named(body, given.side), solution.approximation.cloud().spacing())) {
            const State<dim, n> state = state_at(problem, solution, at.x);
            const Values<n> t = state.F * at.normal;
            const auto [applied, valued] = acting<dim, n>(&given, at, state.u);
            if (given.exchange)
                parts += at.weight * given.exchange(at.x) *
                         (std::abs(given.surroundings(at.x)) + state.u.stableNorm());
            load += at.weight * (applied - valued * applied);
            reaction += at.weight * (valued * t);
            loads += at.weight * Values<n>(applied - valued * applied).stableNorm();
            tractions += at.weight * Values<n>(valued * t).stableNorm();
        }
        if (of_hats) reaction = consistent[k];
        const bool is_load = !given.loads.empty() || given.exchange;
        if (is_load) all.loads.emplace_back(given.side, load);
        if (reaction.stableNorm() > 0) all.reactions.emplace_back(given.side, reaction);
        sum += load + reaction;
        reactions += reaction.stableNorm();
    }
    if (problem.equation.b || problem.equation.c != 0)
        for (const auto& at : rule_in(body)) {
            Values<n> b = Values<n>::Zero(), cu = b;
            if (problem.equation.b) b = problem.equation.b(at.x);
            if (problem.equation.c != 0) cu = problem.equation.c * state_at(problem, solution, at.x).u;
            all.volume += at.weight * (b - cu);
            loads += at.weight * Values<n>(b - cu).stableNorm();
            parts += at.weight * (b.stableNorm() + cu.stableNorm());
        }
    sum += all.volume;
    constexpr double round_off = 1e-6;
    const double sizes =
        std::max(loads + (n == dim && loads > 0 ? reactions : tractions), round_off * (parts + tractions));
    all.defect = sizes > 0 ? 2 * sum.stableNorm() / sizes : 0;
    return all;
}

template <int dim, int n>
double missed_loads(const Problem<dim, n>& problem, const Body<dim>& body, const Solution<dim, n>& solution) {
    double missed = 0, sizes = 0, length = 0;
    for (const Side<dim>& side : body.sides) {
        for (const auto& at : rule_on(side, solution.approximation.cloud().spacing())) {
            const State<dim, n> state = state_at(problem, solution, at.x);
            const auto [applied, valued] = acting<dim, n>(problem.given_on(side), at, state.u);
            const Values<n> gap = state.F * at.normal - applied;
            missed += at.weight * (gap - valued * gap).squaredNorm();
            sizes += at.weight * state.F.squaredNorm();
            length += at.weight;
        }
    }
    constexpr double round_off = 1e-9;  // a solution that hardly varies has nothing but round-off in F
    const double of_values = problem.equation.A(body.x.col(0)).norm() * solution.u.cwiseAbs().maxCoeff() /
                             solution.approximation.cloud().spacing();
    return std::sqrt(sizes / length) > round_off * of_values ? std::sqrt(missed / sizes) : 0;
}

template <int dim, int n>
double noise(const Solution<dim, n>& solution) {
    const Index N = solution.approximation.cloud().size();
    Column<double> unseen(N), gradient(N);
    base::for_each_index(N, [&](Index I) {
        const Weights<dim> at = solution.approximation.at_particle(I, Derivatives::first);
        Values<n> u = Values<n>::Zero();
        Eigen::Matrix<double, n, dim> slope = Eigen::Matrix<double, n, dim>::Zero();
        for (std::size_t j = 0; j < at.particle.size(); ++j) {
            const Values<n> u_J = solution.u.template segment<n>(n * at.particle[j]);
            u += at.value[static_cast<Index>(j)] * u_J;
            slope += u_J * at.first.row(static_cast<Index>(j)).matrix();
        }
        unseen[I] = (solution.u.template segment<n>(n * I) - u).norm() / solution.approximation.h()[I];
        gradient[I] = slope.norm();
    });
    constexpr double round_off = 1e-9;  // a solution that hardly varies over the body has no noise
    const Point<dim> extent = solution.approximation.cloud().x().rowwise().maxCoeff() -
                              solution.approximation.cloud().x().rowwise().minCoeff();
    const double size = std::max(std::sqrt(gradient.square().mean()),
                                 round_off * solution.u.cwiseAbs().maxCoeff() / extent.maxCoeff());
    return size > 0 ? unseen.maxCoeff() / size : 0;
}

template <int dim, int n>
std::vector<double> eigenvalues(const Problem<dim, n>& problem, const Body<dim>& body,
                                const Discretisation& how, Index count) {
    const auto all = conditions(problem, body);
    require_held(problem, body, all);
    const System system = with_lower_degree_for_hats(how, [&](const Discretisation& chosen) {
        const Approximation<dim> approximation(Cloud<dim>(body.x), chosen);
        require_for_hats(checked_quality(approximation, highest_derivatives(all, how.method)), chosen);
        return system_of(problem, body, approximation, all, Wanted::eigenvalues);
    });
    if (count < 1 || count > body.x.cols() / 2)
        throw base::InvalidInput("a body of " + std::to_string(body.x.cols()) + " particles has from 1 to " +
                                 std::to_string(body.x.cols() / 2) + " modes worth computing, not " +
                                 std::to_string(count));
    std::vector<double> lowest;
    for (const std::complex<double>& mu : solvers::largest_of_inverse(system.A, system.M, count)) {
        const std::complex<double> lambda = 1.0 / mu;
        if (std::abs(lambda.imag()) > 1e-2 * std::abs(lambda) || lambda.real() < 0)
            throw base::FailedComputation(
                name(how.method) + ": the eigenvalue " + base::shown(lambda.real(), 4) +
                (lambda.imag() == 0 ? "" : " with an imaginary part of " + base::shown(lambda.imag(), 2)) +
                " is that of no vibration; take more particles, or the method hats");
        lowest.push_back(lambda.real());
    }
    std::sort(lowest.begin(), lowest.end());
    return lowest;
}

Extrapolated extrapolated(double f1, double f2, double f3, double ratio, double formal) {
    const double before = f2 - f1, last = f3 - f2;
    const double order = std::log(std::abs(before / last)) / std::log(ratio);
    if (before * last > 0 && order > 0.5 && order < formal + 1) {
        const double left = last / (std::pow(ratio, order) - 1);
        return {order, f3 + left, 1.25 * std::abs(left)};
    }
    const auto [least, most] = std::minmax({f1, f2, f3});
    return {std::numeric_limits<double>::quiet_NaN(), f3, 3 * (most - least)};
}

template double von_mises(const Eigen::Matrix<double, 2, 2>&, const batra2008::elastostatics::Material&);
template double von_mises(const Eigen::Matrix<double, 3, 3>&, const batra2008::elastostatics::Material&);

template Solution<2, 1> solve(const Problem<2, 1>&, const Body<2>&, const Discretisation&);
template State<2, 1> state_at(const Problem<2, 1>&, const Solution<2, 1>&, const Point<2>&);
template Balance<1> balance(const Problem<2, 1>&, const Body<2>&, const Solution<2, 1>&);
template double noise(const Solution<2, 1>&);
template double missed_loads(const Problem<2, 1>&, const Body<2>&, const Solution<2, 1>&);
template std::vector<double> eigenvalues(const Problem<2, 1>&, const Body<2>&, const Discretisation&, Index);

template Solution<3, 1> solve(const Problem<3, 1>&, const Body<3>&, const Discretisation&);
template State<3, 1> state_at(const Problem<3, 1>&, const Solution<3, 1>&, const Point<3>&);
template Balance<1> balance(const Problem<3, 1>&, const Body<3>&, const Solution<3, 1>&);
template double noise(const Solution<3, 1>&);
template double missed_loads(const Problem<3, 1>&, const Body<3>&, const Solution<3, 1>&);
template std::vector<double> eigenvalues(const Problem<3, 1>&, const Body<3>&, const Discretisation&, Index);

template Solution<2, 2> solve(const Problem<2, 2>&, const Body<2>&, const Discretisation&);
template State<2, 2> state_at(const Problem<2, 2>&, const Solution<2, 2>&, const Point<2>&);
template Balance<2> balance(const Problem<2, 2>&, const Body<2>&, const Solution<2, 2>&);
template double noise(const Solution<2, 2>&);
template double missed_loads(const Problem<2, 2>&, const Body<2>&, const Solution<2, 2>&);
template std::vector<double> eigenvalues(const Problem<2, 2>&, const Body<2>&, const Discretisation&, Index);

template Solution<3, 3> solve(const Problem<3, 3>&, const Body<3>&, const Discretisation&);
template State<3, 3> state_at(const Problem<3, 3>&, const Solution<3, 3>&, const Point<3>&);
template Balance<3> balance(const Problem<3, 3>&, const Body<3>&, const Solution<3, 3>&);
template double noise(const Solution<3, 3>&);
template double missed_loads(const Problem<3, 3>&, const Body<3>&, const Solution<3, 3>&);
template std::vector<double> eigenvalues(const Problem<3, 3>&, const Body<3>&, const Discretisation&, Index);

}  // namespace bodies
