#pragma once

#include <cmath>
#include <optional>

#include "asprone2010/section_5_numerical_tests.hpp"
#include "base/smooth.hpp"

namespace asprone2010 {

/// Section 5.1, the derivative test: errors of the derivatives of eˣ. Figure 1.
///
/// | paper | code | meaning |
/// | --- | --- | --- |
/// | \f$f(x) = e^x\f$ | `exponential()` | the function, with its derivatives |
/// | \f$f''(x)\f$ | `Smooth::D2f` | its second derivative |
/// | infinity norm | `Errors` | largest error over the particles, all or interior |
///
/// The particles hold the exact values. D and D² are applied to them and compared with the exact derivatives
/// in the infinity norm: the worst particle decides, and it lies on the boundary or next to it.
///
/// \image html asprone2010_figure_1.svg "Infinity norm of the error of the second derivative against the number of particles, and its spread on perturbed particles."
///
/// What this section claims, and what was measured: \claims{A-5.1}.
/// The figure of a function, kernel and smoothing length of yours: \ref live_figure_1.
namespace derivative_test {

using base::Smooth;

/// The paper's function, \f$f(x) = e^x\f$.
template <class Scalar = double>
Smooth<Scalar> exponential() {
    const auto exponential_of = [](const Scalar& x) {
        using std::exp;
        return Scalar(exp(x));
    };
    return {exponential_of, exponential_of, exponential_of};
}

/// Infinity norms of the errors of DB and D²B.
template <class Scalar = double>
struct Errors {
    Scalar first, second;
    std::optional<Scalar> first_interior, second_interior;  ///< empty where no particle is interior
};

/// The errors of the operators of given particles. A particle is interior if its distance from both ends is
/// larger than the radius of the support. (The boundary influences operators applied twice over twice that
/// distance.)
template <class Scalar>
Errors<Scalar> errors(const particles::Operators<Scalar>& operators,
                      const numerical_tests::Particles<Scalar>& discrete, const Smooth<Scalar>& exact) {
    const auto& [line, smoothing] = discrete;
    const auto& [D, D2] = operators;
    const Column<Scalar>& x = line.x();
    const Column<Scalar> B = x.unaryExpr(exact.f);
    const Column<Scalar> first = (particles::apply(D, B) - x.unaryExpr(exact.Df)).abs();
    const Column<Scalar> second = (particles::apply(D2, B) - x.unaryExpr(exact.D2f)).abs();

    Errors<Scalar> largest{first.maxCoeff(), second.maxCoeff(), {}, {}};
    const Scalar reach = smoothing.reach();
    Index left = 0;
    while (left < line.size() && !(x[left] - x[0] > reach)) ++left;
    Index right = line.size();
    while (right > left && !(x[line.size() - 1] - x[right - 1] > reach)) --right;
    if (left < right) {
        largest.first_interior = first.segment(left, right - left).maxCoeff();
        largest.second_interior = second.segment(left, right - left).maxCoeff();
    }
    return largest;
}

// Compiled once: see formulations.hpp.
extern template Errors<double> errors(const particles::Operators<double>&,
                                      const numerical_tests::Particles<double>&, const Smooth<double>&);
extern template Errors<long double> errors(const particles::Operators<long double>&,
                                           const numerical_tests::Particles<long double>&,
                                           const Smooth<long double>&);

/// The errors of a formulation on given particles.
template <class Scalar>
Errors<Scalar> errors(const Formulation<Scalar>& formulation,
                      const numerical_tests::Particles<Scalar>& discrete, const Smooth<Scalar>& exact) {
    return errors(formulation.operators(discrete.line, discrete.smoothing), discrete, exact);
}

}  // namespace derivative_test
}  // namespace asprone2010
