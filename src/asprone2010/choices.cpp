#include "asprone2010/choices.hpp"

#include <string>
#include <vector>

#include "asprone2010/section_3_3_rkpm.hpp"
#include "asprone2010/section_5_1_derivative_test.hpp"
#include "asprone2010/section_5_2_static_test.hpp"
#include "asprone2010/section_5_3_vibration_test.hpp"
#include "report/choices.hpp"
#include "report/statistics.hpp"

namespace asprone2010 {

namespace {

using numerical_tests::Discretisation;
using numerical_tests::discretise;
using particles::Gaussian;
using particles::Operator;
using particles::Volumes;
using report::Choice;

double derivative_error(const Formulation<double>& formulation, Index N, const Discretisation& how,
                        unsigned long seed = 1) {
    return derivative_test::errors(formulation, discretise<double>(how, N, seed),
                                   derivative_test::exponential<double>())
        .second;
}

double static_error(const Formulation<double>& formulation, Index N, const Discretisation& how,
                    unsigned long seed = 1) {
    return static_test::error(formulation, discretise<double>(how, N, seed), static_test::exponential_load());
}

double first_ratio(const Formulation<double>& formulation, Volumes volumes) {
    return vibration_test::frequencies(formulation, discretise<double>({volumes}, 100, 1)).front().real() /
           vibration_test::exact_frequency(1);
}

/// Observed order of the displacement's error.
double static_order(const Formulation<double>& formulation, const std::vector<Index>& numbers) {
    std::vector<double> spacing, error;
    for (const Index N : numbers) {
        spacing.push_back(1 / static_cast<double>(N - 1));
        error.push_back(static_error(formulation, N, {}));
    }
    return report::observed_order(spacing, error);
}

/// Quartiles of an error over 1000 draws of the perturbation.
/// \param error a function of the discretisation and the seed
template <class Error>
report::Quartiles quartiles_of_draws(const Error& error) {
    std::vector<double> sample(1000);
    base::for_each_index(1000, [&](Index k) {
        sample[static_cast<std::size_t>(k)] =
            error(Discretisation{Volumes::equal, Gaussian{}, 1, 0.25}, static_cast<unsigned long>(k) + 1);
    });
    return report::quartiles(sample);
}

/// D² of RKPM with its moments imposed on integrals.
template <int... p>
Operator<double> second_derivative_by_integrals(const numerical_tests::Particles<double>& discrete) {
    return rkpm::second_derivative(
        rkpm::first_derivative_by_integrals<p...>(discrete.line, discrete.smoothing));
}

template <int... p>
double derivative_error_by_integrals(Index N, Volumes volumes) {
    const auto discrete = discretise<double>({volumes}, N, 1);
    const Column<double> B = discrete.line.x().exp();
    return numerical_tests::distance<double>(
        particles::apply(second_derivative_by_integrals<p...>(discrete), B), B);
}

template <int... p>
double first_ratio_by_integrals(Volumes volumes) {
    const Operator<double> D2 = second_derivative_by_integrals<p...>(discretise<double>({volumes}, 100, 1));
    return vibration_test::frequencies(vibration_test::stiffness(D2)).front().real() /
           vibration_test::exact_frequency(1);
}

/// Appends a choice to the others.
void add(std::vector<Choice>& all, const char* choice, const char* one, const char* other,
         const std::string& quantity, const Formulation<double>& formulation, double with_one,
         double with_other) {
    all.push_back({choice, one, other, quantity, std::string(formulation.name), with_one, with_other});
}

void add_volumes(std::vector<Choice>& all) {
    for (const auto& formulation : formulations<double>())
        add(all, "volumes", "equal", "partition", "error of D²B, 1280 particles", formulation,
            derivative_error(formulation, 1280, {Volumes::equal}),
            derivative_error(formulation, 1280, {Volumes::partition}));
    for (const auto& formulation : formulations<double>())
        add(all, "volumes", "equal", "partition", "error of u, 640 particles", formulation,
            static_error(formulation, 640, {Volumes::equal}),
            static_error(formulation, 640, {Volumes::partition}));
    for (const auto& formulation : formulations<double>())
        add(all, "volumes", "equal", "partition", "first frequency over exact, 100 particles", formulation,
            first_ratio(formulation, Volumes::equal), first_ratio(formulation, Volumes::partition));
}

void add_numbers_of_particles(std::vector<Choice>& all) {
    for (const char* name : {"original", "rkpm_first_order", "rkpm_second_order"}) {
        const auto& formulation = formulation_named<double>(name);
        add(all, "numbers of particles", "20 to 160", "10240 to 40960", "order of u", formulation,
            static_order(formulation, {20, 40, 80, 160}), static_order(formulation, {10240, 20480, 40960}));
    }
}

void add_draws(std::vector<Choice>& all) {
    const auto& formulation = formulation_named<double>("second_order_fpm");
    const auto derivative = quartiles_of_draws([&](const Discretisation& how, unsigned long seed) {
        return derivative_error(formulation, 320, how, seed);
    });
    const auto displacement = quartiles_of_draws([&](const Discretisation& how, unsigned long seed) {
        return static_error(formulation, 320, how, seed);
    });
    add(all, "draw of the perturbation", "lower quartile of 1000 seeds", "upper quartile",
        "error of D²B, 320 particles", formulation, derivative.lower, derivative.upper);
    add(all, "draw of the perturbation", "lower quartile of 1000 seeds", "upper quartile",
        "error of u, 320 particles", formulation, displacement.lower, displacement.upper);
}

void add_moments_of_rkpm(std::vector<Choice>& all) {
    const auto add_one = [&](const std::string& quantity, const Formulation<double>& formulation,
                             double with_sums, double with_integrals) {
        add(all, "moments of RKPM", "imposed on sums", "imposed on integrals", quantity, formulation,
            with_sums, with_integrals);
    };
    const auto& first = formulation_named<double>("rkpm_first_order");
    const auto& second = formulation_named<double>("rkpm_second_order");
    for (const Volumes volumes : {Volumes::equal, Volumes::partition}) {
        const std::string error = "error of D²B, 640 particles, volumes " + particles::name(volumes);
        const std::string ratio = "first frequency over exact, volumes " + particles::name(volumes);
        add_one(error, first, derivative_error(first, 640, {volumes}),
                derivative_error_by_integrals<0, 1>(640, volumes));
        add_one(error, second, derivative_error(second, 640, {volumes}),
                derivative_error_by_integrals<0, 1, 2>(640, volumes));
        add_one(ratio, first, first_ratio(first, volumes), first_ratio_by_integrals<0, 1>(volumes));
        add_one(ratio, second, first_ratio(second, volumes), first_ratio_by_integrals<0, 1, 2>(volumes));
    }
}

void add_derivatives_at_the_end(std::vector<Choice>& all) {
    const auto& second_order = formulation_named<double>("second_order_fpm");
    for (const auto& formulation : formulations<double>())
        add(all, "derivative at x = 1", "the formulation's own", "second-order FPM's",
            "error of u, 640 particles", formulation, static_error(formulation, 640, {}),
            static_test::error(formulation, second_order, discretise<double>({}, 640, 1),
                               static_test::exponential_load()));
}

}  // namespace

report::Table choices() {
    std::vector<Choice> all;
    add_volumes(all);
    add_numbers_of_particles(all);
    add_draws(all);
    add_moments_of_rkpm(all);
    add_derivatives_at_the_end(all);
    return report::table_of("Asprone et al. (2010), Section 5", all);
}

}  // namespace asprone2010
