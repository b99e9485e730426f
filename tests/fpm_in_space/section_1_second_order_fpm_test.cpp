#include "fpm_in_space/section_1_second_order_fpm.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include "base/quad.hpp"
#include "fpm_in_space/claims/measures.hpp"
#include "tests/support/clouds.hpp"
#include "tests/support/polynomial.hpp"
#include "tests/support/relative.hpp"

using namespace fpm_in_space;
using namespace fpm_in_space::second_order_fpm;
using base::Quad;
using particles::Cloud;
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

/// Largest relative difference of the second derivatives from SSPH's, over all random neighbourhoods.
template <class Scalar, int dim>
double difference_from_ssph() {
    double most = 0;
    for (int sides = 0; sides <= dim; ++sides)
        for (unsigned seed = 1; seed <= 10; ++seed) {
            const auto near = random_neighbourhood<Scalar, dim>(10 * terms<dim, 3>, sides, seed);
            const auto ours = derivatives(near).second, theirs = ssph_with_value_given<3>(near).second;
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
    CHECK(difference_from_ssph<Quad, 2>() < 1e-25);
}

TEST_CASE(
    "second-order FPM in space, (F2), (F3), (F4): corrections have no odd moments, and the matrix is symmetric and definite") {
    in_every_dimension([](auto dimension) {
        constexpr int dim = dimension;
        const auto p2 = polynomials<double, dim>(quadratic<dim>), o = polynomials<double, dim>(odd<dim>);
        for (int sides = 0; sides <= dim; ++sides) {
            const auto near = random_neighbourhood<double, dim>(10 * terms<dim, 3>, sides, 5);
            const auto products = moments(near);
            const Table<double> C = corrections<dim>(p2, products);
            CHECK(product(C, o, products).cwiseAbs().maxCoeff() <
                  1e-10 * product(o, o, products).cwiseAbs().maxCoeff());
            const Table<double> M = product(C, p2, products);
            CHECK((M - M.transpose()).cwiseAbs().maxCoeff() < 1e-10 * M.cwiseAbs().maxCoeff());
            CHECK((solvers::Cholesky<double>(M).pivots().array() > 0).all());
        }
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
    const auto products = moments(near);
    const Table<double> found = product(f, g, products);
    const Column<double> WV = near.W * near.V, g_j = 3 * x + y * y * y;
    CHECK(found(0, 0) == support::relative(((2 + x * y) * g_j * WV).sum(), 1e-13));
    CHECK(found(1, 0) == support::relative((y * g_j * WV).sum(), 1e-13));
}

TEST_CASE(
    "second-order FPM in space: a mirror of the neighbourhood changes the signs of odd derivatives alone") {
    in_every_dimension([](auto dimension) {
        constexpr int dim = dimension;
        const auto near = random_neighbourhood<double, dim>(10 * terms<dim, 3>, dim, 7);
        auto mirrored = near;
        mirrored.r.col(0) *= -1;
        const auto one = derivatives(near), other = derivatives(mirrored);
        const double size = one.second.abs().maxCoeff();
        const auto all = particles::monomials<dim, 2>();
        for (std::size_t k = 1; k < all.size(); ++k) {
            const auto column = static_cast<Index>(k) - 1;
            const int sign = all[k][0] == 1 ? -1 : 1;
            const Column<double> change =
                column < dim
                    ? Column<double>(one.first.col(column) - sign * other.first.col(column))
                    : Column<double>(one.second.col(column - dim) - sign * other.second.col(column - dim));
            CHECK(change.abs().maxCoeff() < 1e-9 * size);
        }
    });
}

namespace {

/// Checks a neighbourhood on one side of a plane against the same that is turned about two axes.
template <int dim>
void check_turned() {
    const auto near = random_neighbourhood<double, dim>(10 * terms<dim, 3>, 1, 9);
    Eigen::Matrix<double, dim, dim> Q = Eigen::Matrix<double, dim, dim>::Identity();
    for (Index axis = 0; axis + 1 < dim; ++axis) {
        Eigen::Matrix<double, dim, dim> turn = Eigen::Matrix<double, dim, dim>::Identity();
        turn(axis, axis) = turn(axis + 1, axis + 1) = std::cos(0.7);
        turn(axis + 1, axis) = std::sin(0.7);
        turn(axis, axis + 1) = -std::sin(0.7);
        Q = Eigen::Matrix<double, dim, dim>(turn * Q);
    }
    auto turned = near;
    turned.r = (near.r.matrix() * Q.transpose()).array();
    const auto one = derivatives(near), other = derivatives(turned);
    const auto laplacian = [](const auto& D) -> Column<double> {
        return D.second.leftCols(dim).rowwise().sum();
    };
    const double size = laplacian(one).abs().maxCoeff();
    CHECK((laplacian(one) - laplacian(other)).abs().maxCoeff() < 1e-9 * size);
    CHECK((one.first.matrix() * Q.transpose() - other.first.matrix()).cwiseAbs().maxCoeff() < 1e-9 * size);
}

}  // namespace

TEST_CASE(
    "second-order FPM in space: the Laplacian of turned neighbours is the same, and D turns with them") {
    check_turned<2>();
    check_turned<3>();
}

TEST_CASE("second-order FPM in space: on a body four times as large D is a quarter, and D² a sixteenth") {
    in_every_dimension([](auto dimension) {
        constexpr int dim = dimension;
        const Cloud<dim> cloud = irregular<dim>(), larger(Points<dim>(4 * cloud.x()));
        const auto assembled = [](const Cloud<dim>& of) {
            return particles::assemble(of, Smoothing(Gaussian<dim>{}, of.spacing()), required<dim>,
                                       derivatives<double, dim>, {0, 10});
        };
        const auto one = assembled(cloud), other = assembled(larger);
        for (const auto& a : particles::monomials<dim, 2>()) {
            const int order = particles::order<dim>(a);
            if (order == 0) continue;
            const Eigen::MatrixXd D = derivative(one, a), of_larger = derivative(other, a);
            CHECK((D - std::pow(4, order) * of_larger).cwiseAbs().maxCoeff() <
                  1e-12 * D.cwiseAbs().maxCoeff());
        }
    });
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
