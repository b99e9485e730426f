#include "batra2008/section_3_2_mlpg.hpp"

#include "batra2008/section_4_2_hole.hpp"
#include "tests/batra2008/elastic.hpp"

using namespace batra2008;
using namespace batra2008::mlpg;
using example_problems::Method;

namespace {

const elastostatics::Material material{2e11, 0.3, elastostatics::Plane::stress};
const support::PolynomialField cubic{material, true};
const Field field{[](const Point<2>& x) { return cubic.u(x); },
                  [](const Point<2>& x) { return elastostatics::strain(cubic.gradient(x)); },
                  [](const Point<2>& x) { return cubic.stress(x); },
                  [](const Point<2>& x) { return cubic.stress_gradient(x); }};
const Vector shift(0.03, -0.02);
const elastostatics::FieldOf<Vector> given = [](const Point<2>& x) { return Vector(cubic.u(x) + shift); };

/// Particles of the plate inside, at an edge, at a displaced corner, and near an edge that cuts the disc.
const std::vector<Point<2>> places{{0.4, 0.1}, {0.4, 0},     {1, 0.1},    {0, 0.1},
                                   {0, 0.2},   {0.03, 0.12}, {0.98, 0.18}};
constexpr double h = 0.06;

Subdomain subdomain_at(const Point<2>& x, Index gauss) {
    const Problem problem = support::plate_with(cubic);
    return subdomain(problem, elastostatics::region(problem), x, h, Kernel(1), gauss);
}

/// Largest error of a solution for displacements of degree m.
double error(Method method, int degree, const Points<2>& x, Index gauss) {
    const Problem problem = support::plate_with({material, degree == 3});
    const Cloud<2> cloud(x);
    const auto solution = example_problems::solve(
        problem, cloud, {method, degree == 3 ? 4.5 : 3.5, degree, plate::penalty(material), 1, gauss});
    return support::relative_error(cloud, solution, problem);
}

}  // namespace

TEST_CASE(
    "(3.15): the test function has unit integral, vanishes at the edge, and its gradient is its slope") {
    const Kernel kernel(1.3);
    const particles::Region everywhere;
    double integral = 0;
    for (const auto& at : particles::polar_rule(everywhere, {0, 0}, 1.3 * h, 20, 40))
        integral += at.weight * W<2>(kernel, at.x, h);
    CHECK(integral == support::relative(1, 1e-12));
    CHECK(W<2>(kernel, {1.3 * h, 0}, h) < 1e-14 / (h * h));
    CHECK(W<2>(kernel, {0, 2 * h}, h) == 0);
    const Point<2> at(0.03, -0.02);
    for (Index axis = 0; axis < 2; ++axis) {
        const Point<2> aside = 1e-6 * Point<2>::Unit(axis);
        const double slope = (W<2>(kernel, at + aside, h) - W<2>(kernel, at - aside, h)) / 2e-6;
        CHECK(DW<2>(kernel, at, h)[axis] == support::relative(slope, 1e-7));
    }
}

TEST_CASE(
    "(3.16), (3.17): the divergence theorem carries the one into the other, the closer the more Gauss points") {
    const double alpha = 1e12;
    for (const Point<2>& x : places) {
        CAPTURE(x);
        double before = 1e300;
        for (const Index gauss : {4, 8, 16}) {
            const Subdomain Omega = subdomain_at(x, gauss);
            const Vector weighted = weighted_residual(Omega, field, given, alpha);
            const double difference =
                (after_divergence_theorem(boundary_work(Omega, field), Omega, field, given, alpha) - weighted)
                    .norm() /
                weighted.norm();
            CHECK(difference < std::max(before, 1e-12));
            before = difference;
        }
        CHECK(before < 1e-9);
    }
}

TEST_CASE(
    "(3.18): on the circle the test function vanishes, so that only the boundary of the body does work") {
    for (int k = 0; k < 16; ++k) {
        const double angle = k * std::acos(-1.0) / 8;
        CHECK(W<2>(Kernel(1), h * Point<2>(std::cos(angle), std::sin(angle)), h) < 1e-12 / (h * h));
    }
    CHECK(boundary_work(subdomain_at({0.4, 0.1}, 8), field).norm() == 0);
    CHECK(boundary_work(subdomain_at({0.4, 0}, 8), field).norm() > 0);
}

TEST_CASE(
    "(3.19): the weak form is (3.17) where the tractions are those given, less what the body force works") {
    const double alpha = 1e12;
    for (const Point<2>& x : places) {
        CAPTURE(x);
        const Subdomain Omega = subdomain_at(x, 12);
        const Vector expected =
            -after_divergence_theorem(boundary_work(Omega, field), Omega, field, given, alpha);
        elastostatics::Exact prescribed = cubic.exact();
        prescribed.u = given;
        CHECK((weak_form(Omega, field, prescribed, alpha) - expected).norm() < 1e-12 * expected.norm());
    }
}

TEST_CASE("(3.19): the traction given works on those components that are not displaced") {
    elastostatics::Exact doubled = cubic.exact();
    doubled.stress = [](const Point<2>& x) { return Stress(2 * cubic.stress(x)); };
    bool some_displaced = false;
    for (const Point<2>& x : places) {
        CAPTURE(x);
        const Subdomain Omega = subdomain_at(x, 12);
        Vector expected = Vector::Zero(), size = Vector::Constant(1);
        for (const BoundaryPoint& at : Omega.boundary) {
            const Vector work = at.weight * at.W * elastostatics::traction(cubic.stress(at.x), at.n);
            size += work.cwiseAbs();
            for (Index i = 0; i < 2; ++i)
                if (at.displaced[static_cast<std::size_t>(i)])
                    some_displaced = true;
                else
                    expected[i] -= work[i];
        }
        const Vector moved = weak_form(Omega, field, doubled, 0) - weak_form(Omega, field, cubic.exact(), 0);
        CHECK((moved - expected).norm() < 1e-10 * size.norm());
    }
    CHECK(some_displaced);
}

TEST_CASE("(3.20): the weak form with matrices is (3.19), on the displaced and the loaded boundary") {
    elastostatics::Exact prescribed = cubic.exact();
    prescribed.u = given;
    prescribed.stress = [](const Point<2>& x) { return Stress(2 * cubic.stress(x)); };
    for (const double alpha : {0.0, 1e9, 1e12})
        for (const Point<2>& x : places) {
            CAPTURE(alpha);
            CAPTURE(x);
            const Subdomain Omega = subdomain_at(x, 12);
            const Vector expected = weak_form(Omega, field, prescribed, alpha);
            const Vector found = matrix_form(Omega, elastostatics::D(material), field, prescribed, alpha);
            CHECK((found - expected).norm() < 1e-12 * expected.norm());
        }
}

TEST_CASE("(3.20): (LM)ᵀ D strains are stresses on the gradient of W, N σ is the traction") {
    const Vector DW_at(3, -2), n(0.6, 0.8);
    const Strain strain(1e-3, -4e-4, 6e-4);
    const Stress sigma = elastostatics::stress(material, strain);
    CHECK(
        (LM(DW_at).transpose() * elastostatics::D(material) * strain - elastostatics::traction(sigma, DW_at))
            .norm() < 1e-12 * sigma.norm());
    CHECK((N(n) * sigma - elastostatics::traction(sigma, n)).norm() < 1e-12 * sigma.norm());
}

TEST_CASE(
    "(3.21), (3.26): both gradients are exact for displacements of degree m, and times T gives the stresses") {
    const support::PolynomialField quadratic{material};
    const Cloud<2> cloud(support::moved_grid(16, 4, 0.2, 5));
    const Point<2> x(0.41, 0.09);
    const auto basis = ssph_basis::basis_at<2>(cloud, Kernel(4), x, 0.0667);
    Column<double> u1(static_cast<Index>(basis.particle().size())), u2(u1.size());
    for (Index j = 0; j < u1.size(); ++j) {
        const Vector u = quadratic.u(cloud.x().col(basis.particle()[static_cast<std::size_t>(j)]));
        u1[j] = u[0];
        u2[j] = u[1];
    }
    for (const Gradient how : {Gradient::own_basis, Gradient::differentiated}) {
        const GradientWeights T = gradient(basis, how);
        CHECK((T.by_x1 * u1).sum() == support::relative(quadratic.gradient(x)(0, 0), 1e-11));
        CHECK((T.by_x2 * u2).sum() == support::relative(quadratic.gradient(x)(1, 1), 1e-11));
        const Column<double> zero = Column<double>::Zero(u1.size());
        Block block{zero, zero, zero, zero};
        mlpg::detail::add(block, 1, N({0.6, 0.8}) * elastostatics::D(material) * T);
        const Vector by_blocks = collocation::sums(block, u1, u2);
        const Vector exact = elastostatics::traction(quadratic.stress(x), {0.6, 0.8});
        CHECK((by_blocks - exact).norm() < 1e-11 * exact.norm());
    }
    CHECK((own_gradient(basis).by_x1 - differentiated_gradient(basis).by_x1).abs().maxCoeff() > 0.1);
}

TEST_CASE("(3.25): the derivatives of all basis functions, against central differences") {
    const Cloud<2> cloud(support::moved_grid(16, 4, 0.2, 5));
    const Kernel kernel(4);
    const Point<2> x(0.41, 0.09);
    const double step = 1e-6;
    const auto basis = ssph_basis::basis_at<2>(cloud, kernel, x, 0.0667);
    for (int axis = 0; axis < 2; ++axis) {
        const Point<2> aside = step * Point<2>::Unit(axis);
        const auto plus =
            ssph_basis::basis_at<2>(cloud, kernel, Point<2>(x + aside), 0.0667, basis.particle());
        const auto minus =
            ssph_basis::basis_at<2>(cloud, kernel, Point<2>(x - aside), 0.0667, basis.particle());
        REQUIRE(plus.particle() == basis.particle());
        REQUIRE(minus.particle() == basis.particle());
        const auto exact = DK(basis, axis);
        for (Index I = 1; I <= 6; ++I) {
            const Column<double> slope = (plus.row(I) - minus.row(I)) / (2 * step);
            CHECK((exact.row(I - 1).transpose().array() - slope).abs().maxCoeff() <
                  1e-7 * slope.abs().maxCoeff());
        }
    }
}

TEST_CASE(
    "(3.22), (3.23), (3.24): stiffness times a field of degree m is the load, to what the Gauss rule leaves") {
    const Problem problem = support::plate_with({material});
    const Cloud<2> cloud(plate::grid(16, 4));
    Eigen::VectorXd u(2 * cloud.size());
    for (Index J = 0; J < cloud.size(); ++J) u.segment<2>(2 * J) = problem.exact.u(cloud.x().col(J));
    for (const Gradient how : {Gradient::own_basis, Gradient::differentiated}) {
        const System equations =
            system<2>(problem, cloud, Kernel(3), cloud.apart(), {how, plate::penalty(material), 1, 16});
        const Eigen::VectorXd left = equations.A * u;
        for (Index row = 0; row < left.size(); ++row) {
            double size = std::abs(equations.b[row]);
            for (Matrix::InnerIterator entry(equations.A, row); entry; ++entry)
                size += std::abs(entry.value() * u[entry.col()]);
            CHECK(std::abs(left[row] - equations.b[row]) < 1e-9 * size);
        }
    }
}

TEST_CASE(
    "mlpg: displacements of degree m are reproduced to what the Gauss rule leaves, on the plate's grid 1e-8") {
    for (const Method method : {Method::weak1, Method::weak2})
        for (const int degree : {2, 3}) {
            CAPTURE(example_problems::name(method));
            CAPTURE(degree);
            const double coarse = error(method, degree, plate::grid(16, 4), 4);
            const double fine = error(method, degree, plate::grid(16, 4), 10);
            CHECK(fine < 1e-8);
            CHECK(fine < coarse);
        }
}

TEST_CASE("mlpg: on irregular particles the error falls with the number of Gauss points") {
    for (const Method method : {Method::weak1, Method::weak2}) {
        const Points<2> x = support::moved_grid(11, 4, 0.15, 2);
        const double coarse = error(method, 2, x, 3), medium = error(method, 2, x, 6),
                     fine = error(method, 2, x, 12);
        CHECK(medium < coarse);
        CHECK(fine < 0.5 * medium);
        CHECK(fine < 1e-6);
    }
}

TEST_CASE("mlpg: by iteration and by factorisation the displacements agree to 1e-9") {
    const Problem of_plate = plate::problem({plate::E, plate::nu}),
                  of_hole = hole::problem({hole::E, hole::nu}, {});
    const double alpha = plate::penalty(of_plate.material), alpha_of_hole = hole::penalty(of_hole.material);
    for (const auto& [problem, x, penalty] :
         {std::tuple(of_plate, support::moved_grid(31, 7, 0.1, 2), alpha),
          std::tuple(of_hole, hole::graded_layout({}, 188, 11, 1), alpha_of_hole)})
        for (const Gradient gradient : {Gradient::own_basis, Gradient::differentiated}) {
            const Cloud<2> cloud(x);
            System equations =
                system<2>(problem, cloud, Kernel(3), cloud.apart(), {gradient, penalty, 1, 4}, 0);
            solvers::SparseRows none;
            solvers::scale_rows(equations.A, equations.b, none);
            const Eigen::VectorXd direct =
                solvers::solve_sparse(solvers::SparseRows(equations.A), equations.b);
            const auto iterated = solvers::iterated(equations.A, equations.b, std::move(equations.elements));
            REQUIRE(iterated.has_value());
            CHECK((*iterated - direct).cwiseAbs().maxCoeff() < 1e-9 * direct.cwiseAbs().maxCoeff());
        }
}
