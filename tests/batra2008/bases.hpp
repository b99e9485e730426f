#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "tests/support/polynomial.hpp"
#include "tests/support/relative.hpp"

namespace support {

/// All that an SSPH basis gives, for any dimension and degree at run time.
struct Bases {
    std::vector<int> particle;
    std::vector<Powers> exponents;        ///< of each entry of Q
    Eigen::ArrayXXd K;                    ///< a column for each entry of Q
    std::vector<Eigen::ArrayXXd> slopes;  ///< of the weights of each entry of Q, a column for each coordinate
};

/// ssph_basis::basis_at() for a cloud of particles, a column each. The row count says the dimension, 1 to 3.
/// \param m degree, 1 to 3
Bases bases(int m, const Eigen::MatrixXd& particles, double rho, const Eigen::VectorXd& place, double h);

/// Condition number of a symmetric matrix in the 2-norm.
double condition(const Eigen::MatrixXd& C);

/// Calls `visit` for one, two and three dimensions, and degrees 1, 2 and 3 in each.
template <class Visit>
void for_each_dimension_and_degree(const Visit& visit) {
    for (const int dim : {1, 2, 3})
        for (const int m : {1, 2, 3}) {
            CAPTURE(dim);
            CAPTURE(m);
            visit(dim, m);
        }
}

/// irregular_points() for a dimension that is known at run time.
inline Eigen::MatrixXd irregular_points_of(int dim, Index across, unsigned seed) {
    if (dim == 1) return irregular_points<1>(across, 0.3, seed);
    if (dim == 2) return irregular_points<2>(across, 0.3, seed);
    return irregular_points<3>(across, 0.3, seed);
}

/// Irregular particles in the unit cube with a mean spacing of h.
struct Irregular {
    explicit Irregular(int dimension)
        : dim(dimension),
          h(1 / (dim == 1   ? 40.0
                 : dim == 2 ? 10.0
                            : 7.0)),
          x(irregular_points_of(dim, std::lround(1 / h) + 1, 5)) {}

    int dim;
    double h;
    Eigen::MatrixXd x;
    static constexpr double rho = 3.5;

    /// Places inside, on the boundary and at a corner, particles and others.
    [[nodiscard]] std::vector<Eigen::VectorXd> places() const {
        std::vector<Eigen::VectorXd> all{x.col(0), x.col(x.cols() / 2), Eigen::VectorXd::Zero(dim)};
        Draws draw(21);
        for (int k = 0; k < 5; ++k)
            all.emplace_back((Eigen::VectorXd::NullaryExpr(dim, [&] { return draw(); }).array() + 1) / 2);
        return all;
    }

    [[nodiscard]] Bases at(int m, const Eigen::VectorXd& place) const { return bases(m, x, rho, place, h); }

    /// Values of a function at some particles.
    template <class Function>
    [[nodiscard]] Eigen::ArrayXd values(const std::vector<int>& particle, const Function& f) const {
        Eigen::ArrayXd F(static_cast<Index>(particle.size()));
        for (Index j = 0; j < F.size(); ++j) F[j] = f(x.col(particle[static_cast<std::size_t>(j)]));
        return F;
    }
};

/// Particles on a circle, at irregular distances.
inline Points<2> circle(Index count, double radius, const Point<2>& centre) {
    Points<2> x(2, count);
    for (Index k = 0; k < count; ++k) {
        const double angle = 2 * std::acos(-1.0) * static_cast<double>(k * k + 3 * k) / 97;
        x.col(k) = centre + radius * Point<2>(std::cos(angle), std::sin(angle));
    }
    return x;
}

}  // namespace support
