#include "asprone2010/section_4_second_order_fpm.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>

#include "asprone2010/claims/ledger.hpp"
#include "asprone2010/claims/measures.hpp"

namespace asprone2010::claims {

namespace {

using particles::Gaussian;

Column<double> second(const Neighbourhood<double>& near) {
    return second_order_fpm::derivatives(near).second;
}

/// Reciprocal condition of the matrix of (42) for a polynomial with these exponents.
double reciprocal_condition(const Neighbourhood<double>& near, const std::array<int, 3>& exponents) {
    constexpr std::array moments{0, 1, 3};
    Eigen::Matrix3d M;
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t k = 0; k < 3; ++k)
            M(static_cast<Index>(row), static_cast<Index>(k)) =
                (near.r.pow(moments[row] + exponents[k]) * near.W * near.V).sum();
    const auto values = Eigen::JacobiSVD<Eigen::Matrix3d, Eigen::NoQRPreconditioner>(M).singularValues();
    return values[2] / values[0];
}

/// The second particle of a line at distances of 1 behind a first gap, with h = 2.
Neighbourhood<double> behind_a_gap(double gap, Volumes volumes) {
    Column<double> x = Column<double>::LinSpaced(20, gap - 1, gap + 18);
    x[0] = 0;
    return particles::neighbourhood(particles::line_at(x, volumes),
                                    particles::Smoothing<double>(Gaussian{}, 2.0), 1);
}

/// \f$A_{12}\f$ of (43), in units of h².
double A12(const Neighbourhood<double>& near) {
    return modified_fpm::matrix(second_order_fpm::corrected(near))(0, 1);
}

/// |A12| behind the gap at which it changes its sign, found by bisection.
double A12_at_its_zero(Volumes volumes) {
    double negative = 0.01, positive = 1;
    for (int k = 0; k < 60; ++k) {
        const double middle = (negative + positive) / 2;
        (A12(behind_a_gap(middle, volumes)) < 0 ? negative : positive) = middle;
    }
    return std::abs(A12(behind_a_gap(positive, volumes)));
}

/// Largest difference between the corrected kernel and W, which is divided by its discrete integral or not,
/// inside.
double difference_of_kernels(Volumes volumes, bool divided) {
    return over_particles(volumes, Where::interior, [=](const Neighbourhood<double>& near) {
        const double integral = divided ? (near.W * near.V).sum() : 1;
        return (second_order_fpm::corrected(near).W - near.W / integral).abs().maxCoeff();
    });
}

}  // namespace

report::Computations section_4() {
    return {
        // Smallest reciprocal condition of (42) with the cubic, over all particles
        {"A-4-cubic-regular", measured([](Volumes volumes) {
             return 1 / over_particles(volumes, Where::all, [](const Neighbourhood<double>& near) {
                        return 1 / reciprocal_condition(near, {3, 1, 0});
                    });
         })},
        // Smallest reciprocal condition of (42) with the cubic behind first gaps of 0.01 to 1
        {"A-4-cubic-regular-short-gap", measured([](Volumes volumes) {
             double least = 1;
             for (int k = 1; k <= 100; ++k)
                 least = std::min(least, reciprocal_condition(behind_a_gap(0.01 * k, volumes), {3, 1, 0}));
             return least;
         })},
        // Largest reciprocal condition of (42) with a quadratic, inside
        {"A-4-quadratic-singular", measured([](Volumes volumes) {
             return over_particles(volumes, Where::interior, [](const Neighbourhood<double>& near) {
                 return reciprocal_condition(near, {2, 1, 0});
             });
         })},
        // Largest difference between the corrected kernel and W inside, then W over its discrete integral
        {"A-4-kernel-inside", readings([](Volumes volumes) -> std::vector<Measurement> {
             return {{"", difference_of_kernels(volumes, false)},
                     {"W is divided by its discrete integral, 1.0001", difference_of_kernels(volumes, true)}};
         })},
        // Largest A11 of (43) on perturbed particles
        {"A-4-entry-vanishes", measured([](Volumes volumes) {
             const auto A11 = [](const Neighbourhood<double>& near) {
                 return modified_fpm::matrix(second_order_fpm::corrected(near))(0, 0);
             };
             return over_particles(volumes, Where::all, A11, 0.25);
         })},
        // Smallest |A12| of (43) on any particles, then with h = δ on perturbed ones
        {"A-4-system-regular", readings([](Volumes volumes) -> std::vector<Measurement> {
             const auto inverse = [](const Neighbourhood<double>& near) { return 1 / A12(near); };
             return {{"", A12_at_its_zero(volumes)},
                     {"h = δ, particles moved by at most δ/4",
                      1 / over_particles(volumes, Where::all, inverse, 0.25)}};
         })},
        // Order of the largest error of DB
        {"A-4-DB-everywhere", order_of_largest_error("second_order_fpm", Derivative::first)},
        // Order of the largest error of D²B
        {"A-4-D2B-everywhere", order_of_largest_error("second_order_fpm", Derivative::second)},
        // Order of D²B at an end, for a function without symmetries
        {"A-4-D2B-at-end", order_at_end(second, D2B, 2)},
    };
}

}  // namespace asprone2010::claims
