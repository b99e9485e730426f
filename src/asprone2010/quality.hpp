#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "asprone2010/section_5_numerical_tests.hpp"
#include "base/errors.hpp"
#include "particles/quality.hpp"

namespace asprone2010 {

/// Beyond the print: whether the operators of a formulation on given particles are worth a table.
///
/// \eq{A40} makes \eq{A42} regular for every particle, and on lines like the print's so is \eq{A43}
/// (\claim{A-4-system-regular}). Not on every line: its \f$A_{12}\f$ has a zero at the second particle of a
/// line with a short first gap, for h = 2δ and equal volumes at 0.098 δ. Next to the zero no system is
/// singular, and the error of the second derivative of eˣ is 38. Neither \f$A_{12}\f$ nor a condition number
/// tells such a row from a good one, since both are small at an end, too. The bound of the error tells: R of
/// particles::quality(), measured for \eq{A43} with h = δ:
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
template <class Scalar>
Column<Scalar> spacing(const numerical_tests::Particles<Scalar>& discrete) {
    const auto& [line, smoothing] = discrete;
    if (!smoothing.ratio()) return particles::spacing(line, particles::Spacing::mean);
    Column<Scalar> delta(smoothing.is_local() ? line.size() : 1);
    for (Index i = 0; i < delta.size(); ++i) delta[i] = smoothing.h(i) / *smoothing.ratio();
    return delta;
}

/// The rows of D and of D² that a test on N particles uses, and whether it applies them to rounded values, so
/// that round-off is multiplied by Σ|w|.
struct Rows {
    particles::Range first, second;
    bool rounded = false;
};
using RowsOf = Rows (*)(Index N);

/// All: the derivatives are compared at each particle.
inline Rows of_derivative_test(Index N) {
    return {{0, N}, {0, N}, true};
}
/// D² inside, and D at the last particle. Its solution is corrected for residuals of exact differences.
inline Rows of_static_test(Index N) {
    return {{N - 1, N}, {1, N - 1}, false};
}
/// D² inside.
inline Rows of_vibration_test(Index N) {
    return {{0, 0}, {1, N - 1}, true};
}
/// D² inside, which is solved and not applied.
inline Rows of_lowest_modes(Index N) {
    return {{0, 0}, {1, N - 1}, false};
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

/// The most that round-off may contribute to a derivative, as a share of max |B|. Three million particles at
/// equal distances stay below it in double precision; two particles 10⁻⁸ apart may not.
constexpr double most_round_off = 0.1;

/// The rows of a test that may err most.
struct Worst {
    Row by_error, by_round_off;  ///< with the largest R over most(), and the largest Σ|w|
    double unit = std::numeric_limits<double>::epsilon();  ///< of round-off in the test

    /// The share of max |B| that round-off may contribute.
    [[nodiscard]] double round_off() const { return unit * by_round_off.sum; }
};

/// Whether the worst rows are worth a table.
inline bool worth_a_table(const Worst& worst) {
    return worst.by_error.R <= most(worst.by_error) && worst.round_off() <= most_round_off;
}

/// The worst of the rows that a test uses.
/// \param exact the degrees up to which D and D² are exact
template <class Scalar>
Worst worst(const particles::Operators<Scalar>& operators, const Exactness& exact,
            const numerical_tests::Particles<Scalar>& discrete, RowsOf rows) {
    const auto& [line, smoothing] = discrete;
    const Column<Scalar> delta = spacing(discrete);
    const auto ratio = static_cast<double>(smoothing.h() / delta.maxCoeff());
    const Rows used = rows(line.size());
    Worst found;
    found.unit = static_cast<double>(std::numeric_limits<Scalar>::epsilon());
    const auto look = [&, &line = line](const Operator<Scalar>& derivative, int k, int degree,
                                        const particles::Range& some) {
        if (some.size() <= 0) return;
        const Column<Scalar> R = particles::quality(derivative, line, k, degree, delta),
                             sum = particles::absolute_sums(derivative);
        const auto row_of_largest = [&](const Column<Scalar>& of) {
            Row row{0, 0, 0, k, degree, ratio};
            of.segment(some.first, some.size()).maxCoeff(&row.particle);
            row.particle += some.first;
            row.R = static_cast<double>(R[row.particle]);
            row.sum = static_cast<double>(sum[row.particle]);
            return row;
        };
        const Row error = row_of_largest(R), round_off = row_of_largest(sum);
        if (error.R / most(error) > found.by_error.R / most(found.by_error)) found.by_error = error;
        if (used.rounded && round_off.sum > found.by_round_off.sum) found.by_round_off = round_off;
    };
    look(operators.D, 1, exact.first, used.first);
    look(operators.D2, 2, exact.second, used.second);
    return found;
}

// Compiled once: see formulations.hpp.
extern template Worst worst(const particles::Operators<double>&, const Exactness&,
                            const numerical_tests::Particles<double>&, RowsOf);
extern template Worst worst(const particles::Operators<long double>&, const Exactness&,
                            const numerical_tests::Particles<long double>&, RowsOf);

/// The formulations from which a test has D and D²: one, or two.
struct Source {
    const Formulation<double>&first, &second;

    [[nodiscard]] Exactness exact() const { return {first.exact.first, second.exact.second}; }
};

/// The worst rows of these formulations. Errors as for Formulation::operators.
Worst worst(const Source& source, const numerical_tests::Particles<double>& discrete, RowsOf rows);

/// Why the worst rows are not worth a table: the formulation, the particle, its position, R or the round-off,
/// and what helps, after trying it.
/// \param finer whether the test can be computed in a finer precision
base::FailedComputation refusal(const Worst& worst, const Source& source,
                                const numerical_tests::Particles<double>& discrete, RowsOf rows,
                                bool finer = false);

}  // namespace quality
}  // namespace asprone2010
