#include "bodies/solution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "base/errors.hpp"
#include "base/text.hpp"
#include "bodies/collocation.hpp"
#include "bodies/discs.hpp"
#include "bodies/hats.hpp"
#include "bodies/level.hpp"
#include "bodies/quality.hpp"
#include "solvers/sparse_spectrum.hpp"

namespace bodies {

namespace {

template <int dim, int n>
System system_of(const Problem<dim, n>& problem, const Body<dim>& body,
                 const Approximation<dim>& approximation, const Conditions<dim, n>& conditions,
                 Wanted wanted) {
    const Method method = approximation.how().method;
    if (method == Method::hats) return Hats<dim, n>(problem, body, approximation).system(conditions, wanted);
    if (method == Method::strong || method == Method::fpm)
        return collocated(problem, conditions, approximation, wanted);
    if constexpr (dim == 2) return on_discs(problem, body, approximation, wanted);
    throw base::InvalidInput(name(method) + ": works only in the plane; in space take " +
                             (body.cells.empty() ? "" : "hats, ") + "fpm or strong");
}

/// Quality number above which hats fall back from degree 3 to 2. It is 2 to 3 in the plane, 10 to 20 in
/// space, and 287 in a fin two cells wide, whose temperature is then wrong.
constexpr double most_for_cubic_hats = 50;

/// The equations of a problem by a method, and what they were made of.
template <int dim>
struct Equations {
    Approximation<dim> approximation;
    Quality quality;
    System system;
};

template <int dim, int n>
Equations<dim> equations_as_asked(const Problem<dim, n>& problem, const Body<dim>& body,
                                  const Conditions<dim, n>& conditions, const Discretisation& how,
                                  Wanted wanted) {
    Approximation<dim> approximation(Cloud<dim>(body.x), how);
    Quality quality = checked_quality(body, approximation, highest_derivatives(conditions, how.method));
    if (how.method == Method::hats && how.degree == 3 && quality.worst.R > most_for_cubic_hats)
        throw base::FailedComputation("hats: monomials of degree 3 have the quality number " +
                                      base::shown(quality.worst.R, 3));
    System system = system_of(problem, body, approximation, conditions, wanted);
    return {std::move(approximation), std::move(quality), std::move(system)};
}

/// Hats fall back to degree 2 where the neighbours do not determine monomials of degree 3 well.
template <int dim, int n>
Equations<dim> equations(const Problem<dim, n>& problem, const Body<dim>& body,
                         const Conditions<dim, n>& conditions, Discretisation how, Wanted wanted) {
    if (how.method == Method::hats && how.degree == 3) try {
            return equations_as_asked(problem, body, conditions, how, wanted);
        } catch (const base::FailedComputation&) {
            how.degree = 2;
        }
    return equations_as_asked(problem, body, conditions, how, wanted);
}

}  // namespace

template <int dim, int n>
Solution<dim, n> solve(const Problem<dim, n>& problem, const Body<dim>& body, const Discretisation& how) {
    Conditions<dim, n> all = conditions(problem, body);
    require_corners(problem, body);
    require_held(problem, body, all);
    const double level = range_of(problem, body, all).nearest_to_zero();
    const Problem<dim, n> above = above_level(problem, level);
    if (level != 0) all = conditions(above, body);
    auto [approximation, quality, system] = equations(above, body, all, how, Wanted::solution);
    const auto& [R, worst] = quality;
    auto& [A, b, nearest, M] = system;
    Eigen::VectorXd u = solvers::solve_sparse(std::move(A), std::move(b), std::move(nearest));
    return {std::move(approximation), std::move(all), R, worst.R, worst.particle, std::move(u), level};
}

template <int dim, int n>
State<dim, n> state_at(const Problem<dim, n>& problem, const Solution<dim, n>& solution,
                       const Point<dim>& x) {
    State<dim, n> state = state_above_level(problem, solution, x);
    state.u.array() += solution.level;
    return state;
}

template <int dim, int n>
State<dim, n> state_above_level(const Problem<dim, n>& problem, const Solution<dim, n>& solution,
                                const Point<dim>& x) {
    const Weights<dim> at = solution.approximation.at(x);
    State<dim, n> state{combined<n>(at.particle, at.value, solution.above),
                        combined<n>(at.particle, at.first, solution.above),
                        {}};
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

template <int dim, int n>
std::vector<double> eigenvalues(const Problem<dim, n>& problem, const Body<dim>& body,
                                const Discretisation& how, Index count) {
    const auto all = conditions(problem, body);
    require_corners(problem, body);
    require_held(problem, body, all);
    require_modes(body.x.cols(), count);
    const System system = equations(problem, body, all, how, Wanted::eigenvalues).system;
    std::vector<std::complex<double>> lambda;
    for (const std::complex<double>& mu : solvers::largest_of_inverse(system.A, system.M, count))
        lambda.push_back(1.0 / mu);
    return vibrations(lambda, how.method, or_hats(body, how.method));
}

void require_modes(Index particles, Index count) {
    if (count < 1 || count > particles / 2)
        throw base::InvalidInput("ask for 1 to " + std::to_string(particles / 2) + " modes on " +
                                 std::to_string(particles) + " particles, got " + std::to_string(count));
}

std::vector<double> vibrations(const std::vector<std::complex<double>>& eigenvalues, Method method,
                               const std::string& or_else) {
    std::vector<double> all;
    for (const std::complex<double>& lambda : eigenvalues) {
        if (std::abs(lambda.imag()) > 1e-2 * std::abs(lambda) || lambda.real() < 0)
            throw base::FailedComputation(
                name(method) + ": the eigenvalue " + base::shown(lambda.real(), 4) +
                (lambda.imag() == 0 ? "" : " with an imaginary part of " + base::shown(lambda.imag(), 2)) +
                " does not belong to a vibration; take more particles" + or_else);
        all.push_back(lambda.real());
    }
    std::sort(all.begin(), all.end());
    return all;
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
template State<2, 1> state_above_level(const Problem<2, 1>&, const Solution<2, 1>&, const Point<2>&);
template std::vector<double> eigenvalues(const Problem<2, 1>&, const Body<2>&, const Discretisation&, Index);

template Solution<3, 1> solve(const Problem<3, 1>&, const Body<3>&, const Discretisation&);
template State<3, 1> state_at(const Problem<3, 1>&, const Solution<3, 1>&, const Point<3>&);
template State<3, 1> state_above_level(const Problem<3, 1>&, const Solution<3, 1>&, const Point<3>&);
template std::vector<double> eigenvalues(const Problem<3, 1>&, const Body<3>&, const Discretisation&, Index);

template Solution<2, 2> solve(const Problem<2, 2>&, const Body<2>&, const Discretisation&);
template State<2, 2> state_at(const Problem<2, 2>&, const Solution<2, 2>&, const Point<2>&);
template State<2, 2> state_above_level(const Problem<2, 2>&, const Solution<2, 2>&, const Point<2>&);
template std::vector<double> eigenvalues(const Problem<2, 2>&, const Body<2>&, const Discretisation&, Index);

template Solution<3, 3> solve(const Problem<3, 3>&, const Body<3>&, const Discretisation&);
template State<3, 3> state_at(const Problem<3, 3>&, const Solution<3, 3>&, const Point<3>&);
template State<3, 3> state_above_level(const Problem<3, 3>&, const Solution<3, 3>&, const Point<3>&);
template std::vector<double> eigenvalues(const Problem<3, 3>&, const Body<3>&, const Discretisation&, Index);

}  // namespace bodies
