#include "solvers/cholesky.hpp"

#include "base/quad.hpp"

namespace solvers {

template <class Scalar>
Cholesky<Scalar>::Cholesky(const Matrix& A) : factors_(A) {}

template <class Scalar>
auto Cholesky<Scalar>::solve(const Vector& b) const -> Vector {
    return factors_.solve(b);
}

template class Cholesky<double>;
template class Cholesky<long double>;
template class Cholesky<base::Quad>;

}  // namespace solvers
