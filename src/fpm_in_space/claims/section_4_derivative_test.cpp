#include "fpm_in_space/section_4_derivative_test.hpp"

#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>
#include <limits>
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

/// All particles of grids.
template <int dim>
constexpr Sizes grids = dim == 2 ? Sizes{31, 121, 121 * 121} : Sizes{17, 33, 33 * 33 * 33};

/// A sample of perturbed ones, for the draws.
template <int dim>
constexpr Sizes perturbed = dim == 2 ? Sizes{31, 121, 150} : Sizes{17, 48, 150};

/// Orders of DB and D²B at each place.
template <int dim>
std::vector<Errors> orders(std::string_view formulation, double perturbation, const Sizes& sizes,
                           unsigned long draws) {
    const auto errors = [&](Index n) {
        return median_errors<dim>(formulation, n, perturbation, cut_gaussian<dim>, sizes.sample, draws);
    };
    const std::vector<Errors> before = errors(sizes.coarse), after = errors(sizes.fine);
    std::vector<Errors> all;
    for (std::size_t place = 0; place < before.size(); ++place)
        all.push_back({order(sizes.coarse, before[place].first, sizes.fine, after[place].first),
                       order(sizes.coarse, before[place].second, sizes.fine, after[place].second)});
    return all;
}

/// Those of the second-order FPM, which serve the claims on both derivatives.
template <int dim>
const std::vector<Errors>& orders_on_grids() {
    static const std::vector<Errors> all = orders<dim>("definite_fpm", 0, grids<dim>, 1);
    return all;
}

template <int dim>
const std::vector<Errors>& orders_on_perturbed() {
    static const std::vector<Errors> all =
        orders<dim>("definite_fpm", 0.25, perturbed<dim>, dim == 2 ? 25 : 3);
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

/// The least order of all places on perturbed particles.
template <int dim>
double least_order(double Errors::*derivative) {
    double least = std::numeric_limits<double>::infinity();
    for (const Errors& place : orders_on_perturbed<dim>()) least = std::min(least, place.*derivative);
    return least;
}

/// Largest errors in the plane on 61² particles.
Errors errors_of_61() {
    return largest(errors_by_place<2>("definite_fpm", 61, 0, gaussian<2>, 61 * 61));
}

/// Spearman's rank correlation.
double rank_correlation(const std::vector<double>& one, const std::vector<double>& other) {
    std::vector<double> work(2 * one.size());
    return gsl_stats_spearman(one.data(), 1, other.data(), 1, one.size(), work.data());
}

/// Of R with the error over the scale of the remainder for ln r, at the particles of
/// data/fpm_in_space/rows.csv; then of R times the scale with the error.
std::vector<Measurement> correlations_at_particles() {
    const report::Table table = report::read_table("data/fpm_in_space/rows.csv");
    std::vector<double> R, scaled_error, bound, error;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        if (table.word(row, "formulation") != "definite_fpm") continue;
        const auto value = [&](const char* column) {
            return std::get<double>(table.rows[row][table.column(column)]);
        };
        const double squared_r = value("x") * value("x") + value("y") * value("y");
        const double scale = 6 * value("spacing") * value("spacing") / (squared_r * squared_r);
        R.push_back(value("quality"));
        scaled_error.push_back(value("error_second") / scale);
        bound.push_back(value("quality") * scale);
        error.push_back(value("error_second"));
    }
    return {{"", rank_correlation(R, scaled_error)},
            {"the size of the fourth derivatives is known, too", rank_correlation(bound, error)}};
}

/// Of the largest R with the error of the solution, on the layouts of data/fpm_in_space/layouts.csv.
double correlation_on_layouts() {
    const report::Table table = report::read_table("data/fpm_in_space/layouts.csv");
    std::vector<double> R, error;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        R.push_back(std::get<double>(table.rows[row][table.column("quality")]));
        error.push_back(std::get<double>(table.rows[row][table.column("log_error_nd")]));
    }
    return rank_correlation(R, error);
}

}  // namespace

report::Computations section_4() {
    return {
        // Orders on grids
        {"F-4-uniform-D2", measured([](auto dim) { return farthest_from_2<dim>(&Errors::second); })},
        {"F-4-uniform-D", measured([](auto dim) { return farthest_from_2<dim>(&Errors::first); })},
        // Orders on perturbed particles, medians of 25 draws in the plane and of 3 in space
        {"F-4-perturbed-D2", measured([](auto dim) { return least_order<dim>(&Errors::second); })},
        {"F-4-perturbed-D", measured([](auto dim) { return least_order<dim>(&Errors::first); })},
        // Order by SSPH of degree 2 where one side ends
        {"F-4-ssph", measured([](auto dim) { return orders<dim>("ssph", 0, grids<dim>, 1)[1].second; })},
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
