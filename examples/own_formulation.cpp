/// Derivatives of a wave in the plane by a formulation of one's own: a weighted least-squares fit of
/// quadratic polynomials. Each particle has its own smoothing length, since the particles lie closer together
/// at one end of the square. The errors of the slope fall with the second power of the particles' distance,
/// those of the curvature with the first.
///
/// Build: make. The exit code is 0 if they do.
#include <Eigen/LU>
#include <cmath>
#include <cstdio>
#include <random>

#include "particles/operators.hpp"
#include "particles/spacing.hpp"

namespace {

using namespace particles;

/// n² particles in the unit square, graded along x and moved by a tenth of their spacing at most.
Points<2> graded(int n) {
    std::mt19937 random(1);
    const auto moved = [&](int k) {
        return (k + 0.2 * (static_cast<double>(random()) / 4294967296.0 - 0.5)) / (n - 1);
    };
    Points<2> x(2, n * n);
    for (int j = 0; j < x.cols(); ++j) {
        const double s = moved(j % n);
        x.col(j) << s * (0.5 + 0.5 * s), moved(j / n);
    }
    return x;
}

/// The weights that give the derivatives of the polynomial nearest to the values, all differences weighed
/// with W V. Offsets are in units of h, and so are the weights.
Derivatives<double, 2> least_squares(const Neighbourhood<double, 2>& near) {
    const auto &x = near.r.col(0), &y = near.r.col(1);
    Eigen::MatrixXd P(near.r.rows(), 5);
    P << x, y, x.square() / 2, y.square() / 2, x * y;
    const Eigen::MatrixXd WP = (near.W * near.V).matrix().asDiagonal() * P;
    const Eigen::MatrixXd weights = WP * inverse<double, 5>(P.transpose() * WP);
    return {weights.leftCols(2), weights.rightCols(3)};
}

struct Errors {
    double slope, curvature;
};

/// Largest errors of two derivatives of sin(2x + y), with n² particles.
Errors errors(int n) {
    const Cloud<2> cloud(graded(n));
    const Smoothing smoothing(QuinticSpline<2>{}, spacing(cloud, Spacing::to_nearest(6)));
    const auto operators = assemble(cloud, smoothing, Requirement{"least_squares", 6}, least_squares);
    const Column<double> phase = (2 * cloud.x().row(0) + cloud.x().row(1)).transpose().array(),
                         f = phase.sin();
    const Exponents<2> x{1, 0}, xy{1, 1};
    return {(apply(derivative(operators, x), f) - 2 * phase.cos()).abs().maxCoeff(),
            (apply(derivative(operators, xy), f) + 2 * phase.sin()).abs().maxCoeff()};
}

}  // namespace

int main() {
    const Errors coarse = errors(21), fine = errors(81);
    const double slope = std::log2(coarse.slope / fine.slope) / 2,
                 curvature = std::log2(coarse.curvature / fine.curvature) / 2;
    std::printf("%4s %12s %12s\n%4d %12.3e %12.3e\n%4d %12.3e %12.3e\norder %11.2f %12.2f\n", "n", "f_x",
                "f_xy", 21, coarse.slope, coarse.curvature, 81, fine.slope, fine.curvature, slope, curvature);
    return slope > 1.7 && curvature > 0.7 ? 0 : 1;
}
