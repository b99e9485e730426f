#include "batra2008/basis_at.hpp"
#include "batra2008/section_2_ssph_basis.hpp"

#include <Eigen/Cholesky>

#include "report/statistics.hpp"
#include "tests/batra2008/bases.hpp"
#include "tests/support/relative.hpp"

using namespace batra2008;
using namespace batra2008::ssph_basis;
using particles::Cloud;
using particles::TruncatedGaussian;
using support::Polynomial;

namespace {

double factorial_of(const support::Powers& a) {
    return std::tgamma(a[0] + 1) * std::tgamma(a[1] + 1) * std::tgamma(a[2] + 1);
}
}  // namespace

TEST_CASE(
    "(2.11): polynomials of degree m are reproduced with all their derivatives on irregular particles") {
    support::for_each_dimension_and_degree([](int dim, int m) {
        const support::Irregular irregular(dim);
        const Polynomial f(dim, m, 10);
        for (const Eigen::VectorXd& x : irregular.places()) {
            const auto [particle, exponents, K, slopes] = irregular.at(m, x);
            const Column<double> F = irregular.values(particle, f);
            for (std::size_t I = 0; I < exponents.size(); ++I) {
                const double exact = f.derivative(exponents[I], x) / factorial_of(exponents[I]);
                const double unit = std::pow(irregular.h, support::order(exponents[I]));
                const double found = (K.col(static_cast<Index>(I)) * F).sum();
                CHECK(std::abs(found - exact) * unit < 1e-10 * F.abs().maxCoeff());
            }
        }
    });
}

TEST_CASE("(2.12): S picks the particles of the support, and S Sᵀ is the unit matrix") {
    const Eigen::MatrixXd S = selection({1, 4, 5}, 7);
    CHECK(S == Eigen::MatrixXd{{0, 1, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 1, 0, 0}, {0, 0, 0, 0, 0, 1, 0}});
    const support::Irregular irregular(2);
    const std::vector<int> particle = irregular.at(2, Point<2>(0.4, 0.6)).particle;
    const auto all = selection(particle, irregular.x.cols());
    CHECK(Eigen::MatrixXd(all * all.transpose()).isIdentity(0));
    const Eigen::VectorXd F = Eigen::VectorXd::LinSpaced(irregular.x.cols(), 0, 1);
    CHECK(all * F == F(particle));
}

TEST_CASE("(2.13), (2.14): with the values of all particles the estimate is the same") {
    const support::Irregular irregular(2);
    const auto wave = [](const Point<2>& x) { return std::exp(x[0]) * std::cos(2 * x[1]); };
    Column<double> all(irregular.x.cols());
    for (Index j = 0; j < all.size(); ++j) all[j] = wave(irregular.x.col(j));
    for (const Eigen::VectorXd& x : irregular.places()) {
        const auto [particle, exponents, K, slopes] = irregular.at(2, x);
        const auto S = selection(particle, irregular.x.cols());
        const Column<double> F_x = irregular.values(particle, wave);
        for (Index I = 0; I < 6; ++I) {
            const double estimate = (K.col(I) * F_x).sum();
            CHECK(through_selection<double>(K.col(I), S, F_x) == support::relative(estimate, 1e-11));
            const Column<double> K_I = spread<double>(K.col(I), S);
            REQUIRE(K_I.size() == all.size());
            CHECK((K_I * all).sum() == support::relative(estimate, 1e-11));
            CHECK((K_I != 0).count() == F_x.size());
        }
    }
}

TEST_CASE("(2.15): the derivatives of polynomials of degree m, in the plane by position in the print") {
    const support::Irregular irregular(2);
    const Cloud<2> cloud(irregular.x);
    const Polynomial f(2, 2, 11);
    for (const Eigen::VectorXd& x : irregular.places()) {
        const auto basis = basis_at<2>(cloud, TruncatedGaussian<2>(3), Point<2>(x), irregular.h);
        const Column<double> F = irregular.values(basis.particle(), f);
        const std::array<support::Powers, 6> in_order{
            {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {0, 2, 0}, {1, 1, 0}}};
        for (std::size_t I = 0; I < 6; ++I)
            CHECK(std::abs((derivative(basis, {in_order[I][0], in_order[I][1]}) * F).sum() -
                           f.derivative(in_order[I], x)) < 1e-10);
        CHECK((derivative(basis, {2, 0}) == 2 * K<4>(basis)).all());
        CHECK((derivative(basis, {1, 1}) == K<6>(basis)).all());
    }
}

TEST_CASE(
    "(2.15): the error of a derivative of order k falls with h to the power m + 1 - k, inside and at an edge") {
    // A pattern of irregular particles around a place shrinks; the print claims one order less.
    const std::vector<double> lengths{0.01, 0.005, 0.0025, 0.00125};
    support::for_each_dimension_and_degree([&](int dim, int m) {
        const Eigen::VectorXd a = Point<3>(1.3, -0.8, 0.6).head(dim), x = Eigen::VectorXd::Constant(dim, 0.2);
        for (const double from : {-1.5, 0.0}) {
            CAPTURE(from);
            const Eigen::MatrixXd pattern =
                (6 * support::irregular_points_of(dim, 7, 17).array() + from).matrix();
            std::vector<std::vector<double>> error(static_cast<std::size_t>(m + 1),
                                                   std::vector<double>(4, 0));
            for (std::size_t k = 0; k < 4; ++k) {
                const Eigen::MatrixXd particles = (lengths[k] * pattern).colwise() + x;
                const auto [particle, exponents, K, slopes] = support::bases(m, particles, 4, x, lengths[k]);
                for (std::size_t I = 0; I < exponents.size(); ++I) {
                    double exact = std::exp(a.dot(x)), sum = 0;
                    for (Index axis = 0; axis < dim; ++axis)
                        exact *= std::pow(a[axis], exponents[I][static_cast<std::size_t>(axis)]);
                    for (std::size_t j = 0; j < particle.size(); ++j)
                        sum += K(static_cast<Index>(j), static_cast<Index>(I)) *
                               std::exp(a.dot(particles.col(particle[j])));
                    double& largest = error[static_cast<std::size_t>(support::order(exponents[I]))][k];
                    largest = std::max(largest, std::abs(factorial_of(exponents[I]) * sum - exact));
                }
            }
            for (int k = 0; k <= m; ++k) {
                CAPTURE(k);
                CHECK(std::abs(report::observed_order(lengths, error[static_cast<std::size_t>(k)]) -
                               (m + 1 - k)) < 0.1);
            }
        }
    });
}

TEST_CASE(
    "(2.16): the differentiated basis functions are the slopes of the basis functions of all of Q, by finite differences") {
    support::for_each_dimension_and_degree([](int dim, int m) {
        const support::Irregular irregular(dim);
        int compared = 0;
        for (const Eigen::VectorXd& x : irregular.places())
            for (int axis = 0; axis < dim; ++axis) {
                const double step = 1e-5 * irregular.h;
                const auto there = irregular.at(m, x + step * Eigen::VectorXd::Unit(dim, axis)),
                           back = irregular.at(m, x - step * Eigen::VectorXd::Unit(dim, axis)),
                           here = irregular.at(m, x);
                if (there.particle != here.particle || back.particle != here.particle) continue;
                for (Index I = 0; I < here.K.cols(); ++I) {
                    const Column<double> slope = (there.K.col(I) - back.K.col(I)) / (2 * step);
                    const double error =
                        (here.slopes[static_cast<std::size_t>(I)].col(axis) - slope).abs().maxCoeff();
                    CAPTURE(I);
                    CHECK(error < 1e-5 * here.K.col(I).abs().maxCoeff() / irregular.h);
                    if (I == 0) CHECK(error < 1e-7 * slope.abs().maxCoeff());
                }
                ++compared;
            }
        CHECK(compared >= 6);
    });
    const support::Irregular irregular(2);
    const auto basis = basis_at<2>(Cloud<2>(irregular.x), TruncatedGaussian<2>(irregular.rho),
                                   Point<2>(0.4, 0.6), irregular.h);
    for (int axis = 0; axis < 2; ++axis)
        CHECK((differentiated_value(basis, axis) == irregular.at(2, Point<2>(0.4, 0.6)).slopes[0].col(axis))
                  .all());
}

TEST_CASE(
    "(2.16): the slopes are exact for polynomials of degree m, yet no basis functions of the derivative") {
    support::for_each_dimension_and_degree([](int dim, int m) {
        const support::Irregular irregular(dim);
        const Polynomial f(dim, m, 13);
        double apart = 0;
        for (const Eigen::VectorXd& x : irregular.places()) {
            const auto [particle, exponents, K, slopes] = irregular.at(m, x);
            const Column<double> F = irregular.values(particle, f);
            for (Index axis = 0; axis < dim; ++axis) {
                const double exact = f.derivative(exponents[static_cast<std::size_t>(1 + axis)], x);
                CHECK(std::abs((slopes[0].col(axis) * F).sum() - exact) * irregular.h <
                      1e-10 * F.abs().maxCoeff());
                apart =
                    std::max(apart, (slopes[0].col(axis) - K.col(1 + axis)).abs().maxCoeff() * irregular.h);
            }
        }
        CHECK(apart > 0.1);
    });
}

TEST_CASE(
    "ssph_basis: basis functions sum to one and their slopes to zero, and are not one at their own particle") {
    const support::Irregular irregular(3);
    const auto [particle, exponents, K, slopes] = irregular.at(2, irregular.x.col(200));
    CHECK(K.col(0).sum() == support::relative(1, 1e-13));
    CHECK(K.col(0).maxCoeff() < 0.9);
    for (Index I = 1; I < 10; ++I) CHECK(std::abs(K.col(I).sum()) < 1e-12 * K.col(I).abs().sum());
    for (Index axis = 0; axis < 3; ++axis)
        CHECK(std::abs(slopes[0].col(axis).sum()) < 1e-12 * slopes[0].col(axis).abs().sum());
}

TEST_CASE("ssph_basis: the condition of C depends neither on h nor on the unit of length") {
    const auto condition = [](const Points<2>& x, const Point<2>& place, double h) {
        return support::condition(basis_at<2>(Cloud<2>(x), TruncatedGaussian<2>(3), place, h).matrix());
    };
    const support::Irregular irregular(2);
    const Points<2> x = irregular.x;
    const Point<2> place(0.4, 0.3);
    const double in_metres = condition(x, place, irregular.h);
    for (const double unit : {1e-9, 1e-3, 0.37, 25.4, 1e6})
        CHECK(condition(unit * x, unit * place, unit * irregular.h) == support::relative(in_metres, 1e-9));
    // The middle of a grid's side, and inside of it.
    const Points<2> coarse = support::grid_points<2>(9), fine = support::grid_points<2>(65);
    CHECK(condition(coarse, {0.5, 0}, 1.0 / 8) ==
          support::relative(condition(fine, {0.5, 0}, 1.0 / 64), 1e-9));
    CHECK(condition(coarse, {0.5, 0.5}, 1.0 / 8) ==
          support::relative(condition(fine, {0.5, 0.5}, 1.0 / 64), 1e-9));
}

TEST_CASE(
    "ssph_basis: the condition of C is the ratio of the outermost eigenvalues, on a grid at most 101 with ρ = 3") {
    const Cloud<2> grid(support::grid_points<2>(9));
    double worst = 0;
    for (Index j = 0; j < grid.size(); ++j) {
        const auto basis = basis_at<2>(grid, TruncatedGaussian<2>(3), Point<2>(grid.x().col(j)), 1.0 / 8);
        Eigen::VectorXd u = Eigen::VectorXd::Ones(6), v = u;  // by powers of C and of its inverse
        for (int k = 0; k < 200; ++k) {
            u = (basis.matrix() * u).normalized();
            v = basis.matrix().llt().solve(v).normalized();
        }
        CHECK(support::condition(basis.matrix()) ==
              support::relative(u.dot(basis.matrix() * u) / v.dot(basis.matrix() * v), 1e-9));
        worst = std::max(worst, support::condition(basis.matrix()));
    }
    CHECK(worst == support::relative(101, 0.01));
}

TEST_CASE("ssph_basis: all rows of K at once are those computed one by one") {
    const support::Irregular irregular(2);
    const Cloud<2> cloud(irregular.x);
    for (const Eigen::VectorXd& x : irregular.places()) {
        const auto basis = basis_at<2>(cloud, TruncatedGaussian<2>(irregular.rho), Point<2>(x), irregular.h);
        const auto all = basis.K();
        REQUIRE(all.rows() == basis.n);
        for (Index I = 1; I <= basis.n; ++I) {
            const Column<double> row = all.row(I - 1).transpose();
            CHECK((row - basis.row(I)).abs().maxCoeff() < 1e-10 * row.abs().maxCoeff());
        }
    }
}

TEST_CASE("ssph_basis: the derivatives that operators take are exact for quadratics, the mixed one too") {
    const particles::Offsets<double, 2> r = 2 * support::random_points<2>(20, 3).transpose().array() - 1;
    const Column<double> x = r.col(0), y = r.col(1), W = (-x * x - y * y).exp();
    const Column<double> f = 2 * x - 3 * y + x * x + 5 * x * y - 4 * y * y;
    const auto [first, second] = derivatives<2>(particles::Neighbourhood<double, 2>{r, W, {}, {}});
    const auto applied = [&](const Column<double>& weights) { return (weights * f).sum(); };
    CHECK(std::abs(applied(first.col(0)) - 2) < 1e-12);
    CHECK(std::abs(applied(first.col(1)) + 3) < 1e-12);
    CHECK(std::abs(applied(second.col(0)) - 2) < 1e-12);
    CHECK(std::abs(applied(second.col(1)) + 8) < 1e-12);
    CHECK(std::abs(applied(second.col(2)) - 5) < 1e-12);
}
