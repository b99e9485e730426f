#pragma once

#include "base/random.hpp"
#include "batra2008/section_4_1_plate.hpp"
#include "tests/support/relative.hpp"

/// Common to the tests of the plane problems.
namespace support {

using namespace batra2008;

/// A displacement whose components are polynomials of degree 2 or 3, with all that follows from it.
struct PolynomialField {
    elastostatics::Material material;
    bool cubic = false;

    [[nodiscard]] Vector u(const Point<2>& x) const {
        const double a = x[0], b = x[1], c = cubic ? 1 : 0;
        return {0.1 + 0.3 * a - 0.2 * b + 0.5 * a * a - 0.7 * a * b + 0.4 * b * b +
                    c * (a * a * a - 2 * a * b * b),
                -0.2 + 0.1 * a + 0.6 * b - 0.3 * a * a + 0.2 * a * b + 0.8 * b * b +
                    c * (b * b * b + 3 * a * a * b)};
    }
    /// Derivatives of the components, rows, by x1 and x2.
    [[nodiscard]] Eigen::Matrix2d gradient(const Point<2>& x) const {
        const double a = x[0], b = x[1], c = cubic ? 1 : 0;
        return Eigen::Matrix2d{
            {0.3 + a - 0.7 * b + c * (3 * a * a - 2 * b * b), -0.2 - 0.7 * a + 0.8 * b - c * 4 * a * b},
            {0.1 - 0.6 * a + 0.2 * b + c * 6 * a * b, 0.6 + 0.2 * a + 1.6 * b + c * (3 * b * b + 3 * a * a)}};
    }
    /// Second derivatives by x1x1, x2x2, x1x2.
    [[nodiscard]] Eigen::Matrix<double, 2, 3> second(const Point<2>& x) const {
        const double a = x[0], b = x[1], c = cubic ? 1 : 0;
        return Eigen::Matrix<double, 2, 3>{{1 + c * 6 * a, 0.8 - c * 4 * a, -0.7 - c * 4 * b},
                                           {-0.6 + c * 6 * b, 1.6 + c * 6 * b, 0.2 + c * 6 * a}};
    }
    [[nodiscard]] Stress stress(const Point<2>& x) const {
        return elastostatics::stress(material, elastostatics::strain(gradient(x)));
    }
    /// Derivatives of the three stresses, rows, by x1 and x2.
    [[nodiscard]] Eigen::Matrix<double, 3, 2> stress_gradient(const Point<2>& x) const {
        const auto d = second(x);
        Eigen::Matrix<double, 3, 2> gradient;
        gradient.col(0) = elastostatics::stress(material, Strain(d(0, 0), d(1, 2), d(0, 2) + d(1, 0)));
        gradient.col(1) = elastostatics::stress(material, Strain(d(0, 2), d(1, 1), d(0, 1) + d(1, 2)));
        return gradient;
    }
    /// The body force that keeps it in equilibrium.
    [[nodiscard]] Vector b(const Point<2>& x) const {
        return -elastostatics::imbalance(stress_gradient(x), Vector::Zero());
    }
    [[nodiscard]] elastostatics::Exact exact() const {
        return {[*this](const Point<2>& x) { return u(x); }, [*this](const Point<2>& x) { return stress(x); },
                [*this](const Point<2>& x) { return b(x); }};
    }
};

/// The plate as a problem that this field solves.
inline Problem plate_with(const PolynomialField& field) {
    Problem problem = plate::problem(field.material);
    problem.exact = field.exact();
    return problem;
}

/// A plate's grid whose inner particles are moved by up to `amplitude` spacings; those on the boundary stay.
inline Points<2> moved_grid(Index nx, Index ny, double amplitude, unsigned long seed) {
    base::Random random(seed);
    Points<2> x = plate::grid(nx, ny);
    const double spacing = plate::L1 / static_cast<double>(nx - 1);
    for (Index i = 1; i < nx - 1; ++i)
        for (Index j = 1; j < ny - 1; ++j)
            for (Index axis = 0; axis < 2; ++axis)
                x(axis, i * ny + j) += random.uniform(-amplitude, amplitude) * spacing;
    return x;
}

/// Largest error of the SSPH field at the particles, relative to the largest displacement.
inline double relative_error(const Cloud<2>& cloud, const example_problems::Solution& solution,
                             const Problem& problem) {
    double error = 0, largest = 0;
    for (Index I = 0; I < cloud.size(); ++I) {
        const Point<2> x = cloud.x().col(I);
        error =
            std::max(error, (example_problems::state_at(cloud, solution, x).u - problem.exact.u(x)).norm());
        largest = std::max(largest, problem.exact.u(x).norm());
    }
    return error / largest;
}

}  // namespace support
