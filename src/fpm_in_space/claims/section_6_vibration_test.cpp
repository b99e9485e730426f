#include "fpm_in_space/section_6_vibration_test.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <string>
#include <string_view>
#include <vector>

#include "fpm_in_space/claims/ledger.hpp"
#include "fpm_in_space/claims/measures.hpp"

namespace fpm_in_space::claims {

namespace {

using vibration_test::Frequencies;
using vibration_test::On;

const Formulation<double, 2>& second_order_fpm_in_the_plane() {
    return formulation_named<double, 2>(second_order_fpm::required<2>.formulation);
}

/// Lowest eigenvalue of a membrane on a grid of 26² particles over the exact one.
double lowest_eigenvalue(const Smoothing<double, 2>& smoothing) {
    const auto K = vibration_test::stiffness(second_order_fpm_in_the_plane(),
                                             derivative_test::body<2>(26, 0, 1), smoothing);
    const std::complex<double> omega = vibration_test::lowest_frequencies(K, 1).front();
    return std::pow(omega.real() / vibration_test::exact_frequency<2>({1, 1}), 2);
}

std::vector<Measurement> lowest(const report::Statement& /*claim*/, std::size_t convention) {
    if (convention == 1) return {};  // a membrane lies in the plane
    const double h = 1.2 / 25;
    return {{"", lowest_eigenvalue(cut_gaussian<2>(1.0 / 25))},
            {"the Gaussian is not cut", lowest_eigenvalue({particles::Gaussian<2>{}, h})}};
}

// On the table of the figure

const DataTable& membrane() {
    static const DataTable table("membrane");
    return table;
}

/// The rows of a formulation on the grid, mode by mode.
std::vector<std::size_t> modes_on_grid(std::string_view formulation) {
    std::vector<std::size_t> rows;
    const report::Table& table = membrane().table;
    for (std::size_t row = 0; row < table.rows.size(); ++row)
        if (table.word(row, "formulation") == formulation && table.word(row, "perturbation") == "0")
            rows.push_back(row);
    if (rows.empty()) membrane().refuse_without("rows of " + std::string(formulation));
    return rows;
}

/// Largest relative difference from the symbol's frequencies among the lower half.
double from_symbol() {
    const auto rows = modes_on_grid("definite_fpm");
    double most = 0;
    for (std::size_t k = 0; k < rows.size() / 2; ++k)
        most = std::max(
            most,
            std::abs(membrane().number(rows[k], "ratio") / membrane().number(rows[k], "ratio_symbol") - 1));
    return most;
}

/// Relative error of the lowest frequency on the grid.
double lowest_error(std::string_view formulation) {
    return std::abs(membrane().number(modes_on_grid(formulation).front(), "ratio") - 1);
}

// On three draws of 30² perturbed particles, h = 1.2 δ

/// The number of complex pairs on each draw. \param stiffness of the particles of a body
template <class Stiffness>
std::vector<double> complex_pairs(const Stiffness& stiffness) {
    std::vector<double> pairs;
    for (unsigned long seed = 1; seed <= 3; ++seed) {
        const Frequencies omega = vibration_test::frequencies(
            stiffness(derivative_test::body<2>(30, 0.25, seed), cut_gaussian<2>(1.0 / 29)));
        pairs.push_back(static_cast<double>(vibration_test::complex_pairs(omega)));
    }
    return pairs;
}

/// Least share of the modes that belong to complex pairs.
double share_of_complex_pairs() {
    const auto pairs = complex_pairs([](const Body<2>& body, const Smoothing<double, 2>& smoothing) {
        return vibration_test::stiffness(second_order_fpm_in_the_plane(), body, smoothing);
    });
    return 2 * *std::min_element(pairs.begin(), pairs.end()) / (28 * 28);
}

/// Largest number of complex pairs by the original SPH.
double original_pairs(On weights) {
    const auto pairs = complex_pairs([&](const Body<2>& body, const Smoothing<double, 2>& smoothing) {
        return vibration_test::original_stiffness(body, smoothing, weights);
    });
    return *std::max_element(pairs.begin(), pairs.end());
}

std::vector<Measurement> original(const report::Statement& /*claim*/, std::size_t convention) {
    if (convention == 1) return {};
    return {{"", original_pairs(On::differences)},
            {"weights stand on the values, not on differences", original_pairs(On::values)}};
}

}  // namespace

report::Computations section_6() {
    return {
        // Lowest eigenvalue of a membrane
        {"F-6-lowest", lowest},
        // Difference of the lower half from the symbol
        {"F-6-symbol", measured_once(from_symbol)},
        // Share of the modes in complex pairs, and how many pairs the original SPH has
        {"F-6-complex", measured_once(share_of_complex_pairs)},
        {"F-6-original", original},
        // Error of the lowest frequency over that of linear elements
        {"F-6-elements",
         measured_once([] { return lowest_error("definite_fpm") / lowest_error("fem_lumped"); })},
    };
}

}  // namespace fpm_in_space::claims
