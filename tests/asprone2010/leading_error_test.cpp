#include "asprone2010/leading_error.hpp"

#include <cmath>

#include "asprone2010/in_quad.hpp"
#include "tests/asprone2010/stencils.hpp"

using namespace asprone2010;
using namespace limit_stencils;
using numerical_tests::Discretisation;
using support::near_end;
using support::relative;

TEST_CASE("leading_error: that of the central difference is δ² B⁗ / 12") {
    const auto [exponent, constant] = leading_error(support::central_difference(), 2);
    CHECK(exponent == 2);
    CHECK(constant == relative(1.0 / 12, 1e-14));
}

TEST_CASE("leading_error: constants of D² at the end, against an independent calculation") {
    const auto check = [](std::string_view formulation, int exponent, double constant) {
        const auto found = leading_error(near_end(formulation, 2), 2);
        CHECK(found.exponent == exponent);
        CHECK(static_cast<double>(found.constant) == relative(constant, 1e-5));
    };
    check("chen_beraun", 0, -2.91335 / std::exp(1.0));
    check("modified_fpm", 1, -1.01366);
    check("second_order_fpm", 2, -0.919921);
}

TEST_CASE("leading_error: it is what a fine line of particles shows, at the end and near it") {
    // Long double carries it: the spacing is fine enough for the next term, coarse enough for round-off.
    const long double delta = 1e-4L;
    for (const std::string_view name : support::all_names)
        for (const int derivative : {1, 2})
            for (const Index from_end : {0, 1, 2}) {
                CAPTURE(name);
                CAPTURE(derivative);
                CAPTURE(from_end);
                const auto [r, w] = near_end(name, derivative, {}, from_end);
                const auto [exponent, constant] = leading_error(Stencil<long double>{r, w}, derivative);
                const long double error =
                    (w * (r * delta).unaryExpr([](const long double& s) { return std::expm1(s); })).sum() *
                        std::pow(delta, -derivative) -
                    1;
                const long double next = delta * 30;
                CHECK(std::abs(error * std::pow(delta, -exponent) - constant) <=
                      next * std::max(std::abs(constant), 0.02L));
            }
}

TEST_CASE("leading_error: volumes of equal size and of cells differ near the end alone") {
    const auto constant = [](const Discretisation& how, Index from_end) {
        return static_cast<double>(leading_error(near_end("modified_fpm", 2, how, from_end), 2).constant);
    };
    const Discretisation cells{particles::Volumes::partition};
    CHECK(constant(cells, 1) != relative(constant({}, 1), 1e-3));
    const Index inside = first_interior(cells);
    CHECK(constant(cells, inside) == relative(constant({}, inside), 1e-12));
}

TEST_CASE("leading_error: a row that is exact beyond the twelfth derivative has none") {
    Stencil<double> nothing{Column<double>::Zero(1), Column<double>::Zero(1)};
    CHECK(leading_error(nothing, 1).exponent == 0);
    Stencil<double> derivative{Column<double>(13), Column<double>(13)};
    // Weights of the first derivative on thirteen points, exact up to degree twelve: Lagrange's.
    for (int j = 0; j < 13; ++j) {
        derivative.r[j] = (j - 6) / 6.0;
        double weight = j == 6 ? 0 : 1 / derivative.r[j];
        for (int k = 0; k < 13; ++k)
            if (k != j && k != 6 && j != 6) weight *= -((k - 6) / 6.0) / (derivative.r[j] - (k - 6) / 6.0);
        derivative.w[j] = weight;
    }
    CHECK_THROWS_AS(leading_error(derivative, 1), base::FailedComputation);
}

TEST_CASE("scaled_error: that of the central difference is δ⁻² (δ⁻² (2 cosh δ − 2) − 1)") {
    for (const double spacing : {0.5, 0.1}) {
        const double sum = 2 * std::cosh(spacing) - 2;
        CHECK(scaled_error(support::central_difference(), 2, spacing, 2) ==
              relative((sum / (spacing * spacing) - 1) / (spacing * spacing), 1e-9));
    }
}

TEST_CASE("extrapolated: a polynomial of degree five, from six spacings, exactly") {
    std::array<double, 6> values{};
    for (int k = 0; k < 6; ++k) {
        const double s = std::ldexp(1.0, -k);
        values[static_cast<std::size_t>(k)] = 7 + s * (1 + s * (-2 + s * (3 + s * (-4 + 5 * s))));
    }
    CHECK(extrapolated(values) == relative(7, 1e-12));
    values[0] += 1;
    CHECK(extrapolated(values) != relative(7, 1e-12));
}

TEST_CASE("measured_constant: what eˣ shows in quadruple precision is the constant of the stencil") {
    for (const char* name : {"chen_beraun", "modified_fpm", "second_order_fpm"}) {
        CAPTURE(name);
        const auto [exponent, constant] = leading_error(near_end(name, 2), 2);
        const base::Quad measured =
            measured_constant(formulation_named<base::Quad>(name), {}, 0, 2, exponent);
        CHECK(static_cast<double>(measured) == relative(static_cast<double>(constant), 1e-9));
    }
}
