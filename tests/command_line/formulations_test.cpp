#include "command_line/formulations.hpp"

#include <algorithm>
#include <string>

#include "asprone2010/section_5_1_derivative_test.hpp"
#include "asprone2010/section_5_2_static_test.hpp"
#include "base/quad.hpp"
#include "batra2008/basis_at.hpp"
#include "report/file.hpp"
#include "report/table.hpp"
#include "tests/programs/run.hpp"
#include "tests/support/folder.hpp"
#include "tests/support/lines.hpp"

using namespace asprone2010;
using particles::Gaussian;
using particles::Volumes;

namespace {

const Formulation<double>& ssph() {
    return command_line::formulation_named("ssph");
}

double second_derivative_error(Index N) {
    return derivative_test::errors(ssph(), support::particles_of(N), derivative_test::exponential<double>())
        .second;
}

/// Largest error of the second derivative of 2 − x + 3x².
template <class Scalar>
double ssph_on_a_parabola() {
    const auto [line, smoothing] =
        numerical_tests::discretise<Scalar>({Volumes::equal, Gaussian{}, 1.5, 0.3}, 40, 7);
    const auto operators = command_line::formulation_named<Scalar>("ssph").operators(line, smoothing);
    const Column<Scalar> x = line.x(), B = Scalar(2) - x + Scalar(3) * x * x;
    return static_cast<double>((particles::apply(operators.D2, B) - Scalar(6)).abs().maxCoeff());
}

}  // namespace

TEST_CASE("formulations: the seven of asprone2010 and ssph, each under its own name") {
    CHECK(command_line::formulations().size() == formulations<double>().size() + 1);
    for (const auto& of : formulations<double>())
        CHECK(command_line::formulation_named(of.name).name == of.name);
    CHECK_THROWS_WITH_AS(command_line::formulation_named("nonsense"),
                         doctest::Contains("there is no formulation 'nonsense'; choose one of original"),
                         base::InvalidInput);
}

TEST_CASE("formulations: ssph is exact on parabolas, for irregular particles and every kernel") {
    particles::for_each_kernel([](const particles::Kernel<>& kernel) {
        CAPTURE(particles::name(kernel));
        const auto [line, smoothing] = support::particles_of(60, {Volumes::equal, kernel, 2, 0.4}, 7);
        const auto [D, D2] = ssph().operators(line, smoothing);
        const Column<double> x = line.x(), B = 2 - x + 3 * x * x;
        CHECK((particles::apply(D, B) - (6 * x - 1)).abs().maxCoeff() < 1e-11);
        CHECK((particles::apply(D2, B) - 6).abs().maxCoeff() < 1e-8);
    });
}

TEST_CASE("formulations: ssph is exact on parabolas to the round-off of each precision") {
    CHECK(ssph_on_a_parabola<double>() < 1e-9);
    CHECK(ssph_on_a_parabola<long double>() < 1e-12);
    CHECK(ssph_on_a_parabola<base::Quad>() < 1e-27);
}

TEST_CASE("formulations: ssph weighs with (3.15) of batra2008 for a scaling factor of 4") {
    const auto [line, smoothing] = support::particles_of(60, {Volumes::equal, Gaussian{}, 1, 0.2}, 3);
    const auto [D, D2] = ssph().operators(line, smoothing);
    Eigen::Matrix<double, 1, Eigen::Dynamic> x(1, line.size());
    for (Index j = 0; j < line.size(); ++j) x(0, j) = line.x()[j];
    const particles::Cloud<1> cloud(x);
    for (const Index i : {Index(0), Index(30)}) {
        const auto basis = batra2008::ssph_basis::basis_at<2>(
            cloud, particles::TruncatedGaussian<1>(4), particles::Point<1>(line.x()[i]), smoothing.h());
        const Column<double> K2 = batra2008::ssph_basis::K<2>(basis), K3 = batra2008::ssph_basis::K<3>(basis);
        for (std::size_t k = 0; k < basis.particle().size(); ++k) {
            const Index j = basis.particle()[k];
            if (j == i) continue;
            CHECK(std::abs(D.coeff(i, j) - K2[static_cast<Index>(k)]) < 1e-11 / smoothing.h());
            CHECK(std::abs(D2.coeff(i, j) - 2 * K3[static_cast<Index>(k)]) <
                  1e-11 / std::pow(smoothing.h(), 2));
        }
    }
}

TEST_CASE(
    "formulations: the second derivative of ssph is of first order at the ends, its displacement of second") {
    std::vector<double> spacing, derivative, displacement;
    for (const Index N : {160, 320, 640}) {
        spacing.push_back(1 / static_cast<double>(N - 1));
        derivative.push_back(second_derivative_error(N));
        displacement.push_back(
            static_test::error(ssph(), support::particles_of(N), static_test::exponential_load()));
    }
    CHECK(report::observed_order(spacing, derivative) == support::relative(1, 0.01));
    CHECK(report::observed_order(spacing, displacement) == support::relative(2, 0.02));
}

TEST_CASE("formulations: the programs know ssph, and refuse it where particles are too few") {
    CHECK(programs::run("derivative_test --formulation ssph --particles 20").code == 0);
    CHECK(programs::run("vibration_test --formulation ssph --particles 20").code == 0);
    programs::check_refused(
        "static_test --formulation ssph --particles 2", 1,
        "ssph: particle 0 (x = 0) has 2 neighbours within 6h, needs 3; take at least 3 particles");
}

TEST_CASE(
    "formulations: definite_fpm is known by its name alone, and is of second order in all three tests, ends included") {
    const auto names = command_line::formulation_names();
    CHECK(std::find(names.begin(), names.end(), "definite_fpm") == names.end());
    const auto& definite = command_line::formulation_named<double>("definite_fpm");
    std::vector<double> spacing, first, second, displacement;
    for (const Index N : {80, 160, 320}) {
        const auto particles = support::particles_of(N, {Volumes::equal, Gaussian{}, 1, 0.25}, 5);
        const auto errors =
            derivative_test::errors(definite, particles, derivative_test::exponential<double>());
        spacing.push_back(1 / static_cast<double>(N - 1));
        first.push_back(errors.first);
        second.push_back(errors.second);
        displacement.push_back(static_test::error(definite, particles, static_test::exponential_load()));
    }
    for (const auto* const error : {&first, &second, &displacement})
        CHECK(report::observed_order(spacing, *error) == support::relative(2, 0.2));
    for (const char* program : {"derivative_test", "static_test", "vibration_test", "constants"})
        CHECK(programs::run(std::string(program) + " --formulation definite_fpm" +
                            (std::string(program) == "constants" ? "" : " --particles 20"))
                  .code == 0);
    const std::string all = programs::run("derivative_test --particles 20").output;
    CHECK(all.find("definite_fpm") == std::string::npos);
}

TEST_CASE(
    "formulations: definite_fpm differentiates behind a short first gap, where second_order_fpm is refused") {
    const support::Folder folder;
    const std::string file = folder.path + "/gap.txt";
    std::string positions = "0\n";
    for (int j = 0; j < 60; ++j) positions += base::shown((0.0980558 + j) / 59.0980558, 17) + "\n";
    report::write_whole(file, positions);
    const std::string options = " --smoothing 2 --smoothing-from largest --positions " + file;
    programs::check_refused("derivative_test --formulation second_order_fpm" + options, 1, "R = ");
    const auto [code, output, errors] = programs::run("derivative_test --formulation definite_fpm" + options);
    CHECK(code == 0);
    const auto table = report::parsed(output);
    CHECK(std::get<double>(table.rows[0][table.column("error_second")]) < 0.02);
}
