#include "particles/neighbourhood.hpp"

#include <doctest/doctest.h>
#include "tests/relative.hpp"

using namespace particles;

namespace {

Line<double> uniform(Index N) {
    return line_at<double>(uniform_positions<double>(N), Volumes::equal);
}

}  // namespace

TEST_CASE("neighbourhood: the Gaussian with h = δ sees six particles on each side, and at an end on one") {
    const auto line = uniform(50);
    const Smoothing<double> smoothing(Gaussian{}, line.spacing());
    CHECK(within_reach(line, smoothing, 25).size() == 13);
    CHECK(within_reach(line, smoothing, 25).first == 19);
    CHECK(within_reach(line, smoothing, 0).size() == 7);
    CHECK(within_reach(line, smoothing, 49).size() == 7);
    CHECK(within_reach(line, smoothing, 2).size() == 9);
}

TEST_CASE("neighbourhood: a particle on the support's very edge is none, whatever round-off says") {
    for (const Index N : {10, 37, 100, 1000, 12345}) {
        const auto line = uniform(N);
        const Smoothing<double> smoothing(CubicSpline{}, line.spacing());
        for (Index i = 2; i < N - 2; ++i) REQUIRE(within_reach(line, smoothing, i).size() == 3);
        CHECK(within_reach(line, smoothing, 0).size() == 2);
    }
}

TEST_CASE("neighbourhood: entries are the offsets, kernel, its derivative and volumes in units of h") {
    const auto line = line_at<double>(perturbed_positions<double>(40, 0.3, 5), Volumes::partition);
    const double h = 1.7 * line.spacing();
    for_each_kernel([&](const Kernel<>& kernel) {
        const Smoothing<double> smoothing(kernel, h);
        for (const Index i : {0, 3, 20, 39}) {
            const Range range = within_reach(line, smoothing, i);
            const auto [r, W, DW, V] = neighbourhood(line, smoothing, i);
            REQUIRE(r.size() == range.size());
            for (Index k = 0; k < r.size(); ++k) {
                const Index j = range.first + k;
                const double s = (line.x()[j] - line.x()[i]) / h;
                CHECK(std::abs(s) < particles::support<double>(kernel));
                CHECK(std::abs(r[k] - s) < 1e-14);
                CHECK(W[k] == std::visit([at = r[k]](const auto& w) { return w.W(at); }, kernel));
                CHECK(DW[k] == std::visit([at = r[k]](const auto& w) { return w.DW(at); }, kernel));
                CHECK(V[k] == support::relative(line.V()[j] / h, 1e-15));
            }
        }
    });
}

TEST_CASE("neighbourhood: scaling the line changes nothing") {
    const Column<double> x = perturbed_positions<double>(30, 0.25, 2);
    const auto near =
        neighbourhood(line_at<double>(x, Volumes::equal), Smoothing<double>(Gaussian{}, 1.0 / 29), 10);
    const auto scaled = neighbourhood(line_at<double>(1024 * x, Volumes::equal),
                                      Smoothing<double>(Gaussian{}, 1024.0 / 29), 10);
    CHECK((near.r == scaled.r).all());
    CHECK((near.W == scaled.W).all());
    CHECK((near.DW == scaled.DW).all());
    CHECK((near.V == scaled.V).all());
}

TEST_CASE("neighbourhood: a smoothing length must be positive and finite") {
    for (const double h : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
        CHECK_THROWS_AS(Smoothing<double>(Gaussian{}, h), InvalidInput);
}
