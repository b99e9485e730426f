#include "particles/quality.hpp"

#include <doctest/doctest.h>

#include "tests/support/clouds.hpp"
#include "tests/support/least_squares.hpp"

using namespace particles;

namespace {

/// Random particles in the unit cube, enough around each of them.
template <int dim>
Points<dim> particles_in_cube() {
    return support::irregular_points<dim>(dim == 1 ? 60 : dim == 2 ? 14 : 8, 0.3, 7);
}

/// The operators on a cloud whose smoothing length is the mean spacing.
template <int dim>
Operators<double, dim> operators_on(const Cloud<dim>& cloud) {
    return assemble(cloud, Smoothing<double, dim>(Gaussian<dim>{}, cloud.spacing()), {"least_squares", 3},
                    support::LeastSquares{});
}

template <int dim>
Column<double> quality_of(const Cloud<dim>& cloud, const std::type_identity_t<Exponents<dim>>& a,
                          const Operators<double, dim>& operators) {
    return quality(derivative(operators, a), cloud, order<dim>(a), 2,
                   Column<double>(Column<double>::Constant(1, cloud.spacing())));
}

/// Calls `check` for one, two and three dimensions, as compile-time numbers.
template <class Check>
void in_every_dimension(const Check& check) {
    check(std::integral_constant<int, 1>{});
    check(std::integral_constant<int, 2>{});
    check(std::integral_constant<int, 3>{});
}

}  // namespace

TEST_CASE("quality: the differences of a grid have the factors of their error terms") {
    using One = Column<double>;
    const One r{{-1, 0, 1}}, first{{-0.5, 0, 0.5}}, second{{1, -2, 1}}, forward{{0, -1, 1}};
    const auto R = [&](const One& w, int exact) { return quality<double, 1>(w, r, exact); };
    CHECK(std::abs(R(first, 2) - 1 / 6.0) < 1e-15);    // δ²/6 B‴
    CHECK(std::abs(R(second, 3) - 1 / 12.0) < 1e-15);  // δ²/12 B⁗
    CHECK(std::abs(R(forward, 1) - 1 / 2.0) < 1e-15);  // δ/2 B″
}

TEST_CASE("quality: in every dimension, no error is larger than R delta^p max|B^(m+1)|") {
    in_every_dimension([](auto dimension) {
        constexpr int dim = dimension;
        const Cloud<dim> cloud(particles_in_cube<dim>());
        const auto operators = operators_on(cloud);
        const Point<dim> c = Point<dim>::LinSpaced(1.3, -0.7);
        const Column<double> B = (c.transpose() * cloud.x()).array().exp().transpose();
        const double slope = c.norm();  // |dB/ds| ≤ |c| B along any direction
        for (const Exponents<dim>& a : monomials<dim, 2>()) {
            const int k = order<dim>(a);
            if (k == 0) continue;
            const auto& D = derivative(operators, a);
            const Column<double> DB = apply(D, B), R = quality_of(cloud, a, operators);
            double exact = 1;
            for (int axis = 0; axis < dim; ++axis)
                exact *= std::pow(c[axis], a[static_cast<std::size_t>(axis)]);
            double closest = 0;
            for (Index i = 0; i < cloud.size(); ++i) {
                double most = B[i];  // B is monotone along a segment
                for (Operator<double>::InnerIterator entry(D, i); entry; ++entry)
                    most = std::max(most, B[entry.col()]);
                const double bound = R[i] * std::pow(cloud.spacing(), 3 - k) * std::pow(slope, 3) * most;
                CHECK(std::abs(DB[i] - exact * B[i]) <= bound);
                closest = std::max(closest, std::abs(DB[i] - exact * B[i]) / bound);
            }
            CHECK(closest > 0.01);  // and the bound is not idle
        }
    });
}

TEST_CASE("quality: it has no unit and does not depend on place and size") {
    in_every_dimension([](auto dimension) {
        constexpr int dim = dimension;
        const Points<dim> x = particles_in_cube<dim>();
        const Cloud<dim> cloud(x), moved((x * 0.03).colwise() + Point<dim>::LinSpaced(4, 5));
        const auto here = operators_on(cloud), there = operators_on(moved);
        for (const Exponents<dim>& a : monomials<dim, 2>()) {
            if (order<dim>(a) == 0) continue;
            const Column<double> R = quality_of(cloud, a, here), S = quality_of(moved, a, there);
            CHECK(((R - S).abs() / R).maxCoeff() < 1e-9);
        }
    });
}

TEST_CASE("quality: a spacing of each particle measures its own row") {
    const Cloud<2> cloud(particles_in_cube<2>());
    const auto D = operators_on(cloud).D[0];
    const Column<double> delta = Column<double>::LinSpaced(cloud.size(), 0.1, 0.2);
    const Column<double> R = quality(D, cloud, 1, 2, delta),
                         one = quality(D, cloud, 1, 2, Column<double>(Column<double>::Constant(1, 1.0)));
    CHECK((R * delta.square() / one - 1).abs().maxCoeff() < 1e-12);
}

TEST_CASE("quality: absolute sums are those of the weights, by which round-off is multiplied") {
    Operator<> D(2, 3);
    D.insert(0, 0) = -3;
    D.insert(0, 2) = 2;
    D.insert(1, 1) = 0.5;
    CHECK((absolute_sums(D) == Column<>{{5, 0.5}}).all());
}

TEST_CASE("quality: an operator of other particles and another number of spacings are refused") {
    const Cloud<1> cloud(particles_in_cube<1>()), fewer(cloud.x().leftCols(50));
    const auto D = operators_on(cloud).D;
    CHECK_THROWS_WITH_AS(static_cast<void>(quality(D, fewer, 1, 2, Column<double>(Column<double>::Ones(1)))),
                         "an operator of 60 rows is not that of 50 particles", InvalidInput);
    CHECK_THROWS_WITH_AS(static_cast<void>(quality(D, cloud, 1, 2, Column<double>(Column<double>::Ones(3)))),
                         "60 particles need as many spacings, or one, got 3", InvalidInput);
}
