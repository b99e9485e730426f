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

/// Smallest |det A| of (43) in units of h, with h = δ, over all particles and 51 perturbed lines.
double least_determinant(Volumes volumes) {
    const auto inverse = [](const Neighbourhood<double>& near) {
        return 1 / modified_fpm::matrix(second_order_fpm::corrected(near)).determinant();
    };
    double most = 0;
    for (unsigned long seed = 1; seed <= 51; ++seed)
        most = std::max(most, over_particles(volumes, Where::all, inverse, 0.25, seed));
    return 1 / most;
}

/// Largest difference between W inside and the kernel that the sums (42) correct, in units of 1/h.
double difference_by_sums(Volumes volumes) {
    return over_particles(volumes, Where::interior, [](const Neighbourhood<double>& near) {
        return (second_order_fpm::corrected(near).W - near.W).abs().maxCoeff();
    });
}

/// The same for the kernel that the integrals (41) correct.
double difference_by_integrals() {
    return largest(inside, [](double x) {
        const CentredKernel W_i = kernel_at(x), K_i = second_order_fpm::corrected(W_i);
        double most = 0;
        for (int k = -30; k <= 30; ++k) {
            const double at = x + 0.1 * k * W_i.h;
            most = std::max(most, W_i.h * std::abs(K_i.W(at) - W_i.W(at)));
        }
        return most;
    });
}

/// \f$e'''_1\f$ of (43) over the norm of K, and \f$e'''_2\f$ over that of DK.
double first_e_43(const CentredKernel& W_i) {
    const CentredKernel K_i = second_order_fpm::corrected(W_i);
    return modified_fpm::first_remainder(B, DB(W_i.x), D2B(W_i.x), K_i) / K_i.norm(K_i.W);
}
double second_e_43(const CentredKernel& W_i) {
    const CentredKernel K_i = second_order_fpm::corrected(W_i);
    return modified_fpm::second_remainder(B, DB(W_i.x), D2B(W_i.x), K_i) / K_i.norm(K_i.DW);
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
        // Largest difference between the corrected kernel and W inside, by sums, then by integrals
        {"A-4-kernel-inside", readings([](Volumes volumes) -> std::vector<Measurement> {
             return {{"", difference_by_sums(volumes)},
                     {"the conditions are the integrals (41)", difference_by_integrals()}};
         })},
        // Largest A11 of (43) on perturbed particles
        {"A-4-entry-vanishes", measured([](Volumes volumes) {
             const auto A11 = [](const Neighbourhood<double>& near) {
                 return modified_fpm::matrix(second_order_fpm::corrected(near))(0, 0);
             };
             return over_particles(volumes, Where::all, A11, 0.25);
         })},
        // Smallest |det A| of (43) on perturbed particles
        {"A-4-system-regular", measured(least_determinant)},
        // Orders of the remainders over the norms
        {"A-4-e-43-first", order_everywhere(first_e_43)},
        {"A-4-e-43-second", order_everywhere(second_e_43)},
        // Order of the largest error of DB
        {"A-4-DB-everywhere", order_of_largest_error("second_order_fpm", Derivative::first)},
        // Order of the largest error of D²B
        {"A-4-D2B-everywhere", order_of_largest_error("second_order_fpm", Derivative::second)},
        // Order of D²B at an end, for a function without symmetries
        {"A-4-D2B-at-end", order_at_end(second, D2B, 2)},
    };
}

}  // namespace asprone2010::claims
