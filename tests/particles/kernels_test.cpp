#include "particles/kernels.hpp"

#include <doctest/doctest.h>

#include <set>

#include "particles/centred_kernel.hpp"
#include "tests/relative.hpp"

using namespace particles;

namespace {

double W(const Kernel& kernel, double s) {
    return std::visit([&](const auto& k) { return k.W(s); }, kernel);
}
double DW(const Kernel& kernel, double s) {
    return std::visit([&](const auto& k) { return k.DW(s); }, kernel);
}
double D2W(const Kernel& kernel, double s) {
    return std::visit([&](const auto& k) { return k.D2W(s); }, kernel);
}

}  // namespace

TEST_CASE("kernels: condition (1) of Section 2, non-negative") {
    for_each_kernel([](const Kernel& kernel) {
        CAPTURE(name(kernel));
        for (double s = -7; s <= 7; s += 0.01) CHECK(W(kernel, s) >= 0);
        CHECK(W(kernel, 0) > 0);
    });
}

TEST_CASE("kernels: condition (2), unit integral") {
    for_each_kernel([](const Kernel& kernel) {
        CAPTURE(name(kernel));
        const auto W_i = centred(kernel, 0.3, 0.7, {-10, 10});
        CHECK(W_i.integral(W_i.W) == support::relative(1, 1e-14));
    });
}

TEST_CASE("kernels: condition (3), derivable with continuous derivatives") {
    for_each_kernel([](const Kernel& kernel) {
        CAPTURE(name(kernel));
        const double step = 1e-5;
        for (double s = -3.97; s <= 4; s += 0.0937) {
            const double DW_found = (W(kernel, s + step) - W(kernel, s - step)) / (2 * step);
            const double D2W_found = (DW(kernel, s + step) - DW(kernel, s - step)) / (2 * step);
            CHECK(std::abs(DW(kernel, s) - DW_found) < 1e-8);
            CHECK(std::abs(D2W(kernel, s) - D2W_found) < 1e-4);
        }
        for (int knot = -3; knot <= 3; ++knot)
            for (const auto& f : {W, DW, D2W}) {
                CAPTURE(knot);
                CHECK(std::abs(f(kernel, knot + 1e-9) - f(kernel, knot - 1e-9)) < 1e-7);
            }
    });
}

TEST_CASE("kernels: condition (4), nothing beyond the support") {
    for_each_kernel([](const Kernel& kernel) {
        CAPTURE(name(kernel));
        const double edge = particles::support<double>(kernel);
        const double negligible =
            std::holds_alternative<Gaussian>(kernel) ? 1.01 * std::numeric_limits<double>::epsilon() : 0;
        for (const double s : {edge, 1.001 * edge, 2 * edge, 100.0}) {
            CHECK(W(kernel, s) <= negligible);
            CHECK(W(kernel, -s) <= negligible);
        }
        CHECK(W(kernel, 0.99 * edge) > 0);
    });
}

TEST_CASE("kernels: even, with odd first and even second derivative") {
    for_each_kernel([](const Kernel& kernel) {
        for (double s = 0; s < 4; s += 0.173) {
            CHECK(W(kernel, -s) == W(kernel, s));
            CHECK(DW(kernel, -s) == -DW(kernel, s));
            CHECK(D2W(kernel, -s) == D2W(kernel, s));
        }
    });
}

TEST_CASE("kernels: values known in closed form") {
    CHECK(Gaussian::W(0.0) == support::relative(0.5641895835477563, 1e-15));
    CHECK(Gaussian::W(1.0) == support::relative(0.5641895835477563 * std::exp(-1), 1e-15));
    CHECK(CubicSpline::W(0.0) == support::relative(2.0 / 3, 1e-15));
    CHECK(CubicSpline::W(1.0) == support::relative(1.0 / 6, 1e-15));
    CHECK(QuinticSpline::W(0.0) == support::relative(66.0 / 120, 1e-15));
    CHECK(QuinticSpline::W(1.0) == support::relative(26.0 / 120, 1e-15));
    CHECK(QuinticSpline::W(2.0) == support::relative(1.0 / 120, 1e-15));
    CHECK(WendlandC2::W(0.0) == 5.0 / 8);
    CHECK(WendlandC4::W(0.0) == 3.0 / 4);
}

TEST_CASE("kernels: the Gaussian's cut follows the scalar's precision") {
    CHECK(particles::support<double>(Gaussian{}) == support::relative(6.0037, 1e-4));
    CHECK(particles::support<long double>(Gaussian{}) > particles::support<double>(Gaussian{}));
    CHECK(static_cast<double>(Gaussian::W(1.0L)) == support::relative(Gaussian::W(1.0), 1e-15));
}

TEST_CASE("kernels: each has a name of its own and is found by it") {
    std::set<std::string> names;
    for_each_kernel([&](const Kernel& kernel) {
        names.insert(name(kernel));
        CHECK(kernel_named(name(kernel)).index() == kernel.index());
    });
    CHECK(names.size() == 5);
    CHECK_THROWS_WITH_AS(
        kernel_named("gauss"),
        "there is no kernel 'gauss'; choose one of gaussian, cubic_spline, quintic_spline, wendland_c2, wendland_c4",
        InvalidInput);
}
