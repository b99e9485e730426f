/// The Laplacian of a function at irregular particles in space, by the SSPH basis of Batra and Zhang (2008),
/// Section 2, with cubic monomials. Its error falls with the second power of the particles' distance, on the
/// boundary as inside.
///
/// Build: make. The exit code is 0 if it does.
#include <cmath>
#include <cstdio>
#include <random>

#include "batra2008/section_2_ssph_basis.hpp"
#include "particles/operators.hpp"

namespace {

using particles::Column;

/// A grid of n³ particles in the unit cube, each moved by a tenth of the spacing at most.
particles::Points<3> irregular(int n) {
    std::mt19937 random(1);
    const auto moved = [&](int k) {
        return (k + 0.2 * (static_cast<double>(random()) / 4294967296.0 - 0.5)) / (n - 1);
    };
    particles::Points<3> x(3, n * n * n);
    for (int j = 0; j < x.cols(); ++j) x.col(j) << moved(j % n), moved(j / n % n), moved(j / n / n);
    return x;
}

/// Largest error of the Laplacian of exp(x + y/2) sin z.
double error(int n) {
    const particles::Cloud<3> cloud(irregular(n));
    const particles::Smoothing<double, 3> smoothing(particles::TruncatedGaussian<3>(3), cloud.spacing());
    const auto operators = particles::assemble(cloud, smoothing, {"ssph", 20}, [](const auto& near) {
        return batra2008::ssph_basis::derivatives<3>(near);
    });
    const auto [x, y, z] =
        std::array{cloud.x().row(0).array().transpose().eval(), cloud.x().row(1).array().transpose().eval(),
                   cloud.x().row(2).array().transpose().eval()};
    const Column<double> f = (x + y / 2).exp() * z.sin();
    Column<double> laplacian = Column<double>::Zero(f.size());
    for (const particles::Exponents<3> a : {particles::Exponents<3>{2, 0, 0}, {0, 2, 0}, {0, 0, 2}})
        laplacian += particles::apply(particles::derivative(operators, a), f);
    return (laplacian - f / 4).abs().maxCoeff();
}

}  // namespace

int main() {
    const double coarse = error(9), fine = error(17), order = std::log2(coarse / fine);
    std::printf("%5s %12s\n%5d %12.3e\n%5d %12.3e   order %.2f\n", "n", "error", 9, coarse, 17, fine, order);
    return order > 1.5 ? 0 : 1;
}
