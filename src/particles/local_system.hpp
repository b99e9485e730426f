#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <string>

#include "base/errors.hpp"
#include "base/pack.hpp"
#include "base/text.hpp"

namespace particles {

using base::everywhere;
using base::FailedComputation;
using base::least;
using base::shown;

/// The particles of a neighbourhood do not determine the unknowns of a formulation.
class SingularNeighbourhood : public FailedComputation {
  public:
    explicit SingularNeighbourhood(const std::string& why) : FailedComputation(why) {}
    /// \param reciprocal_condition NaN counts as 0
    explicit SingularNeighbourhood(double reciprocal_condition)
        : FailedComputation("the local system is singular (reciprocal condition " +
                            shown(reciprocal_condition > 0 ? reciprocal_condition : 0, 2) + ")") {}
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
    if (!everywhere(reciprocal_condition > 100 * std::numeric_limits<Scalar>::epsilon()))
        throw SingularNeighbourhood(least(reciprocal_condition));
    return A_inverse;
}

/// A sum that is a divisor, the 1 × 1 system.
/// \throws SingularNeighbourhood where the sum is below 100 ε times the sum of its absolute terms
template <class Terms>
typename Terms::Scalar nonzero_sum(const Eigen::ArrayBase<Terms>& terms) {
    using Scalar = typename Terms::Scalar;
    using std::abs;
    Scalar sum = terms.sum();
    const Scalar size = terms.abs().sum();
    if (!everywhere(abs(sum) > 100 * std::numeric_limits<Scalar>::epsilon() * size))
        throw SingularNeighbourhood(least(abs(sum) / size));
    return sum;
}

}  // namespace particles
