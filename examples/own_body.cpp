/// A body in code, without drawing or files: a square bar that is twisted. Its stress function has
/// \f$\Delta\varphi + 2 = 0\f$ and is zero on the boundary; the shear stress is its slope, in units of G θ a,
/// and largest in the middle of a side. Timoshenko and Goodier (Theory of Elasticity, §109) have 0.675 there.
///
/// Build: make. The exit code is 0 if the stress is that of the book's series to 1 %.
#include <cmath>
#include <cstdio>
#include <numbers>

#include "bodies/mesh.hpp"
#include "bodies/solution.hpp"

namespace {

using bodies::Point;
using Value = bodies::Values<1>;

/// A square of side 1 with n × n particles. Its boundary has no names: it is one side, "boundary".
bodies::Body<2> square(int n) {
    bodies::Mesh<2> mesh;
    mesh.x.resize(2, n * n);
    for (int k = 0; k < n * n; ++k) mesh.x.col(k) = Point<2>(k % n, k / n) / (n - 1);
    for (int k = 0; k + n < n * n; ++k) {
        if (k % n == n - 1) continue;
        mesh.cells.push_back({k, k + 1, k + n + 1});
        mesh.cells.push_back({k, k + n + 1, k + n});
    }
    return bodies::body_of(mesh);
}

/// The shear stress in the middle of a side.
double largest_stress(int n, bodies::Method method) {
    bodies::Problem<2, 1> problem{bodies::diffusion<2>([](const Point<2>&) { return 1.0; })};
    problem.equation.b = [](const Point<2>&) { return Value(2); };
    problem.given = {{"boundary", {[](const Point<2>&) { return 0.0; }}}};
    bodies::Discretisation how;
    how.method = method;
    const auto solution = bodies::solve(problem, square(n), how);
    return bodies::state_at(problem, solution, {0.5, 0}).gradient.norm();
}

/// The same by the series.
double exact() {
    double sum = 0;
    for (int k = 1; k < 20; k += 2) sum += 1 / (k * k * std::cosh(k * std::numbers::pi / 2));
    return 1 - 8 / (std::numbers::pi * std::numbers::pi) * sum;
}

}  // namespace

int main() {
    bool all_close = true;
    for (const auto method : {bodies::Method::hats, bodies::Method::fpm, bodies::Method::strong}) {
        const double stress = largest_stress(31, method);
        all_close = all_close && std::abs(stress / exact() - 1) < 0.01;
        std::printf("%-6s %.4f, by the series %.4f\n", bodies::name(method).c_str(), stress, exact());
    }
    return all_close ? 0 : 1;
}
