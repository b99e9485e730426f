#include "batra2008/section_3_1_collocation.hpp"

#include <omp.h>

#include "batra2008/section_4_2_hole.hpp"
#include "tests/batra2008/elastic.hpp"

using namespace batra2008;
using namespace batra2008::collocation;

namespace {

const elastostatics::Material material{2e11, 0.3, elastostatics::Plane::strain};
const double nu0 = elastostatics::nu0(material);
const support::PolynomialField field{material};

/// A basis inside an irregular plate, and the field's values at its particles.
struct Local {
    Cloud<2> cloud{support::moved_grid(16, 4, 0.2, 5)};
    Point<2> x{0.41, 0.09};
    ssph_basis::Basis<2, 2> basis = ssph_basis::basis_at<2>(cloud, Kernel(4), x, 0.0667);
    Column<double> u1, u2;
    Local() : u1(static_cast<Index>(basis.particle().size())), u2(u1.size()) {
        for (Index j = 0; j < u1.size(); ++j) {
            const Vector u = field.u(cloud.x().col(basis.particle()[static_cast<std::size_t>(j)]));
            u1[j] = u[0];
            u2[j] = u[1];
        }
    }
};

}  // namespace

TEST_CASE("(3.8): equilibrium in displacements is (3.1) through Hooke's law") {
    for (const auto plane : {elastostatics::Plane::stress, elastostatics::Plane::strain}) {
        const support::PolynomialField cubic{{2e11, 0.3, plane}, true};
        const double n = elastostatics::nu0(cubic.material);
        const Point<2> x(0.4, 0.13);
        const Vector scaled =
            elastostatics::E0(cubic.material) / (1 - n * n) * equilibrium(n, cubic.second(x));
        CHECK((scaled + cubic.b(x)).norm() < 1e-12 * cubic.b(x).norm());
    }
}

TEST_CASE("(3.9), (3.10): values and second derivatives of a quadratic, from all particles' values") {
    const Local local;
    Eigen::VectorXd F(local.cloud.size());
    for (Index J = 0; J < F.size(); ++J) F[J] = field.u(local.cloud.x().col(J))[0];
    CHECK(Q(local.basis, 1, F) == support::relative(field.u(local.x)[0], 1e-12));
    CHECK(Q(local.basis, 2, F) == support::relative(field.gradient(local.x)(0, 0), 1e-11));
    const auto weights = second_derivatives(local.basis);
    for (Index k = 0; k < 3; ++k)
        CHECK((weights.col(k) * local.u1).sum() == support::relative(field.second(local.x)(0, k), 1e-10));
}

TEST_CASE("(3.11), (3.12): a block applied to displacements is (3.8)") {
    const Local local;
    const Vector exact = equilibrium(nu0, field.second(local.x));
    CHECK((sums(equilibrium(local.basis, nu0), local.u1, local.u2) - exact).norm() < 1e-10 * exact.norm());
}

TEST_CASE("(3.13): the block of a given displacement returns the displacement") {
    const Local local;
    CHECK((sums(displacement(local.basis), local.u1, local.u2) - field.u(local.x)).norm() < 1e-12);
}

TEST_CASE("(3.14): the block of a given traction is Hooke's law on any plane; the entry as printed is not") {
    const Local local;
    for (const Vector& n : {Vector(1, 0), Vector(0, -1), Vector(-0.6, 0.8)}) {
        const Vector exact = elastostatics::traction(field.stress(local.x), n);
        Block block = traction(local.basis, material, n);
        CHECK((sums(block, local.u1, local.u2) - exact).norm() < 1e-11 * exact.norm());
        if (n[1] == 0) continue;
        const double factor = elastostatics::E0(material) / (1 - nu0 * nu0);
        block.K22 += factor * (nu0 - 1) * n[1] * K<3>(local.basis);  // ν0 n2 K3 in place of n2 K3
        CHECK((sums(block, local.u1, local.u2) - exact).norm() > 0.1 * exact.norm());
    }
}

TEST_CASE("collocation: displacements of degree m are reproduced on irregular particles") {
    for (const int degree : {2, 3})
        for (const unsigned long seed : {1UL, 2UL, 3UL}) {
            CAPTURE(degree);
            CAPTURE(seed);
            const Problem problem = support::plate_with({material, degree == 3});
            const Cloud<2> cloud(support::moved_grid(16, 4, 0.15, seed));
            const auto solution =
                example_problems::solve(problem, cloud, {example_problems::Method::strong, 4.5, degree});
            // Round-off: a cubic's local systems, and with them the rows, are conditioned ten times worse.
            CHECK(support::relative_error(cloud, solution, problem) < (degree == 2 ? 1e-10 : 1e-9));
        }
}

TEST_CASE(
    "collocation: a quadratic is no solution for cubic displacements, so that the test above could fail") {
    const Problem problem = support::plate_with({material, true});
    const Cloud<2> cloud(support::moved_grid(16, 4, 0.15, 1));
    const auto solution = example_problems::solve(problem, cloud, {example_problems::Method::strong, 4.5, 2});
    CHECK(support::relative_error(cloud, solution, problem) > 1e-4);
}

TEST_CASE(
    "collocation: by iteration and by factorisation a plate's and a hole's displacements agree to 1e-9, on any number of threads") {
    struct Example {
        Problem problem;
        Points<2> x;
    };
    const Problem of_plate = plate::problem({plate::E, plate::nu}),
                  of_hole = hole::problem({hole::E, hole::nu}, {});
    const std::vector<Example> examples{{of_plate, plate::grid(61, 13)},
                                        {of_plate, support::moved_grid(31, 7, 0.1, 2)},
                                        {of_hole, hole::graded_layout({}, 686, 21, 1)},
                                        {of_hole, hole::polar_layout({}, 21, 33)}};
    for (const auto& [problem, x] : examples)
        for (const double rho : {3.0, 4.0}) {
            const Index N = x.cols();
            CAPTURE(N);
            CAPTURE(rho);
            System equations = system<2>(problem, Cloud<2>(x), Kernel(rho), Cloud<2>(x).apart(), 0);
            solvers::SparseRows none;
            solvers::scale_rows(equations.A, equations.b, none);
            const Eigen::VectorXd direct =
                solvers::solve_sparse(solvers::SparseRows(equations.A), equations.b);
            const auto iterated = [&] {
                return solvers::iterated(equations.A, equations.b, solvers::Elements(equations.elements));
            };
            const auto solution = iterated();
            REQUIRE(solution.has_value());
            CHECK((*solution - direct).cwiseAbs().maxCoeff() < 1e-9 * direct.cwiseAbs().maxCoeff());
            const int threads = omp_get_max_threads();
            omp_set_num_threads(threads == 1 ? 2 : 1);
            CHECK(iterated() == solution);
            omp_set_num_threads(threads);
        }
}

TEST_CASE("collocation: a plate that nothing holds is refused, large or small") {
    Problem problem = plate::problem({plate::E, plate::nu});
    problem.corners.clear();
    for (elastostatics::Side& side : problem.sides) side.displaced = {false, false};
    const Cloud<2> cloud(plate::grid(31, 7));
    for (const Index small : {0, 1000})
        CHECK_THROWS_WITH_AS(solved(system<2>(problem, cloud, Kernel(3), cloud.apart(), small)),
                             doctest::Contains("the linear system of 434 unknowns is singular"),
                             base::FailedComputation);
}
