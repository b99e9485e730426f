#include "asprone2010/section_3_2_chen_beraun.hpp"

#include "tests/support/integral_forms.hpp"

using namespace asprone2010;
using namespace asprone2010::chen_beraun;
using support::order_in_h;
using support::Wave;

TEST_CASE("(13) and (17): the expansions leave second and third powers of the offset") {
    std::vector<double> r{0.02, 0.01, 0.005}, first, second;
    for (const double step : r) {
        const double B = Wave::B(0.3 + step);
        first.push_back(std::abs(B - expansion(Wave::B(0.3), Wave::DB(0.3), step)));
        second.push_back(std::abs(B - expansion(Wave::B(0.3), Wave::DB(0.3), Wave::D2B(0.3), step)));
    }
    CHECK(report::observed_order(r, first) == support::relative(2, 0.03));
    CHECK(report::observed_order(r, second) == support::relative(3, 0.03));
}

TEST_CASE("(14): the remainder over the norm of DW is O(h²) at an end and O(h³) inside") {
    const auto remainder = [](const CentredKernel& W_i) {
        return first_remainder(Wave::B, Wave::DB(W_i.x), W_i) / W_i.norm(W_i.DW);
    };
    CHECK(order_in_h(1, remainder) == support::relative(2, 0.05));
    CHECK(order_in_h(0.5, remainder) == support::relative(3, 0.05));
}

TEST_CASE("(15): the exact derivative is the quotient minus, not plus, the remainder over the denominator") {
    for (const double x : {0.0, 0.03, 0.5, 1.0}) {
        const auto W_i = particles::centred(particles::Gaussian{}, x, 0.05, {0, 1});
        const double correction = first_remainder(Wave::B, Wave::DB(x), W_i) / W_i.moment(1, W_i.DW);
        CHECK(first_derivative(Wave::B, W_i) - correction == support::relative(Wave::DB(x), 1e-11));
        CHECK(std::abs(first_derivative(Wave::B, W_i) + correction - Wave::DB(x)) > 1e-4);
    }
}

TEST_CASE("(15): first order at the ends, second order inside") {
    const auto error = [](const CentredKernel& W_i) {
        return first_derivative(Wave::B, W_i) - Wave::DB(W_i.x);
    };
    CHECK(order_in_h(0, error) > 0.95);
    CHECK(order_in_h(1, error) == support::relative(1, 0.05));
    CHECK(order_in_h(0.5, error) == support::relative(2, 0.02));
}

TEST_CASE("(16) tends to (15) as δ/h → 0") {
    support::check_tends_to_integral(
        [](const auto& line, const auto& near, const auto& neighbourhood, Index i) {
            return support::sum_of_differences(first_derivative(neighbourhood), line, near, i, Wave::B);
        },
        [](const CentredKernel& W_i) { return first_derivative(Wave::B, W_i); }, 1);
}

TEST_CASE("(18): the remainder over the norm of W is O(h³) at an end and O(h⁴) inside") {
    const auto remainder = [](const CentredKernel& W_i) {
        return second_remainder(Wave::B, Wave::DB(W_i.x), Wave::D2B(W_i.x), W_i) / W_i.norm(W_i.W);
    };
    CHECK(order_in_h(1, remainder) == support::relative(3, 0.05));
    CHECK(order_in_h(0.5, remainder) == support::relative(4, 0.05));
}

TEST_CASE("(19): the exact second derivative is the quotient minus the remainder over the denominator") {
    for (const double x : {0.0, 0.03, 0.5, 1.0}) {
        const auto W_i = particles::centred(particles::Gaussian{}, x, 0.05, {0, 1});
        const double correction =
            second_remainder(Wave::B, Wave::DB(x), Wave::D2B(x), W_i) / (W_i.moment(2, W_i.W) / 2);
        CHECK(second_derivative(Wave::B, Wave::DB(x), W_i) - correction ==
              support::relative(Wave::D2B(x), 1e-10));
    }
}

TEST_CASE(
    "claim A-3.2-D2B-at-end: (19) is first order at an end with the exact DB; with DB from (15) its error tends to a constant") {
    const auto with_exact = [](const CentredKernel& W_i) {
        return second_derivative(Wave::B, Wave::DB(W_i.x), W_i) - Wave::D2B(W_i.x);
    };
    const auto with_own = [](const CentredKernel& W_i) {
        return second_derivative(Wave::B, first_derivative(Wave::B, W_i), W_i) - Wave::D2B(W_i.x);
    };
    CHECK(order_in_h(1, with_exact) == support::relative(1, 0.05));
    CHECK(order_in_h(0.5, with_exact) == support::relative(2, 0.02));
    CHECK(std::abs(order_in_h(1, with_own)) < 0.05);
    CHECK(order_in_h(0.5, with_own) == support::relative(2, 0.02));
}

TEST_CASE("(20) tends to (19) as δ/h → 0, with its own DB") {
    support::check_tends_to_integral(
        [](const auto& line, const auto& near, const auto& neighbourhood, Index i) {
            return support::sum_of_differences(derivatives(neighbourhood).second, line, near, i, Wave::B);
        },
        [](const CentredKernel& W_i) {
            return second_derivative(Wave::B, first_derivative(Wave::B, W_i), W_i);
        },
        2);
}

TEST_CASE("(16): no other particle in the support is an error") {
    const particles::Neighbourhood<double> alone{Column<double>::Zero(1), Column<double>::Constant(1, 0.56),
                                                 Column<double>::Zero(1), Column<double>::Ones(1)};
    CHECK_THROWS_AS(first_derivative(alone), particles::SingularNeighbourhood);
    CHECK_THROWS_AS(derivatives(alone), particles::SingularNeighbourhood);
}
