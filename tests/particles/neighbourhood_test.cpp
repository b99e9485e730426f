#include "particles/neighbourhood.hpp"

#include <doctest/doctest.h>
#include <algorithm>

#include "particles/spacing.hpp"
#include "tests/support/clouds.hpp"
#include "tests/support/relative.hpp"

using namespace particles;

namespace {

Line<double> uniform(Index N) {
    return line_at<double>(uniform_positions<double>(N), Volumes::equal);
}

/// Calls `check` for one, two and three dimensions, as compile-time numbers.
template <class Check>
void in_every_dimension(const Check& check) {
    check(std::integral_constant<int, 1>{});
    check(std::integral_constant<int, 2>{});
    check(std::integral_constant<int, 3>{});
}

std::vector<int> numbers(Index N, int step = 1) {
    std::vector<int> all;
    for (int j = 0; j < N; j += step) all.push_back(j);
    return all;
}

}  // namespace

TEST_CASE(
    "neighbourhood: those of some particles, counted for a Pack at once, are those that each finds alone") {
    for (const Index N : {2, 9, 40, 333})
        for (const double perturbation : {0.0, 0.25, 0.45})
            for (const double ratio : {0.4, 1.0, 3.0, 30.0})
                for (const auto from : {Spacing::mean, Spacing::local}) {
                    const auto line =
                        line_at(perturbed_positions<double>(N, perturbation, 1), Volumes::equal);
                    const Smoothing<double> smoothing(Gaussian{}, spacing(line, from), ratio);
                    for (const Range some : {Range{0, N}, Range{N / 3, N}, Range{1, N - 1}}) {
                        const auto near = all_within_reach(line, smoothing, some);
                        REQUIRE(static_cast<Index>(near.size()) == some.size());
                        for (Index i = some.first; i < some.last; ++i) {
                            const Range alone = within_reach(line, smoothing, i);
                            const Range& counted = near[static_cast<std::size_t>(i - some.first)];
                            REQUIRE(counted.first == alone.first);
                            REQUIRE(counted.last == alone.last);
                        }
                    }
                }
}

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

TEST_CASE("neighbourhood: a place of a cloud sees offsets, kernel, gradient and volumes in units of h") {
    in_every_dimension([](auto dimension) {
        constexpr int dim = dimension;
        const Cloud<dim> cloud(support::random_points<dim>(300, 5), Column<double>::LinSpaced(300, 1, 2));
        support::Draws draw(1);
        const double h = dim == 1 ? 0.02 : dim == 2 ? 0.06 : 0.15;
        const auto check = [&](const Kernel<dim>& kernel) {
            const Point<dim> place = 0.6 * draw.point<dim>();
            const std::vector<int> particle = in_support(cloud, kernel, place, h);
            const auto [r, W, DW, V] = neighbourhood(cloud, kernel, place, h, particle);
            const double support = particles::support<double>(kernel);
            Index reached = 0;
            for (Index j = 0; j < cloud.size(); ++j)
                reached += (cloud.x().col(j) - place).norm() < support * h * (1 - 1e-7);
            REQUIRE(static_cast<Index>(particle.size()) == reached);
            REQUIRE(r.rows() == reached);
            REQUIRE(DW.rows() == reached);
            for (Index k = 0; k < reached; ++k) {
                const int j = particle[static_cast<std::size_t>(k)];
                const Point<dim> s = (cloud.x().col(j) - place) / h;
                const double value = std::visit([&](const auto& w) { return w.W(s.norm()); }, kernel);
                const double slope = std::visit([&](const auto& w) { return w.DW(s.norm()); }, kernel);
                CHECK((r.row(k).matrix().transpose() - s).norm() < 1e-13);
                CHECK(std::abs(W[k] - value) < 1e-13);
                CHECK((DW.row(k).matrix().transpose() - slope * s / s.norm()).norm() < 1e-12);
                CHECK(V[k] == support::relative(cloud.V()[j] / std::pow(h, dim), 1e-12));
            }
        };
        for_each_kernel<dim>(check);
        check(TruncatedGaussian<dim>(2.5));
    });
}

TEST_CASE("neighbourhood: a line is an ordered cloud") {
    const Column<double> x = perturbed_positions<double>(60, 0.3, 4);
    const auto line = line_at<double>(x, Volumes::partition);
    const Cloud<1> cloud(x.matrix().transpose(), line.V());
    for_each_kernel([&](const Kernel<>& kernel) {
        const double h = 1.4 * line.spacing();
        for (const Index i : {0, 7, 59}) {
            const Range range = within_reach(line, Smoothing<double>(kernel, h), i);
            const std::vector<int> near = within_reach(cloud, Smoothing<double>(kernel, h), i);
            REQUIRE(static_cast<Index>(near.size()) == range.size());
            CHECK(near.front() == range.first);
            const auto [r, W, DW, V] = neighbourhood(line, Smoothing<double>(kernel, h), i);
            const auto of_cloud = neighbourhood(cloud, Smoothing<double>(kernel, h), i);
            CHECK((r == of_cloud.r).all());
            CHECK((W == of_cloud.W).all());
            CHECK((DW == of_cloud.DW).all());
            CHECK((V == of_cloud.V).all());
        }
    });
}

TEST_CASE("neighbourhood: a particle of a grid on the support's very edge is none") {
    for (const Index n : {7, 10, 38, 101}) {
        const Cloud<2> cloud(support::grid_points<2>(n));
        const double h = cloud.apart()[0];
        const Point<2> place = cloud.x().col(3 * n + 3);
        CHECK(in_support<2>(cloud, TruncatedGaussian<2>(2), place, h).size() == 9);
        CHECK(in_support<2>(cloud, TruncatedGaussian<2>(3), place, h).size() == 25);
        CHECK(in_support<2>(cloud, TruncatedGaussian<2>(2.001), place, h).size() == 13);
        CHECK(in_support<2>(cloud, CubicSpline<2>{}, place, h).size() == 9);
    }
}

TEST_CASE("neighbourhood: of the particles that come into question only those in the support are taken") {
    const Cloud<2> cloud(support::random_points<2>(300, 5));
    const Kernel<2> kernel = TruncatedGaussian<2>(3);
    const Point<2> place(0.4, 0.7);
    const auto all = in_support(cloud, kernel, place, 0.05, cloud.within(place, 0.15));
    CHECK(in_support(cloud, kernel, place, 0.05, numbers(300)) == all);
    for (const int j : in_support(cloud, kernel, place, 0.05, numbers(300, 2))) {
        CHECK(j % 2 == 0);
        CHECK(std::count(all.begin(), all.end(), j) == 1);
    }
    CHECK(in_support(cloud, kernel, place, 0.05, {}).empty());
}

TEST_CASE("neighbourhood: scaling all lengths by a power of two changes nothing of what a place sees") {
    in_every_dimension([](auto dimension) {
        constexpr int dim = dimension;
        const Points<dim> x = support::random_points<dim>(300, 9);
        const Point<dim> place = Point<dim>::Constant(0.45);
        const Cloud<dim> cloud(x), scaled(1024 * x);
        for_each_kernel<dim>([&](const Kernel<dim>& kernel) {
            const std::vector<int> near = in_support(cloud, kernel, place, 0.1);
            const Point<dim> there = 1024 * place;
            CHECK(in_support(scaled, kernel, there, 102.4) == near);
            const auto one = neighbourhood(cloud, kernel, place, 0.1, near);
            const auto other = neighbourhood(scaled, kernel, there, 102.4, near);
            CHECK((one.r == other.r).all());
            CHECK((one.W == other.W).all());
            CHECK((one.DW == other.DW).all());
            CHECK((one.V / other.V - 1).abs().maxCoeff() < 1e-14);
        });
    });
}
