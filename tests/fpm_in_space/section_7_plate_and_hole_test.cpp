#include "fpm_in_space/section_7_plate_and_hole.hpp"

#include <doctest/doctest.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "bodies/solution.hpp"
#include "fpm_in_space/section_1_second_order_fpm.hpp"
#include "tests/batra2008/elastic.hpp"
#include "tests/support/bodies_of_batra2008.hpp"
#include "tests/support/remedies.hpp"

using namespace fpm_in_space;
using namespace fpm_in_space::plate_and_hole;
namespace hole = batra2008::hole;
namespace plate = batra2008::plate;

namespace {

/// Displacement of a solution and of the problem: largest difference at the particles, over the largest.
double relative_error(const Cloud<2>& cloud, const Solution& solution, const Problem& problem) {
    double error = 0, largest = 0;
    for (Index I = 0; I < cloud.size(); ++I) {
        const Point<2> x = cloud.x().col(I);
        error = std::max(error, (state_at(cloud, solution, x).u - problem.exact.u(x)).norm());
        largest = std::max(largest, problem.exact.u(x).norm());
    }
    return error / largest;
}

/// The relative difference of the displacements from those that the library for bodies finds.
double difference_from_body(const bodies::Problem<2, 2>& problem, const bodies::Body<2>& body,
                            const Problem& same) {
    bodies::Discretisation how;
    how.method = bodies::Method::fpm;
    const auto expected = bodies::solve(problem, body, how);
    const Solution found = solve(same, Cloud<2>(body.x), {how.smoothing, particles::Spacing::local});
    double difference = 0;
    for (Index I = 0; I < body.x.cols(); ++I)
        for (Index i = 0; i < 2; ++i)
            difference = std::max(
                difference, std::abs(found.u[static_cast<std::size_t>(i)][I] - expected.above[2 * I + i]));
    return difference / expected.above.cwiseAbs().maxCoeff();
}

}  // namespace

TEST_CASE("(F24): the weights are those of the derivatives, by the names of the second paper") {
    const Cloud<2> cloud(support::moved_grid(16, 4, 0.15, 1));
    const auto w = operators(cloud, smoothing(cloud, {}));
    const Index I = 21;
    const Basis basis = basis_at(w, I);
    const auto f = [](const Point<2>& x) {
        return 0.4 + 0.3 * x[0] - 0.2 * x[1] + 0.5 * x[0] * x[0] - 0.7 * x[0] * x[1] + 0.9 * x[1] * x[1];
    };
    Column<double> F(static_cast<Index>(basis.particle().size()));
    for (Index J = 0; J < F.size(); ++J)
        F[J] = f(cloud.x().col(basis.particle()[static_cast<std::size_t>(J)]));
    const Point<2> x = cloud.x().col(I);
    CHECK((K<1>(basis) * F).sum() == f(x));
    CHECK((K<2>(basis) * F).sum() == doctest::Approx(0.3 + x[0] - 0.7 * x[1]));
    CHECK((K<3>(basis) * F).sum() == doctest::Approx(-0.2 - 0.7 * x[0] + 1.8 * x[1]));
    CHECK((K<4>(basis) * F).sum() == doctest::Approx(0.5));
    CHECK((K<5>(basis) * F).sum() == doctest::Approx(0.9));
    CHECK((K<6>(basis) * F).sum() == doctest::Approx(-0.7));
}

TEST_CASE("plate_and_hole: quadratic displacements are reproduced on irregular particles") {
    for (const unsigned long seed : {1UL, 2UL, 3UL}) {
        CAPTURE(seed);
        const Problem problem = support::plate_with({support::plate_material()});
        const Cloud<2> cloud(support::moved_grid(16, 4, 0.15, seed));
        CHECK(relative_error(cloud, solve(problem, cloud, {}), problem) < 1e-9);
    }
}

TEST_CASE("plate_and_hole: cubic ones are not, so that the test above could fail") {
    const Problem problem = support::plate_with({support::plate_material(), true});
    const Cloud<2> cloud(support::moved_grid(16, 4, 0.15, 1));
    CHECK(relative_error(cloud, solve(problem, cloud, {}), problem) > 1e-4);
}

TEST_CASE("(F25): between the particles a quadratic displacement has its values and its stresses") {
    const support::PolynomialField field{support::plate_material()};
    const Cloud<2> cloud(support::moved_grid(16, 4, 0.15, 2));
    const Problem problem = support::plate_with(field);
    const Solution solution = solve(problem, cloud, {});
    for (const Point<2>& x : {Point<2>(3.21, 0.77), Point<2>(0, 1.234), Point<2>(14.9, 2.9)}) {
        const auto state = state_at(cloud, solution, x);
        CHECK((state.u - field.u(x)).norm() < 1e-8 * field.u(x).norm());
        CHECK((state.stress - field.stress(x)).norm() < 1e-8 * field.stress(x).norm());
    }
}

TEST_CASE(
    "plate_and_hole: the displacements are those of the library for bodies, which shares the weights alone") {
    CHECK(difference_from_body(support::plate_problem(), support::plate_body({30, 6}),
                               plate::problem(support::plate_material())) < 1e-9);
    CHECK(difference_from_body(support::hole_problem(), support::hole_body(188, 11),
                               hole::problem(support::hole_material(), {})) < 1e-9);
}

TEST_CASE("plate_and_hole: on the plate's grids the error is of second order") {
    const Problem problem = plate::problem(support::plate_material());
    const auto error = [&](Index nx, Index ny) {
        const Cloud<2> cloud(plate::grid(nx, ny));
        return relative_error(cloud, solve(problem, cloud, {}), problem);
    };
    const double order = std::log2(error(61, 13) / error(121, 25));
    CHECK(order > 1.6);
    CHECK(order < 2.2);
}

TEST_CASE(
    "plate_and_hole: by iteration and by factorisation the displacements agree, on any number of threads") {
    const Problem problem = hole::problem(support::hole_material(), {});
    const Cloud<2> cloud(hole::polar_layout({}, 41, 60));
    auto all = collocated(problem, cloud, {});
    REQUIRE(all.system.elements.K.rows() == all.system.A.rows());
    const Eigen::VectorXd by_factors = solvers::solve_sparse(solvers::SparseRows(all.system.A), all.system.b),
                          iterated = batra2008::solved(std::move(all.system));
    CHECK((iterated - by_factors).norm() < 1e-9 * by_factors.norm());
    const Solution solution = solve(problem, cloud, {});
    const int threads = omp_get_max_threads();
    omp_set_num_threads(threads == 1 ? 2 : 1);
    CHECK((solve(problem, cloud, {}).u[0] == solution.u[0]).all());
    omp_set_num_threads(threads);
}

TEST_CASE(
    "plate_and_hole: particles that do not determine the derivatives are refused, with a remedy that works") {
    const Problem problem = plate::problem(support::plate_material());
    const Cloud<2> cloud(plate::grid(16, 4));
    const auto refused = [&](double ratio) {
        return support::refusal([&] { return solve(problem, cloud, {ratio}); });
    };
    CHECK(refused(0.5).starts_with("fpm: particle 0 "));
    CHECK(refused(support::smoothing_to_try(refused(0.5))).empty());
}

TEST_CASE(
    "plate_and_hole: derivatives that cannot be trusted are refused, with a smoothing length that was tried") {
    const Problem problem = plate::problem(support::plate_material());
    // Near three sides the neighbours lie in three layers, but for small moves.
    for (const double move : {0.001, 0.003}) {
        const Cloud<2> cloud(support::moved_grid(31, 6, move, 1));
        const auto refused = [&](double ratio) {
            return support::refusal([&] { return solve(problem, cloud, {ratio}); });
        };
        const std::string why = refused(1);
        CAPTURE(why);
        REQUIRE(why.find(" has the quality number ") != std::string::npos);
        CHECK(refused(support::smoothing_to_try(why)).empty());
    }
}

TEST_CASE("plate_and_hole: where no smoothing length helps, none is named") {
    // Two of four layers nearly coincide, so that three layers are left.
    particles::Points<2> x = plate::grid(16, 4);
    for (Index j = 0; j < x.cols(); ++j)
        if (j % 4 == 2) x(1, j) = x(1, j - 1) + 1e-4;
    const std::string why = support::refusal([&] {
        return solve(plate::problem(support::plate_material()), Cloud<2>(x), {2, particles::Spacing::mean});
    });
    CAPTURE(why);
    CHECK(why.ends_with("; take other particles"));
}
