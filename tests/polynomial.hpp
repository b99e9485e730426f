#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "tests/clouds.hpp"

namespace support {

/// Exponents of a monomial in up to three coordinates; of fewer the rest are zero.
using Powers = std::array<int, 3>;

template <std::size_t dim>
Powers powers(const std::array<int, dim>& exponents) {
    Powers all{};
    std::copy(exponents.begin(), exponents.end(), all.begin());
    return all;
}

/// A polynomial in one, two or three variables with all its derivatives; its coefficients are draws.
class Polynomial {
  public:
    Polynomial(int dim, int degree, unsigned seed) {
        Draws draw(seed);
        for (int a = 0; a <= degree; ++a)
            for (int b = 0; b <= (dim > 1 ? degree - a : 0); ++b)
                for (int c = 0; c <= (dim > 2 ? degree - a - b : 0); ++c)
                    terms_.emplace_back(Powers{a, b, c}, draw());
    }

    /// \param often how often to differentiate by each coordinate
    [[nodiscard]] double derivative(const Powers& often, const Eigen::Ref<const Eigen::VectorXd>& x) const {
        double sum = 0;
        for (const auto& [exponents, coefficient] : terms_) {
            double term = coefficient;
            for (Index axis = 0; axis < x.size(); ++axis) {
                int exponent = exponents[static_cast<std::size_t>(axis)];
                for (int k = 0; k < often[static_cast<std::size_t>(axis)]; ++k) term *= exponent--;
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
