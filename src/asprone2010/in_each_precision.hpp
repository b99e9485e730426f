#pragma once

#include "asprone2010/limit_stencils.hpp"
#include "asprone2010/quality.hpp"
#include "asprone2010/section_5_1_derivative_test.hpp"
#include "asprone2010/section_5_2_static_test.hpp"

/// The functions that are compiled once for each scalar type. TEMPLATE is `template` where they are compiled,
/// and `extern template` where they are declared.
TEMPLATE Column<Scalar> static_test::displacement(particles::Operators<Scalar>&&, const Line<Scalar>&,
                                                  const Smooth<Scalar>&, int);
TEMPLATE quality::Worst quality::worst(const particles::Operators<Scalar>&, const Exactness&,
                                       const numerical_tests::Particles<Scalar>&, RowsOf);
}
// NOLINTEND(bugprone-macro-parentheses)
