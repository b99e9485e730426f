#pragma once

#include <array>
#include <cstddef>

namespace particles {

/// A multi-index a: the exponents of a monomial \f$r^a\f$, or the numbers of derivatives \f$\partial^a\f$,
/// one for each coordinate.
template <int dim>
using Exponents = std::array<int, dim>;

/// Number of monomials up to degree m.
template <int dim, int m>
inline constexpr int terms = dim == 1   ? m + 1
                             : dim == 2 ? (m + 1) * (m + 2) / 2
                                        : (m + 1) * (m + 2) * (m + 3) / 6;

/// The monomials by degree; the pure powers of a degree come first.
template <int dim, int m>
constexpr std::array<Exponents<dim>, terms<dim, m>> monomials() {
    std::array<Exponents<dim>, terms<dim, m>> all{};
    std::size_t count = 1;
    for (int degree = 1; degree <= m; ++degree) {
        for (std::size_t axis = 0; axis < dim; ++axis) all[count++][axis] = degree;
        if constexpr (dim == 2)
            for (int first = degree - 1; first > 0; --first) all[count++] = {first, degree - first};
        if constexpr (dim == 3)
            for (std::size_t axis = 0; axis < 3; ++axis)  // 12, 23, 31
                for (int first = degree - 1; first > 0; --first) {
                    all[count][axis] = first;
                    all[count++][(axis + 1) % 3] = degree - first;
                }
        if constexpr (dim == 3)
            for (int first = degree - 2; first > 0; --first)
                for (int second = degree - first - 1; second > 0; --second)
                    all[count++] = {first, second, degree - first - second};
    }
    return all;
}

/// a! of a multi-index, the product of the factorials of its entries.
template <int dim>
constexpr int factorial(const Exponents<dim>& a) {
    int product = 1;
    for (const int exponent : a)
        for (int k = 2; k <= exponent; ++k) product *= k;
    return product;
}

/// |a| of a multi-index: degree of the monomial, order of the derivative.
template <int dim>
constexpr int order(const Exponents<dim>& a) {
    int sum = 0;
    for (const int exponent : a) sum += exponent;
    return sum;
}

}  // namespace particles
