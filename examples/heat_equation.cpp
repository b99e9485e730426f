/// Heat in a rod of variable conductivity, marched with the second-order FPM of Asprone et al. (2010),
/// Section 4:
///
///     u_t = (k u')' + f  on [0, 1],  k = 1 + x²,  u given at both ends.
///
/// The operators D and D² stand for the derivatives, (k u')' = k u'' + k' u'; Crank and Nicolson's rule takes
/// steps of the particles' spacing. Source and end values are those of u = e^-t sin 2x, with which the result
/// is compared.
///
/// Build: make. The exit code is 0 if the error falls with the second power of the spacing.
#include <cmath>
#include <cstdio>

#include "asprone2010/formulations.hpp"
#include "particles/line.hpp"
#include "solvers/banded.hpp"

namespace {

using Column = particles::Column<double>;
using Operator = particles::Operator<double>;

/// The exact temperature at time t.
Column temperature(const Column& x, double t) {
    return std::exp(-t) * (2 * x).sin();
}

/// The source that makes it exact.
Column source(const Column& x, double t) {
    return std::exp(-t) * ((3 + 4 * x.square()) * (2 * x).sin() - 4 * x * (2 * x).cos());
}

/// u -> k u'' + k' u' at the inner particles; the rows of the ends are zero.
Operator conduction(const particles::Line<double>& line) {
    const particles::Smoothing<double> smoothing(particles::Gaussian{}, line.spacing());
    const auto [D, D2] = asprone2010::formulation_named("second_order_fpm").operators(line, smoothing);
    Column k = 1 + line.x().square(), Dk = 2 * line.x();
    for (Column* of : {&k, &Dk}) (*of)[0] = (*of)[line.size() - 1] = 0;
    return k.matrix().asDiagonal() * D2 + Dk.matrix().asDiagonal() * D;
}

/// Largest error of the temperature at t = 1, with N particles and N - 1 steps.
double error(particles::Index N) {
    const auto line = particles::line_at(particles::uniform_positions(N), particles::Volumes::equal);
    const Column& x = line.x();
    const double dt = line.spacing();
    Operator I(N, N);
    I.setIdentity();
    const Operator half = dt / 2 * conduction(line), before = I + half, after = I - half;

    Column u = temperature(x, 0);
    for (particles::Index step = 0; step < N - 1; ++step) {
        const double t = static_cast<double>(step) * dt;
        const Column ends = temperature(x, t + dt);
        Column b = (before * u.matrix()).array() + dt * source(x, t + dt / 2);
        for (const particles::Index end : {particles::Index(0), N - 1}) b[end] = ends[end];
        u = solvers::solve_banded(after, b);
    }
    return (u - temperature(x, 1)).abs().maxCoeff();
}

}  // namespace

int main() {
    std::printf("%5s %12s %7s\n", "N", "error", "order");
    double coarser = error(21), order = 0;
    std::printf("%5d %12.3e\n", 21, coarser);
    for (const int N : {41, 81, 161}) {
        const double finer = error(N);
        order = std::log2(coarser / finer);
        std::printf("%5d %12.3e %7.3f\n", N, finer, order);
        coarser = finer;
    }
    return std::abs(order - 2) < 0.1 ? 0 : 1;
}
