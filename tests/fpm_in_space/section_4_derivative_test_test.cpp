#include "fpm_in_space/section_4_derivative_test.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/errors.hpp"
#include "fpm_in_space/claims/measures.hpp"
#include "tests/support/relative.hpp"

using namespace fpm_in_space;
using namespace fpm_in_space::derivative_test;

namespace {

/// Calls `check` for two and three dimensions, as compile-time numbers.
template <class Check>
void in_plane_and_space(const Check& check) {
    check(std::integral_constant<int, 2>{});
    check(std::integral_constant<int, 3>{});
}

template <int dim>
std::vector<Range> places_of(const Body<dim>& body) {
    return {body.on_sides.begin(), body.on_sides.end()};
}

/// The errors of a formulation by place; h = 1.2 δ, the Gaussian lowered to zero at 3h.
template <int dim>
std::vector<AtParticle> largest_errors(Index n, double perturbation, unsigned long seed, Index sample,
                                       std::string_view formulation = "definite_fpm") {
    const Body<dim> cube = body<dim>(n, perturbation, seed);
    const double delta = 1 / static_cast<double>(n - 1);
    const Smoothing<double, dim> smoothing(particles::TruncatedGaussian<dim>(3), 1.2 * delta);
    std::vector<Range> places = places_of(cube);
    for (Range& place : places) place.last = std::min(place.last, place.first + sample);
    std::vector<AtParticle> all;
    for (const auto& there :
         errors(formulation_named<double, dim>(formulation), cube.cloud, smoothing,
                particles::Column<double>::Constant(1, delta), exponential_and_wave<dim>, places))
        all.push_back(largest(there));
    return all;
}

}  // namespace

TEST_CASE("derivative test in space, (F14): the function's derivatives are those of its differences") {
    in_plane_and_space([](auto dimension) {
        constexpr int dim = dimension;
        const Point<dim> x = Point<3>(0.3, 0.6, 0.9).head<dim>();
        const double step = 1e-4;
        for (int one = 0; one < dim; ++one) {
            Exponents<dim> first{};
            first[static_cast<std::size_t>(one)] = 1;
            const Point<dim> e = step * Point<dim>::Unit(one);
            const auto difference = [&](const Exponents<dim>& a) {
                return (exponential_and_wave<dim>(x + e, a) - exponential_and_wave<dim>(x - e, a)) /
                       (2 * step);
            };
            CHECK(exponential_and_wave<dim>(x, first) == support::relative(difference({}), 1e-6));
            for (int other = 0; other < dim; ++other) {
                Exponents<dim> before{}, second{};
                before[static_cast<std::size_t>(other)] = 1;
                second = before;
                ++second[static_cast<std::size_t>(one)];
                CHECK(exponential_and_wave<dim>(x, second) == support::relative(difference(before), 1e-6));
            }
        }
    });
}

TEST_CASE("derivative test in space: particles are counted by the sides that they lie on") {
    const Body<2> square = body<2>(5, 0.25, 1);
    const Body<3> cube = body<3>(5, 0.25, 1);
    CHECK(square.on_sides[0].size() == 9);
    CHECK(square.on_sides[1].size() == 12);
    CHECK(square.on_sides[2].size() == 4);
    CHECK(cube.on_sides[0].size() == 27);
    CHECK(cube.on_sides[1].size() == 54);
    CHECK(cube.on_sides[2].size() == 36);
    CHECK(cube.on_sides[3].size() == 8);
    CHECK(cube.on_sides[3].last == cube.cloud.size());
}

TEST_CASE(
    "derivative test in space, (F15): perturbed particles keep to their sides, and the seed decides them") {
    in_plane_and_space([](auto dimension) {
        constexpr int dim = dimension;
        const Body<dim> moved = body<dim>(7, 0.25, 3), again = body<dim>(7, 0.25, 3),
                        other = body<dim>(7, 0.25, 4);
        CHECK(moved.cloud.x() == again.cloud.x());
        CHECK((moved.cloud.x() - other.cloud.x()).cwiseAbs().maxCoeff() > 0.01);
        for (int sides = 0; sides <= dim; ++sides)
            for (Index j = moved.on_sides[static_cast<std::size_t>(sides)].first;
                 j < moved.on_sides[static_cast<std::size_t>(sides)].last; ++j) {
                int on_sides = 0;
                for (const double coordinate : moved.cloud.x().col(j)) {
                    on_sides += coordinate == 0 || coordinate == 1 ? 1 : 0;
                    const double cells = 6 * coordinate;
                    CHECK(std::abs(cells - std::round(cells)) <= 0.25);
                }
                CHECK(on_sides == sides);
            }
    });
}

namespace {

/// Largest errors of a formulation on a grid of n × n particles, h = δ.
AtParticle on_grid(const Formulation<double, 2>& formulation, Index n) {
    const Body<2> square = body<2>(n, 0, 1);
    const double delta = 1 / static_cast<double>(n - 1);
    return largest(errors<2>(formulation, square.cloud, {particles::Gaussian<2>{}, delta},
                             particles::Column<double>::Constant(1, delta), exponential_and_wave<2>,
                             {{0, square.cloud.size()}})[0]);
}

}  // namespace

TEST_CASE("derivative test in space, (F16): largest errors on grids are those of a calculation in NumPy") {
    const auto& formulation = formulation_named<double, 2>("definite_fpm");
    const AtParticle coarse = on_grid(formulation, 16), middle = on_grid(formulation, 31),
                     fine = on_grid(formulation, 61);
    CHECK(coarse.first == support::relative(1.347e-2, 1e-3));
    CHECK(coarse.second == support::relative(5.688e-2, 1e-3));
    CHECK(middle.first == support::relative(3.565e-3, 1e-3));
    CHECK(middle.second == support::relative(1.401e-2, 1e-3));
    CHECK(fine.first == support::relative(9.098e-4, 1e-3));
    CHECK(fine.second == support::relative(3.473e-3, 1e-3));
}

TEST_CASE(
    "derivative test in space: errors of SSPH with the value given are those of that calculation, too, of second order in second derivatives from degree 3 on") {
    const Formulation<double, 2> quadratic{"quadratic", "", 6, {2, 2}, ssph_with_value_given<2, double, 2>};
    const Formulation<double, 2> cubic{"cubic", "", 10, {3, 3}, ssph_with_value_given<3, double, 2>};
    const AtParticle coarse = on_grid(quadratic, 16), middle = on_grid(quadratic, 31),
                     fine = on_grid(quadratic, 61), by_cubic = on_grid(cubic, 61);
    CHECK(middle.first == support::relative(4.197e-3, 1e-3));
    CHECK(middle.second == support::relative(3.340e-1, 1e-3));
    CHECK(std::log2(coarse.second / fine.second) / 2 == support::relative(0.98, 0.01));
    CHECK(by_cubic.first == support::relative(1.474e-5, 1e-3));
    CHECK(by_cubic.second == support::relative(3.473e-3, 1e-3));
}

namespace {

/// Checks the orders of both derivatives at each place. \param finer ratio of the spacings
void check_second_order(const std::vector<AtParticle>& coarse, const std::vector<AtParticle>& fine,
                        double finer, double tolerance) {
    for (std::size_t place = 0; place < coarse.size(); ++place) {
        CAPTURE(place);
        CHECK(std::log(coarse[place].first / fine[place].first) / std::log(finer) ==
              support::relative(2, tolerance));
        CHECK(std::log(coarse[place].second / fine[place].second) / std::log(finer) ==
              support::relative(2, tolerance));
    }
}

}  // namespace

TEST_CASE(
    "derivative test in space: second order of both derivatives inside, at edges and corners of grids") {
    const Index every = 1000;  // of the edges
    check_second_order(largest_errors<2>(31, 0, 1, every), largest_errors<2>(121, 0, 1, every), 4, 0.05);
}

TEST_CASE("derivative test in space: on grids SSPH of degree 2 is of first order in D² where a side ends") {
    const auto coarse = largest_errors<2>(31, 0, 1, 200, "ssph"),
               fine = largest_errors<2>(61, 0, 1, 300, "ssph");
    CHECK(std::log2(coarse[1].second / fine[1].second) == support::relative(1, 0.05));
}

TEST_CASE(
    "derivative test in space: second order of both derivatives inside, at edges and corners of perturbed particles") {
    check_second_order(largest_errors<2>(31, 0.25, 1, 100), largest_errors<2>(121, 0.25, 1, 100), 4, 0.15);
    check_second_order(largest_errors<3>(12, 0.25, 1, 60), largest_errors<3>(34, 0.25, 1, 60), 3, 0.2);
}

TEST_CASE("derivative test in space: the eigenvalues of a membrane on perturbed particles are positive") {
    for (const double least : claims::least_eigenvalues<2>("definite_fpm"))
        CHECK(least == support::relative(1, 0.02));
}

TEST_CASE("derivative test in space: errors do not depend on which particles are asked for together") {
    const Body<2> square = body<2>(31, 0.25, 2);
    const double delta = 1.0 / 30;
    const Smoothing<double, 2> smoothing(particles::TruncatedGaussian<2>(3.5), 1.2 * delta);
    const auto& formulation = formulation_named<double, 2>("definite_fpm");
    const auto spacing = particles::Column<double>::Constant(1, delta).eval();
    const auto all = errors(formulation, square.cloud, smoothing, spacing, exponential_and_wave<2>,
                            {Range{0, square.cloud.size()}})[0];
    REQUIRE(all.size() == 961);
    const auto by_place =
        errors(formulation, square.cloud, smoothing, spacing, exponential_and_wave<2>, places_of(square));
    for (const auto& there : by_place)
        for (const AtParticle& at : there) {
            const AtParticle& same = all[static_cast<std::size_t>(at.particle)];
            CHECK(same.particle == at.particle);
            CHECK(same.first == at.first);
            CHECK(same.second == at.second);
            CHECK(same.laplacian == at.laplacian);
            CHECK(same.R == at.R);
        }
}

TEST_CASE("derivative test in space: the error of the Laplacian is that of the sum of its rows") {
    const Body<2> square = body<2>(9, 0.2, 3);
    const double delta = 1.0 / 8;
    const Smoothing<double, 2> smoothing(particles::TruncatedGaussian<2>(3.5), 1.2 * delta);
    const auto& formulation = formulation_named<double, 2>("ssph");
    const auto found =
        errors(formulation, square.cloud, smoothing, particles::Column<double>::Constant(1, delta),
               exponential_and_wave<2>, {Range{0, square.cloud.size()}})[0];
    const auto operators = particles::assemble(square.cloud, smoothing, formulation.required(),
                                               formulation.weights, {0, square.cloud.size()});
    particles::Column<double> B(square.cloud.size()), exact(square.cloud.size());
    for (Index i = 0; i < B.size(); ++i) {
        const Point<2> x = square.cloud.x().col(i);
        B[i] = exponential_and_wave<2>(x, {0, 0});
        exact[i] = exponential_and_wave<2>(x, {2, 0}) + exponential_and_wave<2>(x, {0, 2});
    }
    const particles::Column<double> laplacian =
        particles::apply(particles::derivative(operators, Exponents<2>{2, 0}), B) +
        particles::apply(particles::derivative(operators, Exponents<2>{0, 2}), B);
    for (const AtParticle& at : found)
        CHECK(at.laplacian == support::relative(std::abs(laplacian[at.particle] - exact[at.particle]), 1e-9));
}

TEST_CASE("derivative test in space: the error is at most what R says, for a function of known derivatives") {
    const Body<2> square = body<2>(21, 0.25, 5);
    const double delta = 1.0 / 20;
    const Smoothing<double, 2> smoothing(particles::TruncatedGaussian<2>(3.5), 1.2 * delta);
    const Function<2> wave = [](const Point<2>& x,
                                const Exponents<2>& a) {  // all derivatives along lines ≤ 1
        const double s = (x[0] + x[1]) / std::sqrt(2), order = particles::order<2>(a);
        return std::sin(s + order * std::acos(0.0)) / std::pow(2, order / 2);
    };
    const auto all =
        errors(formulation_named<double, 2>("definite_fpm"), square.cloud, smoothing,
               particles::Column<double>::Constant(1, delta), wave, {Range{0, square.cloud.size()}});
    double nearest = 0;
    for (const AtParticle& at : all[0]) {
        CHECK(at.second <= at.R * delta * delta);
        nearest = std::max(nearest, at.second / (at.R * delta * delta));
    }
    CHECK(nearest > 0.1);  // the bound is no mere bound
}

TEST_CASE(
    "derivative test in space: the largest of each number, and the particle of the second derivatives") {
    const AtParticle most = largest({{7, 3, 1, 6, 9}, {8, 1, 2, 2, 4}, {9, 2, 1, 7, 5}});
    CHECK(most.particle == 8);
    CHECK(most.first == 3);
    CHECK(most.second == 2);
    CHECK(most.laplacian == 7);
    CHECK(most.R == 9);
}

TEST_CASE("derivative test in space: what cannot be tested is refused") {
    CHECK_THROWS_WITH_AS(body<2>(2, 0, 1), "a side needs at least 3 particles, got 2", base::InvalidInput);
    CHECK_THROWS_WITH_AS(body<3>(5, 0.5, 1), "the perturbation must lie in [0, 1/2), got 0.5",
                         base::InvalidInput);
    CHECK_THROWS_AS(body<3>(5, std::numeric_limits<double>::quiet_NaN(), 1), base::InvalidInput);
    const Body<2> square = body<2>(9, 0, 1);
    const Smoothing<double, 2> smoothing(particles::Gaussian<2>{}, 0.125);
    CHECK_THROWS_AS(errors(formulation_named<double, 2>("definite_fpm"), square.cloud, smoothing,
                           particles::Column<double>::Constant(1, 0.125),
                           [](const Point<2>& x, const Exponents<2>&) { return 1 / x[0]; },
                           {Range{0, square.cloud.size()}}),
                    base::InvalidInput);
}

TEST_CASE(
    "derivative test in space: distances of a stretched grid grow by the factor, and sides stay sides") {
    CHECK(stretched(0.3, 1) == 0.3);
    for (const double growth : {0.1, 10.0}) {
        CHECK(stretched(0, growth) == 0);
        CHECK(stretched(1, growth) == 1);
        const double first = stretched(1e-4, growth), last = 1 - stretched(1 - 1e-4, growth);
        CHECK(last / first == support::relative(growth, 1e-3));
        CHECK(stretched_spacing<2>(Point<2>(0, 0), 1e-4, growth) == support::relative(first, 1e-3));
        CHECK(stretched_spacing<3>(Point<3>(0, 1, 0), 1e-4, growth) ==
              support::relative(std::max(first, last), 1e-3));
    }
    const Body<2> square = body<2>(9, 0.25, 1), mapped = body<2>(9, 0.25, 1, 10);
    for (Index j = 0; j < square.cloud.size(); ++j)
        for (Index axis = 0; axis < 2; ++axis)
            CHECK(mapped.cloud.x()(axis, j) == stretched(square.cloud.x()(axis, j), 10));
    CHECK_THROWS_WITH_AS(stretched(0.5, 0), "distances grow by a factor from 0.001 to 1000, got 0",
                         base::InvalidInput);
}
