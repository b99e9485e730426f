#include <doctest/doctest.h>
#include <omp.h>

#include "tests/support/clouds.hpp"
#include "tests/support/least_squares.hpp"
#include "tests/support/polynomial.hpp"
#include "tests/support/same_bytes.hpp"

using namespace particles;
using support::LeastSquares;
using support::same_bytes;

namespace {

const Requirement required{"least_squares", 3};

/// Random particles in the unit cube, enough around each of them.
template <int dim>
struct Scene {
    Points<dim> x = support::irregular_points<dim>(dim == 1 ? 60 : dim == 2 ? 14 : 8, 0.3, 7);
    Cloud<dim> cloud{x};
    Smoothing<double, dim> smoothing{Gaussian<dim>{}, cloud.spacing()};

    Operators<double, dim> operators() const { return assemble(cloud, smoothing, required, LeastSquares{}); }
};

/// Calls `check` for one, two and three dimensions, as compile-time numbers.
template <class Check>
void in_every_dimension(const Check& check) {
    check(std::integral_constant<int, 1>{});
    check(std::integral_constant<int, 2>{});
    check(std::integral_constant<int, 3>{});
}

/// Calls `check(a)` for each multi-index of order 1 or 2.
template <int dim, class Check>
void for_each_derivative(const Check& check) {
    for (const Exponents<dim>& a : monomials<dim, 2>())
        if (order<dim>(a) > 0) {
            CAPTURE(dim);
            check(a);
        }
}

}  // namespace

TEST_CASE("operators: in every dimension, quadratic polynomials on a random cloud have their derivatives") {
    in_every_dimension([](auto dimension) {
        constexpr int dim = dimension;
        const Scene<dim> scene;
        const auto operators = scene.operators();
        const support::Polynomial f(dim, 2, 3);
        Column<double> B(scene.cloud.size());
        for (Index j = 0; j < B.size(); ++j) B[j] = f(scene.x.col(j));
        for_each_derivative<dim>([&](const Exponents<dim>& a) {
            const Column<double> found = apply(derivative(operators, a), B);
            for (Index i = 0; i < B.size(); ++i)
                REQUIRE(std::abs(found[i] - f.derivative(support::powers(a), scene.x.col(i))) < 1e-8);
        });
    });
}

TEST_CASE("operators: in every dimension, the weights of a row sum to zero to the last bit") {
    in_every_dimension([](auto dimension) {
        constexpr int dim = dimension;
        const auto operators = Scene<dim>().operators();
        for_each_derivative<dim>([&](const Exponents<dim>& a) {
            const Operator<double>& D = derivative(operators, a);
            for (Index i = 0; i < D.rows(); ++i) {
                double others = 0;
                for (Operator<double>::InnerIterator entry(D, i); entry; ++entry)
                    if (entry.col() != i) others += entry.value();
                REQUIRE(others + D.coeff(i, i) == 0);
            }
        });
    });
}

TEST_CASE("operators: in every dimension, some rows are those of all, on any number of threads") {
    in_every_dimension([](auto dimension) {
        constexpr int dim = dimension;
        const Scene<dim> scene;
        const auto all = scene.operators();
        for (const int threads : {1, 2, 5}) {
            omp_set_num_threads(threads);
            for (const Range rows :
                 {Range{0, 1}, Range{3, 50}, Range{17, 17}, Range{0, scene.cloud.size()}}) {
                const auto some = assemble(scene.cloud, scene.smoothing, required, LeastSquares{}, rows);
                for_each_derivative<dim>([&](const Exponents<dim>& a) {
                    const Operator<double> part = derivative(all, a).middleRows(rows.first, rows.size());
                    CHECK(same_bytes(derivative(some, a), part));
                });
            }
        }
        omp_set_num_threads(omp_get_num_procs());
    });
    CHECK_THROWS_WITH_AS(
        assemble(Scene<2>().cloud, Scene<2>().smoothing, required, LeastSquares{}, {5, 1000}),
        "there are no rows 5 to 999 among 196 particles", InvalidInput);
}

TEST_CASE(
    "operators: in every dimension, a mirrored cloud has mirrored weights, and a permuted one permuted") {
    in_every_dimension([](auto dimension) {
        constexpr int dim = dimension;
        const Scene<dim> scene;
        const auto operators = scene.operators();
        Points<dim> mirrored = scene.x;
        mirrored.row(0) = 1 - mirrored.row(0).array();
        const Index N = mirrored.cols();
        const Points<dim> reversed = mirrored.rowwise().reverse();
        const auto others = assemble(Cloud<dim>(reversed), scene.smoothing, required, LeastSquares{});
        for_each_derivative<dim>([&](const Exponents<dim>& a) {
            const Eigen::MatrixXd D(derivative(operators, a)), E(derivative(others, a));
            const double sign = a[0] % 2 == 0 ? 1 : -1;
            REQUIRE(E.rows() == N);
            CHECK((D - sign * E.reverse()).cwiseAbs().maxCoeff() < 1e-9 * D.cwiseAbs().maxCoeff());
        });
    });
}

TEST_CASE("operators: a cloud turned by a right angle has its derivatives exchanged") {
    const Scene<2> scene;
    const auto operators = scene.operators();
    Points<2> turned(2, scene.x.cols());  // (x, y) becomes (-y, x)
    turned.row(0) = -scene.x.row(1);
    turned.row(1) = scene.x.row(0);
    const auto others = assemble(Cloud<2>(turned), scene.smoothing, required, LeastSquares{});
    const auto differ = [&](const Exponents<2>& a, const Exponents<2>& b, double sign) {
        const Eigen::MatrixXd D(derivative(operators, a)), E(derivative(others, b));
        return (D - sign * E).cwiseAbs().maxCoeff() / D.cwiseAbs().maxCoeff();
    };
    CHECK(differ({1, 0}, {0, 1}, 1) < 1e-11);
    CHECK(differ({0, 1}, {1, 0}, -1) < 1e-11);
    CHECK(differ({2, 0}, {0, 2}, 1) < 1e-11);
    CHECK(differ({1, 1}, {1, 1}, -1) < 1e-11);
}

TEST_CASE("operators: in every dimension, stretching by a divides a derivative of order k by a to the k") {
    in_every_dimension([](auto dimension) {
        constexpr int dim = dimension;
        const Scene<dim> scene;
        const auto operators = scene.operators();
        const Cloud<dim> stretched(8 * scene.x);
        const auto others =
            assemble(stretched, Smoothing<double, dim>(Gaussian<dim>{}, 8 * scene.cloud.spacing()), required,
                     LeastSquares{});
        for_each_derivative<dim>([&](const Exponents<dim>& a) {
            const Eigen::MatrixXd D(derivative(operators, a)), E(derivative(others, a));
            CHECK((D - std::pow(8, order<dim>(a)) * E).cwiseAbs().maxCoeff() <
                  1e-11 * D.cwiseAbs().maxCoeff());
        });
    });
}

TEST_CASE("operators: a line and the same particles as a cloud have the same operators") {
    const Column<double> x = perturbed_positions<double>(60, 0.25, 9);
    const auto line = line_at<double>(x, Volumes::partition);
    const Smoothing<double> smoothing(Gaussian{}, line.spacing());
    const auto of_line = assemble(line, smoothing, required, LeastSquares{});
    const Cloud<1> cloud(x.matrix().transpose(), line.V());
    const auto of_cloud = assemble(cloud, smoothing, required, LeastSquares{});
    const auto differ = [](const Operator<double>& a, const Operator<double>& b) {
        return Eigen::MatrixXd(a - b).cwiseAbs().maxCoeff() / Eigen::MatrixXd(a).cwiseAbs().maxCoeff();
    };
    CHECK(differ(of_line.D, of_cloud.D) < 2e-12);  // packs of the line differ in the last digits
    CHECK(differ(of_line.D2, of_cloud.D2) < 2e-12);
    CHECK_THROWS_WITH_AS(derivative(of_line, {3}), "operators of order 1 and 2 are known, not of order 3",
                         InvalidInput);
}

TEST_CASE("operators: in every dimension, what does not fit together is refused before it is computed") {
    in_every_dimension([](auto dimension) {
        constexpr int dim = dimension;
        const Scene<dim> scene;
        const Column<double> three = Column<double>::Constant(3, 0.1);
        CHECK_THROWS_WITH_AS(
            static_cast<void>(assemble(scene.cloud, Smoothing<double, dim>(Gaussian<dim>{}, three), required,
                                       LeastSquares{})),
            (std::to_string(scene.cloud.size()) + " particles need as many smoothing lengths, or one, got 3")
                .c_str(),
            InvalidInput);
        const auto gradient_alone = [](const Neighbourhood<double, dim>& near) -> Derivatives<double, dim> {
            return {near.DW, {}};
        };
        CHECK_THROWS_WITH_AS(
            static_cast<void>(assemble(scene.cloud, scene.smoothing, {"gradient", 3}, gradient_alone)),
            "gradient has given no weights of second derivatives, which a cloud's operators need",
            InvalidInput);
        const auto not_finite = [](const Neighbourhood<double, dim>& near) {
            auto all = LeastSquares{}(near);
            all.second(0, 0) = std::nan("");
            return all;
        };
        CHECK_THROWS_WITH_AS(
            static_cast<void>(assemble(scene.cloud, scene.smoothing, {"mine", 3}, not_finite)),
            doctest::Contains("but its weights are not finite; "), FailedComputation);
    });
}
