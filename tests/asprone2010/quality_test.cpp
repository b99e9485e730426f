#include "asprone2010/quality.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "tests/support/lines.hpp"

using namespace asprone2010;
using numerical_tests::Particles;
using particles::Gaussian;
using particles::Spacing;
using particles::Volumes;
using quality::of_derivative_test;
using quality::of_static_test;
using quality::of_vibration_test;
using support::particles_of;

namespace {

const Formulation<double>& second_order_fpm() {
    return formulation_named<double>("second_order_fpm");
}

/// A hundred particles at equal distances δ on [0, 1] behind a short first gap.
/// \param gap the first gap in units of δ \param ratio h/δ
Particles<double> after_a_short_gap(double gap, double ratio = 2) {
    const Index N = 101;
    Column<double> x(N);
    for (Index j = 0; j < N; ++j)
        x[j] = j == 0 ? 0 : (gap + static_cast<double>(j - 1)) / (gap + static_cast<double>(N - 2));
    return numerical_tests::discretise<double>({Volumes::equal, Gaussian{}, ratio, 0, Spacing::largest}, x);
}

/// The worst row of a formulation.
quality::Row worst(const Formulation<double>& formulation, const Particles<double>& discrete,
                   quality::RowsOf rows) {
    return quality::worst({formulation, formulation}, discrete, rows).by_error;
}

double R_of(const Particles<double>& discrete) {
    return worst(second_order_fpm(), discrete, of_derivative_test).R;
}

/// The message of a refusal; empty where there is none.
std::string refusal(const quality::Source& source, const Particles<double>& discrete, quality::RowsOf rows) {
    const quality::Worst found = quality::worst(source, discrete, rows);
    return worth_a_table(found) ? "" : quality::refusal(found, source, discrete, rows).what();
}
std::string refusal(const Formulation<double>& formulation, const Particles<double>& discrete,
                    quality::RowsOf rows) {
    return refusal({formulation, formulation}, discrete, rows);
}

}  // namespace

TEST_CASE(
    "quality: on particles at equal distances R is 0.13 inside and 6.2 at the ends, whatever their number") {
    for (const Index N : {10, 100, 1000}) {
        const auto discrete = particles_of(N);
        const auto D2 = second_order_fpm().operators(discrete.line, discrete.smoothing).D2;
        const Column<double> R = particles::quality(D2, discrete.line, 2, 3, quality::spacing(discrete));
        CHECK(R[0] == support::relative(6.2272, 1e-4));
        CHECK(R[N - 1] == support::relative(6.2272, 1e-4));
        if (N > 20) CHECK(R[N / 2] == support::relative(0.12643, 1e-4));
        CHECK(R.maxCoeff() == support::relative(6.2272, 1e-4));
    }
}

TEST_CASE("quality: none of the perturbed lines of the paper is refused, by any formulation") {
    for (unsigned long seed = 1; seed <= 20; ++seed)
        for (const Index N : {10, 17, 40, 113, 320})
            for (const auto volumes : {Volumes::equal, Volumes::partition}) {
                CAPTURE(seed);
                CAPTURE(N);
                const auto discrete = particles_of(N, {volumes, Gaussian{}, 1, 0.25}, seed);
                for (const auto& formulation : formulations<double>()) {
                    CAPTURE(formulation.name);
                    const auto row = worst(formulation, discrete, of_derivative_test);
                    CHECK(row.R < (row.p() > 0 ? 20 : 6));
                    CHECK(row.R < most(row) / 10);
                }
            }
}

TEST_CASE(
    "quality: next to the zero of (43) behind a short first gap R grows without bound, and the row is refused") {
    CHECK(R_of(after_a_short_gap(0.12)) == support::relative(16.47, 1e-3));
    CHECK(R_of(after_a_short_gap(0.099)) == support::relative(423.7, 1e-3));
    CHECK(R_of(after_a_short_gap(0.098096)) == support::relative(9990, 1e-2));
    CHECK(R_of(after_a_short_gap(0.0980558)) > 1e5);

    const auto accepted = after_a_short_gap(0.099), refused = after_a_short_gap(0.098096);
    for (const auto rows : {of_derivative_test, of_static_test, of_vibration_test}) {
        CHECK(refusal(second_order_fpm(), accepted, rows).empty());
        CHECK(
            refusal(second_order_fpm(), refused, rows) ==
            "second_order_fpm: at particle 1 (x = 0.000989888) the error of D2B may reach R delta^2 |B^(4)| with R = 9.99e+03, where 4000 is the most for a table; particles 0 and 1 lie 0.00099 apart, the next one 0.0101; leave one of them out, or try --smoothing 2.2");
    }
}

TEST_CASE("quality: the remedies of a refusal help when they are followed") {
    const auto refused = after_a_short_gap(0.098096);
    Column<double> fewer(refused.line.size() - 1);
    fewer << 0, refused.line.x().tail(fewer.size() - 1);
    const numerical_tests::Discretisation how{Volumes::equal, Gaussian{}, 2, 0, Spacing::largest};
    CHECK(R_of(numerical_tests::discretise<double>(how, fewer)) < 100);

    // Next to the zeros for these h/δ.
    for (const auto& [ratio, gap] : {std::pair{1.5, 0.0334}, {2.0, 0.098056}, {2.5, 0.1774}, {3.0, 0.2685}}) {
        int proposed = 0;
        for (int k = -20; k <= 20; ++k) {
            const double t = gap + 1e-5 * k;
            const std::string message =
                refusal(second_order_fpm(), after_a_short_gap(t, ratio), of_derivative_test);
            const auto at = message.find("--smoothing ");
            if (at == std::string::npos) continue;
            CAPTURE(message);
            ++proposed;
            const double other = std::stod(message.substr(at + 12));
            CHECK(refusal(second_order_fpm(), after_a_short_gap(t, other), of_derivative_test).empty());
        }
        CHECK(proposed > 3);
    }
}

TEST_CASE(
    "quality: a row that multiplies round-off until it hides the derivative is refused, with what helps") {
    Column<double> x(41);  // each gap 1.9 times as wide as the one before it
    for (Index j = 0; j < 41; ++j)
        x[j] = (std::pow(1.9, static_cast<double>(j)) - 1) / (std::pow(1.9, 40.0) - 1);
    const numerical_tests::Discretisation how{Volumes::equal, particles::kernel_named("cubic_spline"), 1.5, 0,
                                              Spacing::local};
    const auto& chen_beraun = formulation_named<double>("chen_beraun");
    const auto refused = numerical_tests::discretise<double>(how, x);
    const auto refusal_in = [&](double unit, bool finer) {
        quality::Worst found = quality::worst({chen_beraun, chen_beraun}, refused, of_derivative_test);
        found.unit = unit;
        return worth_a_table(found)
                   ? std::string()
                   : quality::refusal(found, {chen_beraun, chen_beraun}, refused, of_derivative_test, finer)
                         .what();
    };
    // In double the second derivative of exp errs by 1e6 there, in quadruple precision by 3.
    CHECK(refusal_in(0x1p-52, false).find("round-off of D2B may reach ") != std::string::npos);
    CHECK(refusal_in(0x1p-52, false).find("--precision") == std::string::npos);
    CHECK(refusal_in(0x1p-52, true).find("--precision quad") != std::string::npos);
    CHECK(refusal_in(0x1p-63, true).find("--precision quad") != std::string::npos);
    CHECK(refusal_in(0x1p-112, true).empty());
    // So does a smoothing length that does not shrink with the gaps.
    CHECK(refusal_in(0x1p-52, false).ends_with("; try --smoothing-from largest"));
    const auto helped =
        numerical_tests::discretise<double>({how.volumes, how.kernel, how.smoothing, 0, Spacing::largest}, x);
    CHECK(refusal(chen_beraun, helped, of_derivative_test).empty());
    CHECK(refusal(chen_beraun, particles_of(1000000), of_derivative_test).empty());
    // Tests that solve with the rows, and do not apply them to rounded values, are not refused.
    CHECK(refusal(chen_beraun, refused, of_vibration_test).find("round-off") != std::string::npos);
    CHECK(refusal(chen_beraun, refused, of_static_test).empty());
    CHECK(refusal(chen_beraun, refused, quality::of_lowest_modes).empty());
}

TEST_CASE("quality: only the rows that a test uses count") {
    // The bad row is one of D at an end, which a vibration with fixed ends does not use.
    const numerical_tests::Discretisation how{Volumes::equal, particles::kernel_named("wendland_c4"), 2.4,
                                              0.25};
    int bad = 0;
    for (const Index N : {161, 321, 641})
        for (unsigned long seed = 1; seed <= 5; ++seed) {
            const auto discrete = particles_of(N, how, seed);
            const auto row = worst(second_order_fpm(), discrete, of_derivative_test);
            if (row.R < 1000) continue;
            ++bad;
            CHECK(row.derivative == 1);
            CHECK(worst(second_order_fpm(), discrete, of_vibration_test).R < 20);
        }
    CHECK(bad > 0);
}

TEST_CASE("quality: a kernel that is wide against the spacing is not refused for that") {
    for (const auto& formulation : formulations<double>())
        for (const double ratio : {5.0, 30.0, 1000.0})
            CHECK(refusal(formulation, particles_of(40, {Volumes::equal, Gaussian{}, ratio}), of_static_test)
                      .empty());
}

TEST_CASE("quality: where no power of delta makes the error small, less is accepted") {
    // Two particles at each end, and a kernel that sees little beyond them.
    Column<double> x(13);
    x << 0, 1e-5, Column<double>::LinSpaced(9, 0.1, 0.9), 1 - 1e-5, 1;
    const auto discrete = numerical_tests::discretise<double>({Volumes::equal, Gaussian{}, 0.31}, x);
    const auto& chen_beraun = formulation_named<double>("chen_beraun");
    const auto row = worst(chen_beraun, discrete, of_derivative_test);
    CHECK(row.p() == 0);
    CHECK(row.R > 100);
    CHECK(row.R < 1000);
    CHECK_FALSE(refusal(chen_beraun, discrete, of_derivative_test).empty());
}

TEST_CASE(
    "quality: R is measured in the spacing from which h is taken, and does not depend on the unit of length") {
    const numerical_tests::Discretisation how{Volumes::equal, Gaussian{}, 1.4, 0.2, Spacing::local};
    const auto discrete = particles_of(40, how);
    CHECK((quality::spacing(discrete) - particles::spacing(discrete.line, Spacing::local)).abs().maxCoeff() <
          1e-15);
    const Column<double> x = 1000 * discrete.line.x() - 3;
    const auto in_mm = numerical_tests::discretise<double>(how, x);
    CHECK(R_of(in_mm) == support::relative(R_of(discrete), 1e-9));
    const Particles<double> of_a_length{discrete.line, {Gaussian{}, 0.03}};
    CHECK(quality::spacing(of_a_length).size() == 1);
    CHECK(quality::spacing(of_a_length)[0] == support::relative(1 / 39.0, 1e-12));
}
