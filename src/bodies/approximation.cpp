#include "bodies/approximation.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "base/choose.hpp"
#include "base/errors.hpp"
#include "batra2008/basis_at.hpp"
#include "fpm_in_space/section_1_second_order_fpm.hpp"
#include "fpm_in_space/ssph_with_value_given.hpp"
#include "particles/local_system.hpp"
#include "particles/on_values.hpp"
#include "particles/requirement.hpp"

namespace bodies {

namespace ssph_basis = batra2008::ssph_basis;
namespace second_order_fpm = fpm_in_space::second_order_fpm;
using fpm_in_space::cut;

namespace {

template <int dim>
using Kernel = particles::TruncatedGaussian<dim>;

template <class Work>
auto with_degree(int degree, const Work& work) {
    if (degree == 2) return work(std::integral_constant<int, 2>{});
    if (degree == 3) return work(std::integral_constant<int, 3>{});
    throw base::InvalidInput("the degree of the monomials must be 2 or 3, got " + std::to_string(degree));
}

template <int dim, int m>
Weights<dim> of_basis(const ssph_basis::Basis<dim, m>& basis, bool differentiated, Derivatives which) {
    const auto count = static_cast<Index>(basis.particle().size());
    Weights<dim> weights{basis.particle(), basis.row(1), Offsets<double, dim>(count, dim), {}};
    for (int axis = 0; axis < dim; ++axis)
        weights.first.col(axis) = differentiated ? basis.DK(1, axis) : basis.row(2 + axis);
    if (which == Derivatives::first) return weights;
    weights.second.resize(count, second_derivatives<dim>);
    static constexpr auto all = particles::monomials<dim, 2>();
    for (Index k = 0; k < second_derivatives<dim>; ++k)
        weights.second.col(k) =
            particles::factorial<dim>(all[static_cast<std::size_t>(1 + dim + k)]) * basis.row(2 + dim + k);
    return weights;
}

/// Weights on differences from the value at a particle, as weights on values.
template <int dim>
Weights<dim> of_differences(const particles::Derivatives<double, dim>& derivatives, std::vector<int> particle,
                            Index I, double h) {
    const auto count = static_cast<Index>(particle.size());
    const Index own = std::lower_bound(particle.begin(), particle.end(), I) - particle.begin();
    Column<double> value = Column<double>::Zero(count);
    value[own] = 1;
    return {std::move(particle), std::move(value),
            particles::on_values<double, dim>(derivatives.first / h, own),
            particles::on_values<double, second_derivatives<dim>>(derivatives.second / (h * h), own)};
}

/// The Taylor polynomial of degree 2 around a particle.
template <int dim>
Weights<dim> moved(Weights<dim> at, const Point<dim>& s) {
    static constexpr auto all = particles::monomials<dim, 2>();
    for (int axis = 0; axis < dim; ++axis) at.value += s[axis] * at.first.col(axis);
    for (Index k = 0; k < second_derivatives<dim>; ++k) {
        const auto& a = all[static_cast<std::size_t>(1 + dim + k)];
        at.value += ssph_basis::power<dim>(s, a) / particles::factorial<dim>(a) * at.second.col(k);
        for (int axis = 0; axis < dim; ++axis) {
            auto lower = a;
            if (lower[static_cast<std::size_t>(axis)]-- == 0) continue;
            at.first.col(axis) +=
                ssph_basis::power<dim>(s, lower) / particles::factorial<dim>(lower) * at.second.col(k);
        }
    }
    return at;
}

/// "try --smoothing 1.6, or ", where that determines the derivatives of FPM at all particles.
template <int dim>
std::string smoothing_that_determines(const Approximation<dim>& approximation) {
    constexpr auto required = second_order_fpm::required<dim>;
    const Cloud<dim>& cloud = approximation.cloud();
    if (!particles::more_particles(cloud, required).empty()) return "";
    const std::string other = particles::other_smoothing(
        cloud, approximation.smoothing(), required.particles,
        [&](const particles::Smoothing<double, dim>& tried) {
            return particles::determined(cloud, tried, required, second_order_fpm::derivatives<double, dim>);
        });
    return other.empty() ? "" : "try " + other + ", or ";
}

}  // namespace

const std::vector<std::pair<std::string, Method>>& methods() {
    static const std::vector<std::pair<std::string, Method>> all{{"fpm", Method::fpm},
                                                                 {"strong", Method::strong},
                                                                 {"weak1", Method::weak1},
                                                                 {"weak2", Method::weak2},
                                                                 {"hats", Method::hats}};
    return all;
}

std::string name(Method method) {
    return std::find_if(methods().begin(), methods().end(),
                        [&](const auto& one) { return one.second == method; })
        ->first;
}

Method method_named(std::string_view wanted) {
    return base::choose("method", wanted, methods());
}

bool works(Method method, int dim, bool has_cells) {
    if (method == Method::hats) return has_cells;
    return dim == 2 || (method != Method::weak1 && method != Method::weak2);
}

template <int dim>
Approximation<dim>::Approximation(Cloud<dim> cloud, const Discretisation& how)
    : cloud_(std::move(cloud)), how_(how) {
    const Column<double> spacing = particles::spacing(cloud_, how.spacing);
    h_ = spacing.size() == 1 ? Column<double>(Column<double>::Constant(cloud_.size(), spacing[0])) : spacing;
    if (how.method == Method::fpm) h_ *= how.smoothing;
}

template <int dim>
particles::Smoothing<double, dim> Approximation<dim>::smoothing() const {
    return {Kernel<dim>(cut<dim>), Column<double>(h_ / how_.smoothing), how_.smoothing};
}

template <int dim>
double Approximation<dim>::reach(Index I) const {
    return (how_.method == Method::fpm ? cut<dim> : how_.scaling) * h_[I];
}

template <int dim>
std::vector<int> Approximation<dim>::neighbours(Index I) const {
    return cloud_.within(cloud_.x().col(I), reach(I));
}

template <int dim>
std::vector<int> Approximation<dim>::neighbours_at(const Point<dim>& x) const {
    const Index I = cloud_.nearest(x);
    return how_.method == Method::fpm ? neighbours(I) : cloud_.within(x, reach(I));
}

template <int dim>
Weights<dim> Approximation<dim>::at_particle(Index I, Derivatives which) const {
    const Point<dim> x = cloud_.x().col(I);
    if (how_.method != Method::fpm) return at(x, which);
    std::vector<int> near = neighbours(I);
    const Kernel<dim> kernel(cut<dim>);
    try {
        return of_differences<dim>(second_order_fpm::derivatives<double, dim>(
                                       particles::neighbourhood(cloud_, kernel, x, h_[I], near)),
                                   near, I, h_[I]);
    } catch (const particles::SingularNeighbourhood& error) {
        throw base::FailedComputation("fpm: at " + particles::shown_point(x) + " there are " +
                                      std::to_string(near.size()) + " particles within " +
                                      particles::shown(cut<dim> * h_[I]) + ", and " + error.what() + "; " +
                                      smoothing_that_determines(*this) + "take more or other particles");
    }
}

template <int dim>
Weights<dim> Approximation<dim>::at(const Point<dim>& x, Derivatives which) const {
    const Index I = cloud_.nearest(x);
    if (how_.method == Method::fpm) return moved(at_particle(I), Point<dim>(x - cloud_.x().col(I)));
    return at(x, h_[I], cloud_.within(x, reach(I)), which);
}

template <int dim>
Weights<dim> Approximation<dim>::at(const Point<dim>& x, double h, const std::vector<int>& among,
                                    Derivatives which) const {
    const bool differentiated = how_.method == Method::weak2;
    return with_degree(how_.degree, [&](auto m) {
        return of_basis<dim, m>(
            ssph_basis::basis_at<m>(cloud_, Kernel<dim>(how_.scaling), x, h, among,
                                    differentiated ? ssph_basis::Slopes::known : ssph_basis::Slopes::none,
                                    h_),
            differentiated, which);
    });
}

template <int dim>
Index Approximation<dim>::least_neighbours() const {
    return how_.method != Method::fpm && how_.degree == 3 ? particles::terms<dim, 3>
                                                          : particles::terms<dim, 2>;
}

template <int dim>
Weights<dim> Approximation<dim>::at_particle_from_nearest(Index I, Index enough) const {
    const Point<dim> x = cloud_.x().col(I);
    const bool fpm = how_.method == Method::fpm;
    const Kernel<dim> kernel(fpm ? cut<dim> : how_.scaling);
    return with_degree(fpm ? 2 : how_.degree, [&](auto m) {
        const std::vector<int> near =
            ssph_basis::nearest_that_determine<m, dim>(cloud_, kernel, I, h_[I], enough);
        if (!fpm)
            return of_basis<dim, m>(
                ssph_basis::basis_at<m>(cloud_, kernel, x, h_[I], near, ssph_basis::Slopes::none, h_), false,
                Derivatives::second);
        return of_differences<dim>(
            fpm_in_space::ssph_with_value_given<m>(particles::neighbourhood(cloud_, kernel, x, h_[I], near)),
            near, I, h_[I]);
    });
}

template class Approximation<2>;
template class Approximation<3>;

}  // namespace bodies
