#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "asprone2010/section_5_numerical_tests.hpp"
#include "solvers/spectrum.hpp"

namespace asprone2010 {

/// Section 5.3, the vibration test: natural frequencies of a rod fixed at both ends. Figure 3.
///
/// | paper | code | meaning |
/// | --- | --- | --- |
/// | \f$X, x\f$ | `X` | initial position; the displacement that vibrates is `x` in the equations |
/// | \f$\omega_n\f$ | `frequency` | circular frequency of mode n |
/// | \f$K\f$ | `stiffness` | D² without the rows and columns of the fixed ends |
///
/// Departures from the print: \eq{A47} and \eq{A48} have the wrong sign. Only with the signs below do they
/// give \eq{A49} and \eq{A50}; as printed, \eq{A47} with \f$x = \sin(\omega X)e^{i\omega t}\f$ leaves
/// \f$-2\omega^2 x\f$. And the eigenvalues of K in \eq{A52} approximate \f$-\omega_n^2\f$. N particles have
/// N − 2 modes, since two are fixed.
///
/// \image html asprone2010_figure_3.svg "Frequencies over exact frequencies, 100 particles, and those of linear finite elements (FEM) with consistent and with lumped mass."
///
/// What this section claims, and what was measured: \claims{A-5.3}.
/// The figure of a kernel, smoothing length and line of yours: \ref live_figure_3.
namespace vibration_test {

/// The ends are fixed: their rows and columns of D² are left out. \defeq{A46}
/// \f[ x(0) = x(1) = 0 \tag{46} \f]
/// \param D2 second derivative at N particles [1/length²]
/// \return K, (N − 2) × (N − 2)
inline Eigen::MatrixXd stiffness(const Operator<double>& D2) {
    const Index N = D2.rows();
    return Eigen::MatrixXd(D2).block(1, 1, N - 2, N - 2);
}

/// Equation of motion: its residual for given second derivatives. The print has a plus. \defeq{A47}
/// \f[ \frac{\partial^2 x}{\partial X^2} - \frac{\partial^2 x}{\partial t^2} = 0 \tag{47} \f]
inline double unbalance(double d2x_dX2, double d2x_dt2) {
    return d2x_dX2 - d2x_dt2;
}

/// Acceleration of a displacement that vibrates with frequency ω. The print has no minus. \defeq{A48}
/// \f[ \frac{\partial^2 x}{\partial t^2} = -\omega^2 x \tag{48} \f]
inline double acceleration(double omega, double x) {
    return -omega * omega * x;
}

/// \eq{A47} with \eq{A48}: the residual of a stationary vibration. \defeq{A49}
/// \f[ \frac{\partial^2 x}{\partial X^2} + \omega^2 x = 0 \tag{49} \f]
inline double stationary_unbalance(double d2x_dX2, double omega, double x) {
    return unbalance(d2x_dX2, acceleration(omega, x));
}

/// Shape of a mode. \defeq{A50}
/// \f[ x = \sin(\omega X) \tag{50} \f]
inline double mode(double omega, double X) {
    return std::sin(omega * X);
}

/// Exact frequency of mode n = 1, 2, … \defeq{A51}
/// \f[ \omega_n = \pi n \tag{51} \f]
inline double exact_frequency(Index n) {
    return std::numbers::pi * static_cast<double>(n);
}

/// Order of frequencies: by the real part, then by the imaginary part.
inline bool lower(const std::complex<double>& a, const std::complex<double>& b) {
    return a.real() != b.real() ? a.real() < b.real() : a.imag() < b.imag();
}

/// The discrete problem, an eigenvalue problem \f$\mathbf{K}\mathbf{x} = \lambda\mathbf{x}\f$ with
/// \f$\lambda = -\omega^2\f$. \defeq{A52}
/// \f[ \mathbf{K}\mathbf{x} + \omega^2\mathbf{x} = 0 \tag{52} \f]
/// \return \f$\omega = \sqrt{-\lambda}\f$; it is real where the eigenvalue is negative
inline std::complex<double> frequency(const std::complex<double>& lambda) {
    // The complex root of a negative number has a real part of round-off in some libraries.
    if (lambda.imag() == 0 && lambda.real() > 0)
        return {0, std::copysign(std::sqrt(lambda.real()), -lambda.imag())};
    return std::sqrt(-lambda);
}

/// All frequencies of \eq{A52}, by increasing real part, then imaginary part.
inline std::vector<std::complex<double>> frequencies(const Eigen::MatrixXd& K) {
    std::vector<std::complex<double>> omega = solvers::eigenvalues(K);
    std::transform(omega.begin(), omega.end(), omega.begin(), frequency);
    std::sort(omega.begin(), omega.end(), lower);
    return omega;
}

/// Frequencies of a formulation on given particles.
inline std::vector<std::complex<double>> frequencies(const Formulation<double>& formulation,
                                                     const numerical_tests::Particles<double>& discrete) {
    return frequencies(stiffness(formulation.operators(discrete.line, discrete.smoothing).D2));
}

/// A mode of \eq{A52}.
struct Mode {
    std::complex<double> frequency;
    double residual =
        0;  ///< \f$\|\mathbf{K}^{-1}\mathbf{x} + \mathbf{x}/\omega^2\| / \|\mathbf{x}/\omega^2\|\f$
};

/// The lowest modes of \eq{A52}, for lines too long for the whole spectrum.
///
/// Shapes are the eigenvectors of \f$\mathbf{K}^{-1}\f$ with the largest eigenvalues θ. Frequencies follow
/// from \f$\theta = \mathbf{x}\cdot\mathbf{K}^{-1}\mathbf{x}\f$ by a solution that is corrected as in the
/// static test: a product with K has round-off of the size of \f$\varepsilon/\delta^2\f$. Lowest means
/// smallest |ω|; where frequencies are not real, modes that are not returned may have a lower real part.
/// \param D2 second derivative at N particles \param count of modes, at most N − 4
/// \return by increasing real part, then imaginary part
/// \throws base::FailedComputation where K is singular or the iteration does not converge
inline std::vector<Mode> lowest_modes(const Operator<double>& D2, Index count) {
    const Index inner = D2.rows() - 2;
    const Operator<double> K = particles::among(D2, {1, inner + 1});
    const solvers::BandedFactors<double> factors(K);
    factors.require_regular();
    const auto inverse = [&](const Column<double>& x, const Column<double>& nearly) {
        if ((x == 0).all()) return x;
        Column<double> y = Column<double>::Zero(inner + 2);
        y.segment(1, inner) = nearly;
        for (int k = 0; k < 2; ++k)
            y.segment(1, inner) += factors.solve(x - particles::apply(D2, y).segment(1, inner));
        return Column<double>(y.segment(1, inner));
    };
    const auto [thetas, shapes] = solvers::largest_of_inverse(factors, inner, count);
    std::vector<Mode> modes(static_cast<std::size_t>(count));
    base::for_each_index(count, [&, &values = thetas, &vectors = shapes](Index k) {
        const Eigen::VectorXcd x = vectors.col(k).normalized(), nearly = values[k] * x;
        Eigen::VectorXcd inverse_x(inner);
        inverse_x.real() = inverse(x.real(), nearly.real()).matrix();
        inverse_x.imag() = inverse(x.imag(), nearly.imag()).matrix();
        const std::complex<double> theta = x.dot(inverse_x);
        const std::complex<double> lambda = 1.0 / theta;
        modes[static_cast<std::size_t>(k)] = {frequency(lambda),
                                              (inverse_x - theta * x).norm() / std::abs(theta)};
    });
    std::sort(modes.begin(), modes.end(),
              [](const Mode& a, const Mode& b) { return lower(a.frequency, b.frequency); });
    return modes;
}

/// How the mass of a linear finite element is distributed.
enum class Mass { lumped, consistent };

/// Frequencies of linear finite elements between the particles, with both ends fixed: the reference curves.
/// Stiffness and mass matrices are assembled and the generalised eigenvalue problem is solved.
inline std::vector<std::complex<double>> finite_element_frequencies(const Line<double>& line, Mass mass) {
    const Index N = line.size();
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(N, N);
    Eigen::MatrixXd M = Eigen::MatrixXd::Zero(N, N);
    for (Index e = 0; e + 1 < N; ++e) {
        const double l = line.x()[e + 1] - line.x()[e];
        K.block<2, 2>(e, e) += Eigen::Matrix2d{{1, -1}, {-1, 1}} / l;
        M.block<2, 2>(e, e) += mass == Mass::lumped ? Eigen::Matrix2d{{l / 2, 0}, {0, l / 2}}
                                                    : Eigen::Matrix2d{{l / 3, l / 6}, {l / 6, l / 3}};
    }
    std::vector<std::complex<double>> omega;
    for (const double lambda :
         solvers::symmetric_eigenvalues(K.block(1, 1, N - 2, N - 2), M.block(1, 1, N - 2, N - 2)))
        omega.emplace_back(std::sqrt(lambda));
    return omega;
}

/// D² of linear finite elements with lumped masses, \f$-\mathbf{M}^{-1}\mathbf{K}\f$, between the same
/// particles: with it \eq{A52} is their eigenvalue problem. The rows of the ends are empty.
inline Operator<double> lumped_second_derivative(const Line<double>& line) {
    const Index N = line.size();
    Operator<double> D2(N, N);
    D2.reserve(Eigen::VectorXi::Constant(N, 3));
    for (Index i = 1; i + 1 < N; ++i) {
        const double before = line.x()[i] - line.x()[i - 1], behind = line.x()[i + 1] - line.x()[i],
                     mass = (before + behind) / 2;
        D2.insert(i, i - 1) = 1 / before / mass;
        D2.insert(i, i) = -(1 / before + 1 / behind) / mass;
        D2.insert(i, i + 1) = 1 / behind / mass;
    }
    D2.makeCompressed();
    return D2;
}

}  // namespace vibration_test
}  // namespace asprone2010
