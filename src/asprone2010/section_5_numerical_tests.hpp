#pragma once

#include <cmath>

#include "asprone2010/formulations.hpp"
#include "base/text.hpp"
#include "particles/spacing.hpp"

namespace asprone2010 {

/// Section 5, the setting of the three numerical tests: Ω = [0, 1], particles at equal distances, a Gaussian
/// with h = δ.
///
/// | paper | code | meaning |
/// | --- | --- | --- |
/// | \f$N\f$ | `N`, `line.size()` | number of particles |
/// | \f$\delta\f$ | `line.spacing()` | distance between particles |
/// | \f$h\f$ | `smoothing.h()` | smoothing length, `Discretisation::smoothing` times δ |
/// | δ/4 | `Discretisation::perturbation` | amplitude of the random displacement, 1/4 |
///
/// The print leaves open where the particles lie in their cells, which volumes the end particles carry, which
/// numbers of particles are taken, and how often a perturbed line is drawn. Here both ends carry a particle,
/// since boundary conditions are imposed there. Volumes follow a named convention, by default δ for every
/// particle: \eq{A3} fits cells that tile Ω, but the overlap of two spectra in Figure 3 and footnote 1 are
/// reproduced better with δ (\claim{A-5.3-original-overlaps}, \claim{A-5.2-few-original}). h stays δ when
/// particles are perturbed.
namespace numerical_tests {

/// How a line of N particles is made, and its smoothing length.
struct Discretisation {
    particles::Volumes volumes = particles::Volumes::equal;
    particles::Kernel<> kernel = particles::Gaussian{};
    double smoothing = 1;     ///< h/δ
    double perturbation = 0;  ///< amplitude a of the random displacement, in units of δ
    particles::Spacing smoothing_from = particles::Spacing::mean;  ///< the δ of h/δ
};

/// Particles, and a kernel with its smoothing length.
template <class Scalar = double>
struct Particles {
    Line<Scalar> line;
    particles::Smoothing<Scalar> smoothing;
};

/// Particles at given positions; the perturbation does not enter.
/// \throws base::InvalidInput for positions that do not increase, h ≤ 0
template <class Scalar>
Particles<Scalar> discretise(const Discretisation& how, const Column<Scalar>& x) {
    if (!(std::isfinite(how.smoothing) && how.smoothing > 0))
        throw base::InvalidInput("the smoothing length over the spacing must be positive and finite, got " +
                                 base::shown(how.smoothing));
    const Line<Scalar> line = particles::line_at<Scalar>(x, how.volumes);
    const Column<Scalar> spacing = particles::spacing(line, how.smoothing_from);
    return {line, particles::Smoothing<Scalar>(how.kernel, spacing, Scalar(how.smoothing))};
}

/// The N particles of a discretisation; the seed matters where they are perturbed.
/// \throws base::InvalidInput for N < 2, a perturbation outside [0, 1/2), h ≤ 0
template <class Scalar = double>
Particles<Scalar> discretise(const Discretisation& how, Index N, unsigned long seed) {
    const Column<Scalar> x = how.perturbation == 0
                                 ? particles::uniform_positions<Scalar>(N)
                                 : particles::perturbed_positions<Scalar>(N, how.perturbation, seed);
    return discretise(how, x);
}

// Compiled once: see formulations.hpp.
extern template Particles<double> discretise(const Discretisation&, const Column<double>&);
extern template Particles<double> discretise(const Discretisation&, Index, unsigned long);
extern template Particles<long double> discretise(const Discretisation&, const Column<long double>&);
extern template Particles<long double> discretise(const Discretisation&, Index, unsigned long);

/// \f$\max_j |a_j - b_j|\f$, the norm in which the displacement's error is measured.
template <class Scalar>
Scalar distance(const Column<Scalar>& a, const Column<Scalar>& b) {
    return (a - b).abs().maxCoeff();
}

}  // namespace numerical_tests
}  // namespace asprone2010
