#include "fpm_in_space/section_1_second_order_fpm.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fpm_in_space/claims/ledger.hpp"
#include "fpm_in_space/claims/measures.hpp"
#include "solvers/condition.hpp"

namespace fpm_in_space::claims {

namespace {

using particles::Exponents;
using particles::Point;

/// A polynomial with all monomials up to a degree, and its derivatives.
template <int dim, int degree>
double polynomial(const Point<dim>& x, const Exponents<dim>& a) {
    double sum = 0, coefficient = 1;
    for (const Exponents<dim>& b : particles::monomials<dim, degree>()) {
        double term = coefficient;
        for (std::size_t k = 0; k < dim; ++k) {
            for (int l = 0; l < a[k]; ++l) term *= b[k] - l;
            for (int l = a[k]; l < b[k]; ++l) term *= x[static_cast<Index>(k)];
        }
        sum += term;
        coefficient = -0.9 * coefficient;
    }
    return sum;
}

/// Particles perturbed by nearly half of their distance.
template <int dim>
Body<dim> irregular() {
    return derivative_test::body<dim>(dim == 2 ? 16 : 8, 0.45, 1);
}

/// Largest error of the derivatives of an order, for a polynomial of a degree, over their largest value.
template <int dim, int degree>
double relative_error(int order) {
    const auto [cloud, on_sides] = irregular<dim>();
    const auto found = derivative_test::largest(derivative_test::errors<dim>(
        formulation_named<double, dim>("definite_fpm"), cloud, gaussian<dim>(cloud.spacing()),
        Column<double>::Constant(1, cloud.spacing()), polynomial<dim, degree>, {{0, cloud.size()}})[0]);
    double size = 0;
    for (const Exponents<dim>& a : particles::monomials<dim, 2>())
        if (particles::order<dim>(a) == order)
            for (Index i = 0; i < cloud.size(); ++i)
                size = std::max(size, std::abs(polynomial<dim, degree>(cloud.x().col(i), a)));
    return (order == 1 ? found.first : found.second) / size;
}

/// Calls a function with neighbourhoods of each place, with fewer neighbours and with more.
template <int dim, class Visit>
void for_each_neighbourhood(const Visit& visit) {
    const auto [cloud, on_sides] = irregular<dim>();
    for (const particles::Range& place : on_sides)
        for (Index i = place.first; i < std::min(place.last, place.first + 20); ++i)
            for (const double reach : {4.0, 6.0}) {
                const Smoothing<double, dim> smoothing(particles::TruncatedGaussian<dim>(reach),
                                                       cloud.spacing());
                visit(particles::neighbourhood(cloud, smoothing, i,
                                               particles::within_reach(cloud, smoothing, i)));
            }
}

/// Largest relative difference of the weights of D²B from those of SSPH of degree 3 with the value given.
template <int dim>
double difference_from_ssph() {
    double most = 0;
    for_each_neighbourhood<dim>([&](const Neighbourhood<double, dim>& near) {
        const auto ours = second_order_fpm::derivatives(near).second,
                   theirs = ssph_with_value_given<3>(near).second;
        most = std::max(most, (ours - theirs).abs().maxCoeff() / theirs.abs().maxCoeff());
    });
    return most;
}

/// Least eigenvalue of the matrix of \eq{F5}, scaled to a unit diagonal, over the largest.
template <int dim>
double least_eigenvalue_of_matrix() {
    double least = 1;
    for_each_neighbourhood<dim>([&](const Neighbourhood<double, dim>& near) {
        using namespace second_order_fpm;
        const auto products = moments(near);
        const Table<double> p2 = polynomials<double, dim>(quadratic<dim>);
        const Eigen::MatrixXd M = product(corrections<dim>(p2, products), p2, products);
        const Eigen::VectorXd scale = M.diagonal().cwiseSqrt().cwiseInverse();
        least = std::min(least, solvers::reciprocal_condition(scale.asDiagonal() * M * scale.asDiagonal()));
    });
    return least;
}

/// Least M of \eq{F5} over \f$\sum_j r_j^4 W_j V_j\f$ at the second particle of lines with a short first gap.
double least_behind_short_gap() {
    double least = 1;
    for (int k = 1; k <= 1000; ++k) {
        Column<double> x = Column<double>::LinSpaced(40, -1, 38);
        x[0] = -k / 1000.0;
        x[1] = 0;
        x.tail(38) = Column<double>::LinSpaced(38, 1, 38);
        const auto line = particles::line_at(x, particles::Volumes::equal);
        const auto near = particles::neighbourhood(line, Smoothing<double>(particles::Gaussian<1>{}, 2), 1);
        using namespace second_order_fpm;
        const auto products = moments(near);
        const Table<double> p2 = polynomials<double, 1>(quadratic<1>);
        least = std::min(least, product(corrections<1>(p2, products), p2, products)(0, 0) /
                                    product(p2, p2, products)(0, 0));
    }
    return least;
}

}  // namespace

report::Computations section_1() {
    return {
        // Error of D²B for a cubic on irregular particles
        {"F-1-D2-exact", measured([](auto dim) { return relative_error<dim, 3>(2); })},
        // Error of DB for a quadratic
        {"F-1-D-exact", measured([](auto dim) { return relative_error<dim, 2>(1); })},
        // Difference of the weights from those of SSPH
        {"F-1-ssph", measured([](auto dim) { return difference_from_ssph<dim>(); })},
        // Least eigenvalue of the matrix
        {"F-1-definite", measured([](auto dim) { return least_eigenvalue_of_matrix<dim>(); })},
        // Least matrix on a line, a number, behind a thousand first gaps
        {"F-1-no-zero", measured_once(least_behind_short_gap)},
    };
}

}  // namespace fpm_in_space::claims
