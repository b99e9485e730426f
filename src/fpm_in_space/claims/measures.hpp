#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "fpm_in_space/section_1_second_order_fpm.hpp"
#include "fpm_in_space/section_4_derivative_test.hpp"
#include "fpm_in_space/ssph_with_value_given.hpp"
#include "report/ledger.hpp"
#include "report/table.hpp"

namespace fpm_in_space::claims {

using derivative_test::Body;
using particles::Column;
using particles::Index;
using particles::Smoothing;
using report::Computation;
using report::Measurement;

/// A number that is measured in the plane and in space.
/// \param number a function of the dimension, a std::integral_constant
template <class Number>
Computation measured(const Number& number) {
    return [number](const report::Statement&, std::size_t convention) -> std::vector<Measurement> {
        if (convention == 0) return {{"", number(std::integral_constant<int, 2>{})}};
        return {{"", number(std::integral_constant<int, 3>{})}};
    };
}

/// A number of the plane, or of a line: in space there is none.
Computation measured_once(const std::function<double()>& number);

/// The Gaussian with h = δ.
template <int dim>
Smoothing<double, dim> gaussian(double spacing) {
    return {particles::Gaussian<dim>{}, spacing};
}

/// The Gaussian with h = 1.2 δ, lowered to zero.
template <int dim>
Smoothing<double, dim> cut_gaussian(double spacing) {
    return {particles::TruncatedGaussian<dim>(cut<dim>), 1.2 * spacing};
}

/// Largest errors of DB and D²B.
struct Errors {
    double first = 0, second = 0;
};

/// The errors of a formulation on a grid of n particles along a side, by the number of sides that a particle
/// lies on. \param sample at most so many particles of each place \param seed of the perturbation
template <int dim>
std::vector<Errors> errors_by_place(std::string_view formulation, Index n, double perturbation,
                                    const std::function<Smoothing<double, dim>(double)>& smoothing,
                                    Index sample, unsigned long seed = 1);

/// Median of each over so many draws.
template <int dim>
std::vector<Errors> median_errors(std::string_view formulation, Index n, double perturbation,
                                  const std::function<Smoothing<double, dim>(double)>& smoothing,
                                  Index sample, unsigned long draws);

/// A table of data/fpm_in_space.
struct DataTable {
    explicit DataTable(const std::string& name);

    std::string path;
    report::Table table;

    /// \throws base::FailedComputation where the cell is empty
    [[nodiscard]] double number(std::size_t row, const std::string& column) const;

    /// \throws base::FailedComputation that names the rows
    [[noreturn]] void refuse_without(const std::string& rows) const;
};

/// The errors that a table has of a formulation on n particles along a side, by the number of sides that a
/// particle lies on: medians of the draws.
/// \throws base::FailedComputation where the table has no such row
template <int dim>
std::vector<Errors> errors_in_table(const DataTable& of, std::string_view formulation, Index n,
                                    double perturbation);

/// Spearman's rank correlation.
double rank_correlation(const std::vector<double>& one, const std::vector<double>& other);

/// Largest of all places.
Errors largest(const std::vector<Errors>& by_place);

/// Observed order from errors with \f$n_1\f$ and \f$n_2\f$ particles along a side.
double order(Index n_1, double error_1, Index n_2, double error_2);

/// Least real part of the eigenvalues of \f$-\Delta u = \lambda u\f$ on the square or the cube, held at its
/// sides, over the lowest exact one: on three draws of particles perturbed by δ/4.
template <int dim>
std::vector<double> least_eigenvalues(std::string_view formulation);

}  // namespace fpm_in_space::claims
