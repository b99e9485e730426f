#include "particles/truncated_gaussian.hpp"

#include <doctest/doctest.h>

#include <Eigen/Core>

#include "base/quad.hpp"
#include "tests/support/relative.hpp"

using namespace particles;

namespace {

constexpr std::array<double, 6> scaling_factors{0.5, 1.0, 2.1, 3.0, 4.0, 6.0};

/// Integral over the support by Simpson's rule along the radius. \param surface of the unit sphere of so many
/// dimensions
template <int dim>
double integral(const TruncatedGaussian<dim>& kernel, double surface) {
    constexpr int steps = 2000;
    double sum = 0;
    for (int k = 0; k <= steps; ++k) {
        const double s = kernel.rho() * k / steps;
        const double factor = k == 0 || k == steps ? 1 : k % 2 == 1 ? 4 : 2;
        sum += factor * kernel.at(s * s) * surface * std::pow(s, dim - 1);
    }
    return sum * kernel.rho() / steps / 3;
}

template <int dim>
void check_slope() {
    for (const double rho : scaling_factors) {
        CAPTURE(rho);
        const TruncatedGaussian<dim> kernel(rho);
        for (double s = 0.03 * rho; s < 0.99 * rho; s += 0.05 * rho) {
            const double step = 1e-5 * rho;
            const double slope =
                (kernel.at((s + step) * (s + step)) - kernel.at((s - step) * (s - step))) / (2 * step);
            const double found = -2 * s * (kernel.at(s * s) + kernel.edge());
            CHECK(std::abs(found - slope) < 1e-8 * (kernel.at(0) + kernel.edge()));
            CHECK(kernel.DW(s) == support::relative(found, 1e-14));
            const double curvature = (kernel.DW(s + step) - kernel.DW(s - step)) / (2 * step);
            CHECK(std::abs(kernel.D2W(s) - curvature) < 1e-8 * (kernel.at(0) + kernel.edge()));
        }
    }
}

template <int dim>
void check_edge() {
    for (const double rho : scaling_factors) {
        CAPTURE(rho);
        const TruncatedGaussian<dim> kernel(rho);
        CHECK(kernel.rho() == rho);
        for (const double beyond : {1.0, 1.0001, 2.0, 1e3}) CHECK(kernel.at(rho * rho * beyond) == 0);
        const Eigen::Array3d W = kernel.at(Eigen::Array3d(0, rho * rho, 4 * rho * rho));
        CHECK(W[0] == support::relative(kernel.at(0), 1e-15));
        CHECK(W[1] == 0);
        CHECK(W[2] == 0);
        for (const double beyond : {rho, -rho, 1.0001 * rho, 40.0})
            for (const double value : {kernel.W(beyond), kernel.DW(beyond), kernel.D2W(beyond)})
                CHECK(value == 0);
        // It tends to zero at the edge, in proportion to the distance from it.
        const double near = kernel.at(std::pow(rho * (1 - 1e-6), 2));
        CHECK(near == support::relative(2e-6 * rho * rho * kernel.edge(), 1e-4));
    }
}

}  // namespace

TEST_CASE("truncated_gaussian: unit integral in one, two and three dimensions") {
    const double pi = std::acos(-1.0);
    for (const double rho : scaling_factors) {
        CAPTURE(rho);
        CHECK(integral(TruncatedGaussian<1>(rho), 2) == support::relative(1, 1e-10));
        CHECK(integral(TruncatedGaussian<2>(rho), 2 * pi) == support::relative(1, 1e-10));
        CHECK(integral(TruncatedGaussian<3>(rho), 4 * pi) == support::relative(1, 1e-10));
    }
}

TEST_CASE("truncated_gaussian: zero at the edge of the support and beyond, as a value and as an array") {
    check_edge<1>();
    check_edge<2>();
    check_edge<3>();
}

TEST_CASE("truncated_gaussian: values are the lowered Gaussian's, of G(2) in closed form") {
    const double pi = std::acos(-1.0), q = 0.7 * 0.7;
    const TruncatedGaussian<2> kernel(2);
    const double G = 1 / (1 - 5 * std::exp(-4));
    CHECK(kernel.G() == support::relative(G, 1e-15));
    CHECK(kernel.at(q) == support::relative(G / pi * (std::exp(-q) - std::exp(-4)), 1e-14));
    CHECK(kernel.edge() == support::relative(G / pi * std::exp(-4), 1e-14));
}

TEST_CASE("truncated_gaussian: an array of squared distances gives the single values") {
    const TruncatedGaussian<3> kernel(2.5);
    const Eigen::ArrayXd q = Eigen::ArrayXd::LinSpaced(101, 0, 6.24);
    const Eigen::ArrayXd W = kernel.at(q);
    for (Eigen::Index k = 0; k < q.size(); ++k) CHECK(W[k] == support::relative(kernel.at(q[k]), 1e-11));
}

TEST_CASE("truncated_gaussian: at an offset the value is that at its squared length, to the last bit") {
    const TruncatedGaussian<2> kernel(2.5);
    for (double s = -3; s < 3; s += 0.01) CHECK(kernel.W(s) == kernel.at(s * s));
}

TEST_CASE("truncated_gaussian: the gradients at offsets follow from the values, to the last bit") {
    const TruncatedGaussian<2> kernel(2.5);
    const Offsets<double, 2> s = 1.7 * Offsets<double, 2>::Random(101, 2);
    Column<double> W;
    Offsets<double, 2> DW;
    evaluate(kernel, s, W, DW);
    CHECK((W == kernel.at(squared_lengths(s))).all());
    CHECK((DW == (-2 * s).colwise() * (W + kernel.edge())).all());
}

TEST_CASE("truncated_gaussian: wider scalars vanish at the edge to their own precision") {
    const TruncatedGaussian<1> kernel(3);
    const base::Quad near = base::Quad(3) * (1 - base::Quad(1e-20));
    CHECK(static_cast<double>(kernel.W(near)) == support::relative(18e-20 * kernel.edge(), 1e-12));
    CHECK(static_cast<double>(kernel.edge<long double>()) == support::relative(kernel.edge(), 1e-15));
}

TEST_CASE("truncated_gaussian: positive inside and falling with the distance") {
    const TruncatedGaussian<2> kernel(3);
    for (double s = 0; s < 2.99; s += 0.01) {
        CHECK(kernel.at(s * s) > 0);
        CHECK(kernel.at((s + 0.01) * (s + 0.01)) < kernel.at(s * s));
    }
}

TEST_CASE(
    "truncated_gaussian: its slope follows from its value and what was taken off, by finite differences") {
    check_slope<1>();
    check_slope<2>();
    check_slope<3>();
}

TEST_CASE("truncated_gaussian: wide supports give the Gaussian") {
    const double pi = std::acos(-1.0);
    CHECK(TruncatedGaussian<1>(7).at(1.3) == support::relative(std::exp(-1.3) / std::sqrt(pi), 1e-14));
    CHECK(TruncatedGaussian<2>(40).at(1.3) == support::relative(std::exp(-1.3) / pi, 1e-14));
    CHECK(TruncatedGaussian<3>(7).G() == support::relative(1, 1e-14));
}

TEST_CASE("truncated_gaussian: a scaling factor must be positive and finite") {
    CHECK_THROWS_WITH_AS(TruncatedGaussian<2>(0), "the scaling factor must be positive and finite, got 0",
                         InvalidInput);
    CHECK_THROWS_WITH_AS(TruncatedGaussian<1>(-2.5),
                         "the scaling factor must be positive and finite, got -2.5", InvalidInput);
    CHECK_THROWS_AS(TruncatedGaussian<2>{std::nan("")}, InvalidInput);
    CHECK_THROWS_AS(TruncatedGaussian<3>{HUGE_VAL}, InvalidInput);
}
