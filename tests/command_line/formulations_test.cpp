#include "command_line/formulations.hpp"

#include "asprone2010/section_5_1_derivative_test.hpp"
#include "asprone2010/section_5_2_static_test.hpp"
#include "base/quad.hpp"
#include "batra2008/basis_at.hpp"
#include "tests/programs/run.hpp"
#include "tests/support.hpp"

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
