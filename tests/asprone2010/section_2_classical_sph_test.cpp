#include "asprone2010/section_2_classical_sph.hpp"

#include "tests/support/integral_forms.hpp"

using namespace asprone2010;
using namespace asprone2010::classical_sph;
using support::Wave;

TEST_CASE("(1) is the limit of (2) as h → 0, inside the domain") {
    particles::for_each_kernel([](const particles::Kernel<>& kernel) {
        CAPTURE(particles::name(kernel));
        const auto error = [](const CentredKernel& W_i) {
            return value(Wave::B, W_i) - picked_value(Wave::B, W_i.x);
        };
        CHECK(std::abs(error(particles::centred(kernel, 0.5, 1e-4, {0, 1}))) < 1e-7);
        CHECK(support::order_in_h(0.5, error, kernel) == support::relative(2, 0.01));
    });
}

TEST_CASE("(2) reproduces constants inside and half of them at an end") {
    const auto one = [](double) { return 1.0; };
    CHECK(value(one, particles::centred(particles::Gaussian{}, 0.5, 0.05, {0, 1})) ==
          support::relative(1, 1e-14));
    CHECK(value(one, particles::centred(particles::Gaussian{}, 0, 0.05, {0, 1})) ==
          support::relative(0.5, 1e-14));
}

TEST_CASE("(3) the subdomains tile Ω, and each holds its particle") {
    const auto line = particles::line_at<double>(particles::perturbed_positions<double>(40, 0.4, 3),
                                                 particles::Volumes::partition);
    const Column<double> bounds = subdomain_bounds(line);
    REQUIRE(bounds.size() == 41);
    CHECK(bounds[0] == 0);
    CHECK(bounds[40] == 1);
    for (Index j = 0; j < 40; ++j) {
        CHECK(bounds[j] <= line.x()[j]);
        CHECK(line.x()[j] <= bounds[j + 1]);
        CHECK(line.V()[j] == bounds[j + 1] - bounds[j]);
    }
}

TEST_CASE("(4) tends to (2) as δ/h → 0") {
    support::check_tends_to_integral(
        [](const auto& line, const auto& near, const auto& neighbourhood, Index) {
            return support::sum_of_values(value(neighbourhood), line, near, Wave::B);
        },
        [](const CentredKernel& W_i) { return value(Wave::B, W_i); }, 0);
}

TEST_CASE(
    "claim A-2-integral: on the uniform lattice with h = δ the Gaussian's discrete integral is 1.0001, not 1") {
    const auto [line, smoothing] = support::particles_of(100);
    const double sum = value(particles::neighbourhood(line, smoothing, 50)).sum();
    CHECK(sum == support::relative(1 + 2 * std::exp(-std::pow(std::acos(-1.0), 2)), 1e-9));
}
