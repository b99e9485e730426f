#include "asprone2010/formulations.hpp"

#include <set>

#include "tests/support/lines.hpp"

using namespace asprone2010;
using support::particles_of;

namespace {

/// Polynomials of what degree the operators of a formulation differentiate exactly, on any particles.
struct Degrees {
    std::string_view formulation;
    int first, second;
};
constexpr Degrees exactness[] = {
    {"original", 0, 0}, {"chen_beraun", 1, 1},  {"rkpm_first_order", 0, 0}, {"rkpm_second_order", 0, 0},
    {"fpm", 1, 1},      {"modified_fpm", 2, 2}, {"second_order_fpm", 2, 3},
};

/// Largest relative errors of D and D² on (x − c)^degree, on random particles.
std::array<double, 2> errors(const Formulation<double>& formulation, int degree, particles::Volumes volumes,
                             const particles::Kernel<>& kernel, unsigned long seed) {
    const double c = 0.37;
    const auto [line, smoothing] = particles_of(60, {volumes, kernel, 2.2, 0.4}, seed);
    const auto [D, D2] = formulation.operators(line, smoothing);
    const Column<double> x = line.x() - c;
    const Column<double> B = x.pow(degree);
    const Column<double> DB = degree < 1 ? Column<double>(0 * x) : Column<double>(degree * x.pow(degree - 1));
    const Column<double> D2B =
        degree < 2 ? Column<double>(0 * x) : Column<double>(degree * (degree - 1) * x.pow(degree - 2));
    return {(particles::apply(D, B) - DB).abs().maxCoeff(), (particles::apply(D2, B) - D2B).abs().maxCoeff()};
}

}  // namespace

TEST_CASE("formulations: names are those of the papers' tables, each once, in the paper's order") {
    std::vector<std::string_view> names;
    for (const auto& formulation : formulations<double>()) {
        names.push_back(formulation.name);
        CHECK(&formulation_named<double>(formulation.name) == &formulation);
    }
    CHECK(names == std::vector<std::string_view>{"original", "chen_beraun", "rkpm_first_order",
                                                 "rkpm_second_order", "fpm", "modified_fpm",
                                                 "second_order_fpm"});
    CHECK_THROWS_WITH_AS(
        formulation_named<double>("sph"),
        "there is no formulation 'sph'; choose one of original, chen_beraun, rkpm_first_order, rkpm_second_order, fpm, modified_fpm, second_order_fpm",
        base::InvalidInput);
}

TEST_CASE(
    "formulations: polynomials up to the order are exact on random particles, with every kernel, and no further") {
    for (const auto& [name, first, second] : exactness)
        particles::for_each_kernel(
            [&, name = name, first = first, second = second](const particles::Kernel<>& kernel) {
                for (const auto volumes : {particles::Volumes::equal, particles::Volumes::partition})
                    for (unsigned long seed = 1; seed <= 3; ++seed) {
                        CAPTURE(name);
                        CAPTURE(particles::name(kernel));
                        CAPTURE(seed);
                        const auto& formulation = formulation_named<double>(name);
                        CHECK(formulation.exact.first == first);
                        CHECK(formulation.exact.second == second);
                        for (int degree = 0; degree <= first; ++degree)
                            CHECK(errors(formulation, degree, volumes, kernel, seed)[0] < 1e-10);
                        for (int degree = 0; degree <= second; ++degree)
                            CHECK(errors(formulation, degree, volumes, kernel, seed)[1] < 2e-7);
                        CHECK(errors(formulation, first + 1, volumes, kernel, seed)[0] > 1e-6);
                        CHECK(errors(formulation, second + 1, volumes, kernel, seed)[1] > 1e-5);
                    }
            });
}

TEST_CASE(
    "formulations: the number of particles that each states suffices, and with one fewer there is no second derivative") {
    for (const auto& formulation : formulations<double>()) {
        CAPTURE(formulation.name);
        const auto [line, smoothing] =
            particles_of(formulation.particles, {particles::Volumes::equal, particles::Gaussian{}, 1, 0.2});
        CHECK_NOTHROW(static_cast<void>(formulation.operators(line, smoothing)));
        if (formulation.particles == 2) continue;  // a line has no fewer
        const auto few = particles_of(formulation.particles - 1);
        const auto unchecked = [&] {
            particles::Operators<double> all;
            formulation.assemble(all, few.line, few.smoothing, {formulation.name, 1});
            return all;
        };
        if (formulation.name == "chen_beraun")
            CHECK(Eigen::MatrixXd(unchecked().D2).cwiseAbs().maxCoeff() < 1e-12);
        else
            CHECK_THROWS_AS(static_cast<void>(unchecked()), base::FailedComputation);
    }
}

TEST_CASE(
    "formulations: the second derivative of those that return the first alone is the first applied twice") {
    const auto [line, smoothing] =
        particles_of(60, {particles::Volumes::equal, particles::Gaussian{}, 1, 0.25});
    const Column<double> B = line.x().unaryExpr(&support::Wave::B);
    for (const char* name : {"original", "rkpm_first_order", "rkpm_second_order", "fpm"}) {
        const auto [D, D2] = formulation_named<double>(name).operators(line, smoothing);
        const Column<double> twice = particles::apply(D, particles::apply(D, B));
        CHECK((particles::apply(D2, B) - twice).abs().maxCoeff() < 1e-9);
    }
}

TEST_CASE(
    "formulations: extended precision gives the same operators, and its second derivative is more exact") {
    const Index N = 400;
    const auto in_double = numerical_tests::discretise<double>({}, N, 1);
    const auto in_long = numerical_tests::discretise<long double>({}, N, 1);
    for (std::size_t k = 0; k < formulations<double>().size(); ++k) {
        CAPTURE(formulations<double>()[k].name);
        const auto a = formulations<double>()[k].operators(in_double.line, in_double.smoothing);
        const auto b = formulations<long double>()[k].operators(in_long.line, in_long.smoothing);
        const Eigen::MatrixXd first = Eigen::MatrixXd(a.D), second = Eigen::MatrixXd(a.D2);
        const Eigen::MatrixXd first_long = b.D.toDense().cast<double>(),
                              second_long = b.D2.toDense().cast<double>();
        CHECK((first - first_long).cwiseAbs().maxCoeff() < 1e-11 * first.cwiseAbs().maxCoeff());
        CHECK((second - second_long).cwiseAbs().maxCoeff() < 1e-11 * second.cwiseAbs().maxCoeff());
    }
    const Column<double> B = in_double.line.x().square();
    const Column<long double> B_long = in_long.line.x().square();
    const auto& D2 =
        formulation_named<double>("second_order_fpm").operators(in_double.line, in_double.smoothing).D2;
    const auto& D2_long =
        formulation_named<long double>("second_order_fpm").operators(in_long.line, in_long.smoothing).D2;
    const double error = (particles::apply(D2, B) - 2).abs().maxCoeff();
    const auto error_long = static_cast<double>((particles::apply(D2_long, B_long) - 2).abs().maxCoeff());
    CHECK(error < 1e-8);
    CHECK(error_long < error / 100);
}
