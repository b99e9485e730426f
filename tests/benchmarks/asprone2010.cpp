#include <memory>

#include "asprone2010/section_5_2_static_test.hpp"
#include "asprone2010/section_5_3_vibration_test.hpp"
#include "tests/benchmarks/report.hpp"

namespace benchmarks {

namespace {

using namespace asprone2010;
using Discrete = std::shared_ptr<const numerical_tests::Particles<double>>;

/// Perturbed particles, a Gaussian with h = δ: thirteen neighbours at most.
Discrete perturbed(long N) {
    numerical_tests::Discretisation how;
    how.perturbation = 0.25;
    return std::make_shared<const numerical_tests::Particles<double>>(
        numerical_tests::discretise<double>(how, N, 1));
}

double bytes(const Operator<double>& D) {
    return static_cast<double>(D.nonZeros()) * (sizeof(double) + sizeof(int));
}

}  // namespace

void add_asprone2010(long most) {
    for (const auto& formulation : formulations<double>()) {
        const auto [D, D2] = formulation.operators(perturbed(10000)->line, perturbed(10000)->smoothing);
        const double written = (bytes(D) + bytes(D2)) / 10000,
                     exponentials = static_cast<double>(D.nonZeros()) / 10000;
        for (long N = 1000; N <= most; N *= 10)
            for (const int threads : {1, 2}) {
                const bool once = N >= 10000000;
                const std::string name(formulation.name);
                add({"assembly", name, N, threads, written, exponentials, once}, [&formulation, N] {
                    return [&formulation, of = perturbed(N)] {
                        benchmark::DoNotOptimize(
                            formulation.operators(of->line, of->smoothing).D2.valuePtr());
                    };
                });
                add({"again", name, N, threads, written, exponentials, once}, [&formulation, N] {
                    const auto of = perturbed(N);
                    const auto all = std::make_shared<particles::Operators<double>>();
                    formulation.assemble_again(*all, of->line, of->smoothing);
                    return [&formulation, of, all] {
                        formulation.assemble_again(*all, of->line, of->smoothing);
                        benchmark::DoNotOptimize(all->D2.valuePtr());
                    };
                });
            }
    }

    const auto& formulation = formulation_named<double>("second_order_fpm");
    const double of_D2 =
        bytes(formulation.operators(perturbed(10000)->line, perturbed(10000)->smoothing).D2) / 10000;
    for (long N = 1000; N <= most; N *= 10)
        for (const int threads : {1, 2}) {
            // The operator is read, B is read, D²B is written.
            add({"application", "second_order_fpm", N, threads, of_D2 + 4 + 16}, [&formulation, N] {
                const auto of = perturbed(N);
                const auto D2 = std::make_shared<const Operator<double>>(
                    formulation.operators(of->line, of->smoothing).D2);
                return [B = of->line.x(), D2] { benchmark::DoNotOptimize(particles::apply(*D2, B).data()); };
            });
            for (const int corrections : {0, static_test::most_corrections})
                add({"static", corrections == 0 ? "uncorrected" : "corrected", N, threads, 0, 0,
                     N >= 10000000},
                    [&formulation, N, corrections] {
                        return [&formulation, corrections, of = perturbed(N)] {
                            benchmark::DoNotOptimize(
                                static_test::displacement(formulation.operators(of->line, of->smoothing),
                                                          of->line, static_test::exponential_load<double>(),
                                                          corrections)
                                    .data());
                        };
                    });
        }
    for (long N = 1000; N <= std::min(most, 1000000L); N *= 10)
        add({"modes", "lowest ten", N, 2, 0, 0, N >= 1000000}, [&formulation, N] {
            return [D2 = formulation.operators(perturbed(N)->line, perturbed(N)->smoothing).D2] {
                benchmark::DoNotOptimize(vibration_test::lowest_modes(D2, 10).data());
            };
        });
    for (const long N : {500L, 1000L, 2000L})
        add({"modes", "all", N, 1, 0, 0, true}, [&formulation, N] {
            return [&formulation, of = perturbed(N)] {
                benchmark::DoNotOptimize(vibration_test::frequencies(formulation, *of).data());
            };
        });
}

}  // namespace benchmarks
