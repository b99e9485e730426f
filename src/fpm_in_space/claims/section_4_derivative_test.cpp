#include "fpm_in_space/section_4_derivative_test.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "fpm_in_space/claims/ledger.hpp"
#include "fpm_in_space/claims/measures.hpp"

namespace fpm_in_space::claims {

namespace {

/// Particles along a side, and at most so many of each place.
struct Sizes {
    Index coarse, fine, sample;
};

/// A sample that holds every particle.
constexpr Index every = 1000000;

/// All particles of grids.
template <int dim>
constexpr Sizes grids = dim == 2 ? Sizes{31, 121, every} : Sizes{17, 33, every};

/// Orders of DB and D²B on grids at each place.
template <int dim>
std::vector<Errors> orders(std::string_view formulation) {
    const auto errors = [&](Index n) {
        return errors_by_place<dim>(formulation, n, 0, cut_gaussian<dim>, grids<dim>.sample);
    };
    const auto [coarse, fine, sample] = grids<dim>;
    const std::vector<Errors> before = errors(coarse), after = errors(fine);
    std::vector<Errors> all;
    for (std::size_t place = 0; place < before.size(); ++place)
        all.push_back({order(coarse, before[place].first, fine, after[place].first),
                       order(coarse, before[place].second, fine, after[place].second)});
    return all;
}

/// Those of the second-order FPM, which serve the claims on both derivatives.
template <int dim>
const std::vector<Errors>& orders_on_grids() {
    static const std::vector<Errors> all = orders<dim>("definite_fpm");
    return all;
}

/// The order at the place where it is farthest from 2 on grids.
template <int dim>
double farthest_from_2(double Errors::*derivative) {
    double farthest = 2;
    for (const Errors& place : orders_on_grids<dim>())
        if (std::abs(place.*derivative - 2) > std::abs(farthest - 2)) farthest = place.*derivative;
    return farthest;
}

// On the tables of the figures, data/fpm_in_space

/// The least order of all places on perturbed particles: of the medians of 25 draws, between 31² and 121²
/// particles, and between 17³ and 48³.
template <int dim>
double least_order(double Errors::*derivative) {
    static const DataTable table(dim == 2 ? "plane" : "space");
    const auto [coarse, fine] = dim == 2 ? std::array<Index, 2>{31, 121} : std::array<Index, 2>{17, 48};
    const auto before = errors_in_table<dim>(table, "definite_fpm", coarse, 0.25),
               after = errors_in_table<dim>(table, "definite_fpm", fine, 0.25);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t place = 0; place < before.size(); ++place)
        least = std::min(least, order(coarse, before[place].*derivative, fine, after[place].*derivative));
    return least;
}

/// Largest errors in the plane on 61² particles.
Errors errors_of_61() {
    return largest(errors_by_place<2>("definite_fpm", 61, 0, gaussian<2>, every));
}

/// What orders the errors of the second derivatives of ln r at the particles around the hole.
struct AroundHole {
    double R, size,
        both;  ///< rank correlations of R, of the size of the fourth derivatives, of their product
};

AroundHole around_hole() {
    const DataTable rows("rows");
    std::vector<double> R, size, both, error;
    for (std::size_t row = 0; row < rows.table.rows.size(); ++row) {
        if (rows.table.word(row, "formulation") != "definite_fpm") continue;
        const double r = std::hypot(rows.number(row, "x"), rows.number(row, "y"));
        R.push_back(rows.number(row, "quality"));
        size.push_back(6 * std::pow(rows.number(row, "spacing"), 2) / std::pow(r, 4));
        both.push_back(R.back() * size.back());
        error.push_back(rows.number(row, "error_second"));
    }
    if (error.empty()) rows.refuse_without("rows of definite_fpm");
    return {rank_correlation(R, error), rank_correlation(size, error), rank_correlation(both, error)};
}

/// R predicts as it stands, or with the size.
std::vector<Measurement> quality_around_hole(const report::Statement& /*claim*/, std::size_t convention) {
    if (convention == 1) return {};  // the hole lies in the plane
    const AroundHole found = around_hole();
    return {{"", found.R}, {"the size of the fourth derivatives is known, too", found.both}};
}

/// Of a column of the layouts around the hole with the error of the solution.
double correlation_on_layouts(const std::string& column) {
    const DataTable layouts("layouts");
    std::vector<double> number, error;
    for (std::size_t row = 0; row < layouts.table.rows.size(); ++row) {
        number.push_back(layouts.number(row, column));
        error.push_back(layouts.number(row, "log_error_nd"));
    }
    if (error.empty()) layouts.refuse_without("rows");
    return rank_correlation(number, error);
}

}  // namespace

report::Computations section_4() {
    return {
        // Orders on grids
        {"F-4-uniform-D2", measured([](auto dim) { return farthest_from_2<dim>(&Errors::second); })},
        {"F-4-uniform-D", measured([](auto dim) { return farthest_from_2<dim>(&Errors::first); })},
        // Orders on perturbed particles
        {"F-4-perturbed-D2", measured([](auto dim) { return least_order<dim>(&Errors::second); })},
        {"F-4-perturbed-D", measured([](auto dim) { return least_order<dim>(&Errors::first); })},
        // Order by SSPH of degree 2 where one side ends
        {"F-4-ssph", measured([](auto dim) { return orders<dim>("ssph")[1].second; })},
        // Errors with 61² particles
        {"F-4-numpy-D2", measured_once([] { return errors_of_61().second; })},
        {"F-4-numpy-D", measured_once([] { return errors_of_61().first; })},
        // Does R predict the error of derivatives? And does it add to the size of the fourth derivatives?
        {"F-4-quality", quality_around_hole},
        {"F-4-quality-size", measured_once([] {
             const AroundHole found = around_hole();
             return found.both - found.size;
         })},
        // Do R and the noise predict the error of solutions?
        {"F-4-quality-solution", measured_once([] { return correlation_on_layouts("quality"); })},
        {"F-4-noise-solution", measured_once([] { return correlation_on_layouts("noise"); })},
        // Least eigenvalue of a membrane
        {"F-4-membrane", measured([](auto dim) {
             const auto least = least_eigenvalues<dim>("definite_fpm");
             return *std::min_element(least.begin(), least.end());
         })},
    };
}

}  // namespace fpm_in_space::claims
