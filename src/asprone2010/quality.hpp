#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "asprone2010/section_5_numerical_tests.hpp"
#include "particles/quality.hpp"

namespace asprone2010 {

/// Beyond the print: whether the operators of a formulation on given particles are worth a table.
///
/// \eq{A40} makes \eq{A42} regular for every particle, not \eq{A43} (\claim{A-4-system-regular}): its
/// \f$A_{12}\f$ has a zero at the second particle of a line with a short first gap, for h = 2δ and equal
/// volumes at 0.098 δ. Next to the zero no system is singular, and the error of the second derivative of eˣ
/// is 38. Neither \f$A_{12}\f$ nor a condition number tells such a row from a good one, since both are small
/// at an end, too. The bound of the error tells: R of particles::quality(), measured for \eq{A43} with h = δ:
///
/// | particles | largest R |
/// | --- | --- |
/// | equal distances, far from the ends | 0.13 |
/// | equal distances | 6.2 |
/// | 20 000 lines perturbed by δ/4, 10 to 2560 particles | 15.4 |
/// | h = 2δ, first gap 0.12 δ, 0.099 δ, 0.0981 δ, 0.09806 δ | 16, 424, 1e4, 2e6 |
///
/// On the same lines, the other formulations stay below 3.1. `derivative_test --perturb 0.25 --seeds 607
/// --quality --median` repeats this.
namespace quality {

/// The spacing δ of each particle's h/δ, in which R is measured; the mean spacing, where h was given as a
/// length. One for all, or one for each. [length]
Column<double> spacing(const numerical_tests::Particles<double>& discrete);

/// The rows of D and of D² that a test on N particles uses.
struct Rows {
    particles::Range first, second;
};
using RowsOf = Rows (*)(Index N);

/// All: the derivatives are compared at each particle.
inline Rows of_derivative_test(Index N) {
    return {{0, N}, {0, N}};
}
/// D² inside, and D at the last particle.
inline Rows of_static_test(Index N) {
    return {{N - 1, N}, {1, N - 1}};
}
/// D² inside.
inline Rows of_vibration_test(Index N) {
    return {{0, 0}, {1, N - 1}};
}

/// A row and how far it may err: its error is at most \f$R\,\delta^p\,\max|B^{(m+1)}|\f$.
struct Row {
    double R = 0;
    double sum = 0;  ///< Σ|w|, by which round-off of B is multiplied [1/length^k]
    Index particle = 0;
    int derivative = 2;  ///< k: 1 for a row of D, 2 for one of D²
    int exact = 0;       ///< m
    double ratio = 1;    ///< h/δ
    [[nodiscard]] int p() const { return exact + 1 - derivative; }
};

/// The largest R of a row that is worth a table, \f$1000\max(1, h/\delta)^p\f$: a wide kernel errs by
/// \f$O(h^p)\f$, which is not the row's fault. With h = δ it is sixty times the worst of the perturbed lines
/// above; the second derivative of eˣ may then err by 10 % on 100 particles. With p ≤ 0, no number of
/// particles makes the error small, and it is 100.
inline double most(const Row& row) {
    return row.p() > 0 ? 1000 * std::pow(std::max(1.0, row.ratio), row.p()) : 100;
}

/// The most that round-off may contribute to a derivative, as a share of max |B|. A million particles at equal
/// distances stay ten times below it in double precision; two particles 10⁻⁸ apart may not.
constexpr double most_round_off = 0.1;

/// The round-off unit of a computation, and whether its user may choose a smaller one.
struct Precision {
    double unit = std::numeric_limits<double>::epsilon();
    bool finer = false;
};

/// The worst of the rows of a formulation that a test uses, measured by R over most(). Errors as for
/// Formulation::operators.
Row worst(const Formulation<double>& formulation, const numerical_tests::Particles<double>& discrete,
          RowsOf rows);

/// \return the worst of the rows
/// \throws base::FailedComputation where its R is larger than most(), or where round-off, the unit times Σ|w|
///         of a row, is larger than most_round_off, naming the formulation, the particle, its position, the
///         number, and what helps, after trying it
Row require(const Formulation<double>& formulation, const numerical_tests::Particles<double>& discrete,
            RowsOf rows, const Precision& precision = {});

}  // namespace quality
}  // namespace asprone2010
