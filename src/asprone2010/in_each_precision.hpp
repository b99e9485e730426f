#pragma once

#include "asprone2010/limit_stencils.hpp"
#include "asprone2010/quality.hpp"
#include "asprone2010/section_5_1_derivative_test.hpp"
#include "asprone2010/section_5_2_static_test.hpp"

/// The functions that are compiled once for each scalar type. TEMPLATE is `template` where they are compiled,
/// and `extern template` where they are declared.
// Types cannot stand in parentheses. NOLINTBEGIN(bugprone-macro-parentheses)
#define ASPRONE2010_IN_PRECISION(TEMPLATE, Scalar)                                                         \
    namespace asprone2010 {                                                                                \
    TEMPLATE const std::vector<Formulation<Scalar>>& formulations();                                       \
    TEMPLATE numerical_tests::Particles<Scalar> numerical_tests::discretise(const Discretisation&,         \
                                                                            const Column<Scalar>&);        \
    TEMPLATE numerical_tests::Particles<Scalar> numerical_tests::discretise(const Discretisation&, Index,  \
                                                                            unsigned long);                \
    TEMPLATE derivative_test::Errors<Scalar> derivative_test::errors(                                      \
        const particles::Operators<Scalar>&, const numerical_tests::Particles<Scalar>&,                    \
        const Smooth<Scalar>&);                                                                            \
    TEMPLATE Column<Scalar> static_test::displacement(particles::Operators<Scalar>&&, const Line<Scalar>&, \
                                                      const Smooth<Scalar>&, int);                         \
    TEMPLATE quality::Worst quality::worst(const particles::Operators<Scalar>&, const Exactness&,          \
                                           const numerical_tests::Particles<Scalar>&, RowsOf);             \
    TEMPLATE limit_stencils::Stencil<Scalar> limit_stencils::near_end(                                     \
        const Formulation<Scalar>&, const numerical_tests::Discretisation&, Index, int, const Scalar&);    \
    }
// NOLINTEND(bugprone-macro-parentheses)
