#include "particles/centred_kernel.hpp"

#include <doctest/doctest.h>

#include <numbers>
#include "tests/support/relative.hpp"

using namespace particles;

TEST_CASE("centred kernel: moments of the Gaussian on a half line and inside, in closed form") {
    const double h = 0.05;
    const auto inside = centred(Gaussian{}, 0.5, h, {0, 1});
    CHECK(inside.moment(0, inside.W) == support::relative(1, 1e-14));
    CHECK(std::abs(inside.moment(1, inside.W)) < 1e-17);
    CHECK(inside.moment(2, inside.W) == support::relative(h * h / 2, 1e-13));
    CHECK(inside.moment(1, inside.DW) == support::relative(-1, 1e-13));

    const auto end = centred(Gaussian{}, 0, h, {0, 1});
    CHECK(end.moment(0, end.W) == support::relative(0.5, 1e-14));
    CHECK(end.moment(1, end.W) == support::relative(h / (2 * std::sqrt(std::numbers::pi)), 1e-14));
    CHECK(end.moment(2, end.W) == support::relative(h * h / 4, 1e-13));
    CHECK(end.moment(0, end.DW) == support::relative(-1 / (h * std::sqrt(std::numbers::pi)), 1e-14));
    CHECK(end.moment(1, end.DW) == support::relative(-0.5, 1e-14));

    const double x = 0.03;
    const auto near_end = centred(Gaussian{}, x, h, {0, 1});
    CHECK(near_end.moment(0, near_end.W) == support::relative((1 + std::erf(x / h)) / 2, 1e-14));
}

TEST_CASE("centred kernel: moments of the Gaussian between both ends are error functions and exponentials") {
    for (const double h : {0.02, 0.1, 0.4})
        for (const double x : {0.0, 0.013, 0.2, 0.5, 0.97}) {
            CAPTURE(h);
            CAPTURE(x);
            const auto W_i = centred(Gaussian{}, x, h, {0, 1});
            const double a = -x / h, b = (1 - x) / h;  // the ends, in units of h
            const auto W = [](double s) { return std::exp(-s * s) / std::sqrt(std::numbers::pi); };
            // By parts: the moment of order k from that of order k − 2.
            const double W_0 = (std::erf(b) - std::erf(a)) / 2, W_1 = (W(a) - W(b)) / 2,
                         W_2 = (W_0 + a * W(a) - b * W(b)) / 2, W_3 = W_1 + (a * a * W(a) - b * b * W(b)) / 2;
            const double exact[] = {W_0, W_1, W_2, W_3};
            const double of_DW[] = {W(b) - W(a), b * W(b) - a * W(a) - W_0,
                                    b * b * W(b) - a * a * W(a) - 2 * W_1};
            // Some 400 terms that sum to at most 1 in units of h.
            for (int k = 0; k < 4; ++k)
                CHECK(std::abs(W_i.moment(k, W_i.W) / std::pow(h, k) - exact[k]) < 1e-14);
            for (int k = 0; k < 3; ++k)
                CHECK(std::abs(W_i.moment(k, W_i.DW) / std::pow(h, k - 1) - of_DW[k]) < 1e-14);
        }
}

TEST_CASE("centred kernel: the integral of the derivative is the difference of the ends, for every kernel") {
    for_each_kernel([](const Kernel<>& kernel) {
        CAPTURE(name(kernel));
        for (const double x : {0.0, 0.013, 0.07, 0.5, 1.0}) {
            const auto W_i = centred(kernel, x, 0.05, {0, 1});
            CHECK(std::abs(W_i.integral(W_i.DW) - (W_i.W(1) - W_i.W(0))) < 1e-12);
        }
    });
    const auto lowered = centred(TruncatedGaussian<1>(2.3), 0.013, 0.05, {0, 1});
    CHECK(std::abs(lowered.integral(lowered.DW) + lowered.W(0)) < 1e-12);
}

TEST_CASE("centred kernel: norms") {
    const auto W_i = centred(Gaussian{}, 0.5, 0.05, {0, 1});
    CHECK(W_i.norm(W_i.W) == support::relative(1, 1e-14));
    CHECK(W_i.norm(W_i.DW) == support::relative(2 * W_i.W(0.5), 1e-13));
}

TEST_CASE("centred kernel: an integral that is not finite is an error with the place") {
    const auto W_i = centred(Gaussian{}, 0.5, 0.05, {0, 1});
    CHECK_THROWS_WITH_AS(static_cast<void>(W_i.integral([](double) { return std::nan(""); })),
                         "the integral around x = 0.5 is not finite", InvalidInput);
}
