#include "asprone2010/section_3_1_original.hpp"

#include "tests/support/integral_forms.hpp"

using namespace asprone2010;
using namespace asprone2010::original;
using support::Wave;

namespace {

CentredKernel at(double x, double h = 0.05) {
    return particles::centred(particles::Gaussian{}, x, h, {0, 1});
}

}  // namespace

TEST_CASE("(5) and (6) are equal everywhere: integration by parts") {
    particles::for_each_kernel([](const particles::Kernel<>& kernel) {
        CAPTURE(particles::name(kernel));
        for (const double x : {0.0, 0.02, 0.3, 0.93, 1.0}) {
            const auto W_i = particles::centred(kernel, x, 0.05, {0, 1});
            CHECK(smoothed_derivative(Wave::DB, W_i) ==
                  support::relative(derivative_by_parts(Wave::B, W_i), 1e-11));
        }
    });
}

TEST_CASE("(7) equals (6) inside and grows like 1/h at an end") {
    CHECK(interior_derivative(Wave::B, at(0.5)) ==
          support::relative(derivative_by_parts(Wave::B, at(0.5)), 1e-12));
    const auto error = [](const CentredKernel& W_i) {
        return interior_derivative(Wave::B, W_i) - Wave::DB(W_i.x);
    };
    CHECK(support::order_in_h(1, error) == support::relative(-1, 0.05));
}

TEST_CASE("(8) tends to (7) as δ/h → 0") {
    support::check_tends_to_integral(
        [](const auto& line, const auto& near, const auto& neighbourhood, Index) {
            return support::sum_of_values(interior_derivative(neighbourhood), line, near, Wave::B);
        },
        [](const CentredKernel& W_i) { return interior_derivative(Wave::B, W_i); }, 1);
}

TEST_CASE("(9) holds inside and fails at the ends") {
    CHECK(std::abs(total_derivative(at(0.5))) < 1e-12);
    CHECK(total_derivative(at(0)) == support::relative(-at(0).W(0), 1e-12));
    CHECK(total_derivative(at(1)) == support::relative(at(1).W(1), 1e-12));
}

TEST_CASE(
    "claims A-3.1-equivalent-inside, A-3.1-constants: (7) and (10) agree where (9) holds, and (10) is exact on constants everywhere") {
    CHECK(first_derivative(Wave::B, at(0.5)) ==
          support::relative(interior_derivative(Wave::B, at(0.5)), 1e-12));
    for (const double x : {0.0, 0.01, 1.0}) {
        const double difference = first_derivative(Wave::B, at(x)) - interior_derivative(Wave::B, at(x));
        CHECK(difference == support::relative(Wave::B(x) * total_derivative(at(x)), 1e-12));
        CHECK(std::abs(difference) > 1);
    }
    for (const double x : {0.0, 0.01, 0.5, 1.0})
        CHECK(first_derivative([](double) { return 7.0; }, at(x)) == 0);
}

TEST_CASE("(11) tends to (10) as δ/h → 0") {
    support::check_tends_to_integral(
        [](const auto& line, const auto& near, const auto& neighbourhood, Index i) {
            return support::sum_of_differences(first_derivative(neighbourhood), line, near, i, Wave::B);
        },
        [](const CentredKernel& W_i) { return first_derivative(Wave::B, W_i); }, 1);
}

TEST_CASE(
    "claim A-3.1-DB-at-end: at an end (10) tends to half the derivative, so that it does not converge") {
    CHECK(first_derivative(Wave::B, at(0, 1e-4)) == support::relative(Wave::DB(0) / 2, 1e-3));
    CHECK(first_derivative(Wave::B, at(1, 1e-4)) == support::relative(Wave::DB(1) / 2, 1e-3));
}

TEST_CASE(
    "claim A-3.2-original-inside: inside, (11) with h = δ stalls at the relative error of its missing denominator, 0.998") {
    const auto [line, smoothing] = support::particles_of(200);
    const auto [r, W, DW, V] = particles::neighbourhood(line, smoothing, 100);
    const double denominator = -(r * DW * V).sum();
    CHECK(denominator == support::relative(0.998, 5e-4));
    const auto near = particles::within_reach(line, smoothing, 100);
    const double DB =
        support::sum_of_differences(first_derivative(particles::neighbourhood(line, smoothing, 100)), line,
                                    near, 100, [](double x) { return std::exp(x); }) /
        smoothing.h();
    CHECK(DB / std::exp(line.x()[100]) == support::relative(denominator, 2e-5));
}

TEST_CASE("(12) is (11) of (11)") {
    const auto [line, smoothing] =
        support::particles_of(60, {particles::Volumes::equal, particles::Gaussian{}, 1, 0.25});
    const auto D = formulation_named<double>("original").operators(line, smoothing).D;
    const Column<double> B = line.x().unaryExpr(&Wave::B);
    const Column<double> twice = particles::apply(D, particles::apply(D, B));
    CHECK((particles::apply(second_derivative(D), B) - twice).abs().maxCoeff() < 1e-10);
}
