#pragma once

#include <Eigen/Core>
#include <Eigen/Jacobi>
#include <cmath>
#include <optional>
#include <vector>

#include "base/vector_width.hpp"

namespace solvers {

/// The method of generalised minimal residuals (GMRES; Saad and Schultz 1986) for \f$M^{-1}A\,x = c\f$, with
/// the modified orthogonalisation of Gram and Schmidt.
/// \param apply \f$v \mapsto M^{-1}A\,v\f$ \param c right-hand side
/// \param enough norm of the residual at which to stop
/// \param most largest number of steps; as many vectors are kept
/// \return x with the least residual, for a first guess of zero; nothing where that is not small enough
template <class Apply>
std::optional<Eigen::VectorXd> gmres(const Apply& apply, const Eigen::VectorXd& c, double enough,
                                     Eigen::Index most) {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(c.size());
    const double norm = c.norm();
    if (norm <= enough) return x;
    std::vector<Eigen::VectorXd> Q{c / norm};  // orthonormal
    Eigen::MatrixXd R = Eigen::MatrixXd::Zero(most + 1, most);
    Eigen::VectorXd g = Eigen::VectorXd::Zero(most + 1);  // the residual in rotated coordinates
    g[0] = norm;
    std::vector<Eigen::JacobiRotation<double>> rotations;
    Eigen::Index k = 0;
    while (k < most && std::abs(g[k]) > enough) {
        Eigen::VectorXd w = apply(Q.back());
        const double size = w.norm();
        for (Eigen::Index j = 0; j <= k; ++j) {
            const Eigen::VectorXd& q = Q[static_cast<std::size_t>(j)];
            R(j, k) = q.dot(w);
            w -= R(j, k) * q;
        }
        R(k + 1, k) = w.norm();
        for (Eigen::Index j = 0; j < k; ++j)
            R.col(k).applyOnTheLeft(j, j + 1, rotations[static_cast<std::size_t>(j)].adjoint());
        rotations.emplace_back().makeGivens(R(k, k), R(k + 1, k));
        const double length = R(k + 1, k);
        R.col(k).applyOnTheLeft(k, k + 1, rotations.back().adjoint());
        g.applyOnTheLeft(k, k + 1, rotations.back().adjoint());
        if (!(std::abs(R(k, k)) > 1e-14 * size)) return {};  // singular, or not finite
        ++k;
        if (!(length > 0)) break;  // the space holds the solution
        Q.emplace_back(w / length);
    }
    if (!(std::abs(g[k]) <= enough)) return {};
    const Eigen::VectorXd y = R.topLeftCorner(k, k).triangularView<Eigen::Upper>().solve(g.head(k));
    for (Eigen::Index j = 0; j < k; ++j) x += y[j] * Q[static_cast<std::size_t>(j)];
    return x;
}

}  // namespace solvers
