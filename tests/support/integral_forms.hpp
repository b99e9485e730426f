#pragma once

#include "particles/centred_kernel.hpp"
#include "tests/support/lines.hpp"

/// What the tests of integral forms share.
namespace support {

/// Compares a discrete form with its integral form: with h fixed and δ halved repeatedly, the sum over the
/// particles must tend to the integral, at the ends and inside, for every kernel and for both conventions of
/// the volumes. The sum is a trapezoidal rule where the end particles carry half a spacing (order 2), and a
/// rectangle rule where they do not (order 1).
/// \param discrete (line, near, neighbourhood, i) -> value, in units of h
/// \param integral (CentredKernel) -> value
/// \param power the power of h by which the discrete value must be divided
template <class Discrete, class Integral>
void check_tends_to_integral(const Discrete& discrete, const Integral& integral, int power) {
    const double h = 0.08;
    particles::for_each_kernel([&](const particles::Kernel<>& kernel) {
        for (const auto volumes : {particles::Volumes::equal, particles::Volumes::partition})
            for (const double place : {0.0, 0.5, 1.0}) {
                CAPTURE(particles::name(kernel));
                CAPTURE(particles::name(volumes));
                CAPTURE(place);
                const double exact = integral(particles::centred(kernel, place, h, {0, 1}));
                std::vector<double> spacing, error;
                for (const Index N : {201, 401, 801, 1601}) {
                    const auto line =
                        particles::line_at<double>(particles::uniform_positions<double>(N), volumes);
                    const particles::Smoothing<double> smoothing(kernel, h);
                    const auto i = static_cast<Index>(std::lround(place * static_cast<double>(N - 1)));
                    const auto near = particles::within_reach(line, smoothing, i);
                    const double sum =
                        discrete(line, near, particles::neighbourhood(line, smoothing, i, near), i) /
                        std::pow(h, power);
                    spacing.push_back(line.spacing());
                    error.push_back(std::abs(sum - exact));
                }
                const double size = std::abs(exact) + 1;
                const bool inside = place == 0.5;
                const double least = inside || volumes == particles::Volumes::partition ? 1.8 : 0.9;
                CHECK(error.back() < (least > 1 ? 2e-3 : 0.2) * size);
                if (error.back() > 1e-9 * size) CHECK(report::observed_order(spacing, error) > least);
            }
    });
}

/// Observed order of an error in h at a place of [0, 1], from three halvings of the smoothing length.
/// \param error (CentredKernel) -> error
template <class Error>
double order_in_h(double place, const Error& error,
                  const particles::Kernel<>& kernel = particles::Gaussian{}) {
    std::vector<double> h, size;
    for (const double length : {0.02, 0.01, 0.005, 0.0025}) {
        h.push_back(length);
        size.push_back(std::abs(error(particles::centred(kernel, place, length, {0, 1}))));
    }
    return report::observed_order(h, size);
}

}  // namespace support
