#include "particles/triangle_rule.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <set>

using namespace particles;

TEST_CASE("triangle_rule: polynomials of degree 7 are integrated exactly, those of degree 8 are not") {
    // Over a triangle of area 1, ∫ a^i b^j c^k = 2 i! j! k! / (i + j + k + 2)!
    const auto error = [](int i, int j, int k) {
        double sum = 0;
        for (const auto& [at, weight] : triangle_rule())
            sum += weight * std::pow(at[0], i) * std::pow(at[1], j) * std::pow(at[2], k);
        return std::abs(sum - 2 * std::tgamma(i + 1) * std::tgamma(j + 1) * std::tgamma(k + 1) /
                                  std::tgamma(i + j + k + 3));
    };
    for (int i = 0; i <= 7; ++i)
        for (int j = 0; i + j <= 7; ++j)
            for (int k = 0; i + j + k <= 7; ++k) CHECK(error(i, j, k) < 1e-14);
    CHECK(error(8, 0, 0) > 1e-9);
}

TEST_CASE("triangle_rule: 13 different points inside, the same for each corner") {
    std::set<std::array<double, 3>> points;
    for (const auto& [at, weight] : triangle_rule()) {
        CHECK(std::abs(at[0] + at[1] + at[2] - 1) < 1e-15);
        for (const double coordinate : at) CHECK(coordinate > 0);
        points.insert(at);
    }
    CHECK(points.size() == 13);
    for (const auto& [a, b, c] : points) {
        CHECK(points.contains({b, c, a}));
        CHECK(points.contains({b, a, c}));
    }
}
