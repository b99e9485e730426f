#include "batra2008/section_2_ssph_basis.hpp"

#include "batra2008/basis_at.hpp"

#include "report/statistics.hpp"
#include "tests/batra2008/bases.hpp"
#include "tests/relative.hpp"

using namespace batra2008;
using namespace batra2008::ssph_basis;
using particles::Cloud;
using particles::TruncatedGaussian;
using support::Polynomial;

namespace {

/// Calls `visit` for some dimensions and degrees as compile-time numbers.
template <class Visit>
void for_some_dimensions_and_degrees(const Visit& visit) {
    visit(std::integral_constant<int, 1>(), std::integral_constant<int, 3>());
    visit(std::integral_constant<int, 2>(), std::integral_constant<int, 2>());
    visit(std::integral_constant<int, 2>(), std::integral_constant<int, 3>());
    visit(std::integral_constant<int, 3>(), std::integral_constant<int, 2>());
}

double factorial_of(const support::Powers& a) {
    return std::tgamma(a[0] + 1) * std::tgamma(a[1] + 1) * std::tgamma(a[2] + 1);
}
int order_of(const support::Powers& a) {
    return a[0] + a[1] + a[2];
}

/// Weighted monomials of random offsets.
template <int dim, int m>
struct Sample {
    explicit Sample(Index count, unsigned seed)
        : s(support::random_points<dim>(count, seed).transpose().array() * 2 - 1),
          H(ssph_basis::H<dim, m, double>(s)),
          W((-s.square().rowwise().sum()).exp()) {}
    Eigen::Array<double, Eigen::Dynamic, dim> s;
    Table<double> H;
    Column<double> W;
};

/// Particles at the given places of the plane, seen from the origin with h = 1 and constant weights.
Surroundings<2> seen(const Points<2>& x) {
    Surroundings<2> near;
    near.s = x.transpose().array();
    near.W = Column<double>::Ones(x.cols());
    near.edge = 0;
    for (int j = 0; j < x.cols(); ++j) near.particle.push_back(j);
    return near;
}

}  // namespace

TEST_CASE(
    "(2.1): Taylor's expansion is exact for polynomials, and of others leaves the next power of the offset") {
    for_some_dimensions_and_degrees([](auto dimension, auto degree) {
        constexpr int dim = dimension, m = degree;
        const Polynomial f(dim, m, 3);
        support::Draws draw(1);
        const Point<dim> x = draw.point<dim>(), offset = draw.point<dim>();
        const auto derivative = [&](const Exponents<dim>& a) { return f.derivative(support::powers(a), x); };
        CHECK(taylor<dim, m>(derivative, offset) == support::relative(f(x + offset), 1e-13));

        const auto exponential = [](const Exponents<dim>& /*a*/) {
            return 1.0;
        };  // of the sum, at the origin
        std::vector<double> size, error;
        for (const double length : {0.04, 0.02, 0.01}) {
            size.push_back(length);
            error.push_back(std::abs(taylor<dim, m>(exponential, Point<dim>(length * Point<dim>::Ones())) -
                                     std::exp(dim * length)));
        }
        CHECK(report::observed_order(size, error) == support::relative(m + 1, 0.02));
    });
}

TEST_CASE("(2.2): the monomials times the derivatives are the function, for polynomials of degree m") {
    for_some_dimensions_and_degrees([](auto dimension, auto degree) {
        constexpr int dim = dimension, m = degree;
        const Polynomial f(dim, m, 4);
        support::Draws draw(2);
        const Point<dim> x = draw.point<dim>(), offset = draw.point<dim>();
        const auto derivative = [&](const Exponents<dim>& a) { return f.derivative(support::powers(a), x); };
        CHECK(value(P<dim, m>(offset), Q<dim, m>(derivative)) == support::relative(f(x + offset), 1e-13));
    });
}

TEST_CASE("(2.2), (2.3): monomials and derivatives stand in the print's order, with its factors") {
    const auto P_3 = P<3, 2>({2, 3, 5});
    CHECK(P_3 == Eigen::Matrix<double, 1, 10>{{1, 2, 3, 5, 4, 9, 25, 6, 15, 10}});
    const auto P_2 = P<2, 2>({2, 3});
    CHECK(P_2 == Eigen::Matrix<double, 1, 6>{{1, 2, 3, 4, 9, 6}});
    const auto P_1 = P<1, 3>(Point<1>(2));
    CHECK(P_1 == Eigen::Matrix<double, 1, 4>{{1, 2, 4, 8}});
    // Beyond the print, after its pattern: pure powers first, then those with more of the first coordinate.
    const auto cubic = P<2, 3>({2, 3});
    CHECK(cubic == Eigen::Matrix<double, 1, 10>{{1, 2, 3, 4, 9, 6, 8, 27, 12, 18}});
    // The derivative a1, a2, a3 times is here the number with these digits.
    const auto Q_3 = Q<3, 2>([](const Exponents<3>& a) { return 100 * a[0] + 10 * a[1] + a[2]; });
    CHECK(Q_3 == Eigen::Matrix<double, 10, 1>{{0, 100, 10, 1, 200.0 / 2, 20.0 / 2, 2.0 / 2, 110, 11, 101}});
    const auto Q_2 = Q<2, 2>([](const Exponents<2>& a) { return 10 * a[0] + a[1]; });
    CHECK(Q_2 == Eigen::Matrix<double, 6, 1>{{0, 10, 1, 20.0 / 2, 2.0 / 2, 11}});
    const auto Q_1 = Q<1, 3>([](const Exponents<1>& a) { return a[0]; });
    CHECK(Q_1 == Eigen::Vector4d(0, 1, 2.0 / 2, 3.0 / 6));
}

TEST_CASE("(2.3): the monomials are all of degree m and less, each once, by degree") {
    support::for_each_dimension_and_degree([](int dim, int m) {
        const auto all = support::Irregular(dim).at(m, Eigen::VectorXd::Constant(dim, 0.5)).exponents;
        CHECK(static_cast<long>(all.size()) ==
              std::lround(std::tgamma(dim + m + 1) / std::tgamma(dim + 1) / std::tgamma(m + 1)));
        for (std::size_t k = 0; k < all.size(); ++k) {
            CHECK(order_of(all[k]) <= m);
            if (k > 0) CHECK(order_of(all[k]) >= order_of(all[k - 1]));
            CHECK(std::count(all.begin(), all.end(), all[k]) == 1);
        }
    });
}

TEST_CASE("(2.4), (2.5): what one particle says of Q, and the sum over the particles") {
    const Polynomial f(2, 2, 6);
    const Sample<2, 2> near(9, 1);
    const auto Q_0 =
        Q<2, 2>([&](const Exponents<2>& a) { return f.derivative(support::powers(a), Point<2>::Zero()); });
    Eigen::Matrix<double, 6, 1> left = Eigen::Matrix<double, 6, 1>::Zero();
    for (Index j = 0; j < 9; ++j) {
        const double f_j = f(near.s.row(j).matrix().transpose());
        const Eigen::Matrix<double, 6, 1> term = f_j * near.W[j] * near.H.col(j);
        CHECK((term - outer_product<double>(near.H.col(j).transpose(), near.W[j]) * Q_0).norm() < 1e-14);
        left += term;
    }
    CHECK((left - summed(near.H, near.W) * Q_0).norm() < 1e-13);
}

TEST_CASE("(2.6): a column of H holds the monomials P of a particle's offset") {
    for_some_dimensions_and_degrees([](auto dimension, auto degree) {
        constexpr int dim = dimension, m = degree;
        const Sample<dim, m> near(7, 3);
        constexpr auto all = monomials<dim, m>();
        for (Index j = 0; j < 7; ++j)
            for (Index k = 0; k < terms<dim, m>; ++k) {
                double power = 1;
                for (Index axis = 0; axis < dim; ++axis)
                    power *= std::pow(near.s(j, axis),
                                      all[static_cast<std::size_t>(k)][static_cast<std::size_t>(axis)]);
                CHECK(near.H(k, j) == support::relative(power, 1e-14));
                CHECK(P<dim, m>(near.s.row(j).matrix().transpose())[k] == support::relative(power, 1e-14));
            }
    });
}

TEST_CASE("(2.7): both sides as products of matrices are the sums of (2.5)") {
    const Polynomial f(3, 2, 8);
    const Sample<3, 2> near(15, 2);
    const auto Q_0 =
        Q<3, 2>([&](const Exponents<3>& a) { return f.derivative(support::powers(a), Point<3>::Zero()); });
    Column<double> F(15);
    Eigen::Matrix<double, 10, 1> sum = Eigen::Matrix<double, 10, 1>::Zero();
    for (Index j = 0; j < 15; ++j) {
        F[j] = f(near.s.row(j).matrix().transpose());
        sum += F[j] * near.W[j] * near.H.col(j);
    }
    const auto [left, right] = both_sides(near.H, near.W, F, Q_0);
    CHECK((left - sum).norm() < 1e-13);
    CHECK((right - summed(near.H, near.W) * Q_0).norm() < 1e-13);
    CHECK((left - right).norm() < 1e-13);
}

TEST_CASE("(2.8): C Q = D F for a polynomial of degree m, and D holds the weighted monomials") {
    const Polynomial f(2, 3, 9);
    const Sample<2, 3> near(14, 4);
    const auto Q_0 =
        Q<2, 3>([&](const Exponents<2>& a) { return f.derivative(support::powers(a), Point<2>::Zero()); });
    const auto D_near = D<double>(near.H, near.W);
    Column<double> F(14);
    for (Index j = 0; j < 14; ++j) {
        F[j] = f(near.s.row(j).matrix().transpose());
        CHECK(D_near.col(j) == near.W[j] * near.H.col(j));
    }
    CHECK((C<double>(D_near, near.H) * Q_0 - D_near * F.matrix()).norm() < 1e-13);
}

TEST_CASE("(2.9): C is symmetric to the last bit, positive, and the sum of (2.5)") {
    for_some_dimensions_and_degrees([](auto dimension, auto degree) {
        constexpr int dim = dimension, m = degree, n = terms<dim, m>;
        const Sample<dim, m> near(3 * n, 5);
        const auto C_near = C<double>(D<double>(near.H, near.W), near.H);
        CHECK(C_near == C_near.transpose());
        CHECK((C_near - summed(near.H, near.W)).norm() < 1e-13 * C_near.norm());
        CHECK(Eigen::LLT<Eigen::MatrixXd>(C_near).info() == Eigen::Success);
    });
}

TEST_CASE("(2.9), (2.11): no derivative of the kernel enters, so that weights may be constant") {
    const Polynomial f(2, 2, 12);
    const Points<2> x = 2 * support::random_points<2>(11, 3) - Points<2>::Ones(2, 11);
    const Basis<2, 2> basis(seen(x), 1);
    for (Index I = 0; I < 6; ++I) {
        const auto a = monomials<2, 2>()[static_cast<std::size_t>(I)];
        double sum = 0;
        for (Index j = 0; j < 11; ++j) sum += basis.row(I + 1)[j] * f(x.col(j));
        CHECK(std::abs(sum - f.derivative(support::powers(a), Point<2>::Zero()) / factorial<2>(a)) < 1e-13);
    }
}

TEST_CASE("(2.10): the determinant by Binet and Cauchy is that of C, in one dimension and in the plane") {
    const auto check = [](auto dimension, auto degree, Index count) {
        constexpr int dim = dimension, m = degree;
        const Sample<dim, m> near(count, 6);
        const double det_C = C<double>(D<double>(near.H, near.W), near.H).determinant();
        CHECK(det_C > 0);
        CHECK(determinant(near.H, near.W) == support::relative(det_C, 1e-10));
    };
    const std::integral_constant<int, 1> one;
    const std::integral_constant<int, 2> two;
    check(one, one, 6);
    check(one, two, 6);
    check(two, one, 7);
    check(two, two, 9);
    check(two, two, 6);  // a single choice
}

TEST_CASE("(2.10): the determinant vanishes where the particles lie on a conic, however many they are") {
    const auto det = [](const Points<2>& x) {
        const Eigen::Array<double, Eigen::Dynamic, 2> s = x.transpose().array();
        return determinant<double>(H<2, 2, double>(s), Column<double>::Ones(x.cols()));
    };
    const Points<2> on_circle = support::circle(9, 1.2, {0.3, -0.2});
    Points<2> two_lines = support::random_points<2>(9, 4), one_off = on_circle;
    two_lines.row(1).head(5).setConstant(0.5);
    two_lines.row(0).tail(4) = two_lines.row(1).tail(4);
    one_off.col(4) *= 0.5;
    CHECK(det(on_circle) < 1e-25);
    CHECK(det(two_lines) < 1e-25);
    CHECK(det(one_off) > 1e-4);
}

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
                const double unit = std::pow(irregular.h, order_of(exponents[I]));
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
                    double& largest = error[static_cast<std::size_t>(order_of(exponents[I]))][k];
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
        Eigen::VectorXd most = Eigen::VectorXd::Ones(6), least = most;  // by powers of C and of its inverse
        for (int k = 0; k < 200; ++k) {
            most = (basis.matrix() * most).normalized();
            least = basis.matrix().llt().solve(least).normalized();
        }
        CHECK(support::condition(basis.matrix()) ==
              support::relative(most.dot(basis.matrix() * most) / least.dot(basis.matrix() * least), 1e-9));
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
