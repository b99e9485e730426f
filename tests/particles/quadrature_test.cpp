#include "particles/quadrature.hpp"

#include <doctest/doctest.h>
#include <gsl/gsl_integration.h>

#include <memory>

#include "tests/support/relative.hpp"

using namespace particles;

TEST_CASE("gauss_rule: n points integrate polynomials of degree 2n - 1 exactly, and no higher ones") {
    for (const Index n : {1, 2, 3, 4, 7, 10, 16, 32}) {
        CAPTURE(n);
        const auto [x, w] = gauss_rule(n);
        for (Index degree = 0; degree < 2 * n; ++degree)
            CHECK((w * x.pow(static_cast<double>(degree))).sum() ==
                  support::relative(1 / static_cast<double>(degree + 1), 1e-13));
        if (n > 7)
            continue;  // the error of the next degree, (n!)^4 / ((2n + 1) ((2n)!)^2), drowns in round-off
        const double factorial = std::tgamma(n + 1), factorial_of_2n = std::tgamma(2 * n + 1);
        const double remainder =
            std::pow(factorial, 4) / (static_cast<double>(2 * n + 1) * std::pow(factorial_of_2n, 2));
        CHECK(1 / static_cast<double>(2 * n + 1) - (w * x.pow(static_cast<double>(2 * n))).sum() ==
              support::relative(remainder, 1e-6));
    }
}

TEST_CASE("gauss_rule: nodes lie inside the interval in increasing order, symmetric, with positive weights") {
    for (const Index n : {1, 2, 5, 10, 31, 256}) {
        CAPTURE(n);
        const auto [x, w] = gauss_rule(n, -2, 5);
        CHECK(x[0] > -2);
        CHECK(x[n - 1] < 5);
        CHECK((x.tail(n - 1) > x.head(n - 1)).all());
        CHECK((w > 0).all());
        CHECK(w.sum() == support::relative(7, 1e-13));
        CHECK((x + x.reverse() - 3).abs().maxCoeff() < 1e-14);
        CHECK((w - w.reverse()).abs().maxCoeff() < 1e-15);
    }
}

TEST_CASE("gauss_rule: numbers of points of which GSL has no table give nine digits at least") {
    for (const Index n : {50, 99, 200, 999}) {
        const auto [x, w] = gauss_rule(n);
        CHECK(w.sum() == support::relative(1, 1e-9));
        CHECK((w * x.pow(7.0)).sum() == support::relative(1.0 / 8, 1e-9));
    }
}

TEST_CASE("gauss_rule: the integral of a function that is no polynomial") {
    const auto [x, w] = gauss_rule(20, 0.5, 3);
    CHECK((w * x.exp()).sum() == support::relative(std::exp(3) - std::exp(0.5), 1e-14));
    CHECK((w / x).sum() == support::relative(std::log(6), 1e-14));
}

TEST_CASE("gauss_rule: a rule without points is refused with the number asked for") {
    CHECK_THROWS_WITH_AS(gauss_rule(0), "a quadrature rule needs at least 1 point, got 0", InvalidInput);
    CHECK_THROWS_WITH_AS(gauss_rule(-3), "a quadrature rule needs at least 1 point, got -3", InvalidInput);
}

TEST_CASE("gauss_rule: pairs of points about the middle sum to the bits of GSL's rule of 32 points") {
    double (*const wave)(double, void*) = [](double x, void*) { return std::exp(x) * std::sin(5 * x); };
    const gsl_function integrand{wave, nullptr};
    const std::unique_ptr<gsl_integration_glfixed_table, void (*)(gsl_integration_glfixed_table*)> table(
        gsl_integration_glfixed_table_alloc(32), gsl_integration_glfixed_table_free);
    for (const double a : {-1.0, 0.0, 0.3, 2.7})
        for (const double length : {1e-3, 0.7, 2.0, 9.0})
            CHECK(integral([&](double x) { return wave(x, nullptr); }, a, a + length) ==
                  gsl_integration_glfixed(&integrand, a, a + length, table.get()));
}
