#include "asprone2010/section_5_1_derivative_test.hpp"

#include <algorithm>

#include "asprone2010/claims/ledger.hpp"
#include "asprone2010/claims/measures.hpp"

namespace asprone2010::claims {

namespace {

using numerical_tests::discretise;

/// Distance of the particle with the largest error of D²B for eˣ from the nearer end, in spacings; 640
/// particles.
Index distance_from_end(const Formulation<double>& formulation, Volumes volumes) {
    const auto [line, smoothing] = discretise<double>({volumes}, 640, 1);
    const Column<double> f = line.x().exp();
    Index worst = 0;
    (particles::apply(formulation.operators(line, smoothing).D2, f) - f).abs().maxCoeff(&worst);
    return std::min(worst, 639 - worst);
}

/// Error of D²B for eˣ by second-order FPM on particles perturbed by δ/4.
double error_on_perturbed(Index N, Volumes volumes, unsigned long seed) {
    return derivative_test::errors(formulation_named<double>("second_order_fpm"),
                                   discretise<double>({volumes, particles::Gaussian{}, 1, 0.25}, N, seed),
                                   derivative_test::exponential<double>())
        .second;
}

Computation order_of_second_derivative(std::string_view formulation) {
    return order_of_largest_error(formulation, Derivative::second);
}

}  // namespace

report::Computations section_5_1() {
    return {
        // Order of the largest error of D²B for eˣ, a formulation each
        {"A-5.1-original", order_of_second_derivative("original")},
        {"A-5.1-rkpm-first-order", order_of_second_derivative("rkpm_first_order")},
        {"A-5.1-rkpm-second-order", order_of_second_derivative("rkpm_second_order")},
        {"A-5.1-chen-beraun", order_of_second_derivative("chen_beraun")},
        {"A-5.1-modified-fpm", order_of_second_derivative("modified_fpm")},
        {"A-5.1-second-order-fpm", order_of_second_derivative("second_order_fpm")},
        // Largest distance of the worst particle from an end over those that do not converge; then less one
        // spacing
        {"A-5.1-largest-at-end", readings([](Volumes volumes) -> std::vector<Measurement> {
             Index most = 0;
             for (const auto* name : {"original", "rkpm_first_order", "rkpm_second_order", "chen_beraun"})
                 most = std::max(most, distance_from_end(formulation_named<double>(name), volumes));
             const auto distance = static_cast<double>(most);
             return {{"", distance},
                     {"the particle next to an end counts as boundary", std::max(0.0, distance - 1)}};
         })},
        // Order of the median of D²B's error over 51 perturbed lines
        {"A-5.1-perturbed", order_of_median(error_on_perturbed)},
    };
}

}  // namespace asprone2010::claims
