#include "asprone2010/limit_stencils.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "asprone2010/section_5_1_derivative_test.hpp"
#include "tests/relative.hpp"

using namespace asprone2010;
using namespace limit_stencils;
using numerical_tests::Discretisation;
using support::relative;

namespace {

/// The row of the particle at x = 1, or so many before it.
Stencil<long double> at_end(std::string_view formulation, int derivative, const Discretisation& how = {},
                            Index from_end = 0) {
    const auto [line, smoothing] = right_end<long double>(how, from_end, 1);
    const auto [D, D2] = formulation_named<long double>(formulation).operators(line, smoothing);
    return row<long double>(derivative == 1 ? D : D2, line, line.size() - 1 - from_end, 1, derivative);
}

constexpr std::string_view names[] = {"original", "chen_beraun",  "rkpm_first_order", "rkpm_second_order",
                                      "fpm",      "modified_fpm", "second_order_fpm"};

}  // namespace

TEST_CASE("limit_stencils: constants of D² at the end, against an independent calculation") {
    const auto check = [](std::string_view formulation, int exponent, double constant) {
        const auto found = leading_error(at_end(formulation, 2), 2);
        CHECK(found.exponent == exponent);
        CHECK(static_cast<double>(found.constant) == relative(constant, 1e-5));
    };
    check("chen_beraun", 0, -2.91335 / std::exp(1.0));
    check("modified_fpm", 1, -1.01366);
    check("second_order_fpm", 2, -0.919921);
}

TEST_CASE(
    "limit_stencils: the leading error is what a fine line of particles shows, at the end and near it") {
    // Long double carries it: the spacing is fine enough for the next term, coarse enough for round-off.
    const long double delta = 1e-4L;
    for (const std::string_view name : names)
        for (const int derivative : {1, 2})
            for (const Index from_end : {0, 1, 2}) {
                CAPTURE(name);
                CAPTURE(derivative);
                CAPTURE(from_end);
                const auto [r, w] = at_end(name, derivative, {}, from_end);
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

TEST_CASE("limit_stencils: a stencil does not depend on the spacing") {
    for (const std::string_view name : names) {
        CAPTURE(name);
        const auto wide = right_end<double>({}, 3, 1.0), narrow = right_end<double>({}, 3, std::exp2(-12));
        const auto& formulation = formulation_named<double>(name);
        const Index i = wide.line.size() - 4;
        const auto one =
            row<double>(formulation.operators(wide.line, wide.smoothing).D2, wide.line, i, 1.0, 2);
        const auto other = row<double>(formulation.operators(narrow.line, narrow.smoothing).D2, narrow.line,
                                       i, std::exp2(-12), 2);
        REQUIRE(one.w.size() == other.w.size());
        CHECK((one.w - other.w).abs().maxCoeff() < 1e-9 * amplification(one));
    }
}

TEST_CASE("limit_stencils: inside, rows neither feel the end nor lean to a side") {
    for (const auto& kernel :
         {particles::Kernel(particles::Gaussian{}), particles::Kernel(particles::QuinticSpline{})})
        for (const std::string_view name : names) {
            CAPTURE(name);
            const Discretisation how{particles::Volumes::equal, kernel, 1.3};
            const Index inside = first_interior<long double>(how);
            const auto near = at_end(name, 2, how, inside), far = at_end(name, 2, how, inside + 7);
            REQUIRE(near.w.size() == far.w.size());
            CHECK(static_cast<double>((near.w - far.w).abs().maxCoeff()) < 1e-15);
            CHECK(static_cast<double>((far.w - far.w.reverse()).abs().maxCoeff()) < 1e-15);
            CHECK(std::abs(static_cast<double>(moment(far, 3))) < 1e-12);
        }
}

TEST_CASE("limit_stencils: volumes of equal size and of cells differ near the end alone") {
    const Discretisation cells{particles::Volumes::partition};
    CHECK(static_cast<double>(leading_error(at_end("modified_fpm", 2, cells, 1), 2).constant) !=
          relative(static_cast<double>(leading_error(at_end("modified_fpm", 2, {}, 1), 2).constant), 1e-3));
    const Index inside = first_interior<long double>(cells);
    CHECK(static_cast<double>(leading_error(at_end("modified_fpm", 2, cells, inside), 2).constant) ==
          relative(static_cast<double>(leading_error(at_end("modified_fpm", 2, {}, inside), 2).constant),
                   1e-12));
}

TEST_CASE("limit_stencils: the symbol is that of central differences for a stencil of three points") {
    Stencil<double> central{Column<double>(3), Column<double>(3)};
    central.r << -1, 0, 1;
    central.w << 1, -2, 1;
    for (const double theta : {0.1, 1.0, 3.0})
        CHECK(symbol(central, theta) == relative(2 * std::cos(theta) - 2, 1e-14));
    CHECK(leading_error(central, 2).exponent == 2);
    CHECK(leading_error(central, 2).constant == relative(1.0 / 12, 1e-14));
    CHECK(amplification(central) == 4);
}

TEST_CASE("limit_stencils: the symbol's frequencies increase, and long waves have the exact ones") {
    const auto frequencies = symbol_frequencies(formulation_named<double>("second_order_fpm"), {}, 100);
    REQUIRE(frequencies.size() == 98);
    CHECK(std::is_sorted(frequencies.begin(), frequencies.end()));
    for (const int n : {1, 2, 3}) CHECK(frequencies[n - 1] == relative(std::numbers::pi * n, 2e-3));
}

TEST_CASE("limit_stencils: a row that is exact beyond the twelfth derivative has no leading error") {
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
