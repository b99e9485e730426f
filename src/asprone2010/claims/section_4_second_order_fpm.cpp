#include "asprone2010/section_4_second_order_fpm.hpp"

#include <Eigen/SVD>
#include <array>

#include "asprone2010/claims/ledger.hpp"
#include "asprone2010/claims/measures.hpp"

namespace asprone2010::claims {

namespace {

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
        // Order of the largest error of DB
        {"A-4-DB-everywhere", order_of_largest_error("second_order_fpm", Derivative::first)},
        // Order of the largest error of D²B
        {"A-4-D2B-everywhere", order_of_largest_error("second_order_fpm", Derivative::second)},
        // Order of D²B at an end, for a function without symmetries
        {"A-4-D2B-at-end", order_at_end(second, D2B, 2)},
    };
}

}  // namespace asprone2010::claims
