#include "fpm_in_space/section_2_literal_extension.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "asprone2010/local_conditions.hpp"
#include "asprone2010/section_4_second_order_fpm.hpp"
#include "fpm_in_space/claims/ledger.hpp"
#include "fpm_in_space/claims/measures.hpp"
#include "report/statistics.hpp"

namespace fpm_in_space::claims {

namespace {

/// Largest difference of weights relative to the largest weight.
double difference(const Derivatives<double>& one, const Derivatives<double>& other) {
    return std::max((one.first - other.first).abs().maxCoeff() / other.first.abs().maxCoeff(),
                    (one.second - other.second).abs().maxCoeff() / other.second.abs().maxCoeff());
}

/// Largest difference from the first paper's formulations on a line of perturbed particles.
double difference_on_line() {
    const auto line =
        particles::line_at(particles::perturbed_positions<double>(40, 0.25, 1), particles::Volumes::equal);
    double most = 0;
    for (Index i = 0; i < line.size(); ++i) {
        const auto near =
            particles::neighbourhood(line, Smoothing<double>(particles::Gaussian<1>{}, line.spacing()), i);
        most = std::max(
            {most,
             difference(literal_extension::modified(near), asprone2010::modified_fpm::derivatives(near)),
             difference(literal_extension::second_order(near),
                        asprone2010::second_order_fpm::derivatives(near))});
    }
    return most;
}

/// The errors in the plane: every particle of the sides, and a sample of those inside.
const DataTable& errors_in_plane() {
    static const DataTable table("literal");
    return table;
}

/// Particles along a side.
template <int dim>
constexpr Index coarse = dim == 2 ? 31 : 13;
template <int dim>
constexpr Index fine = dim == 2 ? 61 : 25;

/// Largest error of D²B on a grid; in space of a sample of each place.
template <int dim>
double error_on_grid(std::string_view formulation, Index n) {
    if constexpr (dim == 2) return largest(errors_in_table<2>(errors_in_plane(), formulation, n, 0)).second;
    return largest(errors_by_place<dim>(formulation, n, 0, gaussian<dim>, 100)).second;
}

template <int dim>
double order_on_grid() {
    const auto error = [](Index n) { return error_on_grid<dim>("literal_second_order_fpm", n); };
    return order(coarse<dim>, error(coarse<dim>), fine<dim>, error(fine<dim>));
}

template <int dim>
double ratio_on_grid() {
    return error_on_grid<dim>("literal_second_order_fpm", coarse<dim>) /
           error_on_grid<dim>("definite_fpm", coarse<dim>);
}

/// Largest error of D²B on perturbed particles; in space of all at the sides, and of a sample inside.
template <int dim>
double error_on_perturbed(Index n) {
    const std::string_view formulation = "literal_second_order_fpm";
    if constexpr (dim == 2)
        return largest(errors_in_table<2>(errors_in_plane(), formulation, n, 0.25)).second;
    return largest(median_errors<dim>(formulation, n, 0.25, gaussian<dim>, 1350, 3)).second;
}

template <int dim>
double order_on_perturbed() {
    const Index few = dim == 2 ? 31 : 9, many = dim == 2 ? 61 : 17;
    return order(few, error_on_perturbed<dim>(few), many, error_on_perturbed<dim>(many));
}

/// Median of the largest condition of the local systems.
template <int dim>
double largest_condition() {
    std::vector<double> all;
    for (unsigned long seed = 1; seed <= 25; ++seed) {
        const auto [cloud, on_sides] = derivative_test::body<dim>(coarse<dim>, 0.25, seed);
        const auto smoothing = gaussian<dim>(1 / static_cast<double>(coarse<dim> - 1));
        double most = 0;
        for (const particles::Range& place : on_sides)
            for (Index i = place.first; i < std::min(place.last, place.first + 100); ++i) {
                const auto near = particles::neighbourhood(cloud, smoothing, i,
                                                           particles::within_reach(cloud, smoothing, i));
                const auto kernels = literal_extension::corrected_kernels(near);
                most = std::max(
                    most, asprone2010::local_conditions::condition(literal_extension::matrix(kernels, near)));
            }
        all.push_back(most);
    }
    return report::quartiles(all).median;
}

}  // namespace

report::Computations section_2() {
    return {
        // Difference of the weights from the first paper's on a line
        {"F-2-line", measured_once(difference_on_line)},
        // Order of D²B on grids by the literal second-order FPM
        {"F-2-grid-order", measured([](auto dim) { return order_on_grid<dim>(); })},
        // Its error over that of Section 1
        {"F-2-grid-error", measured([](auto dim) { return ratio_on_grid<dim>(); })},
        // Condition of its local systems on perturbed particles
        {"F-2-condition", measured([](auto dim) { return largest_condition<dim>(); })},
        // Order of D²B on perturbed particles
        {"F-2-perturbed", measured([](auto dim) { return order_on_perturbed<dim>(); })},
        // Least eigenvalue of a membrane by the other reading, on the draw where it is largest
        {"F-2-membrane", measured([](auto dim) {
             const auto least = least_eigenvalues<dim>("literal_fpm_by_derivatives");
             return *std::max_element(least.begin(), least.end());
         })},
    };
}

}  // namespace fpm_in_space::claims
