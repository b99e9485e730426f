#include "asprone2010/section_3_5_modified_fpm.hpp"

#include "tests/support/integral_forms.hpp"

using namespace asprone2010;
using namespace asprone2010::modified_fpm;
using support::order_in_h;
using support::Wave;

namespace {

CentredKernel at(double x, double h = 0.05) {
    return particles::centred(particles::Gaussian{}, x, h, {0, 1});
}

}  // namespace

TEST_CASE("(33), (34): orders of the remainders over the norms, at an end and inside") {
    const auto first = [](const CentredKernel& W_i) {
        return first_remainder(Wave::B, Wave::DB(W_i.x), Wave::D2B(W_i.x), W_i) / W_i.norm(W_i.W);
    };
    const auto second = [](const CentredKernel& W_i) {
        return second_remainder(Wave::B, Wave::DB(W_i.x), Wave::D2B(W_i.x), W_i) / W_i.norm(W_i.DW);
    };
    CHECK(order_in_h(1, first) == support::relative(3, 0.05));
    CHECK(order_in_h(0.5, first) == support::relative(4, 0.05));
    CHECK(order_in_h(1, second) == support::relative(3, 0.05));
    CHECK(order_in_h(0.5, second) == support::relative(3, 0.05));
}

TEST_CASE("(35): the matrix at an end in closed form, and its zeros inside") {
    const double h = 0.05, pi = std::acos(-1.0);
    const Eigen::Matrix2d expected{{h / (2 * std::sqrt(pi)), h * h / 8}, {-0.5, -h / (2 * std::sqrt(pi))}};
    CHECK((matrix(at(0)) - expected).cwiseAbs().maxCoeff() < 1e-13);
    CHECK(std::abs(matrix(at(0.5))(0, 0)) < 1e-15);
    CHECK(std::abs(matrix(at(0.5))(1, 1)) < 1e-15);
}

TEST_CASE("(36): parabolas are exact everywhere, by quadrature and as sums on random particles") {
    const auto parabola = [](double x) { return 1 - 2 * x + 3 * x * x; };
    for (const double x : {0.0, 0.02, 0.5, 1.0}) {
        const Eigen::Vector2d found = derivatives(parabola, at(x));
        CHECK(found[0] == support::relative(-2 + 6 * x, 1e-11));
        CHECK(found[1] == support::relative(6, 1e-10));
    }
    const auto [line, smoothing] =
        support::particles_of(40, {particles::Volumes::partition, particles::Gaussian{}, 1, 0.4});
    for (Index i = 0; i < 40; ++i) {
        const auto near = particles::within_reach(line, smoothing, i);
        const auto weights = derivatives(particles::neighbourhood(line, smoothing, i));
        const double h = smoothing.h();
        CHECK(support::sum_of_differences(weights.first, line, near, i, parabola) / h ==
              support::relative(-2 + 6 * line.x()[i], 1e-10));
        CHECK(support::sum_of_differences(weights.second, line, near, i, parabola) / (h * h) ==
              support::relative(6, 1e-9));
    }
}

TEST_CASE("(36): both derivatives as sums tend to the integrals as δ/h → 0") {
    support::check_tends_to_integral(
        [](const auto& line, const auto& near, const auto& neighbourhood, Index i) {
            return support::sum_of_differences(derivatives(neighbourhood).first, line, near, i, Wave::B);
        },
        [](const CentredKernel& W_i) { return derivatives(Wave::B, W_i)[0]; }, 1);
    support::check_tends_to_integral(
        [](const auto& line, const auto& near, const auto& neighbourhood, Index i) {
            return support::sum_of_differences(derivatives(neighbourhood).second, line, near, i, Wave::B);
        },
        [](const CentredKernel& W_i) { return derivatives(Wave::B, W_i)[1]; }, 2);
}

TEST_CASE("(37) is (36) inside, and is not at an end") {
    CHECK((interior_derivatives(Wave::B, at(0.5)) - derivatives(Wave::B, at(0.5))).norm() < 1e-10);
    CHECK((interior_derivatives(Wave::B, at(1)) - derivatives(Wave::B, at(1))).norm() > 1);
}

TEST_CASE(
    "(38): the error is computed minus exact; at the boundary O(h²) for DB and O(h) for D²B, inside O(h²)") {
    for (const double x : {0.0, 0.03, 0.5, 1.0}) {
        const Eigen::Vector2d exact{Wave::DB(x), Wave::D2B(x)};
        CHECK(
            (derivatives(Wave::B, at(x)) - exact - error(Wave::B, Wave::DB(x), Wave::D2B(x), at(x))).norm() <
            1e-9);
    }
    for (const int unknown : {0, 1}) {
        const auto part = [&](const CentredKernel& W_i) {
            return error(Wave::B, Wave::DB(W_i.x), Wave::D2B(W_i.x), W_i)[unknown];
        };
        CHECK(order_in_h(0.5, part) == support::relative(2, 0.05));
        CHECK(order_in_h(1, part) == support::relative(unknown == 0 ? 2 : 1, 0.05));
    }
}

TEST_CASE("(36): one other particle does not determine two derivatives") {
    const particles::Neighbourhood<double> two{Column<double>::LinSpaced(2, 0, 1),
                                               Column<double>::Constant(2, 0.5),
                                               Column<double>::LinSpaced(2, 0, -1), Column<double>::Ones(2)};
    CHECK_THROWS_AS(derivatives(two), particles::SingularNeighbourhood);
}
