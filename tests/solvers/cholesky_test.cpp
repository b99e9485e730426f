#include "solvers/cholesky.hpp"

#include "base/quad.hpp"
#include "tests/support/relative.hpp"

namespace {

/// Largest error of the solution with a Hilbert matrix of n rows, over its condition number e^{3.5 n}.
template <class Scalar>
double error_on_hilbert(Eigen::Index n) {
    typename solvers::Cholesky<Scalar>::Matrix A(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j) A(i, j) = Scalar(1) / Scalar(static_cast<double>(i + j + 1));
    typename solvers::Cholesky<Scalar>::Vector x(n);
    for (Eigen::Index i = 0; i < n; ++i) x[i] = Scalar(static_cast<double>(i - 1));
    const solvers::Cholesky<Scalar> factors(A);
    REQUIRE((factors.pivots().array() > 0).all());
    const typename solvers::Cholesky<Scalar>::Vector difference = factors.solve(A * x) - x;
    return static_cast<double>(difference.cwiseAbs().maxCoeff()) / std::exp(3.5 * static_cast<double>(n));
}

}  // namespace

TEST_CASE("Cholesky: the solution is exact to the round-off of each precision") {
    for (const Eigen::Index n : {1, 3, 6}) {
        CHECK(error_on_hilbert<double>(n) < 1e-15);
        CHECK(error_on_hilbert<long double>(n) < 1e-18);
        CHECK(error_on_hilbert<base::Quad>(n) < 1e-33);
    }
}

TEST_CASE("Cholesky: the pivots of a matrix of two rows; one that is not definite has a negative pivot") {
    Eigen::Matrix<double, 2, 2, Eigen::RowMajor> A{{4, 2}, {99, 10}};
    const solvers::Cholesky<double, 2> factors(A);
    CHECK(factors.pivots() == Eigen::Vector2d(4, 9));
    CHECK(factors.solve(Eigen::Vector2d(8, 22)) == Eigen::Vector2d(1, 2));
    CHECK(solvers::Cholesky<double, 2>(A - 2 * A(0, 0) * A.Identity()).pivots()[0] == -4);
}
