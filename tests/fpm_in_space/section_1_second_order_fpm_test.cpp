#include "fpm_in_space/section_1_second_order_fpm.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include "base/quad.hpp"
#include "tests/clouds.hpp"
#include "tests/polynomial.hpp"
#include "tests/relative.hpp"

using namespace fpm_in_space;
using namespace fpm_in_space::second_order_fpm;
using base::Quad;
using particles::Cloud;
using particles::Exponents;
using particles::Gaussian;
using particles::Point;
using particles::Points;
using particles::Smoothing;

namespace {

/// Calls `check` for one, two and three dimensions, as compile-time numbers.
template <class Check>
void in_every_dimension(const Check& check) {
    check(std::integral_constant<int, 1>{});
    check(std::integral_constant<int, 2>{});
    check(std::integral_constant<int, 3>{});
}

/// Irregular particles in the unit cube.
template <int dim>
Cloud<dim> irregular(unsigned seed = 3) {
    return Cloud<dim>(support::irregular_points<dim>(dim == 1 ? 40 : dim == 2 ? 12 : 8, 0.25, seed));
}

/// Random neighbours of a particle at the origin, which is the first: all around it, or on one side of some
/// coordinate planes, as at a face, an edge or a corner.
/// \param sides number of coordinates that are not negative
template <class Scalar, int dim>
Neighbourhood<Scalar, dim> random_neighbourhood(Index count, int sides, unsigned seed) {
    support::Draws draw(seed);
    Neighbourhood<Scalar, dim> near;
    near.r.resize(count, dim);
    near.W.resize(count);
    near.V.resize(count);
    for (Index j = 0; j < count; ++j) {
        Point<dim> r = j == 0 ? Point<dim>(Point<dim>::Zero()) : Point<dim>(2 * draw.point<dim>());
        for (int axis = 0; axis < sides; ++axis) r[axis] = std::abs(r[axis]);
        near.r.row(j) = r.transpose().array().template cast<Scalar>();
        using std::exp;
        near.W[j] = exp(-Scalar(r.squaredNorm()));
        near.V[j] = Scalar(1 + draw() / 2);
    }
    return near;
}

/// The derivatives by the SSPH basis (2.8) of degree m whose expansion takes the value at the particle as
/// given: without the constant monomial, on differences, weighted by W V.
template <int m, class Scalar, int dim>
Derivatives<Scalar, dim> by_ssph(const Neighbourhood<Scalar, dim>& near) {
    namespace ssph = batra2008::ssph_basis;
    const Table<Scalar> H = ssph::H<dim, m, Scalar>(near.r).bottomRows(terms<dim, m> - 1);
    const Table<Scalar> D = ssph::D<Scalar>(H, near.W * near.V);
    const solvers::Cholesky<Scalar> factors(ssph::C<Scalar>(D, H));
    Table<Scalar> all = particles::solved(factors, D).topRows(dim + second_derivatives<dim>);
    static constexpr auto a = particles::monomials<dim, 2>();
    for (Index n = 0; n < all.rows(); ++n)
        all.row(n) *= Scalar(particles::factorial<dim>(a[static_cast<std::size_t>(1 + n)]));
    return {all.topRows(dim).transpose().array(),
            all.bottomRows(second_derivatives<dim>).transpose().array()};
}

/// Largest relative difference of the second derivatives from SSPH's, over all random neighbourhoods.
template <class Scalar, int dim>
double difference_from_ssph() {
    double most = 0;
    for (int sides = 0; sides <= dim; ++sides)
        for (unsigned seed = 1; seed <= 10; ++seed) {
            const auto near = random_neighbourhood<Scalar, dim>(10 * terms<dim, 3>, sides, seed);
            const auto ours = derivatives(near).second, theirs = by_ssph<3>(near).second;
            most = std::max(most,
                            static_cast<double>((ours - theirs).abs().maxCoeff() / theirs.abs().maxCoeff()));
        }
    return most;
}

}  // namespace

TEST_CASE(
    "second-order FPM in space, (F1), (F5), (F6): D² is exact on cubics and D on quadratics, on irregular particles") {
    in_every_dimension([](auto dimension) {
        constexpr int dim = dimension;
        const Cloud<dim> cloud = irregular<dim>();
        const auto operators = particles::assemble(cloud, Smoothing(Gaussian<dim>{}, cloud.spacing()),
                                                   required<dim>, derivatives<double, dim>);
        for (const auto& a : particles::monomials<dim, 2>()) {
            const int order = particles::order<dim>(a);
            if (order == 0) continue;
            const support::Polynomial f(dim, order + 1, 3);
            Column<double> B(cloud.size());
            for (Index j = 0; j < B.size(); ++j) B[j] = f(cloud.x().col(j));
            const Column<double> found = particles::apply(derivative(operators, a), B);
            for (Index i = 0; i < B.size(); ++i)
                REQUIRE(std::abs(found[i] - f.derivative(support::powers(a), cloud.x().col(i))) < 1e-8);
        }
    });
}

TEST_CASE(
    "second-order FPM in space: its second derivatives are those of the SSPH basis of degree 3 with the value given, inside, at faces, edges and corners") {
    CHECK(difference_from_ssph<double, 1>() < 1e-10);
    CHECK(difference_from_ssph<double, 2>() < 1e-9);
    CHECK(difference_from_ssph<double, 3>() < 1e-9);
    CHECK(difference_from_ssph<Quad, 1>() < 1e-25);
    CHECK(difference_from_ssph<Quad, 2>() < 1e-25);
    CHECK(difference_from_ssph<Quad, 3>() < 1e-25);
}

TEST_CASE(
    "second-order FPM in space, (F2), (F3), (F4): corrections have no odd moments, and the matrix is symmetric") {
    in_every_dimension([](auto dimension) {
        constexpr int dim = dimension;
        const auto near = random_neighbourhood<double, dim>(10 * terms<dim, 3>, dim, 5);
        const auto products = moments<double>(monomials_of(near), near.W * near.V);
        const auto p2 = polynomials<double, dim>(quadratic<dim>), o = polynomials<double, dim>(odd<dim>);
        const Table<double> C = corrections<dim>(p2, products);
        CHECK(product(C, o, products).cwiseAbs().maxCoeff() <
              1e-10 * product(o, o, products).cwiseAbs().maxCoeff());
        const Table<double> M = product(C, p2, products);
        CHECK((M - M.transpose()).cwiseAbs().maxCoeff() < 1e-10 * M.cwiseAbs().maxCoeff());
        CHECK(odd<dim>.size() == std::array{2, 6, 13}.at(dim - 1));
    });
}

TEST_CASE("second-order FPM in space: products of polynomials are sums over the neighbours (F2)") {
    const auto near = random_neighbourhood<double, 2>(30, 1, 6);
    const auto x = near.r.col(0), y = near.r.col(1);
    Table<double> f = Table<double>::Zero(2, 10), g = Table<double>::Zero(1, 10);
    f(0, 0) = 2;  // 2 + x y, then y
    f(0, 5) = 1;
    f(1, 2) = 1;
    g(0, 1) = 3;  // 3 x + y³
    g(0, 7) = 1;
    const auto products = moments<double>(monomials_of(near), near.W * near.V);
    const Table<double> found = product(f, g, products);
    const Column<double> WV = near.W * near.V, g_j = 3 * x + y * y * y;
    CHECK(found(0, 0) == support::relative(((2 + x * y) * g_j * WV).sum(), 1e-13));
    CHECK(found(1, 0) == support::relative((y * g_j * WV).sum(), 1e-13));
}

TEST_CASE(
    "second-order FPM in space: a mirror of the neighbourhood changes the signs of odd derivatives alone") {
    const auto near = random_neighbourhood<double, 2>(60, 2, 7);
    auto mirrored = near;
    mirrored.r.col(0) *= -1;
    const auto one = derivatives(near), other = derivatives(mirrored);
    const double size = one.second.abs().maxCoeff();
    CHECK((one.first.col(0) + other.first.col(0)).abs().maxCoeff() < 1e-9 * size);
    CHECK((one.first.col(1) - other.first.col(1)).abs().maxCoeff() < 1e-9 * size);
    CHECK((one.second.col(0) - other.second.col(0)).abs().maxCoeff() < 1e-9 * size);
    CHECK((one.second.col(2) + other.second.col(2)).abs().maxCoeff() < 1e-9 * size);
}

TEST_CASE(
    "second-order FPM in space: the Laplacian of turned neighbours is the same, and D turns with them") {
    const auto near = random_neighbourhood<double, 2>(60, 1, 9);
    auto turned = near;
    const double c = std::cos(0.7), s = std::sin(0.7);
    turned.r.col(0) = c * near.r.col(0) - s * near.r.col(1);
    turned.r.col(1) = s * near.r.col(0) + c * near.r.col(1);
    const auto one = derivatives(near), other = derivatives(turned);
    const Column<double> laplacian = one.second.col(0) + one.second.col(1);
    const double size = laplacian.abs().maxCoeff();
    CHECK((laplacian - other.second.col(0) - other.second.col(1)).abs().maxCoeff() < 1e-9 * size);
    CHECK((c * one.first.col(0) - s * one.first.col(1) - other.first.col(0)).abs().maxCoeff() < 1e-9 * size);
}

TEST_CASE("second-order FPM in space: volumes count by their ratios only") {
    const auto near = random_neighbourhood<double, 3>(200, 3, 2);
    auto larger = near;
    larger.V *= 1024;
    const auto one = derivatives(near), other = derivatives(larger);
    CHECK((one.second - other.second).abs().maxCoeff() < 1e-12 * one.second.abs().maxCoeff());
    CHECK((one.first - other.first).abs().maxCoeff() < 1e-12 * one.second.abs().maxCoeff());
}

TEST_CASE(
    "second-order FPM in space: on a line it has no zero behind a short first gap, where the paper's (43) has one") {
    for (const double gap : {0.01, 0.05, 0.098056, 0.0981, 0.2, 0.5, 1.0}) {
        Column<double> x = Column<double>::LinSpaced(60, gap - 1, gap + 58) / 60;
        x[0] = 0;
        const auto line = particles::line_at(x, particles::Volumes::equal);
        const auto operators = particles::assemble(line, Smoothing<double>(Gaussian<1>{}, 2.0 / 60),
                                                   required<1>, derivatives<double, 1>);
        const Column<double> f = line.x().exp(), error = (particles::apply(operators.D2, f) - f).abs();
        CAPTURE(gap);
        CHECK(error.maxCoeff() < 0.02);
    }
}

TEST_CASE("second-order FPM in space: neighbours that do not determine the cubics are refused") {
    auto on_circle = random_neighbourhood<double, 2>(40, 0, 4);
    for (Index j = 1; j < on_circle.W.size(); ++j)
        on_circle.r.row(j) /= std::sqrt(on_circle.r.row(j).square().sum());
    CHECK_THROWS_AS(derivatives(on_circle), particles::SingularNeighbourhood);
    CHECK_THROWS_AS(derivatives(random_neighbourhood<double, 2>(9, 0, 4)), particles::SingularNeighbourhood);
    CHECK_THROWS_AS(derivatives(random_neighbourhood<double, 3>(19, 0, 4)), particles::SingularNeighbourhood);
    auto far = random_neighbourhood<double, 2>(40, 0, 4);
    far.W.setZero();
    CHECK_THROWS_AS(derivatives(far), particles::SingularNeighbourhood);
}

namespace {

/// Largest errors of first and of second derivatives.
struct Errors {
    double first = 0, second = 0;
};

/// Errors of exp(x + y/2) + sin(x + 2y) on a grid of n × n particles, h = δ.
Errors errors_on_grid(Index n, const particles::CloudRule<2>& rule = derivatives<double, 2>) {
    const Cloud<2> cloud(support::grid_points<2>(n));
    const auto operators = particles::assemble(
        cloud, Smoothing(Gaussian<2>{}, 1 / static_cast<double>(n - 1)), required<2>, rule);
    const auto x = cloud.x().row(0).transpose().array(), y = cloud.x().row(1).transpose().array();
    const Column<double> e = (x + y / 2).exp(), s = (x + 2 * y).sin(), c = (x + 2 * y).cos(), f = e + s;
    const auto error = [&](const Exponents<2>& a, const Column<double>& exact) {
        return (particles::apply(derivative(operators, a), f) - exact).abs().maxCoeff();
    };
    return {std::max(error({1, 0}, e + c), error({0, 1}, e / 2 + 2 * c)),
            std::max({error({2, 0}, e - s), error({0, 2}, e / 4 - 4 * s), error({1, 1}, e / 2 - 2 * s)})};
}

}  // namespace

TEST_CASE("second-order FPM in space: errors on grids are those of a calculation in NumPy, second order") {
    const Errors coarse = errors_on_grid(16), middle = errors_on_grid(31), fine = errors_on_grid(61);
    CHECK(coarse.first == support::relative(1.347e-2, 1e-3));
    CHECK(coarse.second == support::relative(5.688e-2, 1e-3));
    CHECK(middle.first == support::relative(3.565e-3, 1e-3));
    CHECK(middle.second == support::relative(1.401e-2, 1e-3));
    CHECK(fine.first == support::relative(9.098e-4, 1e-3));
    CHECK(fine.second == support::relative(3.473e-3, 1e-3));
}

TEST_CASE(
    "second-order FPM in space: errors of SSPH with the value given are those of that calculation, too, of second order in second derivatives from degree 3 on") {
    const Errors coarse = errors_on_grid(16, by_ssph<2, double, 2>),
                 quadratic = errors_on_grid(31, by_ssph<2, double, 2>),
                 finer = errors_on_grid(61, by_ssph<2, double, 2>),
                 cubic = errors_on_grid(61, by_ssph<3, double, 2>);
    CHECK(quadratic.first == support::relative(4.197e-3, 1e-3));
    CHECK(quadratic.second == support::relative(3.340e-1, 1e-3));
    CHECK(std::log2(coarse.second / finer.second) / 2 == support::relative(0.98, 0.01));
    CHECK(cubic.first == support::relative(1.474e-5, 1e-3));
    CHECK(cubic.second == support::relative(3.473e-3, 1e-3));
}
