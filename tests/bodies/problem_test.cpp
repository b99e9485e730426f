#include "bodies/problem.hpp"

#include <doctest/doctest.h>

#include "base/errors.hpp"
#include "tests/support/clouds.hpp"
#include "tests/support/relative.hpp"

using namespace bodies;
namespace elastostatics = batra2008::elastostatics;
using elastostatics::Plane;

namespace {

template <int dim>
Eigen::Matrix<double, dim, dim> stress(const Equation<dim, dim>& equation,
                                       const Eigen::Matrix<double, dim, dim>& gradient) {
    const auto A = equation.A(Point<dim>::Zero());
    Eigen::Matrix<double, dim, dim> F = Eigen::Matrix<double, dim, dim>::Zero();
    for (int ia = 0; ia < dim * dim; ++ia)
        for (int jb = 0; jb < dim * dim; ++jb)
            F(ia / dim, ia % dim) += A(ia, jb) * gradient(jb / dim, jb % dim);
    return F;
}

template <int dim>
Eigen::Matrix<double, dim, dim> random_gradient(unsigned seed) {
    support::Draws draw(seed);
    Eigen::Matrix<double, dim, dim> gradient;
    for (int i = 0; i < dim; ++i) gradient.row(i) = draw.point<dim>().transpose();
    return gradient;
}

}  // namespace

TEST_CASE("problem: in the plane the stresses are those of Hooke's law (3.3) of Batra and Zhang") {
    for (const Plane plane : {Plane::stress, Plane::strain})
        for (unsigned seed = 1; seed <= 10; ++seed) {
            const elastostatics::Material material{2.3, 0.03 * seed, plane};
            const Eigen::Matrix2d gradient = random_gradient<2>(seed);
            const auto expected = elastostatics::stress(material, elastostatics::strain(gradient));
            const Eigen::Matrix2d F = stress(elasticity<2>(material), gradient);
            CHECK(F(0, 0) == support::relative(expected[0], 1e-13));
            CHECK(F(1, 1) == support::relative(expected[1], 1e-13));
            CHECK(F(0, 1) == support::relative(expected[2], 1e-13));
            CHECK(F(0, 1) == F(1, 0));
        }
}

TEST_CASE(
    "problem: in space the strains are (1 + nu)/E stress less nu/E times its trace, whatever the plane") {
    for (const Plane plane : {Plane::stress, Plane::strain}) {
        constexpr double E = 2.3, nu = 0.3;
        const Eigen::Matrix3d gradient = random_gradient<3>(4);
        const Eigen::Matrix3d F = stress(elasticity<3>({E, nu, plane}), gradient);
        const Eigen::Matrix3d strain = (1 + nu) / E * F - nu / E * F.trace() * Eigen::Matrix3d::Identity();
        CHECK((strain - (gradient + gradient.transpose()) / 2).norm() < 1e-14);
    }
}

TEST_CASE("problem: a rotation has no stress") {
    const Eigen::Matrix3d any = random_gradient<3>(5), turn = any - any.transpose();
    CHECK(stress(elasticity<3>({2.3, 0.3}), turn).norm() < 1e-14);
}

TEST_CASE("problem: A is symmetric, as an energy is") {
    const auto A = elasticity<3>({2.3, 0.3}).A(Point<3>::Zero());
    CHECK((A - A.transpose()).norm() == 0);
}

TEST_CASE("problem: materials without meaning are refused, in space as in plane strain") {
    CHECK_THROWS_AS(elasticity<2>({-1, 0.3}), base::InvalidInput);
    CHECK_THROWS_AS(elasticity<2>({1, 0.6}), base::InvalidInput);
    CHECK_NOTHROW(elasticity<2>({1, 0.5, Plane::stress}));
    CHECK_THROWS_AS(elasticity<3>({1, 0.5, Plane::stress}), base::InvalidInput);
}

TEST_CASE("problem: the divergence of k times the unit matrix is the gradient of k") {
    const auto k = [](const Point<3>& x) { return 2 + std::sin(x[0]) + x[1] * x[2]; };
    const auto grad_k = [](const Point<3>& x) { return Point<3>(std::cos(x[0]), x[2], x[1]); };
    const Equation<3, 1> equation = diffusion<3>(k, grad_k);
    const Point<3> x(0.3, -0.8, 0.4);
    CHECK((equation.A(x) - k(x) * Eigen::Matrix3d::Identity()).norm() == 0);
    constexpr double step = 1e-5;
    for (int b = 0; b < 3; ++b) {
        double sum = 0;
        for (int a = 0; a < 3; ++a) {
            const Point<3> aside = step * Point<3>::Unit(a);
            sum += (equation.A(x + aside)(a, b) - equation.A(x - aside)(a, b)) / (2 * step);
        }
        CHECK(std::abs(equation.div_A(x)(0, b) - sum) < 1e-9);
    }
    CHECK_FALSE(static_cast<bool>(diffusion<3>(k).div_A));
}
