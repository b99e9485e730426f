#include "asprone2010/round_off.hpp"

#include <cmath>
#include <limits>

#include "asprone2010/section_5_1_derivative_test.hpp"
#include "tests/asprone2010/stencils.hpp"

using namespace asprone2010;
using namespace limit_stencils;
using support::relative;

TEST_CASE("amplification: the sum of the absolute weights") {
    CHECK(amplification(support::central_difference()) == 4);
}

TEST_CASE("error_model: at the best spacing the sum of truncation and round-off is least") {
    const double epsilon = std::numeric_limits<double>::epsilon();
    for (const char* name : {"modified_fpm", "second_order_fpm"}) {
        CAPTURE(name);
        const ErrorModel model = error_model(formulation_named<double>(name));
        const auto sum = [&](double spacing) {
            return model.truncation(spacing) + model.round_off(spacing, epsilon);
        };
        const double best = model.best_spacing(epsilon);
        CHECK(model.exponent * model.truncation(best) == relative(2 * model.round_off(best, epsilon), 1e-12));
        CHECK(sum(best) < sum(0.99 * best));
        CHECK(sum(best) < sum(1.01 * best));
    }
}

TEST_CASE("error_model: on a line of 1000 particles the error of D²B for eˣ is the truncation") {
    const auto& formulation = formulation_named<double>("second_order_fpm");
    const ErrorModel model = error_model(formulation);
    const auto discrete = numerical_tests::discretise<double>({}, 1000, 1);
    const double error =
        derivative_test::errors(formulation, discrete, derivative_test::exponential<double>()).second;
    CHECK(error == relative(model.truncation(discrete.line.spacing()), 0.02));
}

TEST_CASE(
    "error_model: on a long line the error of D²B stays below the round-off, and above a fiftieth of it") {
    const auto& formulation = formulation_named<double>("second_order_fpm");
    const auto discrete = numerical_tests::discretise<double>({}, 100000, 1);
    const double error =
        derivative_test::errors(formulation, discrete, derivative_test::exponential<double>()).second;
    const double predicted =
        error_model(formulation).round_off(discrete.line.spacing(), std::numeric_limits<double>::epsilon());
    CHECK(error < predicted);
    CHECK(error > predicted / 50);
}
