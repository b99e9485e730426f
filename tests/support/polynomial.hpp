#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "tests/support/clouds.hpp"

namespace support {

/// Exponents of a monomial in three coordinates; those of unused coordinates are zero.
using Powers = std::array<int, 3>;

template <std::size_t dim>
Powers powers(const std::array<int, dim>& exponents) {
    Powers all{};
    std::copy(exponents.begin(), exponents.end(), all.begin());
    return all;
}

/// The degree of such a monomial.
inline int order(const Powers& a) {
    return a[0] + a[1] + a[2];
}

/// A polynomial in one, two or three variables with random coefficients, and all its derivatives.
class Polynomial {
  public:
    Polynomial(int dim, int degree, unsigned seed) {
        Draws draw(seed);
        for (int a = 0; a <= degree; ++a)
            for (int b = 0; b <= (dim > 1 ? degree - a : 0); ++b)
                for (int c = 0; c <= (dim > 2 ? degree - a - b : 0); ++c)
                    terms_.emplace_back(Powers{a, b, c}, draw());
    }

    /// \param orders how many times to differentiate with respect to each coordinate
    [[nodiscard]] double derivative(const Powers& orders, const Eigen::Ref<const Eigen::VectorXd>& x) const {
        double sum = 0;
        for (const auto& [exponents, coefficient] : terms_) {
            double term = coefficient;
            for (Index axis = 0; axis < x.size(); ++axis) {
                int exponent = exponents[static_cast<std::size_t>(axis)];
                for (int k = 0; k < orders[static_cast<std::size_t>(axis)]; ++k) term *= exponent--;
                for (; exponent > 0; --exponent) term *= x[axis];
            }
            sum += term;
        }
        return sum;
    }

    double operator()(const Eigen::Ref<const Eigen::VectorXd>& x) const { return derivative({}, x); }

  private:
    std::vector<std::pair<Powers, double>> terms_;
};

}  // namespace support
