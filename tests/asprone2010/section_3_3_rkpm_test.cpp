#include "asprone2010/section_3_3_rkpm.hpp"

#include "tests/support/integral_forms.hpp"

using namespace asprone2010;
using namespace asprone2010::rkpm;
using support::order_in_h;
using support::Wave;

namespace {

CentredKernel at(double x, double h = 0.05) {
    return particles::centred(particles::Gaussian{}, x, h, {0, 1});
}

}  // namespace

TEST_CASE("(23): the polynomial and its derivative") {
    const Eigen::Vector3d c{2, -3, 5};
    CHECK(correction<0, 1, 2>(c, 0.5) == support::relative(2 - 1.5 + 1.25, 1e-15));
    CHECK(correction_derivative<0, 1, 2>(c, 0.5) == support::relative(-3 + 5, 1e-15));
    CHECK(correction<0, 1, 3>(c, 0.5) == support::relative(2 - 1.5 + 0.625, 1e-15));
    CHECK(correction_derivative<0, 1, 3>(c, 0.5) == support::relative(-3 + 15 * 0.25, 1e-15));
}

TEST_CASE("(22): DK is the derivative of K") {
    const auto K_i = corrected<0, 1, 2>(at(0.02));
    for (const double x : {0.0, 0.01, 0.05, 0.2})
        CHECK(K_i.DW(x) == support::relative((K_i.W(x + 1e-6) - K_i.W(x - 1e-6)) / 2e-6, 1e-6));
}

TEST_CASE(
    "claims A-3.3-moments-*: the corrected kernels have the moments 1, 0 and 1, 0, 0, at the ends too") {
    for (const double x : {0.0, 0.013, 0.5, 1.0}) {
        const auto first = corrected<0, 1>(at(x));
        CHECK(first.moment(0, first.W) == support::relative(1, 1e-12));
        CHECK(std::abs(first.moment(1, first.W)) < 1e-14);
        const auto second = corrected<0, 1, 2>(at(x));
        CHECK(second.moment(0, second.W) == support::relative(1, 1e-12));
        CHECK(std::abs(second.moment(1, second.W)) < 1e-14);
        CHECK(std::abs(second.moment(2, second.W)) < 1e-14);
    }
}

TEST_CASE("the discrete moments of the discrete kernels are 1, 0 and 1, 0, 0 on random particles") {
    const auto [line, smoothing] =
        support::particles_of(50, {particles::Volumes::partition, particles::Gaussian{}, 1, 0.4});
    for (Index i = 0; i < 50; ++i) {
        const auto near = particles::neighbourhood(line, smoothing, i);
        const auto first = corrected<0, 1>(near);
        CHECK((first.W * first.V).sum() == support::relative(1, 1e-12));
        CHECK(std::abs((first.r * first.W * first.V).sum()) < 1e-12);
        const auto second = corrected<0, 1, 2>(near);
        CHECK((second.W * second.V).sum() == support::relative(1, 1e-12));
        CHECK(std::abs((second.r * second.W * second.V).sum()) < 1e-12);
        CHECK(std::abs((second.r * second.r * second.W * second.V).sum()) < 1e-12);
    }
}

TEST_CASE(
    "claims A-3.3-B-*: (21) errs by O(h²) with the first-order kernel, by O(h³) with the second-order one, O(h⁴) inside") {
    const auto first = [](const CentredKernel& W_i) {
        return value(Wave::B, corrected<0, 1>(W_i)) - Wave::B(W_i.x);
    };
    const auto second = [](const CentredKernel& W_i) {
        return value(Wave::B, corrected<0, 1, 2>(W_i)) - Wave::B(W_i.x);
    };
    CHECK(order_in_h(1, first) == support::relative(2, 0.05));
    CHECK(order_in_h(0.5, first) == support::relative(2, 0.05));
    CHECK(order_in_h(1, second) == support::relative(3, 0.05));
    CHECK(order_in_h(0.5, second) == support::relative(4, 0.05));
}

TEST_CASE("(24): the expansion to the second derivative leaves O(h³)") {
    const auto left = [](const CentredKernel& W_i) {
        const auto K_i = corrected<0, 1>(W_i);
        return value(Wave::B, K_i) - expanded_value(Wave::B(W_i.x), Wave::DB(W_i.x), Wave::D2B(W_i.x), K_i);
    };
    CHECK(order_in_h(1, left) == support::relative(3, 0.05));
}

TEST_CASE("the discrete (21) tends to the integral as δ/h → 0, for both orders") {
    support::check_tends_to_integral(
        [](const auto& line, const auto& near, const auto& neighbourhood, Index) {
            return support::sum_of_values(classical_sph::value(corrected<0, 1>(neighbourhood)), line, near,
                                          Wave::B);
        },
        [](const CentredKernel& W_i) { return value(Wave::B, corrected<0, 1>(W_i)); }, 0);
    support::check_tends_to_integral(
        [](const auto& line, const auto& near, const auto& neighbourhood, Index) {
            return support::sum_of_values(classical_sph::value(corrected<0, 1, 2>(neighbourhood)), line, near,
                                          Wave::B);
        },
        [](const CentredKernel& W_i) { return value(Wave::B, corrected<0, 1, 2>(W_i)); }, 0);
}

TEST_CASE("(25) tends to (10) with the corrected kernel as δ/h → 0") {
    support::check_tends_to_integral(
        [](const auto& line, const auto& near, const auto& neighbourhood, Index i) {
            return support::sum_of_differences(first_derivative<1>(neighbourhood), line, near, i, Wave::B);
        },
        [](const CentredKernel& W_i) { return original::first_derivative(Wave::B, corrected<0, 1>(W_i)); },
        1);
    support::check_tends_to_integral(
        [](const auto& line, const auto& near, const auto& neighbourhood, Index i) {
            return support::sum_of_differences(first_derivative<2>(neighbourhood), line, near, i, Wave::B);
        },
        [](const CentredKernel& W_i) { return original::first_derivative(Wave::B, corrected<0, 1, 2>(W_i)); },
        1);
}

TEST_CASE("(26) is (25) of (25)") {
    const auto [line, smoothing] =
        support::particles_of(60, {particles::Volumes::equal, particles::Gaussian{}, 1, 0.25});
    const Column<double> B = line.x().unaryExpr(&Wave::B);
    for (const char* name : {"rkpm_first_order", "rkpm_second_order"}) {
        const auto D = formulation_named<double>(name).operators(line, smoothing).D;
        const Column<double> twice = particles::apply(D, particles::apply(D, B));
        CHECK((particles::apply(second_derivative(D), B) - twice).abs().maxCoeff() < 1e-9);
    }
}

TEST_CASE("(22): two particles do not determine a quadratic correction") {
    const particles::Neighbourhood<double> two{Column<double>::LinSpaced(2, 0, 1),
                                               Column<double>::Constant(2, 0.5),
                                               Column<double>::LinSpaced(2, 0, -1), Column<double>::Ones(2)};
    CHECK_NOTHROW(corrected<0, 1>(two));
    CHECK_THROWS_AS((corrected<0, 1, 2>(two)), particles::SingularNeighbourhood);
}

TEST_CASE(
    "(25) with moments imposed on integrals: inside, with a wide Gaussian, the weights are those of the sums") {
    const auto [line, smoothing] =
        support::particles_of(60, {particles::Volumes::partition, particles::Gaussian{}, 2});
    const Operator<double> first = first_derivative_by_integrals<0, 1>(line, smoothing),
                           second = first_derivative_by_integrals<0, 1, 2>(line, smoothing);
    const auto difference = [&, &line = line, &smoothing = smoothing](const Operator<double>& D, Index i,
                                                                      const Column<double>& weights) {
        const auto near = particles::within_reach(line, smoothing, i);
        double largest = 0;
        for (Index k = 0; k < weights.size(); ++k)
            if (near.first + k != i)
                largest =
                    std::max(largest, std::abs(D.coeff(i, near.first + k) - weights[k] / smoothing.h()));
        return largest * smoothing.h();
    };
    const auto near = particles::neighbourhood(line, smoothing, 30);
    CHECK(difference(first, 30, first_derivative<1>(near)) < 1e-12);
    CHECK(difference(second, 30, first_derivative<2>(near)) < 1e-12);
    const Column<double> constant = Column<double>::Ones(60);
    CHECK((particles::apply(first, constant) == 0).all());
    const auto at_end = particles::neighbourhood(line, smoothing, 0);
    CHECK(difference(second, 0, first_derivative<2>(at_end)) > 1e-3);
}
