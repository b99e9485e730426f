#include "fpm_in_space/section_4_derivative_test.hpp"

#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "fpm_in_space/claims/ledger.hpp"
#include "fpm_in_space/claims/measures.hpp"
#include "report/read_table.hpp"

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

report::Table table(const std::string& name) {
    return report::read_table("data/fpm_in_space/" + name + ".csv");
}

double number(const report::Table& table, std::size_t row, const std::string& column) {
    return std::get<double>(table.rows[row][table.column(column)]);
}

/// The least order of all places on perturbed particles: of the medians of 25 draws, between 31² and 121²
/// particles, and between 17³ and 48³.
template <int dim>
double least_order(const std::string& column) {
    const auto [coarse, fine] = dim == 2 ? std::array<Index, 2>{31, 121} : std::array<Index, 2>{17, 48};
    const report::Table all = table(dim == 2 ? "plane" : "space");
    std::map<std::string, std::map<Index, double>> errors;  // by place and particles along a side
    for (std::size_t row = 0; row < all.rows.size(); ++row)
        if (all.word(row, "formulation") == "definite_fpm" && number(all, row, "perturbation") == 0.25)
            errors[all.word(row, "place")][std::lround(number(all, row, "particles"))] =
                number(all, row, column);
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [place, of] : errors)
        least = std::min(least, order(coarse, of.at(coarse), fine, of.at(fine)));
    return least;
}

/// Largest errors in the plane on 61² particles.
Errors errors_of_61() {
    return largest(errors_by_place<2>("definite_fpm", 61, 0, gaussian<2>, every));
}

/// Spearman's rank correlation.
double rank_correlation(const std::vector<double>& one, const std::vector<double>& other) {
    std::vector<double> work(2 * one.size());
    return gsl_stats_spearman(one.data(), 1, other.data(), 1, one.size(), work.data());
}

/// Of R with the error over the scale of the remainder for ln r, at the particles around the hole; then of R
/// times the scale with the error.
std::vector<Measurement> correlations_at_particles() {
    const report::Table rows = table("rows");
    std::vector<double> R, scaled_error, bound, error;
    for (std::size_t row = 0; row < rows.rows.size(); ++row) {
        if (rows.word(row, "formulation") != "definite_fpm") continue;
        const double r = std::hypot(number(rows, row, "x"), number(rows, row, "y")),
                     scale = 6 * std::pow(number(rows, row, "spacing"), 2) / std::pow(r, 4);
        R.push_back(number(rows, row, "quality"));
        scaled_error.push_back(number(rows, row, "error_second") / scale);
        bound.push_back(number(rows, row, "quality") * scale);
        error.push_back(number(rows, row, "error_second"));
    }
    return {{"", rank_correlation(R, scaled_error)},
            {"the size of the fourth derivatives is known, too", rank_correlation(bound, error)}};
}

/// Of the largest R of a layout with the error of the solution on it.
double correlation_on_layouts() {
    const report::Table layouts = table("layouts");
    std::vector<double> R, error;
    for (std::size_t row = 0; row < layouts.rows.size(); ++row) {
        R.push_back(number(layouts, row, "quality"));
        error.push_back(number(layouts, row, "log_error_nd"));
    }
    return rank_correlation(R, error);
}

}  // namespace

report::Computations section_4() {
    return {
        // Orders on grids
        {"F-4-uniform-D2", measured([](auto dim) { return farthest_from_2<dim>(&Errors::second); })},
        {"F-4-uniform-D", measured([](auto dim) { return farthest_from_2<dim>(&Errors::first); })},
        // Orders on perturbed particles
        {"F-4-perturbed-D2", measured([](auto dim) { return least_order<dim>("error_second"); })},
        {"F-4-perturbed-D", measured([](auto dim) { return least_order<dim>("error_first"); })},
        // Order by SSPH of degree 2 where one side ends
        {"F-4-ssph", measured([](auto dim) { return orders<dim>("ssph")[1].second; })},
        // Errors with 61² particles
        {"F-4-numpy-D2", measured_once([] { return errors_of_61().second; })},
        {"F-4-numpy-D", measured_once([] { return errors_of_61().first; })},
        // Does R predict the error? On tables of derivatives and of solutions
        {"F-4-quality", [](const report::Statement&, std::size_t) { return correlations_at_particles(); }},
        {"F-4-quality-solution", measured_once(correlation_on_layouts)},
        // Least eigenvalue of a membrane
        {"F-4-membrane", measured([](auto dim) { return least_eigenvalue<dim>("definite_fpm"); })},
    };
}

}  // namespace fpm_in_space::claims
