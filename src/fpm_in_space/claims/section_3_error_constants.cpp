#include "fpm_in_space/section_3_error_constants.hpp"

#include <algorithm>

#include "base/quad.hpp"
#include "fpm_in_space/claims/ledger.hpp"
#include "fpm_in_space/claims/measures.hpp"

namespace fpm_in_space::claims {

namespace {

using base::Quad;
using particles::Exponents;

/// The stencils of the second-order FPM at a place.
template <int dim>
error_constants::Rows<Quad, dim> stencils(int bounded) {
    return error_constants::limit_stencils(formulation_named<Quad, dim>("definite_fpm"), {{}, 1, bounded});
}

template <int dim>
double exponent_at_corner() {
    return error_constants::leading_error(error_constants::row(stencils<dim>(dim), {2}), {2}).exponent;
}

/// Largest difference of the constants from those that exponentials show, over the row's largest constant: of
/// all second derivatives that no exchange of coordinates turns into one another.
template <int dim>
double difference_of_constants() {
    double most = 0;
    for (int bounded = 0; bounded <= dim; ++bounded) {
        const auto all = stencils<dim>(bounded);
        for (const Exponents<dim>& a : error_constants::different_derivatives<dim>(bounded)) {
            if (particles::order<dim>(a) < 2) continue;
            const auto row = error_constants::row(all, a);
            const auto exact = error_constants::leading_error(row, a);
            const auto shown = error_constants::measured_constants(row, a, exact.exponent);
            most = std::max(
                most, static_cast<double>((shown - exact.C).abs().maxCoeff() / exact.C.abs().maxCoeff()));
        }
    }
    return most;
}

}  // namespace

report::Computations section_3() {
    return {
        // Exponent of the leading error of D²B at a corner
        {"F-3-corner", measured([](auto dim) { return exponent_at_corner<dim>(); })},
        // Constants from moments beside those of measured errors
        {"F-3-constants", measured([](auto dim) { return difference_of_constants<dim>(); })},
    };
}

}  // namespace fpm_in_space::claims
