#pragma once

#include "base/index.hpp"
#include "particles/line.hpp"

namespace particles {

using base::Index;

/// Nodes and weights of a quadrature rule on an interval.
struct GaussRule {
    Column<double> x, w;
};

/// Gauss–Legendre rule with n points on [a, b], exact on polynomials of degree 2n − 1.
/// \return nodes in increasing order, symmetric about the middle
/// \throws InvalidInput unless n is positive
GaussRule gauss_rule(Index n, double a = 0, double b = 1);

/// The Gauss–Legendre rule of 32 points on an interval of middle m and length 2l, in pairs about the middle:
/// \f[ \int_a^b f\,dx \cong l \sum_k w_k\,[f(m + l x_k) + f(m - l x_k)] \f]
template <class Function>
double integral(const Function& f, double a, double b) {
    static const GaussRule rule = gauss_rule(32, -1, 1);
    const double half = (b - a) / 2, middle = (b + a) / 2;
    double sum = 0;
    for (Index k = 16; k < 32; ++k)
        sum += rule.w[k] * (f(middle + half * rule.x[k]) + f(middle - half * rule.x[k]));
    return half * sum;
}

}  // namespace particles
