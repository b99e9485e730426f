#include "asprone2010/section_5_3_vibration_test.hpp"

#include "tests/support/lines.hpp"

using namespace asprone2010;
using namespace asprone2010::vibration_test;
using support::particles_of;

namespace {

std::vector<double> ratios(std::string_view name, particles::Volumes volumes = particles::Volumes::equal,
                           Index N = 100) {
    std::vector<double> ratio;
    for (const auto& omega : frequencies(formulation_named<double>(name), particles_of(N, {volumes})))
        ratio.push_back(omega.real() / exact_frequency(static_cast<Index>(ratio.size()) + 1));
    return ratio;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
    double largest = 0;
    for (std::size_t k = 0; k < a.size(); ++k) largest = std::max(largest, std::abs(a[k] - b[k]));
    return largest;
}

}  // namespace

TEST_CASE("(52): frequencies are ordered by their real part, then by their imaginary part") {
    CHECK(lower({1, 2}, {2, 1}));
    CHECK_FALSE(lower({2, 1}, {1, 2}));
    CHECK(lower({1, -1}, {1, 1}));
    CHECK_FALSE(lower({1, 1}, {1, -1}));
    CHECK_FALSE(lower({1, 1}, {1, 1}));
}

TEST_CASE("(52): the lowest modes are those of the whole spectrum, on any particles, with small residuals") {
    for (const char* name : {"second_order_fpm", "modified_fpm", "chen_beraun"})
        for (const double perturbation : {0.0, 0.2}) {
            const auto discrete =
                particles_of(120, {particles::Volumes::equal, particles::Gaussian{}, 1, perturbation});
            const auto all = frequencies(formulation_named<double>(name), discrete);
            const auto lowest = lowest_modes(
                formulation_named<double>(name).operators(discrete.line, discrete.smoothing).D2, 10);
            REQUIRE(lowest.size() == 10);
            for (std::size_t k = 0; k < lowest.size(); ++k) {
                CHECK(lowest[k].frequency.real() == support::relative(all[k].real(), 1e-9));
                CHECK(lowest[k].residual < 1e-9);
            }
        }
}

TEST_CASE(
    "(52): on long lines the lowest frequencies are exact to more digits than the round-off of D² has") {
    const auto discrete = particles_of(30000);
    const auto D2 =
        formulation_named<double>("second_order_fpm").operators(discrete.line, discrete.smoothing).D2;
    Index n = 0;
    for (const Mode& mode : lowest_modes(D2, 3)) {
        ++n;
        CHECK(mode.frequency.real() ==
              support::relative(exact_frequency(n), 3e-9 * static_cast<double>(n * n)));
    }
}

TEST_CASE("(46): K is D² without the rows and columns of the ends") {
    const auto [line, smoothing] = particles_of(20);
    const auto D2 = formulation_named<double>("chen_beraun").operators(line, smoothing).D2;
    const Eigen::MatrixXd K = stiffness(D2);
    REQUIRE(K.rows() == 18);
    for (Index i = 0; i < 18; ++i)
        for (Index j = 0; j < 18; ++j) CHECK(K(i, j) == D2.coeff(i + 1, j + 1));
}

TEST_CASE(
    "claims A-5.3-end-conditions, A-5.3-printed-47: sin(ωX) cos(ωt) with ω = πn satisfies (47), (48), (49), (50) and (51) with our signs; with the printed sign (47) leaves −2ω²x") {
    for (const Index n : {1, 2, 7}) {
        const double omega = exact_frequency(n), X = 0.3, t = 0.11, step = 1e-4;
        CHECK(std::abs(mode(omega, 1)) < 1e-14);
        CHECK(mode(omega, 0) == 0);
        const auto x = [&](double at, double when) { return mode(omega, at) * std::cos(omega * when); };
        const double d2x_dX2 = (x(X + step, t) - 2 * x(X, t) + x(X - step, t)) / (step * step);
        const double d2x_dt2 = (x(X, t + step) - 2 * x(X, t) + x(X, t - step)) / (step * step);
        const double size = omega * omega * std::abs(x(X, t));
        CHECK(std::abs(unbalance(d2x_dX2, d2x_dt2)) < 1e-5 * size);
        CHECK(d2x_dt2 == support::relative(acceleration(omega, x(X, t)), 1e-5));
        CHECK(std::abs(stationary_unbalance(d2x_dX2, omega, x(X, t))) < 1e-5 * size);
        CHECK(unbalance(d2x_dX2, -d2x_dt2) == support::relative(-2 * omega * omega * x(X, t), 1e-5));
    }
}

TEST_CASE("(52): the eigenvalues of K are −ω²") {
    const Eigen::Matrix2d K{{-4, 0}, {0, -9}};
    CHECK(frequencies(K)[0] == std::complex<double>(2, 0));
    CHECK(frequencies(K)[1] == std::complex<double>(3, 0));
    const auto unstable = frequencies(Eigen::Matrix2d{{4, 0}, {0, -9}});
    CHECK(unstable[0].real() == doctest::Approx(0));
    CHECK(std::abs(unstable[0].imag()) == doctest::Approx(2));
}

TEST_CASE("5.3: ratios with 100 particles are those of an independent calculation") {
    CHECK(ratios("original").front() == support::relative(0.664, 1e-3));
    CHECK(ratios("chen_beraun").front() == support::relative(0.9999, 1e-4));
    CHECK(ratios("second_order_fpm").back() == support::relative(0.587, 1e-3));
    CHECK(ratios("second_order_fpm").size() == 98);
}

TEST_CASE(
    "claims A-5.3-lowest-*, A-5.3-decrease-*: original and RKPM spectra underestimate even the lowest mode and fall rapidly") {
    for (const auto volumes : {particles::Volumes::equal, particles::Volumes::partition}) {
        for (const char* name : {"original", "rkpm_first_order"}) {
            CHECK(ratios(name, volumes).front() < 0.7);
            CHECK(ratios(name, volumes)[1] < 0.55);
        }
        CHECK(ratios("rkpm_second_order", volumes).front() < 0.96);
        CHECK(ratios("rkpm_second_order", volumes)[1] < 0.7);
    }
}

TEST_CASE("claim A-5.3-original-overlaps: the spectra of original and first-order RKPM overlap") {
    CHECK(largest_difference(ratios("original"), ratios("rkpm_first_order")) < 0.005);
    CHECK(largest_difference(ratios("original", particles::Volumes::partition),
                             ratios("rkpm_first_order", particles::Volumes::partition)) < 0.016);
}

TEST_CASE(
    "claims A-5.3-fpm-overlap, A-5.3-low-frequencies, A-5.3-finite-elements: Chen–Beraun, modified and second-order FPM overlap, predict low modes well and resemble lumped FEM") {
    const auto chen_beraun = ratios("chen_beraun"), modified = ratios("modified_fpm"),
               second_order = ratios("second_order_fpm");
    CHECK(largest_difference(chen_beraun, modified) < 1e-3);
    CHECK(largest_difference(modified, second_order) < 1e-3);
    for (std::size_t n = 1; n <= 10; ++n) CHECK(second_order[n - 1] > 0.99);
    const auto fem = finite_element_frequencies(particles_of(100).line, Mass::lumped);
    CHECK(fem.back().real() / exact_frequency(98) == support::relative(0.643, 1e-3));
    for (std::size_t k = 0; k < 98; ++k)
        CHECK(std::abs(fem[k].real() / exact_frequency(static_cast<Index>(k) + 1) - second_order[k]) < 0.06);
}

TEST_CASE("5.3: finite elements match their closed forms, lumped and consistent") {
    const Index N = 100;
    const auto line = particles_of(N).line;
    const double l = line.spacing();
    const auto lumped = finite_element_frequencies(line, Mass::lumped);
    const auto consistent = finite_element_frequencies(line, Mass::consistent);
    REQUIRE(lumped.size() == 98);
    for (Index n = 1; n <= 98; ++n) {
        const double phase = std::acos(-1.0) * static_cast<double>(n) * l, c = std::cos(phase);
        CHECK(lumped[static_cast<std::size_t>(n - 1)].real() ==
              support::relative(std::sqrt(2 * (1 - c)) / l, 1e-10));
        CHECK(consistent[static_cast<std::size_t>(n - 1)].real() ==
              support::relative(std::sqrt(6 * (1 - c) / (2 + c)) / l, 1e-10));
    }
}

TEST_CASE(
    "5.3: the lowest modes of lumped finite elements are those of the whole spectrum, on any particles") {
    for (const Index N : {60, 5}) {
        numerical_tests::Discretisation how;
        how.perturbation = 0.25;
        const auto line = numerical_tests::discretise<double>(how, N, 3).line;
        const auto all = finite_element_frequencies(line, Mass::lumped);
        const auto lowest = lowest_modes(lumped_second_derivative(line), std::min<Index>(N - 4, 8));
        for (std::size_t n = 0; n < lowest.size(); ++n) {
            CHECK(lowest[n].frequency.real() == support::relative(all[n].real(), 1e-10));
            CHECK(lowest[n].residual < 1e-9);
        }
    }
}
