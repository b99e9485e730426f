#pragma once

#include <algorithm>
#include <string_view>
#include <vector>

#include "asprone2010/local_conditions.hpp"
#include "fpm_in_space/section_2_literal_extension.hpp"

namespace fpm_in_space {

/// The condition numbers of the small systems that a formulation solves for each particle, in units of h.
namespace local_conditions {

/// The conditions of the systems in the order in which they are solved; none for the SSPH basis, whose matrix
/// is not of this text.
/// \param formulation its name in formulations()
template <int dim>
std::vector<double> systems(std::string_view formulation, const Neighbourhood<double, dim>& near) {
    using asprone2010::local_conditions::condition;
    using Dense = Eigen::MatrixXd;
    namespace literal = literal_extension;
    namespace fpm = second_order_fpm;
    const Column<double> WV = near.W * near.V;
    const Table<double> p = fpm::monomials_of(near), p1 = fpm::linear<dim>(p), p2 = fpm::quadratic<dim>(p),
                        o = fpm::odd<dim>(p);
    if (formulation == "definite_fpm")
        return {condition<Dense>(fpm::product(o, o, WV)),
                condition<Dense>(fpm::product(fpm::corrections(p2, o, WV), p2, WV)),
                condition<Dense>(fpm::product(p1, p1, WV))};
    if (formulation == "literal_modified_fpm")
        return {condition<Dense>(literal::matrix(literal::harmonic_kernels(near), near))};
    if (formulation == "literal_fpm_by_derivatives")
        return {condition<Dense>(literal::matrix(literal::kernel_derivatives(near), near))};
    if (formulation == "literal_second_order_fpm")
        return {condition<Dense>(fpm::product(o, o, WV)),
                condition<Dense>(literal::matrix(literal::corrected_kernels(near), near))};
    return {};
}

/// The largest of them; 1 where there is none.
template <int dim>
double largest(std::string_view formulation, const Neighbourhood<double, dim>& near) {
    double most = 1;
    for (const double each : systems(formulation, near)) most = std::max(most, each);
    return most;
}

}  // namespace local_conditions
}  // namespace fpm_in_space
