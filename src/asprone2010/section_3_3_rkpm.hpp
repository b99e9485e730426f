#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "asprone2010/section_3_1_original.hpp"

namespace asprone2010 {

/// Section 3.3, the reproducing kernel particle method: a polynomial corrects the kernel's moments.
///
/// The zeroth moment of the corrected kernel \f$K_i = C_i W_i\f$ is one; the higher moments, up to the order,
/// are zero. The discrete forms take moments as sums over particles, the integral forms by quadrature; both
/// solve \f$M c = e_0\f$ with \f$M_{kl}\f$ the (k+l)-th moment of \f$W_i\f$.
///
/// Why it fails, with either order: the conditions bind the moments of \f$K_i\f$, but \eq{A25} sums
/// \f$DK_i\f$, of which nothing binds the moments. \f$\sum_j (x_j - x_i)\,DK_i V_j\f$, which must be minus
/// one, is -0.98 inside and -0.17 at an end for the second order, -0.998 and -0.30 for the first, with h = δ.
/// Integration by parts ties the two sets of moments together for integrals, and not for sums.
///
/// | paper | code | meaning |
/// | --- | --- | --- |
/// | \f$C_i\f$ | `correction<p...>` | polynomial with the exponents p of \f$(x-x_i)/h\f$ |
/// | \f$a_i, b_i, c_i\f$ | `c[0], c[1], c[2]` | its coefficients |
/// | \f$K_i,\ DK_i\f$ | `K`, `DK` | corrected kernel and its derivative |
///
/// Departures from the print: \f$C_i\f$ is a polynomial of the scaled offset, which changes its coefficients
/// and not \f$K_i\f$. In the discrete forms the moments are sums; the print imposes moments of integrals
/// here, and of sums in Section 4 only. For the second order this choice has a large effect, which \ref
/// choices measures.
///
/// What this section claims, and what was measured: \claims{A-3.3}.
/// Its weights and their moments, on particles that you move: \ref live_stencil.
namespace rkpm {

/// The improved representation of a function. \defeq{A21}
/// \f[ B(x_i) \cong \int_\Omega B(x)\,K_i(x)\,d\Omega \tag{21} \f]
/// \return the value, with an error of O(h²) for the first order and O(h³) for the second
inline double value(const Function& B, const CentredKernel& K_i) {
    return classical_sph::value(B, K_i);
}

/// \f$s^n\f$.
template <int n, class Scalar>
Scalar power(const Scalar& s) {
    if constexpr (n == 0)
        return Scalar(1);
    else if constexpr (n == 1)
        return s;
    else
        return power<n - 1>(s) * s;
}

/// The correction polynomial, here with any set of exponents: 0, 1 for the first order and 0, 1, 2 for the
/// second. \defeq{A23}
/// \f[ C_i(x) = a_i + b_i (x - x_i) + c_i (x - x_i)^2 + \dots \tag{23} \f]
/// \tparam p the exponents
/// \param c the coefficients, one for each exponent
/// \param s scaled offset \f$(x - x_i)/h\f$
template <int... p, class Coefficients, class Scalar>
Scalar correction(const Coefficients& c, const Scalar& s) {
    Index k = 0;
    Scalar sum(0);
    ((sum += c[k++] * power<p>(s)), ...);
    return sum;
}

/// Derivative of the correction polynomial with respect to s.
template <int... p, class Coefficients, class Scalar>
Scalar correction_derivative(const Coefficients& c, const Scalar& s) {
    Index k = 0;
    Scalar sum(0);
    ((sum += (c[k++] * p) * power<(p > 0 ? p - 1 : 0)>(s)), ...);
    return sum;
}

/// \f$M_{kl}\f$ for the exponents p.
/// \param moment a function of k: the k-th moment of the kernel in units of h
template <class Scalar, int... p, class Moment>
Eigen::Matrix<Scalar, sizeof...(p), sizeof...(p)> moment_matrix(const Moment& moment) {
    constexpr std::array exponents{p...};
    Eigen::Matrix<Scalar, sizeof...(p), sizeof...(p)> M;
    for (std::size_t k = 0; k < exponents.size(); ++k)
        for (std::size_t l = 0; l < exponents.size(); ++l)
            M(static_cast<Index>(k), static_cast<Index>(l)) = moment(exponents[k] + exponents[l]);
    return M;
}

/// The coefficients with which the p-th moments of \f$K_i\f$ become 1, 0, 0, …: the first column of
/// \f$M^{-1}\f$.
/// \param moment a function of k: the k-th moment of the kernel in units of h
/// \throws SingularNeighbourhood where the particles do not determine the coefficients
template <class Scalar, int... p, class Moment>
Eigen::Matrix<Scalar, sizeof...(p), 1> correction_coefficients(const Moment& moment) {
    return inverse(moment_matrix<Scalar, p...>(moment)).col(0);
}

/// The corrected kernel, for the integral forms. \defeq{A22}
/// \f[ K_i(x) = C_i(x) \cdot W_i(x) \tag{22} \f]
/// \tparam p the exponents of \f$C_i\f$, which are also the moments that are imposed
template <int... p>
CentredKernel corrected(const CentredKernel& W_i) {
    const auto c = correction_coefficients<double, p...>(
        [&](int k) { return W_i.moment(k, W_i.W) / std::pow(W_i.h, k); });
    CentredKernel K_i = W_i;
    K_i.W = [c, W_i](double x) { return correction<p...>(c, (x - W_i.x) / W_i.h) * W_i.W(x); };
    K_i.DW = [c, W_i](double x) {
        const double s = (x - W_i.x) / W_i.h;
        return correction_derivative<p...>(c, s) / W_i.h * W_i.W(x) + correction<p...>(c, s) * W_i.DW(x);
    };
    return K_i;
}

/// \f$m_k = \sum_j r_j^k\,W_i(x_j)\,\Delta\Omega_j\f$ for k = 0 … n, in units of h.
template <int n, class Scalar>
std::array<Scalar, n + 1> moments(const Neighbourhood<Scalar>& near) {
    const auto& [r, W, DW, V] = near;
    std::array<Scalar, n + 1> m{};
    for (Index j = 0; j < r.size(); ++j) {
        Scalar term = W[j] * V[j];
        for (Scalar& m_k : m) {
            m_k += term;
            term *= r[j];
        }
    }
    return m;
}

/// The corrected kernel at the particles: a neighbourhood with K and DK in the place of W and DW. The moments
/// are those of its sums.
/// \throws SingularNeighbourhood where the particles do not determine \f$C_i\f$
template <int... p, class Scalar>
Neighbourhood<Scalar> corrected(const Neighbourhood<Scalar>& near) {
    const auto& [r, W, DW, V] = near;
    const auto m = moments<2 * std::max({p...})>(near);
    const auto c =
        correction_coefficients<Scalar, p...>([&](int k) { return m[static_cast<std::size_t>(k)]; });
    const Column<Scalar> C = r.unaryExpr([&](const Scalar& s) { return correction<p...>(c, s); });
    const Column<Scalar> DC = r.unaryExpr([&](const Scalar& s) { return correction_derivative<p...>(c, s); });
    return {r, C * W, DC * W + C * DW, V};
}

/// Taylor's expansion against \f$K_i\f$, up to the second derivative: what \eq{A21} represents. \defeq{A24}
/// \f[ \begin{aligned}
///     \int_\Omega B\,K_i\,d\Omega &= B(x_i)\int_\Omega K_i\,d\Omega
///     + DB(x_i)\int_\Omega (x-x_i)\,K_i\,d\Omega
///     \\ &+ \tfrac12 D^2B(x_i)\int_\Omega (x-x_i)^2\,K_i\,d\Omega + \dots
///     \end{aligned} \tag{24} \f]
inline double expanded_value(double B_i, double DB_i, double D2B_i, const CentredKernel& K_i) {
    const auto& K = K_i.W;
    return B_i * K_i.moment(0, K) + DB_i * K_i.moment(1, K) + D2B_i * K_i.moment(2, K) / 2;
}

/// First derivative with the corrected kernel, as \eq{A11}. \defeq{A25}
/// \f[ DB(x_i) \cong \sum_{j=1}^N [B(x_i) - B(x_j)]\,DK_i(x_j)\,\Delta\Omega_j \tag{25} \f]
/// \tparam order 1 or 2
/// \param near the particles in the support of \f$W_i\f$
/// \return weights on \f$B(x_j) - B(x_i)\f$ [1/h]
/// \throws SingularNeighbourhood where the particles do not determine \f$C_i\f$
template <int order, class Scalar>
Column<Scalar> first_derivative(const Neighbourhood<Scalar>& near) {
    static_assert(order == 1 || order == 2, "RKPM is described for the first and the second order");
    const auto corrected_near = [&] {
        if constexpr (order == 1)
            return corrected<0, 1>(near);
        else
            return corrected<0, 1, 2>(near);
    }();
    const auto& [r, K, DK, V] = corrected_near;
    return -DK * V;
}

/// \eq{A25} for a whole line of particles, with the moments imposed on integrals as in the print. It serves
/// to measure the effect of our choice, the sums.
/// \tparam p the exponents of \f$C_i\f$
/// \return D [1/length]
template <int... p>
Operator<double> first_derivative_by_integrals(const Line<double>& line,
                                               const particles::Smoothing<double>& smoothing) {
    std::vector<Eigen::Triplet<double>> weights;
    for (Index i = 0; i < line.size(); ++i) {
        const CentredKernel K_i =
            corrected<p...>(particles::centred(smoothing.kernel(), line.x()[i], smoothing.h(), {0, 1}));
        const auto near = particles::within_reach(line, smoothing, i);
        for (Index j = near.first; j < near.last; ++j)
            weights.emplace_back(static_cast<int>(i), static_cast<int>(j),
                                 -K_i.DW(line.x()[j]) * line.V()[j]);
    }
    Operator<double> D(line.size(), line.size());
    D.setFromTriplets(weights.begin(), weights.end());
    particles::annihilate_constants(D);
    return D;
}

/// Second derivative: \eq{A25} with DB in the place of B, \f$D^2 = D\,D\f$ as in \eq{A12}. \defeq{A26}
/// \f[ D^2B(x_i) \cong \sum_{j=1}^N [DB(x_i) - DB(x_j)]\,DK_i(x_j)\,\Delta\Omega_j \tag{26} \f]
/// \param D the operator of \eq{A25} for all particles
/// \param memory another operator, whose memory becomes the result's
template <class Scalar>
Operator<Scalar> second_derivative(const Operator<Scalar>& D, Operator<Scalar>&& memory = {}) {
    return product(D, D, std::move(memory));
}

}  // namespace rkpm
}  // namespace asprone2010
