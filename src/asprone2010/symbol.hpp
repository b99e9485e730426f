#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "asprone2010/limit_stencils.hpp"

namespace asprone2010::limit_stencils {

/// The symbol of D² on an infinite line: the eigenvalue, times δ², of a wave that advances by θ radians from
/// one particle to the next. The exact one is −θ². Its imaginary part vanishes, since stencils far from the
/// ends are even.
/// \f[ \lambda(\theta) = \sum_j w_j\,(\cos\theta r_j - 1) \f]
template <class Scalar>
Scalar symbol(const Stencil<Scalar>& stencil, const Scalar& theta) {
    const auto& [r, w] = stencil;
    return (w * ((theta * r).cos() - 1)).sum();
}

/// The frequencies that the symbol gives to the N − 2 waves that vanish at both ends of a line of N
/// particles, in increasing order. Where λ is positive the frequency counts as zero.
/// \f[ \omega_n = \frac{\sqrt{-\lambda(\theta_n)}}{\delta}, \qquad \theta_n = \pi n\,\delta, \qquad \delta = \frac{1}{N-1} \f]
inline std::vector<double> symbol_frequencies(const Formulation<double>& formulation,
                                              const numerical_tests::Discretisation& how, Index N) {
    const Stencil<double> inside = near_end(formulation, how, first_interior(how), 2);
    const auto intervals = static_cast<double>(N - 1);
    std::vector<double> frequencies;
    for (Index n = 1; n + 1 < N; ++n) {
        const double theta = std::numbers::pi * static_cast<double>(n) / intervals;
        frequencies.push_back(std::sqrt(std::max(-symbol(inside, theta), 0.0)) * intervals);
    }
    std::sort(frequencies.begin(), frequencies.end());
    return frequencies;
}

}  // namespace asprone2010::limit_stencils
