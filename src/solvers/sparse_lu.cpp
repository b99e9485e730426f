#include "solvers/sparse_lu.hpp"

namespace solvers {

SparseLU::SparseLU(const Matrix& A) : factors_(A) {}

SparseLU::Vector SparseLU::solve(const Vector& b) const {
    return factors_.solve(b);
}

SparseLU::Vector SparseLU::solve_transposed(const Vector& b) {
    return factors_.transpose().solve(b);
}

}  // namespace solvers
