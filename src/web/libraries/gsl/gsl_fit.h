#pragma once

#include <Eigen/Core>
#include <cstddef>

/// The line c0 + c1 x of least squares through n points. The covariances are not computed.
inline int gsl_fit_linear(const double* x, std::size_t /*stride*/, const double* y, std::size_t /*stride*/,
                          std::size_t n, double* c0, double* c1, double* /*cov00*/, double* /*cov01*/,
                          double* /*cov11*/, double* /*sumsq*/) {
    const auto count = static_cast<Eigen::Index>(n);
    const Eigen::Map<const Eigen::ArrayXd> X(x, count), Y(y, count);
    const Eigen::ArrayXd from_mean = X - X.mean();
    *c1 = (from_mean * (Y - Y.mean())).sum() / from_mean.square().sum();
    *c0 = Y.mean() - *c1 * X.mean();
    return 0;
}
