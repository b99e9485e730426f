#include "asprone2010/section_5_3_vibration_test.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numeric>

#include "asprone2010/claims/ledger.hpp"
#include "asprone2010/claims/measures.hpp"

namespace asprone2010::claims {

namespace {

using numerical_tests::discretise;
using vibration_test::exact_frequency;

/// The formulations whose curves overlap in Figure 3.
constexpr std::array three{"chen_beraun", "modified_fpm", "second_order_fpm"};

/// Frequencies over the exact ones, mode by mode.
std::vector<double> normalised(const std::vector<std::complex<double>>& frequencies) {
    std::vector<double> ratio;
    ratio.reserve(frequencies.size());
    for (const auto& omega : frequencies)
        ratio.push_back(omega.real() / exact_frequency(static_cast<Index>(ratio.size()) + 1));
    return ratio;
}

/// Normalised frequencies of N particles.
std::vector<double> ratios(std::string_view formulation, Volumes volumes, Index N = 100) {
    return normalised(vibration_test::frequencies(formulation_named<double>(formulation),
                                                  discretise<double>({volumes}, N, 1)));
}

/// Those of finite elements with lumped mass between the same particles.
std::vector<double> finite_element_ratios() {
    return normalised(vibration_test::finite_element_frequencies(discretise<double>({}, 100, 1).line,
                                                                 vibration_test::Mass::lumped));
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
    double most = 0;
    for (std::size_t k = 0; k < a.size(); ++k) most = std::max(most, std::abs(a[k] - b[k]));
    return most;
}

double largest_relative_difference(const std::vector<double>& a, const std::vector<double>& reference) {
    double most = 0;
    for (std::size_t k = 0; k < a.size(); ++k)
        most = std::max(most, std::abs(a[k] - reference[k]) / reference[k]);
    return most;
}

Computation mean_of_five_lowest(std::string_view formulation) {
    return measured([=](Volumes volumes) {
        const auto ratio = ratios(formulation, volumes);
        return std::accumulate(ratio.begin(), ratio.begin() + 5, 0.0) / 5;
    });
}

Computation tenth_over_first(std::string_view formulation) {
    return measured([=](Volumes volumes) {
        const auto ratio = ratios(formulation, volumes);
        return ratio[9] / ratio[0];
    });
}

/// What (47) leaves over ω²x of x = sin(ωX) cos(ωt) at X = 0.3, t = 0, where ∂²x/∂X² = ∂²x/∂t² = −ω²x.
double unbalance(double sign_of_acceleration) {
    const double omega = exact_frequency(1), x = vibration_test::mode(omega, 0.3);
    const double D2x = vibration_test::acceleration(omega, x);
    return std::abs(vibration_test::unbalance(D2x, sign_of_acceleration * D2x)) / (omega * omega * x);
}

/// What (48) with a sign before ω²x leaves of the same vibration, whose acceleration is a central difference.
double unbalance_of_48(double sign) {
    const double omega = exact_frequency(1), x = vibration_test::mode(omega, 0.3), step = 1e-4;
    const double acceleration = 2 * x * (std::cos(omega * step) - 1) / (step * step);
    return std::abs(acceleration - sign * omega * omega * x) / (omega * omega * x);
}

/// Eigenvalue of K nearest to zero by second-order FPM, over the square of the lowest exact frequency.
double lowest_eigenvalue(Volumes volumes) {
    const auto [line, smoothing] = discretise<double>({volumes}, 100, 1);
    const auto K = vibration_test::stiffness(
        formulation_named<double>("second_order_fpm").operators(line, smoothing).D2);
    double most = -HUGE_VAL;
    for (const auto& lambda : solvers::eigenvalues(K)) most = std::max(most, lambda.real());
    return most / (exact_frequency(1) * exact_frequency(1));
}

}  // namespace

report::Computations section_5_3() {
    return {
        // Largest |sin(ω_n)| of the 98 frequencies πn
        {"A-5.3-end-conditions", measured([] {
             double most = 0;
             for (Index n = 1; n <= 98; ++n)
                 most = std::max(most, std::abs(vibration_test::mode(exact_frequency(n), 1)));
             return most;
         })},
        // Mean ratio of the five lowest modes
        {"A-5.3-lowest-original", mean_of_five_lowest("original")},
        {"A-5.3-lowest-rkpm-first-order", mean_of_five_lowest("rkpm_first_order")},
        {"A-5.3-lowest-rkpm-second-order", mean_of_five_lowest("rkpm_second_order")},
        // Tenth ratio over the first
        {"A-5.3-decrease-original", tenth_over_first("original")},
        {"A-5.3-decrease-rkpm-first-order", tenth_over_first("rkpm_first_order")},
        {"A-5.3-decrease-rkpm-second-order", tenth_over_first("rkpm_second_order")},
        // Largest difference between the ratios of the original formulation and of first-order RKPM
        {"A-5.3-original-overlaps", measured([](Volumes volumes) {
             return largest_difference(ratios("original", volumes), ratios("rkpm_first_order", volumes));
         })},
        // Largest difference between the ratios of modified FPM and of Chen and Beraun or second-order FPM
        {"A-5.3-fpm-overlap", measured([](Volumes volumes) {
             const auto modified = ratios("modified_fpm", volumes);
             return std::max(largest_difference(ratios("chen_beraun", volumes), modified),
                             largest_difference(ratios("second_order_fpm", volumes), modified));
         })},
        // The tenth ratio that is farthest from one
        {"A-5.3-low-frequencies", measured([](Volumes volumes) {
             double farthest = 1;
             for (const auto* name : three)
                 if (const double tenth = ratios(name, volumes)[9];
                     std::abs(tenth - 1) > std::abs(farthest - 1))
                     farthest = tenth;
             return farthest;
         })},
        // Largest relative difference from finite elements with lumped mass
        {"A-5.3-finite-elements", measured([](Volumes volumes) {
             double most = 0;
             for (const auto* name : three)
                 most = std::max(most,
                                 largest_relative_difference(ratios(name, volumes), finite_element_ratios()));
             return most;
         })},
        // What (47) leaves as printed, then with the other sign of the acceleration; what (48) leaves
        {"A-5.3-printed-47", readings([](Volumes) -> std::vector<Measurement> {
             return {{"", unbalance(-1)}, {"the sign of ∂²x/∂t² is changed, in (48), too", unbalance(1)}};
         })},
        {"A-5.3-printed-48", readings([](Volumes) -> std::vector<Measurement> {
             return {{"", unbalance_of_48(1)},
                     {"the sign of ∂²x/∂t² is changed, in (47), too", unbalance_of_48(-1)}};
         })},
        // Lowest eigenvalue of K over π², then with the other sign
        {"A-5.3-eigenvalues", readings([](Volumes volumes) -> std::vector<Measurement> {
             return {{"", lowest_eigenvalue(volumes)},
                     {"their sign is changed", -lowest_eigenvalue(volumes)}};
         })},
        // Number of frequencies of 100 particles, then of 100 between the ends
        {"A-5.3-number", readings([](Volumes volumes) -> std::vector<Measurement> {
             const auto number = [&](Index N) {
                 return static_cast<double>(ratios("second_order_fpm", volumes, N).size());
             };
             return {{"", number(100)}, {"N counts the particles between the ends", number(102)}};
         })},
    };
}

}  // namespace asprone2010::claims
