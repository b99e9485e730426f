#pragma once

#include <array>
#include <string_view>

#include "asprone2010/limit_stencils.hpp"
#include "tests/support/relative.hpp"

namespace support {

inline constexpr std::array<std::string_view, 7> all_names{
    "original", "chen_beraun",  "rkpm_first_order", "rkpm_second_order",
    "fpm",      "modified_fpm", "second_order_fpm"};

/// The limit stencil of a formulation in long double.
inline asprone2010::limit_stencils::Stencil<long double> near_end(
    std::string_view formulation, int derivative,
    const asprone2010::numerical_tests::Discretisation& how = {}, asprone2010::Index from_end = 0) {
    return asprone2010::limit_stencils::near_end(asprone2010::formulation_named<long double>(formulation),
                                                 how, from_end, derivative);
}

/// The second derivative on three points.
inline asprone2010::limit_stencils::Stencil<double> central_difference() {
    asprone2010::limit_stencils::Stencil<double> stencil{particles::Column<double>(3),
                                                         particles::Column<double>(3)};
    stencil.r << -1, 0, 1;
    stencil.w << 1, -2, 1;
    return stencil;
}

}  // namespace support
