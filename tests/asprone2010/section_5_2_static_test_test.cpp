#include "asprone2010/section_5_2_static_test.hpp"

#include "tests/support/claims.hpp"
#include "tests/support/lines.hpp"

using namespace asprone2010;
using particles::Gaussian;
using particles::Volumes;
using support::expected;
using support::particles_of;

namespace {

double error(std::string_view name, Index N, const numerical_tests::Discretisation& how = {},
             unsigned long seed = 1) {
    return static_test::error(formulation_named<double>(name), particles_of(N, how, seed),
                              static_test::exponential_load());
}

double order(std::string_view name, const std::vector<Index>& particles, Volumes volumes = Volumes::equal) {
    std::vector<double> spacing, errors;
    for (const Index N : particles) {
        spacing.push_back(1.0 / static_cast<double>(N - 1));
        errors.push_back(error(name, N, {volumes}));
    }
    return report::observed_order(spacing, errors);
}

}  // namespace

TEST_CASE("5.2: the exact solution satisfies (45) and both end conditions") {
    const auto exact = static_test::exponential_load();
    CHECK(exact.f(0) == 0);
    CHECK(std::abs(exact.Df(1)) < 1e-15);
    for (const double x : {0.1, 0.5, 0.9}) {
        CHECK(-exact.D2f(x) == std::exp(x));
        CHECK(exact.Df(x) == support::relative((exact.f(x + 1e-5) - exact.f(x - 1e-5)) / 2e-5, 1e-8));
        CHECK(exact.D2f(x) == support::relative((exact.Df(x + 1e-5) - exact.Df(x - 1e-5)) / 2e-5, 1e-8));
    }
}

TEST_CASE(
    "5.2: the system holds u at the first, −D²u at the inner, Du at the last particle, and the load beside them") {
    const auto [line, smoothing] = particles_of(30);
    const auto operators = formulation_named<double>("second_order_fpm").operators(line, smoothing);
    auto D2 = operators.D2;
    const Eigen::MatrixXd A = static_test::system(std::move(D2), operators.D);
    CHECK(A.row(0) == Eigen::RowVectorXd::Unit(30, 0));
    CHECK(A.middleRows(1, 28) == -Eigen::MatrixXd(operators.D2).middleRows(1, 28));
    CHECK(A.row(29) == Eigen::MatrixXd(operators.D).row(29));
    const base::Smooth<> exact{[](double x) { return 5 + x; }, [](double x) { return 7 + x; },
                               [](double x) { return 9 * x; }};
    const Column<double> f = static_test::right_hand_side(line, exact);
    CHECK(f[0] == 5);
    CHECK(f[10] == -9 * line.x()[10]);
    CHECK(f[29] == 8);
}

TEST_CASE("5.2: the residual is what the system leaves of the load, at the ends too") {
    const auto [line, smoothing] = particles_of(30, {Volumes::equal, Gaussian{}, 1, 0.25});
    const auto operators = formulation_named<double>("second_order_fpm").operators(line, smoothing);
    auto D2 = operators.D2;
    const auto A = static_test::system(std::move(D2), operators.D);
    const Column<double> f = line.x().cos(), u = 3 + line.x().sin();
    const Column<double> left = static_test::residual(A, f, u);
    CHECK(left[0] == 1 - 3.0);
    CHECK((left - (f - (A * u.matrix()).array())).abs().maxCoeff() < 1e-10);
}

TEST_CASE("5.2: corrections restore in double precision what the condition of long lines takes") {
    const auto& formulation = formulation_named<double>("second_order_fpm");
    const auto exact = static_test::exponential_load<double>();
    const auto short_line = particles_of(2001), line = particles_of(20001);
    const double expected = static_test::error(formulation, short_line, exact) / 100;
    CHECK(static_test::error(formulation, line, exact) == support::relative(expected, 5e-3));
    CHECK(static_test::error(formulation, formulation, line, exact, 0) > 10 * expected);
}

TEST_CASE("5.2: a parabola is solved exactly by the formulations that differentiate it exactly") {
    const base::Smooth<> parabola{[](double x) { return 1 + 2 * x - 3 * x * x; },
                                  [](double x) { return 2 - 6 * x; }, [](double) { return -6.0; }};
    for (const char* name : {"modified_fpm", "second_order_fpm"})
        CHECK(static_test::error(formulation_named<double>(name),
                                 particles_of(50, {Volumes::partition, Gaussian{}, 1, 0.4}),
                                 parabola) < 1e-11);
}

TEST_CASE("5.2: errors with 640 particles are those of an independent calculation") {
    CHECK(error("second_order_fpm", 640) == support::relative(4.0e-7, 0.005));
    CHECK(error("modified_fpm", 640) == support::relative(2.14e-6, 0.005));
    CHECK(error("chen_beraun", 640) == support::relative(2.455e-3, 0.005));
}

TEST_CASE(
    "claims A-5.2-*: both FPMs are second order, Chen–Beraun is first, original and both RKPMs do not converge") {
    for (const auto volumes : {Volumes::equal, Volumes::partition}) {
        CHECK(order("second_order_fpm", {160, 320, 640, 1280}, volumes) ==
              support::relative(expected("A-5.2-second-order-fpm"), 0.02));
        CHECK(order("modified_fpm", {160, 320, 640, 1280}, volumes) ==
              support::relative(expected("A-5.2-modified-fpm"), 0.02));
        CHECK(order("chen_beraun", {160, 320, 640, 1280}, volumes) ==
              support::relative(expected("A-5.2-chen-beraun"), 0.02));
        for (const char* name : {"original", "rkpm_first_order", "rkpm_second_order"})
            CHECK(std::abs(order(name, {10240, 20480, 40960}, volumes)) < 0.1);
        for (const char* name : {"original", "rkpm_first_order"})
            CHECK(error(name, 40960, {volumes}) == support::relative(4.0e-3, 0.05));
        CHECK(error("rkpm_second_order", 40960, {volumes}) == support::relative(4.08e-2, 0.01));
    }
}

TEST_CASE(
    "claims A-5.2-few-*: original and first-order RKPM look first order for few particles and lose it with more") {
    for (const char* name : {"original", "rkpm_first_order"}) {
        CHECK(order(name, {20, 40, 80, 160}) == support::relative(expected("A-5.2-few-original"), 0.1));
        CHECK(order(name, {640, 1280, 2560}) < 0.3);
        CHECK(order(name, {10240, 20480, 40960}) < 0.05);
    }
}

TEST_CASE(
    "5.2: a second-order derivative at the end leaves Chen–Beraun first order, with a thirtieth of the error") {
    const auto with_end = [](Index N) {
        return static_test::error(formulation_named<double>("chen_beraun"),
                                  formulation_named<double>("second_order_fpm"), particles_of(N),
                                  static_test::exponential_load());
    };
    CHECK(with_end(640) < error("chen_beraun", 640) / 30);
    CHECK(report::observed_order({1.0 / 639, 1.0 / 2559}, {with_end(640), with_end(2560)}) ==
          support::relative(1, 0.05));
}

TEST_CASE("claim A-5.2-errs-less: the second-order FPM errs five times less than the modified FPM") {
    for (const Index N : {160, 320, 640, 1280})
        CHECK(error("modified_fpm", N) / error("second_order_fpm", N) == support::relative(5.4, 0.1));
}

TEST_CASE(
    "claim A-5.2-perturbed: on perturbed particles the second-order FPM keeps order two in the median over seeds") {
    std::vector<double> spacing, median;
    for (const Index N : {40, 80, 160, 320, 640, 1280}) {
        std::vector<double> sample;
        for (unsigned long seed = 1; seed <= 101; ++seed)
            sample.push_back(error("second_order_fpm", N, {Volumes::equal, Gaussian{}, 1, 0.25}, seed));
        spacing.push_back(1.0 / static_cast<double>(N - 1));
        median.push_back(report::quartiles(sample).median);
    }
    CHECK(report::observed_order(spacing, median) == support::relative(expected("A-5.2-perturbed"), 0.05));
}
