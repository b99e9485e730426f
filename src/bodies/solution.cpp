#include "bodies/solution.hpp"

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
#include "fpm_in_space/section_1_second_order_fpm.hpp"
#include "particles/multi_index.hpp"
#include "particles/quality.hpp"
#include "particles/requirement.hpp"
#include "solvers/sparse_spectrum.hpp"

namespace bodies {

namespace {

namespace ssph_basis = batra2008::ssph_basis;
namespace second_order_fpm = fpm_in_space::second_order_fpm;

/// The order of the highest derivative in the equations of each particle.
template <int dim, int n>
std::vector<int> highest_derivatives(const Conditions<dim, n>& conditions, Method method) {
    std::vector<int> order;
    for (const auto& here : conditions)
        order.push_back(here.empty() && (method == Method::strong || method == Method::fpm) ? 2 : 1);
    return order;
}

constexpr int exact_of_fpm = 3;  // degree of the polynomials whose second derivatives are exact

/// The largest R of the derivatives of order k. \param w weights and \param r offsets, in units of h
template <int dim>
double largest_quality(const particles::Derivatives<double, dim>& w, const Offsets<double, dim>& r, int k,
                       int exact) {
    double largest = 0;
    if (k == 1)
        for (int axis = 0; axis < dim; ++axis)
            largest = std::max(largest, particles::quality<double, dim>(w.first.col(axis), r, exact));
    else
        for (int pair = 0; pair < second_derivatives<dim>; ++pair)
            largest = std::max(largest, particles::quality<double, dim>(w.second.col(pair), r, exact));
    return largest;
}

/// R of the derivatives of order k at a particle, in units of h.
template <int dim>
double quality_of_row(const Approximation<dim>& approximation, Index I, int k) {
    const int exact = approximation.how().method == Method::fpm ? exact_of_fpm : approximation.how().degree;
    const Weights<dim> at = approximation.at_particle(I);
    const double h = approximation.h()[I];
    Offsets<double, dim> r(static_cast<Index>(at.particle.size()), dim);
    for (std::size_t j = 0; j < at.particle.size(); ++j)
        r.row(static_cast<Index>(j)) =
            (approximation.cloud().x().col(at.particle[j]) - approximation.cloud().x().col(I)).transpose() /
            h;
    return largest_quality<dim>({h * at.first, h * h * at.second}, r, k, exact);
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

/// R of each particle, and the worst row.
struct Quality {
    Column<double> R;
    particles::WorstRow worst;
};

/// ", or the method hats" where that is another method, which works on the body.
template <int dim>
std::string or_hats(const Body<dim>& body, Method method) {
    return body.cells.empty() || method == Method::hats ? "" : ", or the method hats";
}

/// Whether the derivatives of particle I by FPM can be trusted with other smoothing lengths.
template <int dim>
bool serves(const Cloud<dim>& cloud, const particles::Smoothing<double, dim>& tried, Index I, int k) {
    const auto near = particles::neighbourhood(cloud, tried, I, particles::within_reach(cloud, tried, I));
    const auto weights = second_order_fpm::derivatives<double, dim>(near);
    return largest_quality<dim>(weights, near.r, k, exact_of_fpm) <= ssph_basis::most;
}

/// What helps where the derivatives of a particle by FPM cannot be trusted: the end of a sentence.
template <int dim>
std::string another_smoothing(const Approximation<dim>& approximation, const std::vector<int>& order,
                              Index worst) {
    const Cloud<dim>& cloud = approximation.cloud();
    const auto serves_at = [&](const particles::Smoothing<double, dim>& tried, Index I) {
        return serves<dim>(cloud, tried, I, order[static_cast<std::size_t>(I)]);
    };
    const auto serves_all = [&](const particles::Smoothing<double, dim>& tried) {
        try {
            Index I = serves_at(tried, worst) ? 0 : cloud.size() + 1;
            while (I < cloud.size() && serves_at(tried, I)) ++I;
            return I == cloud.size();
        } catch (const base::FailedComputation&) {
            return false;
        }
    };
    return particles::another_smoothing(cloud, approximation.smoothing(),
                                        second_order_fpm::required<dim>.particles, serves_all);
}

/// \throws base::FailedComputation where the worst row is too bad for a solution
template <int dim>
Quality checked_quality(const Body<dim>& body, const Approximation<dim>& approximation,
                        const std::vector<int>& order) {
    const Discretisation& how = approximation.how();
    const Cloud<dim>& cloud = approximation.cloud();
    if (how.method != Method::fpm) {
        const particles::TruncatedGaussian<dim> kernel(how.scaling);
        const particles::WorstRow worst =
            how.degree == 2 ? ssph_basis::require_quality<2, dim>(cloud, kernel, approximation.h(), order)
                            : ssph_basis::require_quality<3, dim>(cloud, kernel, approximation.h(), order);
        return {qualities(approximation, order), worst};
    }
    Quality found{qualities(approximation, order), {}};
    auto& [R, worst] = found;
    worst.R = R.maxCoeff(&worst.particle);
    worst.derivative = order[static_cast<std::size_t>(worst.particle)];
    if (worst.R > ssph_basis::most)
        throw base::FailedComputation(
            "fpm: particle " + std::to_string(worst.particle) + " at " +
            particles::shown_point(cloud.x().col(worst.particle)) + " has the quality number " +
            base::shown(worst.R, 3) + ", more than " + base::shown(ssph_basis::most, 3) +
            ": its derivatives cannot be trusted; " +
            another_smoothing(approximation, order, worst.particle) + or_hats(body, how.method));
    return found;
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
    throw base::InvalidInput(name(method) + ": works in the plane; in space take " +
                             (body.cells.empty() ? "" : "hats, ") + "fpm or strong");
}

/// Quality number above which hats do without monomials of degree 3. It is 2 to 3 in the plane, 10 to 20 in
/// space, and 287 in a fin of two cells, whose temperature is then wrong.
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

/// For hats whose neighbours do not determine monomials of degree 3 well, with those of degree 2.
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
    require_held(problem, body, all);
    auto [approximation, quality, system] = equations(problem, body, all, how, Wanted::solution);
    const auto& [R, worst] = quality;
    auto& [A, b, nearest, M] = system;
    Eigen::VectorXd u = solvers::solve_sparse(std::move(A), std::move(b), std::move(nearest));
    return {std::move(approximation), std::move(all), R, worst.R, worst.particle, std::move(u)};
}

template <int dim, int n>
State<dim, n> state_at(const Problem<dim, n>& problem, const Solution<dim, n>& solution,
                       const Point<dim>& x) {
    const Weights<dim> at = solution.approximation.at(x);
    State<dim, n> state{
        combined<n>(at.particle, at.value, solution.u), combined<n>(at.particle, at.first, solution.u), {}};
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
    require_held(problem, body, all);
    if (count < 1 || count > body.x.cols() / 2)
        throw base::InvalidInput("a body of " + std::to_string(body.x.cols()) + " particles has from 1 to " +
                                 std::to_string(body.x.cols() / 2) + " modes worth computing, not " +
                                 std::to_string(count));
    const System system = equations(problem, body, all, how, Wanted::eigenvalues).system;
    std::vector<double> lowest;
    for (const std::complex<double>& mu : solvers::largest_of_inverse(system.A, system.M, count)) {
        const std::complex<double> lambda = 1.0 / mu;
        if (std::abs(lambda.imag()) > 1e-2 * std::abs(lambda) || lambda.real() < 0)
            throw base::FailedComputation(
                name(how.method) + ": the eigenvalue " + base::shown(lambda.real(), 4) +
                (lambda.imag() == 0 ? "" : " with an imaginary part of " + base::shown(lambda.imag(), 2)) +
                " is that of no vibration; take more particles" + or_hats(body, how.method));
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
template std::vector<double> eigenvalues(const Problem<2, 1>&, const Body<2>&, const Discretisation&, Index);

template Solution<3, 1> solve(const Problem<3, 1>&, const Body<3>&, const Discretisation&);
template State<3, 1> state_at(const Problem<3, 1>&, const Solution<3, 1>&, const Point<3>&);
template std::vector<double> eigenvalues(const Problem<3, 1>&, const Body<3>&, const Discretisation&, Index);

template Solution<2, 2> solve(const Problem<2, 2>&, const Body<2>&, const Discretisation&);
template State<2, 2> state_at(const Problem<2, 2>&, const Solution<2, 2>&, const Point<2>&);
template std::vector<double> eigenvalues(const Problem<2, 2>&, const Body<2>&, const Discretisation&, Index);

template Solution<3, 3> solve(const Problem<3, 3>&, const Body<3>&, const Discretisation&);
template State<3, 3> state_at(const Problem<3, 3>&, const Solution<3, 3>&, const Point<3>&);
template std::vector<double> eigenvalues(const Problem<3, 3>&, const Body<3>&, const Discretisation&, Index);

}  // namespace bodies
