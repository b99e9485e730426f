#pragma once

#include "particles/centred_kernel.hpp"
#include "particles/neighbourhood.hpp"
#include "particles/operators.hpp"

/// Asprone, Auricchio, Manfredi, Prota, Reali, Sangalli (2010), *Particle Methods for a 1D Elastic Model
/// Problem: Error Analysis and Development of a Second-Order Accurate Formulation*, CMES 62(1), 1–21.
namespace asprone2010 {

using base::Interval;
using particles::CentredKernel;
using particles::Column;
using particles::Derivatives;
using particles::Function;
using particles::Index;
using particles::inverse;
using particles::Line;
using particles::Neighbourhood;
using particles::nonzero_sum;
using particles::Operator;
using particles::product;

/// Section 2, classical SPH: from Dirac's delta to a sum over particles, in two approximation steps.
///
/// The kernel must be non-negative, of unit integral, smooth and of compact support; the Gaussian breaks the
/// last condition and is cut where it is negligible. particles/kernels.hpp has the kernels, each with
/// h = 1.
///
/// | paper | code | meaning |
/// | --- | --- | --- |
/// | \f$B\f$ | `B` | the function whose values are known |
/// | \f$x_i\f$ | `W_i.x` | a particle |
/// | \f$W_i,\ DW_i\f$ | `W`, `DW` | kernel centred at \f$x_i\f$ and its derivative in x |
/// | \f$x_j - x_i\f$ | `r` | offset |
/// | \f$\Delta\Omega_j\f$ | `V` | subdomain of a particle, and its measure |
/// | \f$h,\ \delta\f$ | `h`, `spacing` | smoothing length, distance between particles |
///
/// Departures from the print: it calls the diameter of the support the smoothing length h, yet Section 5 sets
/// h to the particle spacing δ, and a support of diameter δ holds no neighbour. Here h is the Gaussian's
/// length in \f$e^{-((x-x_i)/h)^2}\f$, and the radius of the support is a property of the kernel. And \eq{A3}
/// asks for volumes that tile Ω (`partition`); the tests of Section 5 take δ for every particle by default
/// (`equal`), for the reasons in \ref asprone2010::numerical_tests.
///
/// What this section claims, and what was measured: \claims{A-2}.
/// Its weights and their moments, on particles that you move: \ref live_stencil.
namespace classical_sph {

/// Dirac's delta at \f$x_i\f$ picks the value there: all that follows approximates this. \defeq{A1}
/// \f[ B(x_i) = \int_\Omega B(x)\,\delta_i(x)\,d\Omega \tag{1} \f]
inline double picked_value(const Function& B, double x_i) {
    return B(x_i);
}

/// First step: a kernel takes the place of the delta. \defeq{A2}
/// \f[ B(x_i) \cong \int_\Omega B(x)\,W_i(x)\,d\Omega \tag{2} \f]
/// \return the smoothed value, in the unit of B
inline double value(const Function& B, const CentredKernel& W_i) {
    return W_i.integral([&](double x) { return B(x) * W_i.W(x); });
}

/// The domain is divided among the particles: bounds of their subdomains, N + 1 numbers. \defeq{A3}
/// \f[ \bigcup_{j=1}^N \Delta\Omega_j = \Omega \tag{3} \f]
/// The print does not say where the bounds lie: here they are the midpoints between particles and both
/// ends of Ω.
template <class Scalar>
Column<Scalar> subdomain_bounds(const Line<Scalar>& line) {
    return particles::cell_bounds(line.x());
}

/// Second step: a sum over the particles takes the place of the integral. \defeq{A4}
/// \f[ B(x_i) \cong \sum_{j=1}^N B(x_j)\,W_i(x_j)\,\Delta\Omega_j \tag{4} \f]
/// \param near the particles in the support of \f$W_i\f$
/// \return weights on \f$B(x_j)\f$ [1]
template <class Scalar>
Column<Scalar> value(const Neighbourhood<Scalar>& near) {
    const auto& [r, W, DW, V] = near;
    return W * V;
}

}  // namespace classical_sph
}  // namespace asprone2010
