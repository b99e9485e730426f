#include "asprone2010/section_4_second_order_fpm.hpp"

#include <Eigen/SVD>

#include "tests/support/integral_forms.hpp"

using namespace asprone2010;
using namespace asprone2010::second_order_fpm;
using support::order_in_h;
using support::Wave;

namespace {

CentredKernel at(double x, double h = 0.05) {
    return particles::centred(particles::Gaussian{}, x, h, {0, 1});
}

double reciprocal_condition(const Eigen::Matrix3d& M) {
    const auto values = M.jacobiSvd().singularValues();
    return values[2] / values[0];
}

/// The matrix of (42) for a polynomial with the given exponents.
Eigen::Matrix3d conditions(const particles::Neighbourhood<double>& near, std::array<int, 3> exponents) {
    Eigen::Matrix3d M;
    int row = 0;
    for (const int moment : {0, 1, 3}) {
        for (std::size_t k = 0; k < 3; ++k)
            M(row, static_cast<Index>(k)) = (near.r.pow(moment + exponents[k]) * near.W * near.V).sum();
        ++row;
    }
    return M;
}

}  // namespace

TEST_CASE(
    "(39), (40), (41): the corrected kernel has the moments 1, 0 and 0 of order 0, 1 and 3, everywhere") {
    for (const double x : {0.0, 0.013, 0.5, 1.0}) {
        const Eigen::Vector3d moments = imposed_moments(corrected(at(x)));
        CHECK(moments[0] == support::relative(1, 1e-12));
        CHECK(std::abs(moments[1]) < 1e-14);
        CHECK(std::abs(moments[2]) < 1e-16);
    }
    // The quotient K/W is a cubic without a quadratic term: (40).
    const auto K_i = corrected(at(0.02)), W_i = at(0.02);
    const auto C = [&](double s) { return K_i.W(0.02 + 0.05 * s) / W_i.W(0.02 + 0.05 * s); };
    CHECK(C(1) + C(-1) == support::relative(2 * C(0), 1e-12));
    CHECK(C(3) - 4 * C(2) + 6 * C(1) - 4 * C(0) + C(-1) == doctest::Approx(0).epsilon(1e-10));
    for (const double x : {0.0, 0.01, 0.05, 0.2})
        CHECK(K_i.DW(x) == support::relative((K_i.W(x + 1e-6) - K_i.W(x - 1e-6)) / 2e-6, 1e-6));
}

TEST_CASE("(42): the same moments as sums, on random particles") {
    const auto [line, smoothing] =
        support::particles_of(50, {particles::Volumes::partition, particles::Gaussian{}, 1, 0.4});
    for (Index i = 0; i < 50; ++i) {
        const auto [r, K, DK, V] = corrected(particles::neighbourhood(line, smoothing, i));
        CHECK((K * V).sum() == support::relative(1, 1e-11));
        CHECK(std::abs((r * K * V).sum()) < 1e-11);
        CHECK(std::abs((r.cube() * K * V).sum()) < 1e-11);
    }
}

TEST_CASE(
    "claims A-4-cubic-regular, A-4-quadratic-singular: with the cubic (42) is regular for every particle; with a quadratic it is singular inside") {
    const auto [line, smoothing] = support::particles_of(100);
    for (Index i = 0; i < 100; ++i) {
        const auto near = particles::neighbourhood(line, smoothing, i);
        CHECK(reciprocal_condition(conditions(near, {3, 1, 0})) > 1e-3);
        if (i >= 6 && i < 94) CHECK(reciprocal_condition(conditions(near, {2, 1, 0})) < 1e-14);
    }
}

TEST_CASE("claim A-4-kernel-inside: far from the boundary K is W over its discrete integral, 1.0001") {
    const auto [line, smoothing] = support::particles_of(100);
    const auto near = particles::neighbourhood(line, smoothing, 50);
    const auto K = corrected(near);
    const double integral = (near.W * near.V).sum();
    CHECK(integral == support::relative(1.0001, 1e-5));
    CHECK((K.W - near.W / integral).abs().maxCoeff() < 1e-13);
    const auto end = particles::neighbourhood(line, smoothing, 0);
    CHECK((corrected(end).W - end.W).abs().maxCoeff() > 0.1);
}

TEST_CASE("claim A-4-entry-vanishes: A11 of (43) vanishes for every particle, to round-off") {
    const auto [line, smoothing] =
        support::particles_of(100, {particles::Volumes::equal, particles::Gaussian{}, 1, 0.25});
    for (Index i = 0; i < 100; ++i)
        CHECK(std::abs(modified_fpm::matrix(corrected(particles::neighbourhood(line, smoothing, i)))(0, 0)) <
              1e-12);
}

TEST_CASE(
    "claims A-4-cubic-regular-short-gap, A-4-system-regular: behind a short first gap (42) is regular, and A12 of (43) vanishes at the gaps of a calculation in NumPy") {
    struct Zero {
        double ratio, gap;  ///< h/δ, and the gap over δ
        particles::Volumes volumes;
    };
    using enum particles::Volumes;
    for (const Zero& zero :
         {Zero{1, 0.0347, partition}, Zero{1.2, 0.0071, equal}, Zero{1.2, 0.1068, partition},
          Zero{1.5, 0.0334, equal}, Zero{1.5, 0.2189, partition}, Zero{2, 0.0981, equal},
          Zero{2, 0.3711, partition}, Zero{2.5, 0.1774, equal}, Zero{2.5, 0.5050, partition},
          Zero{3, 0.2685, equal}, Zero{3, 0.6314, partition}}) {
        CAPTURE(zero.ratio);
        CAPTURE(zero.gap);
        const auto second = [&](double t) {
            Column<double> x = Column<double>::LinSpaced(40, t - 1, t + 38);
            x[0] = 0;
            return particles::neighbourhood(particles::line_at(x, zero.volumes),
                                            particles::Smoothing<double>(particles::Gaussian{}, zero.ratio),
                                            1);
        };
        const auto A12 = [&](double t) { return modified_fpm::matrix(corrected(second(t)))(0, 1); };
        CHECK(A12(zero.gap - 1e-4) < 0);
        CHECK(A12(zero.gap + 1e-4) > 0);
        CHECK(reciprocal_condition(conditions(second(zero.gap), {3, 1, 0})) > 1e-3);
    }
}

TEST_CASE(
    "(43): parabolas are exact for DB and cubics for D²B, by quadrature and as sums on random particles") {
    const auto cubic = [](double x) { return 1 - 2 * x + 3 * x * x - 4 * x * x * x; };
    const auto parabola = [](double x) { return 1 - 2 * x + 3 * x * x; };
    for (const double x : {0.0, 0.02, 0.5, 1.0}) {
        CHECK(derivatives(parabola, corrected(at(x)))[0] == support::relative(-2 + 6 * x, 1e-11));
        CHECK(derivatives(cubic, corrected(at(x)))[1] == support::relative(6 - 24 * x, 1e-9));
    }
    const auto [line, smoothing] =
        support::particles_of(40, {particles::Volumes::partition, particles::Gaussian{}, 1, 0.4});
    for (Index i = 0; i < 40; ++i) {
        const auto near = particles::within_reach(line, smoothing, i);
        const auto weights = derivatives(particles::neighbourhood(line, smoothing, i));
        const double h = smoothing.h(), x = line.x()[i];
        CHECK(support::sum_of_differences(weights.first, line, near, i, parabola) / h ==
              support::relative(-2 + 6 * x, 1e-9));
        CHECK(support::sum_of_differences(weights.second, line, near, i, cubic) / (h * h) ==
              support::relative(6 - 24 * x, 1e-8));
    }
}

TEST_CASE("(43): both derivatives as sums tend to the integrals as δ/h → 0") {
    support::check_tends_to_integral(
        [](const auto& line, const auto& near, const auto& neighbourhood, Index i) {
            return support::sum_of_differences(derivatives(neighbourhood).first, line, near, i, Wave::B);
        },
        [](const CentredKernel& W_i) { return derivatives(Wave::B, corrected(W_i))[0]; }, 1);
    support::check_tends_to_integral(
        [](const auto& line, const auto& near, const auto& neighbourhood, Index i) {
            return support::sum_of_differences(derivatives(neighbourhood).second, line, near, i, Wave::B);
        },
        [](const CentredKernel& W_i) { return derivatives(Wave::B, corrected(W_i))[1]; }, 2);
}

TEST_CASE(
    "(44): the error is computed minus exact, the sign of its first entry as printed; O(h²) everywhere") {
    for (const double x : {0.0, 0.03, 0.5, 1.0}) {
        const auto K_i = corrected(at(x));
        const Eigen::Vector2d exact{Wave::DB(x), Wave::D2B(x)};
        CHECK((derivatives(Wave::B, K_i) - exact - error(Wave::B, Wave::DB(x), Wave::D2B(x), K_i)).norm() <
              1e-9);
    }
    for (const int unknown : {0, 1})
        for (const double x : {0.0, 0.5, 1.0}) {
            const auto part = [&](const CentredKernel& W_i) {
                return error(Wave::B, Wave::DB(W_i.x), Wave::D2B(W_i.x), corrected(W_i))[unknown];
            };
            CAPTURE(unknown);
            CAPTURE(x);
            CHECK(order_in_h(x, part) > 1.9);
        }
}

TEST_CASE("(42): particles that lie symmetrically at one distance do not determine a, b and c") {
    particles::Neighbourhood<double> three{
        Column<double>::LinSpaced(3, -1, 1), {}, {}, Column<double>::Ones(3)};
    three.W = (-three.r.square()).exp();
    three.DW = -2 * three.r * three.W;
    CHECK_THROWS_AS(corrected(three), particles::SingularNeighbourhood);
}
