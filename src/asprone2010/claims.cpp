#include "asprone2010/claims.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "asprone2010/section_5_1_derivative_test.hpp"
#include "asprone2010/section_5_2_static_test.hpp"
#include "asprone2010/section_5_3_vibration_test.hpp"
#include "report/statistics.hpp"

namespace asprone2010::claims {

namespace {

using numerical_tests::Discretisation;
using numerical_tests::discretise;
using particles::Gaussian;
using particles::Volumes;
using report::Measurement;

/// What a claim's quantity measures under a convention of the volumes.
using Measure = std::function<std::vector<Measurement>(Volumes)>;

using Numbers = std::vector<Index>;
const Numbers fine{320, 640, 1280};
const Numbers few{20, 40, 80, 160};
const Numbers many{10240, 20480, 40960};

/// A function without symmetries, with its derivatives, for what the print says of any B.
double B(double x) {
    return std::exp(x) + std::cos(2 * x);
}
double DB(double x) {
    return std::exp(x) - 2 * std::sin(2 * x);
}
double D2B(double x) {
    return std::exp(x) - 4 * std::cos(2 * x);
}

std::vector<Measurement> stated(double value) {
    return {{"", value}};
}

/// The same under both conventions: the claim is about integrals or about the continuous problem.
template <class Compute>
Measure either(const Compute& compute) {
    return [compute](Volumes) { return stated(compute()); };
}

// Orders

template <class Error>
double order(const Numbers& numbers, const Error& error) {
    std::vector<double> spacing, size;
    for (const Index N : numbers) {
        spacing.push_back(1 / static_cast<double>(N - 1));
        size.push_back(std::abs(error(N)));
    }
    return report::observed_order(spacing, size);
}

/// Order in h of an error of the integral forms, at a place of [0, 1].
template <class Error>
double order_in_h(double place, const Error& error) {
    std::vector<double> h, size;
    for (const double length : {0.01, 0.005, 0.0025}) {
        h.push_back(length);
        size.push_back(std::abs(error(particles::centred(Gaussian{}, place, length, {0, 1}))));
    }
    return report::observed_order(h, size);
}

/// The worse of both ends: the smaller order.
template <class Error>
double order_at_ends(const Error& error) {
    return std::min(order_in_h(0, error), order_in_h(1, error));
}

// Sections 2 to 4 at one particle

CentredKernel kernel_at(double x) {
    return particles::centred(Gaussian{}, x, 0.05, {0, 1});
}

double largest(const std::vector<double>& places, const std::function<double(double)>& size) {
    double most = 0;
    for (const double x : places) most = std::max(most, std::abs(size(x)));
    return most;
}
const std::vector<double> everywhere{0, 0.013, 0.06, 0.5, 0.94, 1};
const std::vector<double> inside{0.4, 0.5, 0.6};

/// Largest size of something over the neighbourhoods of a uniform line with h = δ; interior only, or all.
template <class Size>
double over_particles(Volumes volumes, bool interior, const Size& size, double perturbation = 0) {
    const auto [line, smoothing] = discretise<double>({volumes, Gaussian{}, 1, perturbation}, 100, 1);
    double most = 0;
    for (Index i = interior ? 13 : 0; i < (interior ? 87 : 100); ++i)
        most = std::max<double>(most, std::abs(size(particles::neighbourhood(line, smoothing, i))));
    return most;
}

/// Error of weights on differences at one particle of N, the last or the middle one. \param power of 1/h the weights carry
template <class Weights>
double error_at(Index N, bool at_end, const Discretisation& how, const Weights& weights, double exact(double),
                int power) {
    const auto [line, smoothing] = discretise<double>(how, N, 1);
    const Index i = at_end ? N - 1 : N / 2;
    const auto near = particles::within_reach(line, smoothing, i);
    const Column<double> w = weights(particles::neighbourhood(line, smoothing, i, near));
    double sum = 0;
    for (Index k = 0; k < w.size(); ++k) sum += w[k] * (B(line.x()[near.first + k]) - B(line.x()[i]));
    return sum / std::pow(smoothing.h(), power) - exact(line.x()[i]);
}

template <class Weights>
Measure order_at(bool at_end, const Weights& weights, double exact(double), int power,
                 double perturbation = 0) {
    return [=](Volumes volumes) {
        return stated(order(fine, [&](Index N) {
            return error_at(N, at_end, {volumes, Gaussian{}, 1, perturbation}, weights, exact, power);
        }));
    };
}

/// Smallest or largest reciprocal condition of the matrix of (42) for a polynomial with these exponents.
double reciprocal_condition(const Neighbourhood<double>& near, const std::array<int, 3>& exponents) {
    Eigen::Matrix3d M;
    Index row = 0;
    for (const int moment : {0, 1, 3}) {
        for (std::size_t k = 0; k < 3; ++k)
            M(row, static_cast<Index>(k)) = (near.r.pow(moment + exponents[k]) * near.W * near.V).sum();
        ++row;
    }
    const auto values = M.jacobiSvd().singularValues();
    return values[2] / values[0];
}

// Section 5

derivative_test::Errors<double> derivative_errors(std::string_view name, Index N, const Discretisation& how,
                                                  unsigned long seed = 1) {
    return derivative_test::errors(formulation_named<double>(name), discretise<double>(how, N, seed),
                                   derivative_test::exponential<double>());
}

double static_error(std::string_view name, Index N, const Discretisation& how, unsigned long seed = 1) {
    return static_test::error(formulation_named<double>(name), discretise<double>(how, N, seed),
                              static_test::exponential_load());
}

Measure derivative_order(std::string_view name, double derivative_test::Errors<double>::*which =
                                                    &derivative_test::Errors<double>::second) {
    return [=](Volumes volumes) {
        return stated(order(fine, [&](Index N) { return derivative_errors(name, N, {volumes}).*which; }));
    };
}

Measure interior_order(std::string_view name, std::optional<double> derivative_test::Errors<double>::*which,
                       double perturbation = 0) {
    return [=](Volumes volumes) {
        return stated(order(fine, [&](Index N) {
            return (derivative_errors(name, N, {volumes, Gaussian{}, 1, perturbation}).*which).value();
        }));
    };
}

Measure static_order(std::string_view name, const Numbers& numbers) {
    return [=](Volumes volumes) {
        return stated(order(numbers, [&](Index N) { return static_error(name, N, {volumes}); }));
    };
}

/// Order of the median over 51 seeds of perturbed lines.
template <class Error>
Measure median_order(const Error& error) {
    return [error](Volumes volumes) {
        return stated(order({40, 80, 160, 320, 640}, [&](Index N) {
            std::vector<double> sample(51);
            base::for_each_index(51, [&](Index seed) {
                sample[static_cast<std::size_t>(seed)] = error(
                    N, Discretisation{volumes, Gaussian{}, 1, 0.25}, static_cast<unsigned long>(seed) + 1);
            });
            return report::quartiles(sample).median;
        }));
    };
}

/// Distance of the worst particle from the nearer end, in spacings, for 640 particles.
double place_of_largest_error(std::string_view name, Volumes volumes) {
    const auto [line, smoothing] = discretise<double>({volumes}, 640, 1);
    const Column<double> f = line.x().exp();
    Index worst = 0;
    (particles::apply(formulation_named<double>(name).operators(line, smoothing).D2, f) - f)
        .abs()
        .maxCoeff(&worst);
    return static_cast<double>(std::min(worst, 639 - worst));
}

std::vector<double> ratios(std::string_view name, Volumes volumes) {
    std::vector<double> ratio;
    for (const auto& omega :
         vibration_test::frequencies(formulation_named<double>(name), discretise<double>({volumes}, 100, 1)))
        ratio.push_back(omega.real() / vibration_test::exact_frequency(static_cast<Index>(ratio.size()) + 1));
    return ratio;
}

std::vector<double> finite_element_ratios() {
    std::vector<double> ratio;
    for (const auto& omega : vibration_test::finite_element_frequencies(discretise<double>({}, 100, 1).line,
                                                                        vibration_test::Mass::lumped))
        ratio.push_back(omega.real() / vibration_test::exact_frequency(static_cast<Index>(ratio.size()) + 1));
    return ratio;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
    double most = 0;
    for (std::size_t k = 0; k < a.size(); ++k) most = std::max(most, std::abs(a[k] - b[k]));
    return most;
}

Measure ratio_of_mode(std::string_view name, std::size_t n) {
    return [=](Volumes volumes) { return stated(ratios(name, volumes)[n - 1]); };
}

Measure mean_of_five_lowest(std::string_view name) {
    return [=](Volumes volumes) {
        const auto ratio = ratios(name, volumes);
        return stated(std::accumulate(ratio.begin(), ratio.begin() + 5, 0.0) / 5);
    };
}

std::map<std::string, Measure> all() {
    using Errors = derivative_test::Errors<double>;
    const auto first_of = [](const auto& derivatives) {
        return [=](const Neighbourhood<double>& near) { return derivatives(near).first; };
    };
    const auto second_of = [](const auto& derivatives) {
        return [=](const Neighbourhood<double>& near) { return derivatives(near).second; };
    };
    const auto chen_beraun_first = [](const Neighbourhood<double>& near) {
        return chen_beraun::first_derivative(near);
    };
    const auto chen_beraun_both = [](const Neighbourhood<double>& near) {
        return chen_beraun::derivatives(near);
    };
    const auto modified_both = [](const Neighbourhood<double>& near) {
        return modified_fpm::derivatives(near);
    };
    const auto second_order_both = [](const Neighbourhood<double>& near) {
        return second_order_fpm::derivatives(near);
    };
    const auto fpm_first = [](const Neighbourhood<double>& near) { return fpm::first_derivative(near); };
    const auto smooth = Gaussian{};

    std::map<std::string, Measure> of;

    of["A01a"] = either([=] {
        double least = 1;
        for (double s = -20; s <= 20; s += 0.01) least = std::min(least, smooth.W(s));
        return least;
    });
    of["A01b"] = either([] { return kernel_at(0.5).moment(0, kernel_at(0.5).W); });
    of["A01c"] = either([=] { return smooth.W(20.0); });
    of["A01d"] = either([] {
        return order_in_h(0.5,
                          [](const CentredKernel& W_i) { return classical_sph::value(B, W_i) - B(W_i.x); });
    });

    of["A02a"] = either([] {
        return largest(inside, [](double x) {
            return original::first_derivative(B, kernel_at(x)) -
                   original::interior_derivative(B, kernel_at(x));
        });
    });
    of["A02b"] = either([] {
        return largest(everywhere, [](double x) {
            return original::first_derivative([](double) { return 1.0; }, kernel_at(x));
        });
    });
    of["A02c"] = either([] {
        return largest(everywhere, [](double x) {
            return original::derivative_by_parts(B, kernel_at(x)) -
                   original::smoothed_derivative(DB, kernel_at(x));
        });
    });
    of["A02d"] = either([] {
        return largest(inside, [](double x) {
            return original::interior_derivative([](double) { return 1.0; }, kernel_at(x));
        });
    });
    of["A02e"] = either([] {
        return std::min(std::abs(original::total_derivative(kernel_at(0))),
                        std::abs(original::total_derivative(kernel_at(1))));
    });

    const auto original_first = [](const Neighbourhood<double>& near) {
        return original::first_derivative(near);
    };
    of["A03a"] = order_at(true, original_first, DB, 1);
    of["A03b"] = [=](Volumes volumes) {
        const auto [line, smoothing] = discretise<double>({volumes}, 640, 1);
        const auto near = particles::within_reach(line, smoothing, 639);
        const Column<double> w =
            original::interior_derivative(particles::neighbourhood(line, smoothing, 639, near));
        double sum = 0;
        for (Index k = 0; k < w.size(); ++k) sum += w[k] * B(line.x()[near.first + k]);
        const double without = sum / smoothing.h() - DB(1);
        return stated(std::abs(error_at(640, true, {volumes}, original_first, DB, 1) / without));
    };

    of["A04a"] = order_at(true, chen_beraun_first, DB, 1);
    of["A04b"] = interior_order("chen_beraun", &Errors::first_interior);
    of["A04c"] = [=](Volumes volumes) {
        const auto measured = [&](double a) {
            return interior_order("chen_beraun", &Errors::first_interior, a)(volumes).front().value;
        };
        return std::vector<Measurement>{{"", measured(0.25)}, {"particles are uniform", measured(0)}};
    };
    of["A05"] = [=](Volumes volumes) {
        const auto measured = [&](double smoothing) {
            return order(fine, [&](Index N) {
                return derivative_errors("original", N, {volumes, Gaussian{}, smoothing})
                    .first_interior.value();
            });
        };
        return std::vector<Measurement>{{"", measured(1)}, {"h/δ is larger than 1 (here 2)", measured(2)}};
    };
    of["A06a"] = [=](Volumes volumes) {
        const auto own = [&](Index N) {
            return error_at(N, true, {volumes}, second_of(chen_beraun_both), D2B, 2);
        };
        const auto exact = [&](Index N) {
            const auto [line, smoothing] = discretise<double>({volumes}, N, 1);
            const auto [r, W, DW, V] = particles::neighbourhood(line, smoothing, N - 1);
            const double without = error_at(
                N, true, {volumes},
                [](const Neighbourhood<double>& near) {
                    return chen_beraun::second_derivative(near, Column<double>(0 * near.r));
                },
                D2B, 2);
            return without - DB(1) / smoothing.h() * (r * W * V).sum() / ((r * r * W * V).sum() / 2);
        };
        return std::vector<Measurement>{{"", order(fine, own)}, {"DB is exact", order(fine, exact)}};
    };
    of["A06b"] = interior_order("chen_beraun", &Errors::second_interior);

    const auto moments = [](auto corrected, int count) {
        return [=](Volumes volumes) {
            return stated(over_particles(volumes, false, [&](const Neighbourhood<double>& near) {
                const auto K = corrected(near);
                double most = std::abs((K.W * K.V).sum() - 1);
                for (int k = 1; k <= count; ++k)
                    most = std::max(most, std::abs((K.r.pow(k) * K.W * K.V).sum()));
                return most;
            }));
        };
    };
    of["A07a"] = moments([](const Neighbourhood<double>& near) { return rkpm::corrected<0, 1>(near); }, 1);
    of["A07b"] = moments([](const Neighbourhood<double>& near) { return rkpm::corrected<0, 1, 2>(near); }, 2);
    of["A07c"] = either([] {
        return order_at_ends(
            [](const CentredKernel& W_i) { return rkpm::value(B, rkpm::corrected<0, 1>(W_i)) - B(W_i.x); });
    });
    of["A07d"] = either([] {
        return order_at_ends([](const CentredKernel& W_i) {
            return rkpm::value(B, rkpm::corrected<0, 1, 2>(W_i)) - B(W_i.x);
        });
    });
    of["A08a"] = derivative_order("rkpm_first_order", &Errors::first);
    of["A08b"] = derivative_order("rkpm_second_order", &Errors::first);

    of["A09a"] = either([] {
        return order_at_ends([](const CentredKernel& W_i) { return fpm::error(B, DB(W_i.x), W_i)[0]; });
    });
    of["A09b"] = order_at(true, fpm_first, DB, 1);
    of["A09c"] = interior_order("fpm", &Errors::first_interior);
    of["A09d"] = derivative_order("fpm");
    of["A09e"] = either([] {
        return largest(inside, [](double x) {
            const auto A = fpm::matrix(kernel_at(x));
            return std::max(std::abs(A(0, 1)) / 0.05, std::abs(A(1, 0)) * 0.05);
        });
    });

    of["A10a"] = order_at(true, first_of(modified_both), DB, 1);
    of["A10b"] = order_at(true, second_of(modified_both), D2B, 2);
    of["A10c"] = interior_order("modified_fpm", &Errors::first_interior);
    of["A10d"] = interior_order("modified_fpm", &Errors::second_interior);

    of["A11a"] = [](Volumes volumes) {
        return stated(1 / over_particles(volumes, false, [](const Neighbourhood<double>& near) {
                          return 1 / reciprocal_condition(near, {3, 1, 0});
                      }));
    };
    of["A11b"] = [](Volumes volumes) {
        return stated(over_particles(volumes, true, [](const Neighbourhood<double>& near) {
            return reciprocal_condition(near, {2, 1, 0});
        }));
    };
    of["A12"] = [](Volumes volumes) {
        const auto difference = [&](bool scaled) {
            return over_particles(volumes, true, [&](const Neighbourhood<double>& near) {
                const double factor = scaled ? (near.W * near.V).sum() : 1;
                return (second_order_fpm::corrected(near).W - near.W / factor).abs().maxCoeff();
            });
        };
        return std::vector<Measurement>{{"", difference(false)},
                                        {"W is divided by its discrete integral, 1.0001", difference(true)}};
    };
    of["A13"] = [](Volumes volumes) {
        return stated(over_particles(
            volumes, false,
            [](const Neighbourhood<double>& near) {
                return modified_fpm::matrix(second_order_fpm::corrected(near))(0, 0);
            },
            0.25));
    };
    of["A14a"] = derivative_order("second_order_fpm", &Errors::first);
    of["A14b"] = derivative_order("second_order_fpm");
    of["A14c"] = order_at(true, second_of(second_order_both), D2B, 2);

    of["A15a"] = derivative_order("original");
    of["A15b"] = derivative_order("rkpm_first_order");
    of["A15c"] = derivative_order("rkpm_second_order");
    of["A15d"] = derivative_order("chen_beraun");
    of["A15e"] = derivative_order("modified_fpm");
    of["A15f"] = derivative_order("second_order_fpm");
    of["A15g"] = [](Volumes volumes) {
        double farthest = 0;
        for (const auto& formulation : formulations<double>())
            farthest = std::max(farthest, place_of_largest_error(formulation.name, volumes));
        return std::vector<Measurement>{
            {"", farthest}, {"the particle next to an end counts as boundary", std::max(0.0, farthest - 1)}};
    };
    of["A16"] = median_order([](Index N, const Discretisation& how, unsigned long seed) {
        return derivative_errors("second_order_fpm", N, how, seed).second;
    });

    of["A17a"] = static_order("second_order_fpm", fine);
    of["A17b"] = static_order("modified_fpm", fine);
    of["A17c"] = static_order("chen_beraun", fine);
    of["A17d"] = static_order("original", many);
    of["A17e"] = static_order("rkpm_first_order", many);
    of["A17f"] = static_order("rkpm_second_order", many);
    of["A18a"] = static_order("original", few);
    of["A18b"] = static_order("rkpm_first_order", few);
    of["A19"] = [](Volumes volumes) {
        return stated(static_error("modified_fpm", 640, {volumes}) /
                      static_error("second_order_fpm", 640, {volumes}));
    };
    of["A20"] = median_order([](Index N, const Discretisation& how, unsigned long seed) {
        return static_error("second_order_fpm", N, how, seed);
    });

    of["A21"] = either([] {
        double most = 0;
        for (Index n = 1; n <= 98; ++n)
            most = std::max(most, std::abs(vibration_test::mode(vibration_test::exact_frequency(n), 1)));
        return most;
    });
    of["A22a"] = mean_of_five_lowest("original");
    of["A22b"] = mean_of_five_lowest("rkpm_first_order");
    of["A22c"] = mean_of_five_lowest("rkpm_second_order");
    for (const auto& [id, name] :
         {std::pair{"A22d", "original"}, {"A22e", "rkpm_first_order"}, {"A22f", "rkpm_second_order"}})
        of[id] = [name = std::string(name)](Volumes volumes) {
            const auto ratio = ratios(name, volumes);
            return stated(ratio[9] / ratio[0]);
        };
    of["A23"] = [](Volumes volumes) {
        return stated(largest_difference(ratios("original", volumes), ratios("rkpm_first_order", volumes)));
    };
    of["A24a"] = [](Volumes volumes) {
        const auto modified = ratios("modified_fpm", volumes);
        return stated(std::max(largest_difference(ratios("chen_beraun", volumes), modified),
                               largest_difference(ratios("second_order_fpm", volumes), modified)));
    };
    of["A24b"] = ratio_of_mode("second_order_fpm", 10);
    of["A24c"] = [](Volumes volumes) {
        const auto ratio = ratios("second_order_fpm", volumes), reference = finite_element_ratios();
        double most = 0;
        for (std::size_t k = 0; k < ratio.size(); ++k)
            most = std::max(most, std::abs(ratio[k] - reference[k]) / reference[k]);
        return stated(most);
    };

    of["A25"] = either([] {
        const auto W_i = kernel_at(0.5);
        return W_i.moment(1, W_i.DW) / (W_i.norm(W_i.DW) * W_i.h);
    });
    of["A26a"] = either([] {
        return largest(everywhere, [](double x) {
            const auto W_i = kernel_at(x);
            return chen_beraun::first_derivative(B, W_i) +
                   chen_beraun::first_remainder(B, DB(x), W_i) / W_i.moment(1, W_i.DW) - DB(x);
        });
    });
    of["A26b"] = either([] {
        return largest(everywhere, [](double x) {
            const auto W_i = kernel_at(x);
            return chen_beraun::second_derivative(B, DB(x), W_i) +
                   chen_beraun::second_remainder(B, DB(x), D2B(x), W_i) / (W_i.moment(2, W_i.W) / 2) - D2B(x);
        });
    });
    const auto vibration = [](double sign_of_acceleration) {
        // x = sin(ωX) cos(ωt) at X = 0.3, t = 0, where ∂²x/∂X² = −ω²x and ∂²x/∂t² = −ω²x; relative to ω²x.
        const double omega = vibration_test::exact_frequency(1), x = vibration_test::mode(omega, 0.3);
        const double d2x = vibration_test::acceleration(omega, x);
        return std::abs(vibration_test::unbalance(d2x, sign_of_acceleration * d2x)) / (omega * omega * x);
    };
    of["A27a"] = [=](Volumes) {
        return std::vector<Measurement>{{"", vibration(-1)},
                                        {"the sign of ∂²x/∂t² is changed", vibration(1)}};
    };
    of["A27b"] = [](Volumes volumes) {
        const auto [line, smoothing] = discretise<double>({volumes}, 100, 1);
        const auto K = vibration_test::stiffness(
            formulation_named<double>("second_order_fpm").operators(line, smoothing).D2);
        double nearest_zero = -1e300;
        for (const auto& lambda : solvers::eigenvalues(K))
            nearest_zero = std::max(nearest_zero, lambda.real());
        const double exact = vibration_test::exact_frequency(1);
        return std::vector<Measurement>{{"", nearest_zero / (exact * exact)},
                                        {"their sign is changed", -nearest_zero / (exact * exact)}};
    };
    of["A27c"] = [](Volumes volumes) {
        return stated(static_cast<double>(ratios("second_order_fpm", volumes).size()));
    };
    return of;
}

}  // namespace

report::Ledger ledger() {
    report::Ledger of{"asprone2010", {}};
    for (const auto& [id, measure] : all())
        of.computations[id] = [measure = measure](std::size_t convention) {
            return measure(std::array{Volumes::equal, Volumes::partition}.at(convention));
        };
    return of;
}

}  // namespace asprone2010::claims
