#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "asprone2010/formulations.hpp"
#include "asprone2010/section_3_2_chen_beraun.hpp"
#include "asprone2010/section_3_4_fpm.hpp"
#include "asprone2010/section_4_second_order_fpm.hpp"

namespace asprone2010 {

namespace detail {

template <class Scalar, class... Rule>
Formulation<Scalar> formulation(std::string_view name, std::string_view section, std::string_view equations,
                                Index particles, Exactness exact, Rule... /*stateless*/) {
    return {name,
            section,
            equations,
            particles,
            exact,
            [](particles::Operators<Scalar>& all, const Line<Scalar>& line,
               const particles::Smoothing<Scalar>& smoothing, const particles::Requirement& required) {
                particles::assemble_again(all, line, smoothing, required, Rule{}...);
            }};
}

}  // namespace detail

/// All formulations, in the paper's order. A rule returns both derivatives of a neighbourhood, or the first
/// alone; then the section says how the second follows for the whole line: \eq{A12}, \eq{A26} and the end of
/// Section 3.4.
template <class Scalar>
const std::vector<Formulation<Scalar>>& formulations() {
    using detail::formulation;
    static const std::vector<Formulation<Scalar>> all{
        formulation<Scalar>(
            "original", "3.1", "(11) (12)", 2, {0, 0},
            [](const auto& near) { return original::first_derivative(near); },
            [](const Operator<Scalar>& D, Operator<Scalar>&& memory) {
                return original::second_derivative(D, std::move(memory));
            }),
        formulation<Scalar>("chen_beraun", "3.2", "(16) (20)", 3, {1, 1},
                            [](const auto& near) { return chen_beraun::derivatives(near); }),
        formulation<Scalar>(
            "rkpm_first_order", "3.3", "(25) (26)", 2, {0, 0},
            [](const auto& near) { return rkpm::first_derivative<1>(near); },
            [](const Operator<Scalar>& D, Operator<Scalar>&& memory) {
                return rkpm::second_derivative(D, std::move(memory));
            }),
        formulation<Scalar>(
            "rkpm_second_order", "3.3", "(25) (26)", 3, {0, 0},
            [](const auto& near) { return rkpm::first_derivative<2>(near); },
            [](const Operator<Scalar>& D, Operator<Scalar>&& memory) {
                return rkpm::second_derivative(D, std::move(memory));
            }),
        formulation<Scalar>(
            "fpm", "3.4", "(30)", 2, {1, 1}, [](const auto& near) { return fpm::first_derivative(near); },
            [](const Operator<Scalar>& D, Operator<Scalar>&& memory) {
                return fpm::second_derivative(D, std::move(memory));
            }),
        formulation<Scalar>("modified_fpm", "3.5", "(36)", 3, {2, 2},
                            [](const auto& near) { return modified_fpm::derivatives(near); }),
        formulation<Scalar>("second_order_fpm", "4", "(43)", 4, {2, 3},
                            [](const auto& near) { return second_order_fpm::derivatives(near); }),
    };
    return all;
}

}  // namespace asprone2010
