#include "batra2008/section_2_ssph_basis.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "batra2008/basis_at.hpp"
#include "batra2008/claims/ledger.hpp"
#include "batra2008/claims/measures.hpp"
#include "report/statistics.hpp"

namespace batra2008::claims {

namespace {

/// The particles in the support around a place beside the origin, and what it sees of them.
struct Seen {
    std::vector<int> particle;
    particles::Neighbourhood<double, 2> near;
};
Seen seen_by(const particles::Cloud<2>& cloud) {
    const particles::Kernel<2> kernel = particles::TruncatedGaussian<2>(3);
    const Point<2> place(0.1, 0);
    const std::vector<int> particle = particles::in_support(cloud, kernel, place, 0.3);
    return {particle, particles::neighbourhood(cloud, kernel, place, 0.3, particle)};
}

/// Asymmetry of the sum of (2.5) relative to its largest entry.
double asymmetry() {
    const auto cloud = random_cloud<2>(60, 3);
    const auto near = seen_by(cloud).near;
    const auto H = ssph_basis::H<2, 2, double>(near.r);
    const auto C = ssph_basis::summed(H, near.W);
    return (C - C.transpose()).cwiseAbs().maxCoeff() / C.cwiseAbs().maxCoeff();
}

/// Largest error of the derivatives of a quadratic with equal weights for all particles.
double error_with_constant_kernel() {
    const auto cloud = random_cloud<2>(60, 2);
    auto [particle, near] = seen_by(cloud);
    near.W.setOnes();
    const ssph_basis::Basis<2, 2> basis(near, particle, 0.3);
    const auto f = [](const Point<2>& x) {
        return 1 + 2 * x[0] - x[1] + 3 * x[0] * x[0] + x[0] * x[1] - 2 * x[1] * x[1];
    };
    const std::array<double, 6> exact{f({0.1, 0}), 2.6, -0.9, 6, -4, 1};
    double most = 0;
    for (Index I = 0; I < 6; ++I) {
        const Column<double> weights =
            ssph_basis::derivative(basis, ssph_basis::monomials<2, 2>()[static_cast<std::size_t>(I)]);
        double sum = 0;
        for (std::size_t j = 0; j < basis.particle().size(); ++j)
            sum += weights[static_cast<Index>(j)] * f(cloud.x().col(basis.particle()[j]));
        most = std::max(most, std::abs(sum - exact[static_cast<std::size_t>(I)]));
    }
    return most;
}

/// What is estimated, by its entry of Q in dim dimensions: f, its derivative by x1, its second derivative by
/// x1.
constexpr Index f = 0, first = 1;
constexpr Index second(int dim) {
    return dim + 1;
}

/// Order in h of the error of an estimate for m = 2. The particles are random and shrink with h towards a
/// place beside the origin. The function exp(k·x) has no symmetries.
template <int dim>
double order_of_error(Index I) {
    const auto cloud = random_cloud<dim>(dim == 1 ? 20 : dim == 2 ? 60 : 300, 1);
    const particles::TruncatedGaussian<dim> kernel(3);
    const Point<dim> place = Point<dim>::Constant(0.05);
    const auto basis = ssph_basis::basis_at<2>(cloud, kernel, place, dim == 1 ? 0.25 : dim == 2 ? 0.3 : 0.33);
    const Column<double> weights =
        ssph_basis::derivative(basis, ssph_basis::monomials<dim, 2>()[static_cast<std::size_t>(I)]);
    const Point<dim> k = Point<dim>::LinSpaced(dim, 1, 0.6);
    const int power = I == f ? 0 : I == first ? 1 : 2;
    const double exact = std::pow(k[0], power);
    const std::vector<double> scales{0.04, 0.02, 0.01};
    std::vector<double> errors;
    for (const double scale : scales) {
        double sum = 0;
        for (std::size_t j = 0; j < basis.particle().size(); ++j)
            sum += weights[static_cast<Index>(j)] *
                   std::exp(scale * k.dot(Point<dim>(cloud.x().col(basis.particle()[j]) - place)));
        errors.push_back(std::abs(sum / std::pow(scale, power) - exact));
    }
    return report::observed_order(scales, errors);
}

/// Smallest singular value of C over its largest.
template <class Matrix>
double reciprocal_condition(const Matrix& C) {
    const auto values = Eigen::JacobiSVD<Matrix, Eigen::NoQRPreconditioner>(C).singularValues();
    return values[values.size() - 1] / values[0];
}

/// Reciprocal condition of C for 12 particles around the origin, in units of h with ρ = 4: on a circle, or on
/// a curve that wobbles about it.
double reciprocal_condition_of_ring(double wobble) {
    constexpr int count = 12;
    Eigen::Array<double, Eigen::Dynamic, 2> s(count, 2);
    for (int j = 0; j < count; ++j) {
        const double angle = 2 * std::numbers::pi * j / count, r = 2 + wobble * std::cos(3 * angle);
        s.row(j) << 0.7 + r * std::cos(angle), 0.2 + r * std::sin(angle);
    }
    const Column<double> W = particles::TruncatedGaussian<2>(4).at(s.square().rowwise().sum().eval());
    return reciprocal_condition<Eigen::Matrix<double, 6, 6>>(
        ssph_basis::summed(ssph_basis::H<2, 2, double>(s), W));
}

/// Reciprocal condition of the one-dimensional C for so many different particles.
double reciprocal_condition_on_line(Index count) {
    const Eigen::Array<double, Eigen::Dynamic, 1> s =
        Eigen::Array<double, Eigen::Dynamic, 1>::LinSpaced(count, -0.7, 1.1);
    const Column<double> W = particles::TruncatedGaussian<1>(4).at(s.square().eval());
    return reciprocal_condition<Eigen::Matrix3d>(ssph_basis::summed(ssph_basis::H<1, 2, double>(s), W));
}

}  // namespace

report::Computations section_2() {
    return {
        // Asymmetry of C as the sum (2.5)
        {"B-2-symmetric", measured(asymmetry)},
        // Error of all derivatives of a quadratic with W = 1
        {"B-2-constant-kernel", measured(error_with_constant_kernel)},
        // Order of the error of f, of its first and of its second derivative, in one dimension
        {"B-2-1d-f", measured([] { return order_of_error<1>(f); })},
        {"B-2-1d-first", measured([] { return order_of_error<1>(first); })},
        {"B-2-1d-second", measured([] { return order_of_error<1>(second(1)); })},
        // In two dimensions
        {"B-2-2d-f", measured([] { return order_of_error<2>(f); })},
        {"B-2-2d-first", measured([] { return order_of_error<2>(first); })},
        {"B-2-2d-second", measured([] { return order_of_error<2>(second(2)); })},
        // In three dimensions
        {"B-2-3d-f", measured([] { return order_of_error<3>(f); })},
        {"B-2-3d-first", measured([] { return order_of_error<3>(first); })},
        {"B-2-3d-second", measured([] { return order_of_error<3>(second(3)); })},
        // Reciprocal condition of C for 12 particles on a circle, then on a curve of higher degree
        {"B-2-regular", readings([]() -> std::vector<Measurement> {
             return {
                 {"", reciprocal_condition_of_ring(0)},
                 {"no curve of second degree runs through all particles", reciprocal_condition_of_ring(0.5)}};
         })},
        // Reciprocal condition of C for three particles on a line
        {"B-2-three-suffice", measured([] { return reciprocal_condition_on_line(3); })},
        // For two
        {"B-2-three-necessary", measured([] { return reciprocal_condition_on_line(2); })},
    };
}

}  // namespace batra2008::claims
