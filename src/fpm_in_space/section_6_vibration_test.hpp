#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <type_traits>
#include <vector>

#include "asprone2010/section_5_3_vibration_test.hpp"
#include "fpm_in_space/section_3_error_constants.hpp"
#include "fpm_in_space/section_4_derivative_test.hpp"
#include "solvers/rows.hpp"

namespace fpm_in_space {

/// Section 6, the vibration test in the plane and in space: natural frequencies of a membrane, or of the air
/// in a cube, held at its sides. Figure 3 of the first paper, with more coordinates.
///
/// | symbol | code | meaning |
/// | --- | --- | --- |
/// | \f$u\f$ | | displacement; zero on the sides |
/// | \f$K\f$ | `stiffness` | the Laplacian at the particles inside |
/// | \f$M\f$ | `Elements::M` | mass matrix of finite elements |
/// | \f$\omega\f$ | `frequency` | circular frequency, for a speed of sound of one |
/// | \f$m\f$ | `m` | half waves along each coordinate |
/// | \f$n\f$ | `n` | particles along a side, of which n − 2 are inside |
///
/// The frequencies are compared in order, the k-th with the k-th: a mode is not looked for by its shape.
///
/// **On the grid** (membrane.csv, h = 1.2 δ) every formulation follows its symbol, but for the highest
/// frequencies. The lowest one by the second-order FPM is 0.3 percent too low; linear triangles with lumped
/// masses err a sixth of that. Of the higher modes of SSPH most are at less than half their frequency: a fit
/// that need not meet the value at the particle hardly sees values that alternate. The original SPH does not
/// see them at all, and has hundreds of frequencies below the lowest exact one.
///
/// **On perturbed particles** the frequencies change little. But only the matrices of finite elements are
/// symmetric: half of the modes by the second-order FPM belong to complex pairs, of which one grows and one
/// decays, where the grid has three pairs. No imaginary part exceeds 0.8 percent of the real one. Of the
/// original SPH dozens of displacements grow without a vibration.
///
/// \image html fpm_in_space_figure_membrane.svg "Frequencies of a membrane over the exact ones against the mode, as a share of all modes: 30² particles of a grid (left) and perturbed by δ/4 (right), h = 1.2 δ. In grey the symbol on an infinite lattice. The key counts complex pairs, left and right."
///
/// What this section claims, and what was measured: \claims{F-6}.
namespace vibration_test {

using asprone2010::vibration_test::frequency;
using asprone2010::vibration_test::lower;
using asprone2010::vibration_test::Mass;
using derivative_test::Body;
using error_constants::Lattice;
using particles::Column;
using particles::Exponents;
using particles::Index;
using particles::Point;
using particles::Smoothing;
using solvers::SparseRows;
using Frequencies = std::vector<std::complex<double>>;

/// The Laplacian at the particles inside, of the values there; the others are held. \defeq{F20}
/// \f[ K_{ij} = \sum_a D^2_{aa,ij}, \qquad \mathbf{K}\mathbf{u} + \omega^2\mathbf{u} = 0, \qquad
///     i, j\ \text{inside} \tag{F20} \f]
/// \param body whose first particles are those inside
/// \return K [1/length²]
/// \throws base::FailedComputation as particles::assemble()
template <int dim>
SparseRows stiffness(const Formulation<double, dim>& formulation, const Body<dim>& body,
                     const Smoothing<double, dim>& smoothing);

/// The exact frequency of a mode with \f$m_a\f$ half waves along each coordinate. \defeq{F21}
/// \f[ \omega_m = \pi\,\sqrt{\sum_a m_a^2}, \qquad m_a = 1, 2, \ldots \tag{F21} \f]
template <int dim>
double exact_frequency(const std::type_identity_t<Exponents<dim>>& m) {
    double sum = 0;
    for (const int m_a : m) sum += static_cast<double>(m_a) * m_a;
    return std::numbers::pi * std::sqrt(sum);
}

/// The lowest exact frequencies, in order.
template <int dim>
std::vector<double> exact_frequencies(Index count);

/// Whether weights stand on differences \f$B(x_i) - B(x_j)\f$, \eq{A11}, or on minus the values, \eq{A8}.
enum class On { differences, values };

/// The analogue of the original SPH: its first derivative \eq{A11} along each coordinate, applied twice as in
/// \eq{A12}, at the particles inside. \defeq{F22}
/// \f[ K_{ij} = \sum_a \sum_k D_{a,ik}\,D_{a,kj}, \qquad
///     D_a B(x_i) = \sum_j [B(x_i) - B(x_j)]\,\partial_a W_i(x_j)\,V_j \tag{F22} \f]
/// On a line it is the first paper's. Where h is wide, \f$\mathbf{K}\f$ is the Laplacian of the Gaussian of
/// \f$\sqrt{2}\,h\f$ inside a grid, but not beside the sides. It is not symmetric beside the sides and
/// where the particles are perturbed, since each difference has \f$B(x_i)\f$, too. With weights on the values
/// \f$D_a\f$ is antisymmetric where volumes are equal, and K symmetric; but then the derivative of a constant
/// is not zero there.
template <int dim>
SparseRows original_stiffness(const Body<dim>& body, const Smoothing<double, dim>& smoothing,
                              On weights = On::differences);

/// Linear finite elements: \f$\mathbf{K}\mathbf{u} + \omega^2\mathbf{M}\mathbf{u} = 0\f$.
struct Elements {
    SparseRows K;  ///< minus the stiffness matrix, so that its sign is that of \eq{F20}
    SparseRows M;  ///< [length²]
};

/// Linear triangles between the particles: each square of the grid is cut in two from its lower left to its
/// upper right, also where the particles are perturbed. \defeq{F23}
/// \f[ K_{ij} = -\int \nabla N_i \cdot \nabla N_j\,dA, \qquad M_{ij} = \int N_i\,N_j\,dA
///     \quad\text{or, lumped,}\quad \delta_{ij} \int N_i\,dA \tag{F23} \f]
/// On the grid K is that of differences between the four nearest particles.
/// \throws base::FailedComputation where a triangle is turned over, which no perturbation up to δ/4 does
Elements elements(const Body<2>& body, Mass mass);

/// All frequencies \f$\omega = \sqrt{-\lambda}\f$, by increasing real part, then imaginary part. Imaginary
/// parts of λ up to \f$\sqrt{\varepsilon}\max|\lambda|\f$ count as zero: a real eigenvalue that is double and
/// has one eigenvector splits by as much where the matrix changes by its round-off, ε max|λ|.
Frequencies frequencies(const SparseRows& K);

/// Those of a symmetric problem, all of them real.
Frequencies frequencies(const Elements& elements);

/// The lowest frequencies, those of the smallest |ω|, in the same order: for grids too large for all of them.
/// \param count at most K.rows() − 2
/// \throws base::FailedComputation where K is singular or the iteration does not converge
Frequencies lowest_frequencies(const SparseRows& K, Index count);
Frequencies lowest_frequencies(const Elements& elements, Index count);

/// How many pairs of conjugate frequencies there are; such modes do not vibrate alone, they grow or decay.
Index complex_pairs(const Frequencies& frequencies);

/// The frequencies that the symbol \eq{F13} gives to the waves that vanish on the sides of a grid, in order,
/// \f[ \omega_m = \frac{\sqrt{-\lambda(\theta_m)}}{\delta}, \qquad \theta_m = \pi\,m\,\delta, \qquad
///     m_a = 1, \ldots, n - 2 \f]
/// Where λ is positive, the frequency counts as zero.
/// \param lattice without a boundary \param n particles along a side
template <int dim>
std::vector<double> symbol_frequencies(const Formulation<base::Quad, dim>& formulation,
                                       const Lattice<dim>& lattice, Index n);

/// The same of \eq{F22}:
/// \f[ \lambda(\theta) = -\sum_a \Big(\sum_j \partial_a W(r_j)\,V_j \sin\theta \cdot r_j\Big)^2 \f]
template <int dim>
std::vector<double> original_symbol_frequencies(const Lattice<dim>& lattice, Index n);

// Compiled once, in section_6_vibration_test.cpp.
extern template SparseRows stiffness(const Formulation<double, 2>&, const Body<2>&,
                                     const Smoothing<double, 2>&);
extern template SparseRows stiffness(const Formulation<double, 3>&, const Body<3>&,
                                     const Smoothing<double, 3>&);
extern template std::vector<double> exact_frequencies<2>(Index);
extern template std::vector<double> exact_frequencies<3>(Index);
extern template SparseRows original_stiffness(const Body<1>&, const Smoothing<double, 1>&, On);
extern template SparseRows original_stiffness(const Body<2>&, const Smoothing<double, 2>&, On);
extern template SparseRows original_stiffness(const Body<3>&, const Smoothing<double, 3>&, On);
extern template std::vector<double> symbol_frequencies(const Formulation<base::Quad, 2>&, const Lattice<2>&,
                                                       Index);
extern template std::vector<double> symbol_frequencies(const Formulation<base::Quad, 3>&, const Lattice<3>&,
                                                       Index);
extern template std::vector<double> original_symbol_frequencies(const Lattice<2>&, Index);
extern template std::vector<double> original_symbol_frequencies(const Lattice<3>&, Index);

}  // namespace vibration_test
}  // namespace fpm_in_space
