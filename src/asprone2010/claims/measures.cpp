#include "asprone2010/claims/measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "asprone2010/section_5_1_derivative_test.hpp"
#include "report/statistics.hpp"

namespace asprone2010::claims {

using numerical_tests::discretise;
using particles::Gaussian;

Computation readings(const std::function<std::vector<Measurement>(Volumes)>& measurements) {
    return [measurements](const report::Statement&, std::size_t convention) {
        return measurements(std::array{Volumes::equal, Volumes::partition}.at(convention));
    };
}

Computation measured(const std::function<double(Volumes)>& number) {
    return readings([number](Volumes volumes) { return std::vector<Measurement>{{"", number(volumes)}}; });
}

Computation measured(const std::function<double()>& number) {
    return measured([number](Volumes) { return number(); });
}

double B(double x) {
    return std::exp(x) + std::cos(2 * x);
}
double DB(double x) {
    return std::exp(x) - 2 * std::sin(2 * x);
}
double D2B(double x) {
    return std::exp(x) - 4 * std::cos(2 * x);
}

CentredKernel kernel_at(double x) {
    return particles::centred(Gaussian{}, x, 0.05, {0, 1});
}

double largest(const std::vector<double>& places, const std::function<double(double)>& value) {
    double most = 0;
    for (const double x : places) most = std::max(most, std::abs(value(x)));
    return most;
}

double order_in_h(double place, const std::function<double(const CentredKernel&)>& error) {
    const std::vector<double> h{0.01, 0.005, 0.0025};
    std::vector<double> size;
    size.reserve(h.size());
    for (const double length : h)
        size.push_back(std::abs(error(particles::centred(Gaussian{}, place, length, {0, 1}))));
    return report::observed_order(h, size);
}

Computation order_at_ends(const IntegralError& error) {
    return measured([error] { return std::min(order_in_h(0, error), order_in_h(1, error)); });
}

Computation order_far_inside(const IntegralError& error) {
    return measured([error] { return order_in_h(0.5, error); });
}

Computation order_everywhere(const IntegralError& error) {
    return measured([error] {
        return std::min({order_in_h(0, error), order_in_h(0.5, error), order_in_h(1, error)});
    });
}

double order(const std::vector<Index>& numbers, const std::function<double(Index)>& error) {
    std::vector<double> spacing, size;
    for (const Index N : numbers) {
        spacing.push_back(1 / static_cast<double>(N - 1));
        size.push_back(std::abs(error(N)));
    }
    return report::observed_order(spacing, size);
}

double over_particles(Volumes volumes, Where where,
                      const std::function<double(const Neighbourhood<double>&)>& value, double perturbation,
                      unsigned long seed) {
    const auto [line, smoothing] = discretise<double>({volumes, Gaussian{}, 1, perturbation}, 100, seed);
    const Index margin = where == Where::interior ? 13 : 0;
    double most = 0;
    for (Index i = margin; i < 100 - margin; ++i)
        most = std::max(most, std::abs(value(particles::neighbourhood(line, smoothing, i))));
    return most;
}

LastNeighbourhood last_neighbourhood(Index N, Volumes volumes) {
    const auto [line, smoothing] = discretise<double>({volumes}, N, 1);
    const auto range = particles::within_reach(line, smoothing, N - 1);
    return {particles::neighbourhood(line, smoothing, N - 1, range),
            line.x().segment(range.first, N - range.first), smoothing.h()};
}

double error_at_end(Index N, Volumes volumes, const Rule& rule, double exact(double), int power) {
    const auto [near, x, h] = last_neighbourhood(N, volumes);
    const Column<double> weights = rule(near);
    double sum = 0;
    for (Index k = 0; k < weights.size(); ++k) sum += weights[k] * (B(x[k]) - B(1));
    return sum / std::pow(h, power) - exact(1);
}

Computation order_at_end(const Rule& rule, double exact(double), int power) {
    return measured([=](Volumes volumes) {
        return order(usual, [&](Index N) { return error_at_end(N, volumes, rule, exact, power); });
    });
}

namespace {

derivative_test::Errors<double> errors(std::string_view formulation, Index N,
                                       const numerical_tests::Discretisation& how) {
    return derivative_test::errors(formulation_named<double>(formulation), discretise<double>(how, N, 1),
                                   derivative_test::exponential<double>());
}

}  // namespace

Computation order_of_largest_error(std::string_view formulation, Derivative which) {
    return measured([=](Volumes volumes) {
        return order(usual, [&](Index N) {
            const auto error = errors(formulation, N, {volumes});
            return which == Derivative::first ? error.first : error.second;
        });
    });
}

double order_inside(std::string_view formulation, Derivative which, Volumes volumes, double perturbation,
                    double smoothing) {
    return order(usual, [&](Index N) {
        const auto error = errors(formulation, N, {volumes, Gaussian{}, smoothing, perturbation});
        return (which == Derivative::first ? error.first_interior : error.second_interior).value();
    });
}

Computation order_inside(std::string_view formulation, Derivative which) {
    return measured([=](Volumes volumes) { return order_inside(formulation, which, volumes); });
}

Computation order_of_median(const std::function<double(Index, Volumes, unsigned long)>& error) {
    return measured([error](Volumes volumes) {
        return order({40, 80, 160, 320, 640}, [&](Index N) {
            std::vector<double> sample(51);
            base::for_each_index(51, [&](Index k) {
                sample[static_cast<std::size_t>(k)] = error(N, volumes, static_cast<unsigned long>(k) + 1);
            });
            return report::quartiles(sample).median;
        });
    });
}

}  // namespace asprone2010::claims
