#include "fpm_in_space/claims/measures.hpp"

#include <gsl/gsl_statistics_double.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <variant>

#include "base/errors.hpp"
#include "base/text.hpp"
#include "particles/operators.hpp"
#include "report/read_table.hpp"
#include "report/statistics.hpp"
#include "solvers/spectrum.hpp"

namespace fpm_in_space::claims {

using particles::Range;

Computation measured_once(const std::function<double()>& number) {
    return [number](const report::Statement&, std::size_t convention) -> std::vector<Measurement> {
        if (convention == 0) return {{"", number()}};
        return {};
    };
}

template <int dim>
std::vector<Errors> errors_by_place(std::string_view formulation, Index n, double perturbation,
                                    const std::function<Smoothing<double, dim>(double)>& smoothing,
                                    Index sample, unsigned long seed) {
    const auto [cloud, on_sides] = derivative_test::body<dim>(n, perturbation, seed);
    const double spacing = 1 / static_cast<double>(n - 1);
    std::vector<Range> places;
    places.reserve(on_sides.size());
    for (const Range& place : on_sides)
        places.push_back({place.first, std::min(place.last, place.first + sample)});
    std::vector<Errors> by_place;
    for (const auto& of_place : derivative_test::errors<dim>(
             formulation_named<double, dim>(formulation), cloud, smoothing(spacing),
             Column<double>::Constant(1, spacing), derivative_test::exponential_and_wave<dim>, places)) {
        const auto found = derivative_test::largest(of_place);
        by_place.push_back({found.first, found.second});
    }
    return by_place;
}

template <int dim>
std::vector<Errors> median_errors(std::string_view formulation, Index n, double perturbation,
                                  const std::function<Smoothing<double, dim>(double)>& smoothing,
                                  Index sample, unsigned long draws) {
    std::vector<std::vector<Errors>> all;
    for (unsigned long seed = 1; seed <= draws; ++seed)
        all.push_back(errors_by_place<dim>(formulation, n, perturbation, smoothing, sample, seed));
    std::vector<Errors> medians(dim + 1);
    for (std::size_t place = 0; place <= dim; ++place) {
        std::vector<double> first, second;
        for (const auto& draw : all) {
            first.push_back(draw[place].first);
            second.push_back(draw[place].second);
        }
        medians[place] = {report::quartiles(first).median, report::quartiles(second).median};
    }
    return medians;
}

DataTable::DataTable(const std::string& name)
    : path("data/fpm_in_space/" + name + ".csv"), table(report::read_table(path)) {}

double DataTable::number(std::size_t row, const std::string& column) const {
    const auto* const found = std::get_if<double>(&table.rows[row][table.column(column)]);
    if (!found) refuse_without("a number in row " + std::to_string(row + 1) + ", " + column);
    return *found;
}

void DataTable::refuse_without(const std::string& rows) const {
    throw base::FailedComputation(path + " lacks " + rows + "; remove it and run make " + path);
}

template <int dim>
std::vector<Errors> errors_in_table(const DataTable& of, std::string_view formulation, Index n,
                                    double perturbation) {
    std::vector<Errors> by_place;
    for (int sides = 0; sides <= dim; ++sides) {
        const std::string place = fpm_in_space::place<dim>(sides);
        std::size_t row = 0;
        const auto fits = [&] {
            return of.table.word(row, "formulation") == formulation && of.table.word(row, "place") == place &&
                   of.number(row, "particles") == static_cast<double>(n) &&
                   of.number(row, "perturbation") == perturbation;
        };
        while (row < of.table.rows.size() && !fits()) ++row;
        if (row == of.table.rows.size())
            of.refuse_without("a row of " + std::string(formulation) + ", particles " + std::to_string(n) +
                              ", perturbation " + base::shown(perturbation) + ", " + place);
        by_place.push_back({of.number(row, "error_first"), of.number(row, "error_second")});
    }
    return by_place;
}

double rank_correlation(const std::vector<double>& one, const std::vector<double>& other) {
    std::vector<double> work(2 * one.size());
    return gsl_stats_spearman(one.data(), 1, other.data(), 1, one.size(), work.data());
}

Errors largest(const std::vector<Errors>& by_place) {
    Errors most;
    for (const Errors& each : by_place)
        most = {std::max(most.first, each.first), std::max(most.second, each.second)};
    return most;
}

double order(Index n_1, double error_1, Index n_2, double error_2) {
    return std::log(error_1 / error_2) /
           std::log(static_cast<double>(n_2 - 1) / static_cast<double>(n_1 - 1));
}

template <int dim>
std::vector<double> least_eigenvalues(std::string_view formulation) {
    const Index n = dim == 2 ? 26 : 9;
    const auto& chosen = formulation_named<double, dim>(formulation);
    std::vector<double> least;
    for (unsigned long seed = 1; seed <= 3; ++seed) {
        const auto [cloud, on_sides] = derivative_test::body<dim>(n, 0.25, seed);
        const Range inside = on_sides[0];  // the first of all
        const auto operators = particles::assemble(cloud, gaussian<dim>(1 / static_cast<double>(n - 1)),
                                                   chosen.required(), chosen.weights, inside);
        Eigen::MatrixXd K = Eigen::MatrixXd::Zero(inside.size(), inside.size());
        for (std::size_t axis = 0; axis < dim; ++axis)
            K -= Eigen::MatrixXd(operators.D2[axis]).leftCols(inside.size());
        double lowest = std::numeric_limits<double>::infinity();
        for (const auto& eigenvalue : solvers::eigenvalues(K)) lowest = std::min(lowest, eigenvalue.real());
        least.push_back(lowest / (dim * std::numbers::pi * std::numbers::pi));
    }
    return least;
}

#define FPM_IN_SPACE_MEASURES(dim)                                                                          \
    template std::vector<Errors> errors_by_place(std::string_view, Index, double,                           \
                                                 const std::function<Smoothing<double, dim>(double)>&,      \
                                                 Index, unsigned long);                                     \
    template std::vector<Errors> median_errors(std::string_view, Index, double,                             \
                                               const std::function<Smoothing<double, dim>(double)>&, Index, \
                                               unsigned long);                                              \
    template std::vector<Errors> errors_in_table<dim>(const DataTable&, std::string_view, Index, double);   \
    template std::vector<double> least_eigenvalues<dim>(std::string_view);
FPM_IN_SPACE_MEASURES(2)
FPM_IN_SPACE_MEASURES(3)

}  // namespace fpm_in_space::claims
