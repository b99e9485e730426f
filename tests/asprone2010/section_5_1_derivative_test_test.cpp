#include "asprone2010/section_5_1_derivative_test.hpp"

#include "tests/support/claims.hpp"
#include "tests/support/lines.hpp"

using namespace asprone2010;
using particles::Gaussian;
using particles::Volumes;
using support::expected;
using support::particles_of;

namespace {

derivative_test::Errors<double> errors(std::string_view name, Index N,
                                       const numerical_tests::Discretisation& how = {},
                                       unsigned long seed = 1) {
    return derivative_test::errors(formulation_named<double>(name), particles_of(N, how, seed),
                                   derivative_test::exponential<double>());
}

/// Observed order of one of the errors over these numbers of particles.
template <class Which>
double order(std::string_view name, const std::vector<Index>& particles, const Which& which,
             const numerical_tests::Discretisation& how = {}) {
    std::vector<double> spacing, error;
    for (const Index N : particles) {
        spacing.push_back(1.0 / static_cast<double>(N - 1));
        error.push_back(which(errors(name, N, how)));
    }
    return report::observed_order(spacing, error);
}

const std::vector<Index> fine{320, 640, 1280};
const auto first = [](const auto& e) { return e.first; };
const auto second = [](const auto& e) { return e.second; };
const auto first_interior = [](const auto& e) { return *e.first_interior; };
const auto second_interior = [](const auto& e) { return *e.second_interior; };

}  // namespace

TEST_CASE("5.1: errors for eˣ with 1280 particles are those of an independent calculation") {
    CHECK(errors("second_order_fpm", 1280).second == support::relative(1.526e-6, 1e-3));
    CHECK(errors("modified_fpm", 1280).second == support::relative(2.153e-3, 1e-3));
    CHECK(errors("chen_beraun", 1280).second == support::relative(2.91335, 1e-4));
}

TEST_CASE(
    "claims A-5.1-*: original, both RKPMs and Chen–Beraun do not converge, modified FPM is first and second-order FPM second order") {
    for (const auto volumes : {Volumes::equal, Volumes::partition}) {
        const numerical_tests::Discretisation how{volumes};
        for (const char* name : {"original", "rkpm_first_order", "rkpm_second_order"})
            CHECK(order(name, fine, second, how) == support::relative(-1, 0.05));
        CHECK(std::abs(order("chen_beraun", fine, second, how)) < 0.01);
        CHECK(std::abs(order("fpm", fine, second, how)) < 0.01);
        CHECK(order("modified_fpm", fine, second, how) ==
              support::relative(expected("A-5.1-modified-fpm"), 0.01));
        CHECK(order("second_order_fpm", fine, second, how) ==
              support::relative(expected("A-5.1-second-order-fpm"), 0.01));
    }
}

TEST_CASE("5.1: the first derivative converges with the orders of Sections 3 and 4") {
    CHECK(std::abs(order("original", fine, first)) < 0.01);
    CHECK(order("chen_beraun", fine, first) == support::relative(1, 0.01));
    CHECK(order("fpm", fine, first) == support::relative(1, 0.01));
    CHECK(order("modified_fpm", fine, first) == support::relative(2, 0.01));
    CHECK(order("second_order_fpm", fine, first) == support::relative(2, 0.01));
}

TEST_CASE(
    "claims A-3.2-*-inside, A-3.4-DB-inside, A-3.5-*-inside: inside, the corrected formulations are second order on uniform particles") {
    for (const char* name : {"chen_beraun", "modified_fpm", "second_order_fpm"}) {
        CHECK(order(name, fine, first_interior) == support::relative(2, 0.01));
        CHECK(order(name, fine, second_interior) == support::relative(2, 0.01));
    }
    CHECK(order("fpm", fine, first_interior) == support::relative(2, 0.01));
}

TEST_CASE(
    "claim A-5.1-perturbed: on perturbed particles the second-order FPM keeps order two in the median over seeds") {
    std::vector<double> spacing, median;
    for (const Index N : {80, 160, 320, 640}) {
        std::vector<double> sample;
        for (unsigned long seed = 1; seed <= 51; ++seed)
            sample.push_back(
                errors("second_order_fpm", N, {Volumes::equal, Gaussian{}, 1, 0.25}, seed).second);
        spacing.push_back(1.0 / static_cast<double>(N - 1));
        median.push_back(report::quartiles(sample).median);
    }
    CHECK(report::observed_order(spacing, median) == support::relative(expected("A-5.1-perturbed"), 0.05));
}

TEST_CASE(
    "5.1: interior particles are farther than the support's radius from both ends; few particles have none") {
    CHECK_FALSE(errors("second_order_fpm", 13).second_interior.has_value());
    CHECK(errors("second_order_fpm", 15).second_interior.has_value());
    CHECK(errors("modified_fpm", 100).second_interior.value() < errors("modified_fpm", 100).second / 10);
    CHECK(errors("modified_fpm", 4, {Volumes::equal, particles::CubicSpline{}, 1.5, 0}).first > 0);
}

TEST_CASE("5.1: each error is that of its own derivative, everywhere and inside") {
    const base::Smooth<> off_by_two_and_three{
        [](double x) { return x * x; }, [](double x) { return 2 * x + 2; }, [](double) { return 2.0 + 3; }};
    const auto of = derivative_test::errors(formulation_named<double>("second_order_fpm"), particles_of(50),
                                            off_by_two_and_three);
    CHECK(of.first == support::relative(2, 1e-10));
    CHECK(of.first_interior.value() == support::relative(2, 1e-10));
    CHECK(of.second == support::relative(3, 1e-10));
    CHECK(of.second_interior.value() == support::relative(3, 1e-10));
}
