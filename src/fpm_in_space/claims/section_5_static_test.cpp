#include "fpm_in_space/section_5_static_test.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "fpm_in_space/claims/ledger.hpp"
#include "fpm_in_space/claims/measures.hpp"

namespace fpm_in_space::claims {

namespace {

/// Largest errors of the values and of the first derivatives at all places: those of the static test, on the
/// tables of the figure.
struct StaticErrors {
    double value = 0, first = 0;
};

/// \param of a table of static_test_in_space
StaticErrors static_errors(const DataTable& of, std::string_view formulation, std::string_view layout,
                           Index n, std::string_view conditions) {
    StaticErrors largest;
    bool found = false;
    for (std::size_t row = 0; row < of.table.rows.size(); ++row) {
        const auto is = [&](const char* column, std::string_view word) {
            return of.table.word(row, column) == word;
        };
        if (!is("formulation", formulation) || !is("layout", layout) || !is("conditions", conditions) ||
            of.number(row, "particles") != static_cast<double>(n))
            continue;
        found = true;
        largest.value = std::max(largest.value, of.number(row, "error_value"));
        largest.first = std::max(largest.first, of.number(row, "error_first"));
    }
    if (!found)
        of.refuse_without("rows of " + std::string(formulation) + ", " + std::string(layout) +
                          ", particles " + std::to_string(n) + ", " + std::string(conditions));
    return largest;
}

/// Particles along a side between which orders are taken.
template <int dim>
constexpr std::array<Index, 2> sides = dim == 2 ? std::array<Index, 2>{31, 121} : std::array<Index, 2>{9, 17};

/// Orders of both errors.
template <int dim>
StaticErrors static_orders(const DataTable& of, std::string_view formulation, std::string_view layout,
                           std::string_view conditions) {
    const auto [coarse, fine] = sides<dim>;
    const auto before = static_errors(of, formulation, layout, coarse, conditions),
               after = static_errors(of, formulation, layout, fine, conditions);
    return {order(coarse, before.value, fine, after.value), order(coarse, before.first, fine, after.first)};
}

template <int dim>
DataTable on_grids() {
    return DataTable(dim == 2 ? "poisson" : "poisson_in_space");
}

/// The least order of values and fluxes on perturbed particles, of the medians of the draws.
template <int dim>
double least_order_of_draws(std::string_view layout) {
    const DataTable draws(dim == 2           ? "poisson_draws"
                          : layout == "grid" ? "poisson_in_space_draws"
                                             : "poisson_in_space_stretched");
    const auto [value, first] = static_orders<dim>(draws, "definite_fpm", layout, "mixed");
    return std::min(value, first);
}

/// How many times the error of SSPH of degree 2 is that of the second-order FPM.
template <int dim>
double ratio_of_ssph() {
    constexpr Index n = dim == 2 ? 61 : 17;
    const auto of = on_grids<dim>();
    return static_errors(of, "ssph", "grid", n, "mixed").value /
           static_errors(of, "definite_fpm", "grid", n, "mixed").value;
}

}  // namespace

report::Computations section_5() {
    return {
        // Orders: with given values; with fluxes on perturbed particles, and on stretched grids
        {"F-5-dirichlet", measured([](auto dim) {
             return static_orders<dim>(on_grids<dim>(), "definite_fpm", "grid", "dirichlet").value;
         })},
        {"F-5-mixed", measured([](auto dim) { return least_order_of_draws<dim>("grid"); })},
        {"F-5-stretched", measured([](auto dim) { return least_order_of_draws<dim>("stretched-10"); })},
        // Beside SSPH of degree 2 and 3
        {"F-5-ssph", measured([](auto dim) { return ratio_of_ssph<dim>(); })},
        {"F-5-cubic", measured([](auto dim) {
             return static_orders<dim>(on_grids<dim>(), "cubic_ssph", "grid", "mixed").first;
         })},
    };
}

}  // namespace fpm_in_space::claims
