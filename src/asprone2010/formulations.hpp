#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "asprone2010/section_3_2_chen_beraun.hpp"
#include "asprone2010/section_3_4_fpm.hpp"
#include "asprone2010/section_4_second_order_fpm.hpp"
#include "base/choose.hpp"
#include "particles/operators.hpp"

namespace asprone2010 {

/// A formulation of Sections 3 and 4 as tests, programs and figures see it.
template <class Scalar = double>
struct Formulation {
    std::string_view name;       ///< on the command line and in tables
    std::string_view section;    ///< of the paper
    std::string_view equations;  ///< of its discrete form
    Index particles = 0;         ///< that a neighbourhood must hold, the particle itself included

    using Assemble = particles::Operators<Scalar> (*)(const Line<Scalar>&,
                                                      const particles::Smoothing<Scalar>&,
                                                      const particles::Requirement&);
    Assemble assemble = nullptr;

    /// D and D² of the formulation on a line of particles. Errors as for particles::assemble.
    [[nodiscard]] particles::Operators<Scalar> operators(
        const Line<Scalar>& line, const particles::Smoothing<Scalar>& smoothing) const {
        return assemble(line, smoothing, {name, particles});
    }
};

namespace detail {

template <class Scalar, class... Rule>
Formulation<Scalar> formulation(std::string_view name, std::string_view section, std::string_view equations,
                                Index particles, Rule... /*stateless*/) {
    return {name, section, equations, particles,
            [](const Line<Scalar>& line, const particles::Smoothing<Scalar>& smoothing,
               const particles::Requirement& required) {
                return particles::assemble(line, smoothing, required, Rule{}...);
            }};
}

}  // namespace detail

/// All formulations, in the paper's order. A rule returns both derivatives of a neighbourhood, or the first
/// alone; then the section says how the second follows for the whole line: \eq{A12}, \eq{A26} and the end of
/// Section 3.4.
template <class Scalar = double>
const std::vector<Formulation<Scalar>>& formulations() {
    using detail::formulation;
    static const std::vector<Formulation<Scalar>> all{
        formulation<Scalar>(
            "original", "3.1", "(11) (12)", 2,
            [](const auto& near) { return original::first_derivative(near); },
            [](const auto& D) { return original::second_derivative(D); }),
        formulation<Scalar>("chen_beraun", "3.2", "(16) (20)", 3,
                            [](const auto& near) { return chen_beraun::derivatives(near); }),
        formulation<Scalar>(
            "rkpm_first_order", "3.3", "(25) (26)", 2,
            [](const auto& near) { return rkpm::first_derivative<1>(near); },
            [](const auto& D) { return rkpm::second_derivative(D); }),
        formulation<Scalar>(
            "rkpm_second_order", "3.3", "(25) (26)", 3,
            [](const auto& near) { return rkpm::first_derivative<2>(near); },
            [](const auto& D) { return rkpm::second_derivative(D); }),
        formulation<Scalar>(
            "fpm", "3.4", "(30)", 2, [](const auto& near) { return fpm::first_derivative(near); },
            [](const auto& D) { return fpm::second_derivative(D); }),
        formulation<Scalar>("modified_fpm", "3.5", "(36)", 3,
                            [](const auto& near) { return modified_fpm::derivatives(near); }),
        formulation<Scalar>("second_order_fpm", "4", "(43)", 4,
                            [](const auto& near) { return second_order_fpm::derivatives(near); }),
    };
    return all;
}

// Compiled once for each precision: formulations_double.cpp, formulations_long.cpp, formulations_quad.cpp.
extern template const std::vector<Formulation<double>>& formulations();
extern template const std::vector<Formulation<long double>>& formulations();

/// The formulation of a list that has a name.
/// \throws base::InvalidInput where none has
template <class Scalar>
const Formulation<Scalar>& named(const std::vector<Formulation<Scalar>>& list, std::string_view wanted) {
    std::vector<std::pair<std::string, const Formulation<Scalar>*>> known;
    for (const auto& formulation : list) known.emplace_back(formulation.name, &formulation);
    return *base::choose("formulation", wanted, known);
}

/// \throws base::InvalidInput for a name that no formulation has
template <class Scalar = double>
const Formulation<Scalar>& formulation_named(std::string_view wanted) {
    return named(formulations<Scalar>(), wanted);
}

}  // namespace asprone2010
