#include "asprone2010/section_3_4_fpm.hpp"

#include "tests/support/integral_forms.hpp"

using namespace asprone2010;
using namespace asprone2010::fpm;
using support::order_in_h;
using support::Wave;

namespace {

CentredKernel at(double x, double h = 0.05) {
    return particles::centred(particles::Gaussian{}, x, h, {0, 1});
}

}  // namespace

TEST_CASE("(27), (28): orders of the remainders over the norms, at an end and inside") {
    const auto first = [](const CentredKernel& W_i) {
        return first_remainder(Wave::B, Wave::DB(W_i.x), W_i) / W_i.norm(W_i.W);
    };
    const auto second = [](const CentredKernel& W_i) {
        return second_remainder(Wave::B, Wave::DB(W_i.x), W_i) / W_i.norm(W_i.DW);
    };
    CHECK(order_in_h(1, first) == support::relative(2, 0.05));
    CHECK(order_in_h(0.5, first) == support::relative(2, 0.05));
    CHECK(order_in_h(1, second) == support::relative(2, 0.05));
    CHECK(order_in_h(0.5, second) == support::relative(3, 0.05));
}

TEST_CASE("(29): the matrix at an end in closed form, by quadrature") {
    const double h = 0.05, pi = std::acos(-1.0);
    const Eigen::Matrix2d expected{{0.5, h / (2 * std::sqrt(pi))}, {-1 / (h * std::sqrt(pi)), -0.5}};
    CHECK((matrix(at(0)) - expected).cwiseAbs().maxCoeff() < 1e-12);
    const auto inside = matrix(at(0.5));
    CHECK(std::abs(inside(0, 1)) < 1e-15);
    CHECK(std::abs(inside(1, 0)) < 1e-12);
}

TEST_CASE("(30): linear functions and their derivatives are exact everywhere, by quadrature and as sums") {
    const auto line_B = [](double x) { return 3 - 2 * x; };
    for (const double x : {0.0, 0.02, 0.5, 1.0}) {
        const Eigen::Vector2d found = value_and_derivative(line_B, at(x));
        CHECK(found[0] == support::relative(line_B(x), 1e-12));
        CHECK(found[1] == support::relative(-2, 1e-11));
    }
    const auto [line, smoothing] =
        support::particles_of(40, {particles::Volumes::partition, particles::Gaussian{}, 1, 0.4});
    for (Index i = 0; i < 40; ++i) {
        const auto near = particles::within_reach(line, smoothing, i);
        const auto weights = value_and_derivative(particles::neighbourhood(line, smoothing, i));
        CHECK(support::sum_of_values(weights.value, line, near, line_B) ==
              support::relative(line_B(line.x()[i]), 1e-12));
        CHECK(support::sum_of_values(weights.first, line, near, line_B) / smoothing.h() ==
              support::relative(-2, 1e-10));
    }
}

TEST_CASE("(30): value and derivative as sums tend to the integrals as δ/h → 0") {
    support::check_tends_to_integral(
        [](const auto& line, const auto& near, const auto& neighbourhood, Index) {
            return support::sum_of_values(value_and_derivative(neighbourhood).value, line, near, Wave::B);
        },
        [](const CentredKernel& W_i) { return value_and_derivative(Wave::B, W_i)[0]; }, 0);
    support::check_tends_to_integral(
        [](const auto& line, const auto& near, const auto& neighbourhood, Index i) {
            return support::sum_of_differences(first_derivative(neighbourhood), line, near, i, Wave::B);
        },
        [](const CentredKernel& W_i) { return value_and_derivative(Wave::B, W_i)[1]; }, 1);
}

TEST_CASE("(31) is (30) inside, and is not at an end") {
    CHECK((interior_value_and_derivative(Wave::B, at(0.5)) - value_and_derivative(Wave::B, at(0.5))).norm() <
          1e-12);
    CHECK((interior_value_and_derivative(Wave::B, at(1)) - value_and_derivative(Wave::B, at(1))).norm() > 1);
}

TEST_CASE(
    "(32): the error is computed minus exact; O(h²) for B, for DB O(h²) inside and O(h) at the boundary") {
    for (const double x : {0.0, 0.03, 0.5, 1.0}) {
        const Eigen::Vector2d exact{Wave::B(x), Wave::DB(x)};
        CHECK((value_and_derivative(Wave::B, at(x)) - exact - error(Wave::B, Wave::DB(x), at(x))).norm() <
              1e-11);
    }
    for (const int unknown : {0, 1}) {
        const auto part = [&](const CentredKernel& W_i) {
            return error(Wave::B, Wave::DB(W_i.x), W_i)[unknown];
        };
        CHECK(order_in_h(0.5, part) == support::relative(2, 0.05));
        CHECK(order_in_h(1, part) == support::relative(unknown == 0 ? 2 : 1, 0.05));
    }
}

TEST_CASE(
    "claims A-3.4-*-at-end, A-3.4-DB-inside: B converges with order 2 everywhere, DB with 2 inside and 1 at the boundary, as sums with h = δ") {
    std::vector<double> spacing, B, DB_end, DB_inside;
    for (const Index N : {161, 321, 641, 1281}) {
        const auto [line, smoothing] = support::particles_of(N);
        const auto error = [&, &line = line, &smoothing = smoothing](Index i, bool derivative) {
            const auto near = particles::within_reach(line, smoothing, i);
            const auto weights = value_and_derivative(particles::neighbourhood(line, smoothing, i));
            return derivative
                       ? std::abs(support::sum_of_values(weights.first, line, near, Wave::B) / smoothing.h() -
                                  Wave::DB(line.x()[i]))
                       : std::abs(support::sum_of_values(weights.value, line, near, Wave::B) -
                                  Wave::B(line.x()[i]));
        };
        spacing.push_back(line.spacing());
        B.push_back(error(N - 1, false));
        DB_end.push_back(error(N - 1, true));
        DB_inside.push_back(error(N / 2, true));
    }
    CHECK(report::observed_order(spacing, B) == support::relative(2, 0.05));
    CHECK(report::observed_order(spacing, DB_end) == support::relative(1, 0.05));
    CHECK(report::observed_order(spacing, DB_inside) == support::relative(2, 0.05));
}

TEST_CASE(
    "claim A-3.4-applied-twice: applied twice, the error of eˣ tends to a constant: 1.29 with equal volumes, 1.03 with the partition") {
    const auto error = [](particles::Volumes volumes) {
        const auto [line, smoothing] = support::particles_of(1280, {volumes});
        const auto D2 = formulation_named<double>("fpm").operators(line, smoothing).D2;
        const Column<double> B = line.x().exp();
        return (particles::apply(D2, B) - B).abs().maxCoeff();
    };
    CHECK(error(particles::Volumes::equal) == support::relative(1.29, 0.005));
    CHECK(error(particles::Volumes::partition) == support::relative(1.03, 0.005));
}

TEST_CASE("the procedure reiterated is (30) of (30)") {
    const auto [line, smoothing] =
        support::particles_of(60, {particles::Volumes::equal, particles::Gaussian{}, 1, 0.25});
    const auto D = formulation_named<double>("fpm").operators(line, smoothing).D;
    const Column<double> B = line.x().unaryExpr(&Wave::B);
    CHECK((particles::apply(second_derivative(D), B) - particles::apply(D, particles::apply(D, B)))
              .abs()
              .maxCoeff() < 1e-10);
}
