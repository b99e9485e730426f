#include "fpm_in_space/section_5_static_test.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <type_traits>

#include "base/errors.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/polynomial.hpp"
#include "tests/support/relative.hpp"
#include "tests/support/remedies.hpp"

using namespace fpm_in_space;
using namespace fpm_in_space::static_test;
using derivative_test::exponential_and_wave;

namespace {

constexpr std::array all_conditions{Conditions::dirichlet, Conditions::mixed, Conditions::neumann};

/// Calls `check` for two and three dimensions, as compile-time numbers.
template <class Check>
void in_plane_and_space(const Check& check) {
    check(std::integral_constant<int, 2>{});
    check(std::integral_constant<int, 3>{});
}

/// h = 1.2 δ, the Gaussian lowered to zero at 3.5 h in the plane and at 3 h in space.
template <int dim>
Smoothing<double, dim> smoothing(const Column<double>& spacing) {
    return {particles::TruncatedGaussian<dim>(dim == 2 ? 3.5 : 3), spacing, 1.2};
}

template <int dim>
Column<double> spacing(const Cloud<dim>& cloud, Index n, double growth) {
    Column<double> all(cloud.size());
    for (Index i = 0; i < cloud.size(); ++i)
        all[i] =
            derivative_test::stretched_spacing<dim>(cloud.x().col(i), 1 / static_cast<double>(n - 1), growth);
    return all;
}

/// A particle cloud with the rows of a formulation on it.
template <int dim>
struct Test {
    Cloud<dim> cloud;
    Rows<dim> rows;

    [[nodiscard]] AtParticle largest(const Function<dim>& B, Conditions conditions) const {
        const Column<double> u = solution<dim>(rows, cloud, B, conditions);
        return static_test::largest(errors<dim>(rows, cloud, B, u), {0, cloud.size()});
    }
};

template <int dim>
Test<dim> test(std::string_view formulation, Index n, double perturbation, double growth = 1) {
    auto [cloud, on_sides] = derivative_test::body<dim>(n, perturbation, 1, growth);
    const Column<double> delta = spacing(cloud, n, growth);
    auto rows =
        static_test::rows(formulation_named<double, dim>(formulation), cloud, smoothing<dim>(delta), delta);
    return {std::move(cloud), std::move(rows)};
}

template <int dim>
Function<dim> polynomial(int degree) {
    return [p = support::Polynomial(dim, degree, 7)](const Point<dim>& x, const Exponents<dim>& a) {
        return p.derivative(support::powers(a), x);
    };
}

}  // namespace

TEST_CASE(
    "static test in space: with fluxes on a stretched grid the values of SSPH are useless, those of FPM are not") {
    const auto error = [](std::string_view formulation) {
        return test<2>(formulation, 16, 0, 10).largest(exponential_and_wave<2>, Conditions::neumann).value;
    };
    CHECK(error("definite_fpm") < 0.2);
    for (const char* ssph : {"ssph", "cubic_ssph"}) CHECK(error(ssph) > 100 * error("definite_fpm"));
}

TEST_CASE(
    "static test in space, (F17) and (F18): exact on quadratics, by every formulation, with all conditions") {
    in_plane_and_space([](auto dimension) {
        constexpr int dim = dimension;
        for (const auto& formulation : formulations<double, dim>()) {
            if (dim == 3 && formulation.name.starts_with("literal")) continue;
            // The literal extensions are near singular on perturbed particles.
            const bool literal = formulation.name.starts_with("literal");
            CAPTURE(formulation.name);
            const auto on = test<dim>(formulation.name, dim == 2 ? 10 : 6, literal ? 0 : 0.25);
            for (const Conditions conditions : all_conditions) {
                CAPTURE(static_cast<int>(conditions));
                const AtParticle most = on.largest(polynomial<dim>(2), conditions);
                CHECK(most.value < 1e-9);
                CHECK(most.first < 1e-8);
            }
        }
    });
}

TEST_CASE("static test in space: on stretched grids, too, and by SSPH of degree 3 on cubics") {
    in_plane_and_space([](auto dimension) {
        constexpr int dim = dimension;
        const Index n = dim == 2 ? 10 : 6;
        CHECK(test<dim>("definite_fpm", n, 0.25, 4).largest(polynomial<dim>(2), Conditions::mixed).value <
              1e-9);
        CHECK(test<dim>("cubic_ssph", n, 0).largest(polynomial<dim>(3), Conditions::mixed).value < 1e-9);
    });
}

TEST_CASE("static test in space, (F19): second order of values and first derivatives in the plane") {
    const auto coarse = test<2>("definite_fpm", 16, 0), fine = test<2>("definite_fpm", 31, 0);
    for (const Conditions conditions : all_conditions) {
        CAPTURE(static_cast<int>(conditions));
        const AtParticle before = coarse.largest(exponential_and_wave<2>, conditions),
                         after = fine.largest(exponential_and_wave<2>, conditions);
        CHECK(std::log2(before.value / after.value) == support::relative(2, 0.1));
        CHECK(std::log2(before.first / after.first) > 1.6);
    }
}

TEST_CASE(
    "static test in space: where a value side meets a flux side the value holds, and fluxes are added") {
    using Plane = Point<2>;
    CHECK(outward<2>(Plane(0.3, 0.7)) == Plane(0, 0));
    CHECK(outward<2>(Plane(1, 0.7)) == Plane(1, 0));
    CHECK(outward<2>(Plane(1, 1)) == Plane(1, 1));
    CHECK(outward<3>(Point<3>(1, 0, 0.5)) == Point<3>(1, -1, 0));
    CHECK(has_value<2>(Conditions::mixed, Plane(1, -1)));
    CHECK_FALSE(has_value<2>(Conditions::mixed, Plane(1, 1)));
    CHECK_FALSE(has_value<2>(Conditions::neumann, Plane(-1, -1)));
    const auto on = test<2>("definite_fpm", 9, 0);
    const Function<2> B = exponential_and_wave<2>;
    for (Index i = 0; i < on.cloud.size(); ++i) {
        const Row<2>& row = on.rows.all[static_cast<std::size_t>(i)];
        const Plane x = on.cloud.x().col(i);
        const Equation equation = equation_at<2>(row, x, B, Conditions::mixed);
        if (x == Plane(1, 1)) {
            CHECK(equation.given == B(x, {1, 0}) + B(x, {0, 1}));
            CHECK((equation.weights - row.first.rowwise().sum()).abs().maxCoeff() == 0);
        }
        if (x == Plane(1, 0)) {
            CHECK(equation.given == B(x, {}));
            CHECK(equation.weights[row.own] == 1);
            CHECK(equation.weights.abs().sum() == 1);
        }
    }
}

TEST_CASE("static test in space: with fluxes on all sides, the reaction finds the constant") {
    CHECK(reaction(Conditions::mixed) == 0);
    const auto on = test<2>("definite_fpm", 9, 0.25);
    const Function<2> five = [](const Point<2>&, const Exponents<2>& a) {
        return particles::order<2>(a) == 0 ? 5.0 : 0.0;
    };
    const Column<double> u = solution<2>(on.rows, on.cloud, five, Conditions::neumann);
    CHECK((u - 5).abs().maxCoeff() < 1e-10);
    const Row<2>& row = on.rows.all.front();
    CHECK(balance(row, 1, 3).weights[row.own] == row.laplacian[row.own] - 1);
    CHECK(balance(row, 1, 3).given == -3);
}

namespace {

/// A body whose corners at sides with loads have the sum of the normals.
template <int dim>
bodies::Body<dim> with_sums_of_normals(bodies::Body<dim> body) {
    for (auto& side : body.sides)
        for (auto& place : side.places)
            if (const Point<dim> n = outward<dim>(body.x.col(place.particle)); (n.array() >= 0).all())
                place.normal = n;
    return body;
}

/// The solution with values on left, bottom and back, or on all sides, by the library's bodies.
template <int dim>
Column<double> by_bodies(const Cloud<dim>& cloud, const bodies::Body<dim>& body, Conditions conditions) {
    const Function<dim> B = exponential_and_wave<dim>;
    const auto along = [](int axis, int order) {
        Exponents<dim> a{};
        a[static_cast<std::size_t>(axis)] = order;
        return a;
    };
    bodies::Problem<dim, 1> problem{bodies::diffusion<dim>([](const Point<dim>&) { return 1.0; })};
    problem.equation.b = [=](const Point<dim>& x) {
        double sum = 0;
        for (int axis = 0; axis < dim; ++axis) sum -= B(x, along(axis, 2));
        return bodies::Values<1>(sum);
    };
    for (const auto& side : body.sides) {
        bodies::Given<dim, 1> given{side.name};
        const bool loaded = side.name == "right" || side.name == "top" || side.name == "front";
        if (conditions == Conditions::mixed && loaded)
            given.loads.push_back([=](const Point<dim>& x, const Point<dim>& n) {
                double sum = 0;
                for (int axis = 0; axis < dim; ++axis) sum += n[axis] * B(x, along(axis, 1));
                return bodies::Values<1>(sum);
            });
        else
            given.value[0] = [=](const Point<dim>& x) { return B(x, {}); };
        problem.given.push_back(given);
    }
    bodies::Discretisation how;
    how.spacing = particles::Spacing::mean;
    const auto solved = bodies::solve<dim, 1>(problem, body, how);
    REQUIRE(solved.approximation.cloud().x() == cloud.x());
    return solved.u().array();
}

}  // namespace

TEST_CASE("static test in space: the solution is that of the library's bodies, written apart") {
    in_plane_and_space([](auto dimension) {
        constexpr int dim = dimension;
        support::Block<dim> block;
        block.n.fill(dim == 2 ? 14 : 6);
        block.amplitude = 0.2;
        const bodies::Body<dim> body = with_sums_of_normals(support::block<dim>(block));
        const Cloud<dim> cloud(body.x);
        const Column<double> delta = Column<double>::Constant(1, cloud.spacing());
        const auto own = static_test::rows(formulation_named<double, dim>("definite_fpm"), cloud,
                                           smoothing<dim>(delta), delta);
        for (const Conditions conditions : {Conditions::dirichlet, Conditions::mixed}) {
            const Column<double> u = solution<dim>(own, cloud, exponential_and_wave<dim>, conditions),
                                 v = by_bodies<dim>(cloud, body, conditions);
            CHECK((u - v).abs().maxCoeff() < 1e-9);
        }
    });
}

TEST_CASE("static test in space: a large system is solved by iteration, and as by factorisation") {
    const auto large = test<2>("definite_fpm", 65, 0.25);
    REQUIRE(large.rows.nearest.size() == large.rows.all.size());
    const Column<double> u = solution<2>(large.rows, large.cloud, exponential_and_wave<2>, Conditions::mixed),
                         v = solution<2>({large.rows.all, {}}, large.cloud, exponential_and_wave<2>,
                                         Conditions::mixed);
    CHECK((u - v).abs().maxCoeff() < 1e-9);
}

TEST_CASE("static test in space: the largest of each number in a place, and the particle of the value") {
    const AtParticle most = static_test::largest({{0, 9, 9, 9}, {1, 1, 3, 1}, {2, 2, 1, 4}}, {1, 3});
    CHECK(most.particle == 2);
    CHECK(most.value == 2);
    CHECK(most.first == 3);
    CHECK(most.R == 4);
}

TEST_CASE("static test in space: what cannot be solved is refused, with what to do") {
    CHECK_THROWS_WITH_AS(conditions_named("robin"),
                         "there is no condition 'robin'; choose one of dirichlet, mixed, neumann",
                         base::InvalidInput);
    const auto& formulation = formulation_named<double, 2>("definite_fpm");
    const Column<double> delta = Column<double>::Constant(1, 0.125);
    const auto [cloud, on_sides] = derivative_test::body<2>(9, 0, 1);
    const auto refused = [&](const Cloud<2>& moved, const char* why) {
        CHECK_THROWS_WITH_AS(static_test::rows(formulation, moved, smoothing<2>(delta), delta), why,
                             base::InvalidInput);
    };
    refused(Cloud<2>(particles::Points<2>(0.5 * cloud.x())),
            "the static test needs particles on all sides, and there is none with x = 1; add them");
    refused(
        Cloud<2>(particles::Points<2>(cloud.x().array() + 1)),
        "the static test needs particles between 0 and 1 along each axis, and particle 0 lies at x = (1.125, 1.375); move and scale them");
    const auto rows = static_test::rows(formulation, cloud, smoothing<2>(delta), delta);
    CHECK_THROWS_AS(static_cast<void>(solution<2>(
                        rows, cloud, [](const Point<2>& x, const Exponents<2>&) { return 1 / x[0]; },
                        Conditions::dirichlet)),
                    base::InvalidInput);
    CHECK_THROWS_AS(static_test::rows(formulation, cloud, smoothing<2>(0.5 * delta), delta),
                    base::FailedComputation);
}

TEST_CASE("static test in space: a Laplacian that cannot be trusted is refused, with what was tried") {
    // One particle sees three layers, at unequal distances and but for small moves.
    support::Draws draw(1);
    particles::Points<2> x(2, 21 * 11);
    for (Index j = 0; j < x.cols(); ++j) {
        const Index k = j % 21, l = j / 21;
        x.col(j) =
            Point<2>(static_cast<double>(k) / 20, derivative_test::stretched(static_cast<double>(l) / 10, 4));
        if (k > 0 && k < 20 && l > 0 && l < 10) x.col(j) += 5e-5 * draw.point<2>();
    }
    const Cloud<2> cloud(x);
    Column<double> delta = Column<double>::Constant(cloud.size(), 0.1);
    delta[5 * 21 + 10] = 0.03;
    const auto refused = [&](double ratio) {
        return support::refusal([&] {
            const Smoothing<double, 2> smoothing(particles::TruncatedGaussian<2>(3.5), delta, ratio);
            return static_test::rows(formulation_named<double, 2>("definite_fpm"), cloud, smoothing, delta);
        });
    };
    const std::string why = refused(1.2);
    CAPTURE(why);
    REQUIRE(why.starts_with("definite_fpm: the Laplacian of particle 115 "));
    CHECK(why.find("; take another formulation, or try --smoothing ") != std::string::npos);
    CHECK(refused(support::smoothing_to_try(why)).empty());
}
