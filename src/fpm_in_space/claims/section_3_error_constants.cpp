#include "fpm_in_space/section_3_error_constants.hpp"

#include <algorithm>

#include "base/quad.hpp"
#include "fpm_in_space/claims/ledger.hpp"
#include "fpm_in_space/claims/measures.hpp"

namespace fpm_in_space::claims {

namespace {

using base::Quad;
using particles::Exponents;

/// The row of \f$\partial_{11}\f$ of the second-order FPM.
template <int dim>
error_constants::Stencil<Quad, dim> row_of_11(int bounded) {
    return error_constants::row(
        error_constants::limit_stencils(formulation_named<Quad, dim>("definite_fpm"), {{}, 1, bounded}), {2});
}

template <int dim>
double exponent_at_corner() {
    return error_constants::leading_error(row_of_11<dim>(dim), {2}).exponent;
}

/// Largest difference of the constants from those that exponentials show, over the largest constant.
template <int dim>
double difference_of_constants() {
    double most = 0;
    for (int bounded = 0; bounded <= dim; ++bounded) {
        const auto row = row_of_11<dim>(bounded);
        const auto exact = error_constants::leading_error(row, {2});
        const auto shown = error_constants::measured_constants(row, {2}, exact.exponent);
        most = std::max(most,
                        static_cast<double>((shown - exact.C).abs().maxCoeff() / exact.C.abs().maxCoeff()));
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
