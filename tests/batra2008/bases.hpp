#pragma once

#include <Eigen/Core>
#include <vector>

#include "tests/polynomial.hpp"

namespace support {

/// All that an SSPH basis gives, for any dimension and degree at run time.
struct Bases {
    std::vector<int> particle;
    std::vector<Powers> exponents;        ///< of each entry of Q
    Eigen::ArrayXXd K;                    ///< a column for each entry of Q
    std::vector<Eigen::ArrayXXd> slopes;  ///< of the weights of each entry of Q, a column for each coordinate
};

/// ssph_basis::basis_at() for a cloud of particles, a column each. The row count says the dimension, 1 to 3.
/// \param m degree, 1 to 3
Bases bases(int m, const Eigen::MatrixXd& particles, double rho, const Eigen::VectorXd& place, double h);

}  // namespace support
