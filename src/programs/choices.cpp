#include "asprone2010/section_5_1_derivative_test.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>
#include "asprone2010/section_5_2_static_test.hpp"
#include "asprone2010/section_5_3_vibration_test.hpp"
#include "batra2008/section_4_1_plate.hpp"
#include "batra2008/section_4_2_hole.hpp"
#include "command_line/options.hpp"
#include "report/statistics.hpp"

namespace {

/// A table of choices, and a row of it: the same quantity with the one and with the other choice.
report::Table table_of_choices(const std::string& about) {
    report::Table table;
    table.comments = {about + ": what the print leaves open, and what another choice changes",
                      "a row: the same quantity with the one and with the other choice"};
    table.columns = {{"choice"},
                     {"one"},
                     {"other"},
                     {"quantity"},
                     {"formulation"},
                     {"with_one", {1e-4, 1e-9}},
                     {"with_other", {1e-4, 1e-9}}};
    return table;
}

namespace of_asprone2010 {

using namespace asprone2010;
using numerical_tests::Discretisation;
using numerical_tests::discretise;
using particles::Gaussian;
using particles::Volumes;

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

double static_order(const Formulation<double>& formulation, const std::vector<Index>& numbers) {
    std::vector<double> spacing, error;
    for (const Index N : numbers) {
        spacing.push_back(1 / static_cast<double>(N - 1));
        error.push_back(static_error(formulation, N, {}));
    }
    return report::observed_order(spacing, error);
}

template <class Error>
report::Quartiles spread(const Error& error) {
    std::vector<double> sample(1000);
    base::for_each_index(1000, [&](Index k) {
        sample[static_cast<std::size_t>(k)] =
            error(Discretisation{Volumes::equal, Gaussian{}, 1, 0.25}, static_cast<unsigned long>(k) + 1);
    });
    return report::quartiles(sample);
}

/// The operators of RKPM with the moments imposed on integrals, as below (24), and sampled at the particles.
template <int... p>
particles::Operators<double> rkpm_by_integrals(const numerical_tests::Particles<double>& discrete) {
    const auto& [line, smoothing] = discrete;
    const Index N = line.size();
    std::vector<Eigen::Triplet<double>> weights;
    for (Index i = 0; i < N; ++i) {
        const CentredKernel K_i =
            rkpm::corrected<p...>(particles::centred(smoothing.kernel(), line.x()[i], smoothing.h(), {0, 1}));
        const auto near = particles::within_reach(line, smoothing, i);
        for (Index j = near.first; j < near.last; ++j)
            weights.emplace_back(static_cast<int>(i), static_cast<int>(j),
                                 -K_i.DW(line.x()[j]) * line.V()[j]);
    }
    Operator<double> D(N, N);
    D.setFromTriplets(weights.begin(), weights.end());
    particles::annihilate_constants(D);
    particles::Operators<double> of;
    of.D2 = rkpm::second_derivative(D);
    of.D = D;
    return of;
}

template <int... p>
double derivative_error_by_integrals(Index N, Volumes volumes) {
    const auto discrete = discretise<double>({volumes}, N, 1);
    const Column<double> B = discrete.line.x().exp();
    return numerical_tests::distance<double>(particles::apply(rkpm_by_integrals<p...>(discrete).D2, B), B);
}

template <int... p>
double first_ratio_by_integrals(Volumes volumes) {
    const auto discrete = discretise<double>({volumes}, 100, 1);
    return vibration_test::frequencies(vibration_test::stiffness(rkpm_by_integrals<p...>(discrete).D2))
               .front()
               .real() /
           vibration_test::exact_frequency(1);
}

report::Table measured() {
    report::Table table = table_of_choices("Asprone et al. (2010), Section 5");
    const auto add = [&](const char* choice, const char* one, const char* other, const char* quantity,
                         const Formulation<double>& formulation, double with_one, double with_other) {
        table.rows.push_back({std::string(choice), std::string(one), std::string(other),
                              std::string(quantity), std::string(formulation.name), with_one, with_other});
    };
    for (const auto& of : formulations<double>())
        add("volumes", "equal", "partition", "error of D²B, 1280 particles", of,
            derivative_error(of, 1280, {Volumes::equal}), derivative_error(of, 1280, {Volumes::partition}));
    for (const auto& of : formulations<double>())
        add("volumes", "equal", "partition", "error of u, 640 particles", of,
            static_error(of, 640, {Volumes::equal}), static_error(of, 640, {Volumes::partition}));
    for (const auto& of : formulations<double>())
        add("volumes", "equal", "partition", "first frequency over exact, 100 particles", of,
            first_ratio(of, Volumes::equal), first_ratio(of, Volumes::partition));
    for (const char* name : {"original", "rkpm_first_order", "rkpm_second_order"})
        add("numbers of particles", "20 to 160", "10240 to 40960", "order of u",
            formulation_named<double>(name), static_order(formulation_named<double>(name), {20, 40, 80, 160}),
            static_order(formulation_named<double>(name), {10240, 20480, 40960}));
    const auto& second_order = formulation_named<double>("second_order_fpm");
    const auto derivative = spread([&](const Discretisation& how, unsigned long seed) {
        return derivative_error(second_order, 320, how, seed);
    });
    const auto displacement = spread([&](const Discretisation& how, unsigned long seed) {
        return static_error(second_order, 320, how, seed);
    });
    add("draw of the perturbation", "lower quartile of 1000 seeds", "upper quartile",
        "error of D²B, 320 particles", second_order, derivative.lower, derivative.upper);
    add("draw of the perturbation", "lower quartile of 1000 seeds", "upper quartile",
        "error of u, 320 particles", second_order, displacement.lower, displacement.upper);
    const auto& rkpm_1 = formulation_named<double>("rkpm_first_order");
    const auto& rkpm_2 = formulation_named<double>("rkpm_second_order");
    for (const Volumes volumes : {Volumes::equal, Volumes::partition}) {
        const bool equal = volumes == Volumes::equal;
        const char* error = equal ? "error of D²B, 640 particles, volumes equal"
                                  : "error of D²B, 640 particles, volumes partition";
        const char* ratio = equal ? "first frequency over exact, volumes equal"
                                  : "first frequency over exact, volumes partition";
        add("moments of RKPM", "imposed on sums", "imposed on integrals", error, rkpm_1,
            derivative_error(rkpm_1, 640, {volumes}), derivative_error_by_integrals<0, 1>(640, volumes));
        add("moments of RKPM", "imposed on sums", "imposed on integrals", error, rkpm_2,
            derivative_error(rkpm_2, 640, {volumes}), derivative_error_by_integrals<0, 1, 2>(640, volumes));
        add("moments of RKPM", "imposed on sums", "imposed on integrals", ratio, rkpm_1,
            first_ratio(rkpm_1, volumes), first_ratio_by_integrals<0, 1>(volumes));
        add("moments of RKPM", "imposed on sums", "imposed on integrals", ratio, rkpm_2,
            first_ratio(rkpm_2, volumes), first_ratio_by_integrals<0, 1, 2>(volumes));
    }
    for (const auto& of : formulations<double>())
        add("derivative at x = 1", "the formulation's own", "second-order FPM's", "error of u, 640 particles",
            of, static_error(of, 640, {}),
            static_test::error(of, second_order, discretise<double>({}, 640, 1),
                               static_test::exponential_load()));
    return table;
}

}  // namespace of_asprone2010

namespace of_batra2008 {

using namespace batra2008;
using elastostatics::Plane;
using example_problems::Errors;
using example_problems::Method;

constexpr std::array<Method, 3> methods{Method::strong, Method::weak1, Method::weak2};
constexpr std::array<Method, 2> weak{Method::weak1, Method::weak2};

/// The plate with 16 × 4 particles.
struct Plate {
    plate::Corners corners = plate::default_corners();
    double penalty = 1;  ///< in units of the print's
    Index gauss = 10;
};

struct Results {
    Errors errors;
    double field,
        unknowns;  ///< largest error of u2 at the bottom in percent, by the SSPH field and by the unknowns
};

Results solved(const Plate& of, Method method) {
    const elastostatics::Material material{plate::E, plate::nu};
    const Problem problem = plate::problem(material, of.corners);
    const Cloud<2> cloud(plate::grid(16, 4));
    const auto solution = example_problems::solve(
        problem, cloud, {method, 3, 2, of.penalty * plate::penalty(material), 1, of.gauss});
    double error = 0, largest = 0;
    for (Index I = 0; I < cloud.size(); I += 4) {
        const double exact = problem.exact.u(cloud.x().col(I))[1];
        error = std::max(error, std::abs(solution.u[2 * I + 1] - exact));
        largest = std::max(largest, std::abs(exact));
    }
    return {example_problems::errors(plate::mesh(16, 4), cloud, solution, problem),
            plate::largest_error_u2(cloud, solution, problem), 100 * error / largest};
}

Errors around_hole(const Points<2>& x, Method method, const hole::Shape& shape,
                   const std::vector<elastostatics::Corner>& corners = {}) {
    Problem problem = hole::problem({hole::E, hole::nu, Plane::strain}, shape);
    problem.corners = corners;
    const Cloud<2> cloud(x);
    const auto solution =
        example_problems::solve(problem, cloud, {method, 4, 2, hole::penalty(problem.material)});
    return example_problems::errors(hole::mesh(shape), cloud, solution, problem);
}

report::Table measured() {
    report::Table table = table_of_choices("Batra and Zhang (2008), Section 4");
    const auto add = [&](const char* choice, const char* one, const char* other, const char* quantity,
                         Method method, double with_one, double with_other) {
        table.rows.push_back({std::string(choice), std::string(one), std::string(other),
                              std::string(quantity), example_problems::name(method), with_one, with_other});
    };
    for (const Method method : methods) {
        const Results of = solved({}, method);
        add("error norm", "difference of the norms (dn)", "norm of the difference (nd)", "log E, plate",
            method, of.errors.log_dn, of.errors.log_nd);
    }
    for (const Method method : methods) {
        const Results of = solved({}, method);
        add("displacement at a particle", "SSPH field", "the unknown itself",
            "largest error of u2 in percent, plate", method, of.field, of.unknowns);
    }
    Plate tops;
    tops.corners[0] = {"s11", "s12"};
    add("conditions at corner 1", "s11, s22", "s11, s12", "log E dn, plate", Method::strong,
        solved({}, Method::strong).errors.log_dn, solved(tops, Method::strong).errors.log_dn);
    add("conditions at corner 1", "s11, s22", "s11, s12", "largest error of u2 in percent, plate",
        Method::strong, solved({}, Method::strong).field, solved(tops, Method::strong).field);
    for (const Method method : weak)
        add("Gauss points", "10", "32", "log E dn, plate", method, solved({}, method).errors.log_dn,
            solved({.gauss = 32}, method).errors.log_dn);
    for (const Method method : weak)
        add("penalty", "the print's", "a hundredth of it", "log E dn, plate", method,
            solved({}, method).errors.log_dn, solved({.penalty = 0.01}, method).errors.log_dn);
    for (const Method method : weak)
        add("penalty", "the print's", "a hundred times it", "log E dn, plate", method,
            solved({}, method).errors.log_dn, solved({.penalty = 100}, method).errors.log_dn);

    const hole::Shape shape;
    const Points<2> reference = hole::graded_layout(shape, 188, 11, 1);
    for (const Method method : methods)
        add("layout around the hole", "graded-188-11, draw 1", "draw 2", "log E dn", method,
            around_hole(reference, method, shape).log_dn,
            around_hole(hole::graded_layout(shape, 188, 11, 2), method, shape).log_dn);
    for (const Method method : methods)
        add("layout around the hole", "graded-188-11, draw 1", "polar-11x17", "log E dn", method,
            around_hole(reference, method, shape).log_dn,
            around_hole(hole::polar_layout(shape, 11, 17), method, shape).log_dn);
    for (const Method method : methods)
        add("radius of the hole", "0.3 m", "0.4 m", "log E dn, polar-11x17", method,
            around_hole(hole::polar_layout(shape, 11, 17), method, shape).log_dn,
            around_hole(hole::polar_layout({0.4, 3}, 11, 17), method, {0.4, 3}).log_dn);
    const elastostatics::Corner outer{{3, 3}, {plate::condition_named("s11"), plate::condition_named("s12")}};
    add("conditions at the outer corner of the quarter", "s11, s22", "s11, s12", "log E dn, polar-11x17",
        Method::strong, around_hole(hole::polar_layout(shape, 11, 17), Method::strong, shape).log_dn,
        around_hole(hole::polar_layout(shape, 11, 17), Method::strong, shape, {outer}).log_dn);
    return table;
}

}  // namespace of_batra2008

}  // namespace

int main(int argc, char** argv) {
    command_line::CommandLine app("Measures what the choices change that the print of a paper leaves open.",
                                  "choices", "Example: choices --paper batra2008 --output /tmp/choices.csv");
    std::string paper = "asprone2010", output;
    app.add_option("--paper", paper, "asprone2010 (default) or batra2008")
        .type_name("NAME")
        .among({"asprone2010", "batra2008"});
    app.add_output(output);
    return command_line::run(app, argc, argv, 0, output, {}, [&] {
        return paper == "batra2008" ? of_batra2008::measured() : of_asprone2010::measured();
    });
}
