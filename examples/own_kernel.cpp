/// A kernel and a formulation of one's own on a line: the cosine kernel, which the second-order FPM of
/// Asprone et al. (2010) takes as any other, and a fit of cubic polynomials. The errors of D²B fall with the
/// second power of the particles' distance, at the ends as inside.
///
/// Build: make. The exit code is 0 if they do.
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "asprone2010/section_4_second_order_fpm.hpp"
#include "particles/operators.hpp"

namespace {

using namespace particles;
using std::numbers::pi;

/// The same particles seen through the cosine kernel, W(s) = (1 + cos πs/2)²/6 for |s| < 2.
Neighbourhood<> with_cosine(Neighbourhood<> near) {
    const Column<> c = (pi / 2 * near.r).cos();
    near.W = (1 + c).square() / 6;
    near.DW = -pi / 6 * (1 + c) * (pi / 2 * near.r).sin();
    return near;
}

/// The second-order FPM with this kernel.
Derivatives<> cosine_fpm(const Neighbourhood<>& near) {
    return asprone2010::second_order_fpm::derivatives(with_cosine(near));
}

/// The derivatives of the cubic polynomial through B(x_i) nearest to the other values, by weights W V.
Derivatives<> cubic_fit(const Neighbourhood<>& near) {
    Eigen::MatrixXd P(near.r.size(), 3);
    P << near.r, near.r.square() / 2, near.r.cube() / 6;
    const Eigen::MatrixXd WP = (near.W * near.V).matrix().asDiagonal() * P;
    const Eigen::MatrixXd weights = WP * inverse<double, 3>(P.transpose() * WP);
    return {weights.col(0), weights.col(1)};
}

/// Largest error of the second derivative of exp at N particles.
template <class Formulation>
double error(Index N, Formulation formulation) {
    const Line<> line = line_at(uniform_positions(N), Volumes::equal);
    const Smoothing smoothing(CubicSpline{}, 2.5 * line.spacing());  // says who is near: |s| < 2
    const Operators<> operators = assemble(line, smoothing, {"own", 4}, formulation);
    const Column<> B = line.x().exp();
    return (apply(operators.D2, B) - B).abs().maxCoeff();
}

/// Prints the errors for 40, 80 and 160 particles. \return the order between the last two
template <class Formulation>
double order(const char* name, const Formulation& formulation) {
    const double coarse = error(40, formulation), middle = error(80, formulation),
                 fine = error(160, formulation), order = std::log(middle / fine) / std::log(159.0 / 79);
    std::printf("%-12s %10.2e %10.2e %10.2e   order %.2f\n", name, coarse, middle, fine, order);
    return order;
}

}  // namespace

int main() {
    const double fpm = order("cosine_fpm", cosine_fpm), fit = order("cubic_fit", cubic_fit);
    return std::min(fpm, fit) > 1.9 ? 0 : 1;
}
