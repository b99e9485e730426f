#include "batra2008/section_4_example_problems.hpp"

#include "batra2008/section_3_2_mlpg.hpp"
#include "batra2008/section_4_2_hole.hpp"

#include "tests/batra2008/elastic.hpp"

using namespace batra2008;
using namespace batra2008::example_problems;

TEST_CASE("(4.4): the two readings of the error norm, for fields whose norms are known") {
    const auto mesh = background_mesh(
        3, 2, [](const Point<2>& at) { return at; }, [](const Point<2>&) { return 1.0; });
    const elastostatics::FieldOf<Vector> exact = [](const Point<2>&) { return Vector(3, 4); };
    const auto constant = [&](const Vector& u) {
        return errors(mesh, std::vector<Vector>(mesh.size(), u), exact);
    };
    CHECK(constant({3.3, 4.4}).log_dn == support::relative(-1, 1e-12));
    CHECK(constant({3.3, 4.4}).log_nd == support::relative(-1, 1e-12));
    // As long as the exact field, but turned: the difference of the norms does not see it.
    CHECK(constant({4, 3}).log_dn < -14);
    CHECK(constant({4, 3}).log_nd == support::relative(std::log10(std::sqrt(2.0) / 5), 1e-12));
}

TEST_CASE(
    "example_problems: the background mesh integrates polynomials of degree 7 exactly, on a mapped body too") {
    const auto identity = background_mesh(
        2, 3, [](const Point<2>& at) { return at; }, [](const Point<2>&) { return 1.0; });
    CHECK(identity.size() == 2 * 2 * 3 * 13);
    for (int a = 0; a <= 7; ++a)
        for (int b = 0; a + b <= 7; ++b) {
            double sum = 0;
            for (const MeshPoint& at : identity)
                sum += at.weight * std::pow(at.x[0], a) * std::pow(at.x[1], b);
            CHECK(sum == support::relative(1.0 / ((a + 1) * (b + 1)), 1e-13));
        }
    double degree_8 = 0;
    for (const MeshPoint& at : identity) degree_8 += at.weight * std::pow(at.x[0], 8);
    CHECK(std::abs(degree_8 - 1.0 / 9) > 1e-9);
    const auto stretched = background_mesh(
        2, 3, [](const Point<2>& at) { return Point<2>(3 * at[0], 2 * at[1]); },
        [](const Point<2>&) { return 6.0; });
    double integral = 0;
    for (const MeshPoint& at : stretched) integral += at.weight * at.x[0] * at.x[1];
    CHECK(integral == support::relative(9.0 / 2 * 4.0 / 2, 1e-13));
}

TEST_CASE("example_problems: methods by their names; degrees that a method cannot use are refused") {
    for (const Method method : {Method::strong, Method::weak1, Method::weak2})
        CHECK(method_named(name(method)) == method);
    CHECK(name(Method::strong) == "strong");
    CHECK(name(Method::weak1) == "weak1");
    CHECK(name(Method::weak2) == "weak2");
    CHECK_THROWS_WITH_AS(method_named("weak3"), doctest::Contains("choose one of strong"),
                         base::InvalidInput);
    const Problem problem = plate::problem({plate::E, plate::nu});
    const Cloud<2> cloud(plate::grid(16, 4));
    CHECK_THROWS_WITH_AS(solve(problem, cloud, {Method::strong, 3, 1}),
                         doctest::Contains("take --degree 2 or 3"), base::InvalidInput);
    CHECK_THROWS_AS(solve(problem, cloud, {Method::weak1, 3, 4, 1e16}), base::InvalidInput);
}

TEST_CASE("example_problems: too small a support is an error with place, counts and a remedy that helps") {
    const Problem problem = plate::problem({plate::E, plate::nu});
    const Cloud<2> cloud(plate::grid(16, 4));
    CHECK_THROWS_WITH_AS(
        solve(problem, cloud, {Method::strong, 2}),
        doctest::Contains(
            "ssph_basis: at (0, 0) there are 4 particles within 2h = 0.133 for the 6 monomials of degree 2; try --scaling 2.5"),
        base::FailedComputation);
    CHECK_NOTHROW(solve(problem, cloud, {Method::strong, 2.5}));
}

TEST_CASE("example_problems: stress and displacement of a solution are those of a field of degree m") {
    const support::PolynomialField field{{2e11, 0.3}};
    const Problem problem = support::plate_with(field);
    const Cloud<2> cloud(support::moved_grid(16, 4, 0.1, 4));
    Eigen::VectorXd u(2 * cloud.size());
    for (Index J = 0; J < cloud.size(); ++J) u.segment<2>(2 * J) = field.u(cloud.x().col(J));
    const Point<2> x(0.43, 0.11);
    for (const Method method : {Method::strong, Method::weak1, Method::weak2}) {
        const State state = state_at(cloud, {{method, 4}, field.material, cloud.apart(), u}, x);
        CHECK((state.u - field.u(x)).norm() < 1e-12);
        CHECK((state.stress - field.stress(x)).norm() < 1e-10 * field.stress(x).norm());
    }
}

TEST_CASE("example_problems: each method solves with its own gradient, and shows stresses by the same") {
    const support::PolynomialField field{{2e11, 0.3}, true};  // of degree 3, so that the gradients differ
    const Problem problem = support::plate_with(field);
    const Cloud<2> cloud(support::moved_grid(8, 3, 0.1, 4));
    Eigen::VectorXd u(2 * cloud.size());
    for (Index J = 0; J < cloud.size(); ++J) u.segment<2>(2 * J) = field.u(cloud.x().col(J));
    const Point<2> x(0.43, 0.11);
    const auto basis =
        batra2008::ssph_basis::basis_at<2>(cloud, Kernel(4), x, cloud.apart()[cloud.nearest(x)]);
    for (const auto& [method, own] : {std::pair(Method::weak1, mlpg::Gradient::own_basis),
                                      std::pair(Method::weak2, mlpg::Gradient::differentiated)}) {
        const Discretisation how{method, 4, 2, plate::penalty(field.material)};
        const System expected = mlpg::system<2>(problem, cloud, Kernel(4), cloud.apart(),
                                                {own, how.penalty, how.test_scaling, how.gauss});
        CHECK((system(problem, cloud, how).A - expected.A).norm() == 0);
        const auto [K2, K3] = mlpg::gradient(basis, own);
        Eigen::Matrix2d gradient = Eigen::Matrix2d::Zero();
        for (Index j = 0; j < K2.size(); ++j)
            gradient += u.segment<2>(2 * basis.particle()[static_cast<std::size_t>(j)]) *
                        Eigen::RowVector2d(K2[j], K3[j]);
        const Stress stress = elastostatics::stress(field.material, elastostatics::strain(gradient));
        CHECK((state_at(cloud, {how, field.material, cloud.apart(), u}, x).stress - stress).norm() <=
              1e-12 * stress.norm());
    }
}

TEST_CASE(
    "example_problems: unknowns of a field of degree m have no noise; alternating ones are noise to a field of wide kernels") {
    const support::PolynomialField field{{2e11, 0.3}};
    const Cloud<2> cloud(support::moved_grid(16, 4, 0.1, 4));
    Eigen::VectorXd smooth(2 * cloud.size()), alternating = Eigen::VectorXd::Zero(2 * cloud.size());
    for (Index J = 0; J < cloud.size(); ++J) {
        smooth.segment<2>(2 * J) = field.u(cloud.x().col(J));
        alternating[2 * J] = J % 2 == 0 ? 1 : -1;
    }
    const Solution of_field{{Method::strong, 4}, field.material, cloud.apart(), smooth};
    CHECK(noise(cloud, of_field) < 1e-10);
    Solution scaled{{Method::strong, 4}, field.material, 3 * cloud.apart(), alternating};
    CHECK(noise(cloud, scaled) > most_noise);
    const double of_one = noise(cloud, scaled);
    scaled.u *= 1000;
    CHECK(noise(cloud, scaled) == support::relative(of_one, 1e-9));
}

TEST_CASE(
    "example_problems: solutions by the paper's lengths have little noise; by six neighbours' they have much") {
    const hole::Shape shape;
    const Problem problem = hole::problem({hole::E, hole::nu, elastostatics::Plane::strain}, shape);
    const Cloud<2> cloud(hole::graded_layout(shape, 188, 11, 1));
    Discretisation how{Method::strong, 4};
    CHECK(noise(cloud, solve(problem, cloud, how)) == support::relative(0.0744, 0.01));
    how.smoothing_from = particles::Spacing::to_nearest(6);
    CHECK(noise(cloud, solve(problem, cloud, how)) > 5);
}
