#include "command_line/membranes.hpp"

#include <algorithm>
#include <cmath>

#include "base/memory.hpp"
#include "base/text.hpp"
#include "command_line/lists.hpp"

namespace command_line {

using base::InvalidInput;
using vibration_test::Frequencies;
using vibration_test::Mass;
namespace derivative_test = fpm_in_space::derivative_test;

bool MembraneCase::is_elements() const {
    return formulation.starts_with("fem");
}

std::vector<std::string> membrane_formulations(long dimension) {
    std::vector<std::string> all = fpm_in_space::formulation_names();
    all.insert(all.begin(), "original");
    if (dimension == 2) all.insert(all.end(), {"fem_lumped", "fem_consistent"});
    return all;
}

void complete(MembraneOptions& options) {
    if (options.particles.empty()) options.particles = {options.dimension == 2 ? 30 : 9};
    if (options.formulations.empty())
        options.formulations = {"original", "ssph", "cubic_ssph", "definite_fpm"};
    check_grids(options);
    static_cast<void>(cases(options));
    for (const long n : options.particles) {
        const double modes = std::pow(static_cast<double>(n - 2), options.dimension);
        const std::string what = "the spectrum on " + std::to_string(n) + " particles along a side";
        if (options.lowest == 0)  // a full matrix, and the copy that LAPACK overwrites
            base::require_memory(what, 2 * sizeof(double) * modes * modes,
                                 "take fewer --particles, or --lowest 10");
        else  // at least as many neighbours as a quadratic polynomial has terms, and the factors
            base::require_memory_of_entries(what, 6 * modes, 500 * modes, "take fewer --particles");
        if (options.lowest > 0 && static_cast<double>(options.lowest) > modes - 2)
            throw InvalidInput("--lowest " + std::to_string(options.lowest) + ": " + std::to_string(n) +
                               " particles along a side have " + base::shown(modes) +
                               " modes, of which at most " + base::shown(std::max(modes - 2, 0.0)) +
                               " can be found so; take more --particles, or leave --lowest out");
    }
    if (options.figure.path.empty()) return;
    if (options.lowest > 0) throw InvalidInput("--plot draws whole spectra; leave --lowest out");
    if (options.particles.size() > 1 || options.perturbations.size() > 2 || options.seeds > 1)
        throw InvalidInput(
            "--plot draws one number of --particles, at most two perturbations, such as 0,0.25, and one seed");
}

std::vector<MembraneCase> cases(const MembraneOptions& options) {
    std::vector<MembraneCase> all;
    for (const std::string& formulation :
         chosen("formulation", options.formulations, membrane_formulations(options.dimension)))
        for (const CloudCase& cloud : cases(draws(options))) all.push_back({formulation, cloud});
    return all;
}

template <int dim>
Frequencies frequencies(const MembraneOptions& options, const MembraneCase& one) {
    const auto& [formulation, cloud] = one;
    const auto of = [&](const auto& matrix) {
        return options.lowest > 0 ? vibration_test::lowest_frequencies(matrix, options.lowest)
                                  : vibration_test::frequencies(matrix);
    };
    const auto body = derivative_test::body<dim>(cloud.n, cloud.perturbation, cloud.seed);
    if constexpr (dim == 2) {
        if (formulation == "fem_lumped") return of(vibration_test::elements(body, Mass::lumped));
        if (formulation == "fem_consistent") return of(vibration_test::elements(body, Mass::consistent));
    }
    const auto h =
        smoothing<dim>(options, particles::Column<double>::Constant(1, 1 / static_cast<double>(cloud.n - 1)));
    if (formulation == "original") return of(vibration_test::original_stiffness(body, h));
    return of(vibration_test::stiffness(fpm_in_space::formulation_named<double, dim>(formulation), body, h));
}

template <int dim>
std::vector<double> symbol_frequencies(const MembraneOptions& options, const MembraneCase& one) {
    const auto& [formulation, cloud] = one;
    if (one.is_elements() || cloud.perturbation != 0) return {};
    const auto kernel = smoothing<dim>(options, particles::Column<double>::Ones(1)).kernel();
    const fpm_in_space::error_constants::Lattice<dim> lattice{kernel, options.smoothing};
    if (formulation == "original") return vibration_test::original_symbol_frequencies(lattice, cloud.n);
    return vibration_test::symbol_frequencies(fpm_in_space::formulation_named<base::Quad, dim>(formulation),
                                              lattice, cloud.n);
}

template Frequencies frequencies<2>(const MembraneOptions&, const MembraneCase&);
template Frequencies frequencies<3>(const MembraneOptions&, const MembraneCase&);
template std::vector<double> symbol_frequencies<2>(const MembraneOptions&, const MembraneCase&);
template std::vector<double> symbol_frequencies<3>(const MembraneOptions&, const MembraneCase&);

}  // namespace command_line
