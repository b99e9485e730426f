#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "particles/errors.hpp"

namespace particles {

/// The particles of a neighbourhood do not determine the unknowns of a formulation.
class SingularNeighbourhood : public FailedComputation {
  public:
    explicit SingularNeighbourhood(double reciprocal_condition)
        : FailedComputation("the local system is singular (reciprocal condition " +
                            shown(reciprocal_condition, 2) + ")") {}
};

/// Inverse of a small local matrix (closed form up to 4 × 4).
/// \throws SingularNeighbourhood where the reciprocal condition number (1-norm) is below 100 ε
template <class Scalar, int n>
Eigen::Matrix<Scalar, n, n> inverse(const Eigen::Matrix<Scalar, n, n>& A) {
    const auto norm = [](const Eigen::Matrix<Scalar, n, n>& M) {
        return M.cwiseAbs().colwise().sum().maxCoeff();
    };
    Eigen::Matrix<Scalar, n, n> A_inverse = A.inverse();
    const Scalar reciprocal_condition = 1 / (norm(A) * norm(A_inverse));
    if (!(reciprocal_condition > 100 * std::numeric_limits<Scalar>::epsilon()))
        throw SingularNeighbourhood(A_inverse.allFinite() ? static_cast<double>(reciprocal_condition) : 0);
    return A_inverse;
}

/// A sum that a formulation divides by, the 1 × 1 system.
/// \throws SingularNeighbourhood where the sum vanishes against the sizes of its terms
template <class Terms>
typename Terms::Scalar nonzero_sum(const Eigen::ArrayBase<Terms>& terms) {
    using Scalar = typename Terms::Scalar;
    using std::abs;
    const Scalar sum = terms.sum();
    const Scalar size = terms.abs().sum();
    if (!(abs(sum) > 100 * std::numeric_limits<Scalar>::epsilon() * size))
        throw SingularNeighbourhood(size > 0 ? static_cast<double>(abs(sum) / size) : 0);
    return sum;
}

}  // namespace particles
