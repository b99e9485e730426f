#include "bodies/quality.hpp"

#include <algorithm>

#include "base/errors.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "batra2008/basis_at.hpp"
#include "fpm_in_space/section_1_second_order_fpm.hpp"
#include "particles/requirement.hpp"

namespace bodies {

namespace ssph_basis = batra2008::ssph_basis;
namespace second_order_fpm = fpm_in_space::second_order_fpm;

template <int dim, int n>
std::vector<int> highest_derivatives(const Conditions<dim, n>& conditions, Method method) {
    std::vector<int> order;
    for (const auto& here : conditions)
        order.push_back(here.empty() && (method == Method::strong || method == Method::fpm) ? 2 : 1);
    return order;
}

namespace {

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
        const int k = order[static_cast<std::size_t>(I)];
        R[I] = k == no_equations ? 0 : quality_of_row(approximation, I, k);
    });
    return R;
}

/// Whether the derivatives of particle I by FPM can be trusted with other smoothing lengths.
template <int dim>
bool serves(const Cloud<dim>& cloud, const particles::Smoothing<double, dim>& tried, Index I, int k) {
    const auto near = particles::neighbourhood(cloud, tried, I, particles::within_reach(cloud, tried, I));
    const auto weights = second_order_fpm::derivatives<double, dim>(near);
    return largest_quality<dim>(weights, near.r, k, exact_of_fpm) <= ssph_basis::most;
}

/// The remedy, the end of a message, where the derivatives of a particle by FPM cannot be trusted.
template <int dim>
std::string another_smoothing(const Approximation<dim>& approximation, const std::vector<int>& order,
                              Index worst) {
    const Cloud<dim>& cloud = approximation.cloud();
    const auto serves_at = [&](const particles::Smoothing<double, dim>& tried, Index I) {
        const int k = order[static_cast<std::size_t>(I)];
        return k == no_equations || serves<dim>(cloud, tried, I, k);
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

}  // namespace

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
            "fpm: the particle at " + particles::shown_point(cloud.x().col(worst.particle)) +
            " has the quality number " + base::shown(worst.R, 3) + ", more than " +
            base::shown(ssph_basis::most, 3) + ": its derivatives cannot be trusted; " +
            another_smoothing(approximation, order, worst.particle) + or_hats(body, how.method));
    return found;
}

template std::vector<int> highest_derivatives(const Conditions<2, 1>&, Method);
template std::vector<int> highest_derivatives(const Conditions<3, 1>&, Method);
template std::vector<int> highest_derivatives(const Conditions<2, 2>&, Method);
template std::vector<int> highest_derivatives(const Conditions<3, 3>&, Method);
template Quality checked_quality(const Body<2>&, const Approximation<2>&, const std::vector<int>&);
template Quality checked_quality(const Body<3>&, const Approximation<3>&, const std::vector<int>&);

}  // namespace bodies
