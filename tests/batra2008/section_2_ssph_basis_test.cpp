#include "batra2008/section_2_ssph_basis.hpp"

#include "report/statistics.hpp"
#include "tests/batra2008/bases.hpp"
#include "tests/relative.hpp"

using namespace batra2008;
using namespace batra2008::ssph_basis;
using particles::Cloud;
using particles::TruncatedGaussian;
using support::Polynomial;

namespace {

/// Calls `visit` for one, two and three dimensions, and degrees 1, 2 and 3 in each.
template <class Visit>
void for_each_dimension_and_degree(const Visit& visit) {
    for (const int dim : {1, 2, 3})
        for (const int m : {1, 2, 3}) {
            CAPTURE(dim);
            CAPTURE(m);
            visit(dim, m);
        }
}

/// The same with compile-time numbers, for those parts that take them; not all nine.
template <class Visit>
void for_some_dimensions_and_degrees(const Visit& visit) {
    visit(std::integral_constant<int, 1>(), std::integral_constant<int, 3>());
    visit(std::integral_constant<int, 2>(), std::integral_constant<int, 2>());
    visit(std::integral_constant<int, 2>(), std::integral_constant<int, 3>());
    visit(std::integral_constant<int, 3>(), std::integral_constant<int, 2>());
}

Eigen::MatrixXd irregular_points(int dim, Index across, unsigned seed) {
    if (dim == 1) return support::irregular_points<1>(across, 0.3, seed);
    if (dim == 2) return support::irregular_points<2>(across, 0.3, seed);
    return support::irregular_points<3>(across, 0.3, seed);
}

/// Irregular particles in the unit cube with a mean spacing of h.
struct Irregular {
    explicit Irregular(int dimension)
        : dim(dimension),
          h(1 / (dim == 1   ? 40.0
                 : dim == 2 ? 10.0
                            : 7.0)),
          x(irregular_points(dim, std::lround(1 / h) + 1, 5)) {}

    int dim;
    double h;
    Eigen::MatrixXd x;
    static constexpr double rho = 3.5;

    /// Places inside, on the boundary and at a corner, particles and others.
    [[nodiscard]] std::vector<Eigen::VectorXd> places() const {
        std::vector<Eigen::VectorXd> all{x.col(0), x.col(x.cols() / 2), Eigen::VectorXd::Zero(dim)};
        support::Draws draw(21);
        for (int k = 0; k < 5; ++k)
            all.emplace_back((Eigen::VectorXd::NullaryExpr(dim, [&] { return draw(); }).array() + 1) / 2);
        return all;
    }

    [[nodiscard]] support::Bases at(int m, const Eigen::VectorXd& place) const {
        return support::bases(m, x, rho, place, h);
    }

    /// Values of a function at some particles.
    template <class Function>
    [[nodiscard]] Column<double> values(const std::vector<int>& particle, const Function& f) const {
        Column<double> F(static_cast<Index>(particle.size()));
        for (Index j = 0; j < F.size(); ++j) F[j] = f(x.col(particle[static_cast<std::size_t>(j)]));
        return F;
    }
};

double factorial_of(const support::Powers& a) {
    return std::tgamma(a[0] + 1) * std::tgamma(a[1] + 1) * std::tgamma(a[2] + 1);
}
int order_of(const support::Powers& a) {
    return a[0] + a[1] + a[2];
}

/// One row of H: the monomials of an offset.
template <int dim, int m>
Eigen::Array<double, 1, terms<dim, m>> P(const Point<dim>& offset) {
    const Eigen::Array<double, Eigen::Dynamic, dim> s = offset.transpose().array();
    return H<dim, m, double>(s);
}

/// Weighted monomials of random offsets.
template <int dim, int m>
struct Sample {
    explicit Sample(Index count, unsigned seed)
        : s(support::random_points<dim>(count, seed).transpose().array() * 2 - 1),
          H(ssph_basis::H<dim, m, double>(s)),
          W((-s.square().rowwise().sum()).exp()) {}
    Eigen::Array<double, Eigen::Dynamic, dim> s;
    Eigen::Array<double, Eigen::Dynamic, terms<dim, m>> H;
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

Points<2> circle(Index count, double radius, const Point<2>& centre) {
    Points<2> x(2, count);
    for (Index k = 0; k < count; ++k) {
        const double angle = 2 * std::acos(-1.0) * static_cast<double>(k * k + 3 * k) / 97;
        x.col(k) = centre + radius * Point<2>(std::cos(angle), std::sin(angle));
    }
    return x;
}

/// The message of the refusal, or nothing.
template <class Work>
std::string refusal(const Work& work) {
    try {
        work();
    } catch (const base::FailedComputation& error) {
        return error.what();
    }
    return "";
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
        CHECK(value<terms<dim, m>>(P<dim, m>(offset), Q<dim, m>(derivative)) ==
              support::relative(f(x + offset), 1e-13));
    });
}

TEST_CASE("(2.2), (2.3): monomials and derivatives stand in the print's order, with its factors") {
    const auto P_3 = P<3, 2>({2, 3, 5});
    CHECK((P_3 == Eigen::Array<double, 1, 10>{{1, 2, 3, 5, 4, 9, 25, 6, 15, 10}}).all());
    const auto P_2 = P<2, 2>({2, 3});
    CHECK((P_2 == Eigen::Array<double, 1, 6>{{1, 2, 3, 4, 9, 6}}).all());
    const auto P_1 = P<1, 3>(Point<1>(2));
    CHECK((P_1 == Eigen::Array<double, 1, 4>{{1, 2, 4, 8}}).all());
    // Beyond the print, after its pattern: pure powers first, then those with more of the first coordinate.
    const auto cubic = P<2, 3>({2, 3});
    CHECK((cubic == Eigen::Array<double, 1, 10>{{1, 2, 3, 4, 9, 6, 8, 27, 12, 18}}).all());
    // The derivative a1, a2, a3 times is here the number with these digits.
    const auto Q_3 = Q<3, 2>([](const Exponents<3>& a) { return 100 * a[0] + 10 * a[1] + a[2]; });
    CHECK(Q_3 == Eigen::Matrix<double, 10, 1>{{0, 100, 10, 1, 200.0 / 2, 20.0 / 2, 2.0 / 2, 110, 11, 101}});
    const auto Q_2 = Q<2, 2>([](const Exponents<2>& a) { return 10 * a[0] + a[1]; });
    CHECK(Q_2 == Eigen::Matrix<double, 6, 1>{{0, 10, 1, 20.0 / 2, 2.0 / 2, 11}});
    const auto Q_1 = Q<1, 3>([](const Exponents<1>& a) { return a[0]; });
    CHECK(Q_1 == Eigen::Vector4d(0, 1, 2.0 / 2, 3.0 / 6));
}

TEST_CASE("(2.3): the monomials are all of degree m and less, each once, by degree") {
    for_each_dimension_and_degree([](int dim, int m) {
        const auto all = Irregular(dim).at(m, Eigen::VectorXd::Constant(dim, 0.5)).exponents;
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
        const Eigen::Matrix<double, 6, 1> term = f_j * near.W[j] * near.H.row(j).matrix().transpose();
        CHECK((term - outer_product<6>(near.H.row(j), near.W[j]) * Q_0).norm() < 1e-14);
        left += term;
    }
    CHECK((left - summed<6>(near.H, near.W) * Q_0).norm() < 1e-13);
}

TEST_CASE("(2.6): a row of H holds the products of a particle's offsets") {
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
                CHECK(near.H(j, k) == support::relative(power, 1e-14));
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
        sum += F[j] * near.W[j] * near.H.row(j).matrix().transpose();
    }
    const auto [left, right] = both_sides<10>(near.H, near.W, F, Q_0);
    CHECK((left - sum).norm() < 1e-13);
    CHECK((right - summed<10>(near.H, near.W) * Q_0).norm() < 1e-13);
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
        CHECK((D_near.row(j) == near.W[j] * near.H.row(j)).all());
    }
    CHECK((C<double>(D_near, near.H) * Q_0 - D_near.matrix().transpose() * F.matrix()).norm() < 1e-13);
}

TEST_CASE("(2.9): C is symmetric to the last bit, positive, and the sum of (2.5)") {
    for_some_dimensions_and_degrees([](auto dimension, auto degree) {
        constexpr int dim = dimension, m = degree, n = terms<dim, m>;
        const Sample<dim, m> near(3 * n, 5);
        const auto C_near = C<double>(D<double>(near.H, near.W), near.H);
        CHECK(C_near == C_near.transpose());
        CHECK((C_near - summed<n>(near.H, near.W)).norm() < 1e-13 * C_near.norm());
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
        for (Index j = 0; j < 11; ++j) sum += basis.K(I)[j] * f(x.col(j));
        CHECK(std::abs(sum - f.derivative(support::powers(a), Point<2>::Zero()) / factorial<2>(a)) < 1e-13);
    }
}

TEST_CASE("(2.10): the determinant by Binet and Cauchy is that of C, in one dimension and in the plane") {
    const auto check = [](auto dimension, auto degree, Index count) {
        constexpr int dim = dimension, m = degree, n = terms<dim, m>;
        const Sample<dim, m> near(count, 6);
        const double det_C = C<double>(D<double>(near.H, near.W), near.H).determinant();
        CHECK(det_C > 0);
        CHECK(determinant<n>(near.H, near.W) == support::relative(det_C, 1e-10));
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
        return determinant<6>(H<2, 2, double>(s), Column<double>::Ones(x.cols()));
    };
    const Points<2> on_circle = circle(9, 1.2, {0.3, -0.2});
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
    for_each_dimension_and_degree([](int dim, int m) {
        const Irregular irregular(dim);
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
    const Irregular irregular(2);
    const std::vector<int> particle = irregular.at(2, Point<2>(0.4, 0.6)).particle;
    const auto all = selection(particle, irregular.x.cols());
    CHECK(Eigen::MatrixXd(all * all.transpose()).isIdentity(0));
    const Eigen::VectorXd F = Eigen::VectorXd::LinSpaced(irregular.x.cols(), 0, 1);
    CHECK(all * F == F(particle));
}

TEST_CASE("(2.13), (2.14): with the values of all particles the estimate is the same") {
    const Irregular irregular(2);
    const auto wave = [](const Point<2>& x) { return std::exp(x[0]) * std::cos(2 * x[1]); };
    Column<double> all(irregular.x.cols());
    for (Index j = 0; j < all.size(); ++j) all[j] = wave(irregular.x.col(j));
    for (const Eigen::VectorXd& x : irregular.places()) {
        const auto [particle, exponents, K, slopes] = irregular.at(2, x);
        const auto S = selection(particle, irregular.x.cols());
        const Column<double> F_x = irregular.values(particle, wave);
        for (Index I = 0; I < 6; ++I) {
            const double estimate = (K.col(I) * F_x).sum();
            CHECK(through_selection(K.col(I), S, F_x) == support::relative(estimate, 1e-11));
            const Column<double> K_I = spread(K.col(I), S);
            REQUIRE(K_I.size() == all.size());
            CHECK((K_I * all).sum() == support::relative(estimate, 1e-11));
            CHECK((K_I != 0).count() == F_x.size());
        }
    }
}

TEST_CASE("(2.15): the derivatives of polynomials of degree m, in the plane by position in the print") {
    const Irregular irregular(2);
    const Cloud<2> cloud(irregular.x);
    const Polynomial f(2, 2, 11);
    for (const Eigen::VectorXd& x : irregular.places()) {
        const auto basis = basis_at<2>(cloud, TruncatedGaussian<2>(3), Point<2>(x), irregular.h);
        const Column<double> F = irregular.values(basis.particle(), f);
        const std::array<support::Powers, 6> in_order{
            {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {0, 2, 0}, {1, 1, 0}}};
        for (std::size_t I = 0; I < 6; ++I)
            CHECK(std::abs((derivative(basis, static_cast<Index>(I)) * F).sum() -
                           f.derivative(in_order[I], x)) < 1e-10);
        CHECK((derivative(basis, 3) == 2 * basis.K(3)).all());
        CHECK((derivative(basis, 5) == basis.K(5)).all());
    }
}

TEST_CASE(
    "(2.15): the error of a derivative of order k falls with h to the power m + 1 - k, inside and at an "
    "edge") {
    // A pattern of irregular particles around a place shrinks; the print claims one order less.
    const std::vector<double> lengths{0.01, 0.005, 0.0025, 0.00125};
    for_each_dimension_and_degree([&](int dim, int m) {
        const Eigen::VectorXd a = Point<3>(1.3, -0.8, 0.6).head(dim), x = Eigen::VectorXd::Constant(dim, 0.2);
        for (const double from : {-1.5, 0.0}) {
            CAPTURE(from);
            const Eigen::MatrixXd pattern = (6 * irregular_points(dim, 7, 17).array() + from).matrix();
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
    "(2.16): the differentiated basis functions are the slopes of the basis functions of all of Q, by finite "
    "differences") {
    for_each_dimension_and_degree([](int dim, int m) {
        const Irregular irregular(dim);
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
    const Irregular irregular(2);
    const auto basis = basis_at<2>(Cloud<2>(irregular.x), TruncatedGaussian<2>(irregular.rho),
                                   Point<2>(0.4, 0.6), irregular.h);
    for (int axis = 0; axis < 2; ++axis)
        CHECK((differentiated_value(basis, axis) == irregular.at(2, Point<2>(0.4, 0.6)).slopes[0].col(axis))
                  .all());
}

TEST_CASE(
    "(2.16): the slopes are exact for polynomials of degree m, yet no basis functions of the derivative") {
    for_each_dimension_and_degree([](int dim, int m) {
        const Irregular irregular(dim);
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
    "ssph_basis: basis functions sum to one and their slopes to zero, and are not one at their own "
    "particle") {
    const Irregular irregular(3);
    const auto [particle, exponents, K, slopes] = irregular.at(2, irregular.x.col(200));
    CHECK(K.col(0).sum() == support::relative(1, 1e-13));
    CHECK(K.col(0).maxCoeff() < 0.9);
    for (Index I = 1; I < 10; ++I) CHECK(std::abs(K.col(I).sum()) < 1e-12 * K.col(I).abs().sum());
    for (Index axis = 0; axis < 3; ++axis)
        CHECK(std::abs(slopes[0].col(axis).sum()) < 1e-12 * slopes[0].col(axis).abs().sum());
}

TEST_CASE("ssph_basis: the condition of C depends neither on h nor on the unit of length") {
    const auto condition = [](const Points<2>& x, const Point<2>& place, double h) {
        return basis_at<2>(Cloud<2>(x), TruncatedGaussian<2>(3), place, h).condition();
    };
    const Irregular irregular(2);
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
    "ssph_basis: the condition of C is the ratio of the outermost eigenvalues, on a grid at most 101 with ρ "
    "= 3") {
    const Cloud<2> grid(support::grid_points<2>(9));
    double worst = 0;
    for (Index j = 0; j < grid.size(); ++j) {
        const auto basis = basis_at<2>(grid, TruncatedGaussian<2>(3), Point<2>(grid.x().col(j)), 1.0 / 8);
        Eigen::VectorXd most = Eigen::VectorXd::Ones(6), least = most;  // by powers of C and of its inverse
        for (int k = 0; k < 200; ++k) {
            most = (basis.matrix() * most).normalized();
            least = basis.matrix().llt().solve(least).normalized();
        }
        CHECK(basis.condition() ==
              support::relative(most.dot(basis.matrix() * most) / least.dot(basis.matrix() * least), 1e-9));
        worst = std::max(worst, basis.condition());
    }
    CHECK(worst == support::relative(101, 0.01));
}

TEST_CASE("ssph_basis: too few particles are refused with place and numbers, and the remedy works") {
    const Points<2> grid = support::grid_points<2>(5);
    const Point<2> at_side(0, 0.5);
    CHECK(refusal([&] { support::bases(2, grid, 1.2, at_side, 0.25); }) ==
          "ssph_basis: at (0, 0.5) there are 4 particles within 1.2h = 0.3 for the 6 monomials of degree 2; "
          "try "
          "--scaling 2.1");  // six particles in two columns, within 1.5h, do not suffice
    CHECK_NOTHROW(support::bases(2, grid, 2.1, at_side, 0.25));
    int refused = 0;
    for_each_dimension_and_degree([&](int dim, int m) {
        const Irregular irregular(dim);
        for (const Eigen::VectorXd& x : irregular.places())
            for (const double rho : {0.3, 0.8, 1.2, 1.6}) {
                const std::string why = refusal([&] { support::bases(m, irregular.x, rho, x, irregular.h); });
                if (why.empty()) continue;
                CAPTURE(why);
                ++refused;
                const std::size_t remedy = why.find("; try --scaling ");
                REQUIRE(remedy != std::string::npos);
                const double scaling = std::stod(why.substr(remedy + 16));
                CHECK(scaling > rho);
                CHECK_NOTHROW(support::bases(m, irregular.x, scaling, x, irregular.h));
            }
    });
    CHECK(refused > 100);
}

TEST_CASE("ssph_basis: all rows of K at once are those computed one by one") {
    const Irregular irregular(2);
    const Cloud<2> cloud(irregular.x);
    for (const Eigen::VectorXd& x : irregular.places()) {
        const auto basis = basis_at<2>(cloud, TruncatedGaussian<2>(irregular.rho), Point<2>(x), irregular.h);
        const auto all = basis.K();
        for (Index I = 0; I < basis.n; ++I)
            CHECK((all.col(I) - basis.K(I)).abs().maxCoeff() < 1e-10 * basis.K(I).abs().maxCoeff());
    }
}

TEST_CASE("ssph_basis: a cloud with fewer particles than monomials is refused with the number it needs") {
    CHECK_THROWS_WITH_AS(
        support::bases(2, support::random_points<2>(5, 1), 1000, Point<2>(0.5, 0.25), 0.1),
        "ssph_basis: at (0.5, 0.25) there are 5 particles within 1000h = 100 for the 6 monomials "
        "of degree 2; take at least 6 particles",
        base::FailedComputation);
}

TEST_CASE(
    "ssph_basis: particles on a conic do not determine the monomials; no scaling factor helps, another "
    "particle does") {
    const Points<2> on_circle = circle(12, 1, {0, 0});
    const Point<2> x(0.2, 0);
    const std::string why = refusal([&] { support::bases(2, on_circle, 4, x, 0.5); });
    CHECK(
        why.starts_with("ssph_basis: at (0.2, 0) there are 12 particles within 4h = 2 for the 6 monomials of "
                        "degree 2, which they do not determine: the local system is singular (reciprocal "
                        "condition "));
    CHECK(why.ends_with("); take other particles"));
    CHECK_NOTHROW(support::bases(1, on_circle, 4, x, 0.5));
    Points<2> with_another(2, 13);
    with_another << on_circle, Point<2>(0.1, 0.1);
    CHECK_NOTHROW(support::bases(2, with_another, 4, x, 0.5));
}

TEST_CASE(
    "ssph_basis: collinear and coplanar particles, and those of two rows, do not determine the monomials") {
    const auto undetermined = [](int m, const Eigen::MatrixXd& x, double rho, const Eigen::VectorXd& at,
                                 double h) {
        const std::string why = refusal([&] { support::bases(m, x, rho, at, h); });
        CAPTURE(why);
        CHECK(why.find(", which they do not determine: ") != std::string::npos);
    };
    Points<2> line = Points<2>::Zero(2, 20);
    line.row(0) = Eigen::RowVectorXd::LinSpaced(20, 0, 1);
    undetermined(1, line, 4, Point<2>(0.5, 0), 0.05);
    Points<3> plane = Points<3>::Zero(3, 100);
    plane.topRows(2) = support::random_points<2>(100, 2);
    undetermined(1, plane, 4, Point<3>(0.5, 0.5, 0), 0.1);
    // On a grid a particle at a distance of ρh has no weight: ρ = 2 leaves a place at the side two rows of three.
    const Points<2> grid = support::grid_points<2>(5);
    undetermined(2, grid, 2, Point<2>(0, 0.5), 0.25);
    CHECK_NOTHROW(support::bases(2, grid, 2.5, Point<2>(0, 0.5), 0.25));
}

TEST_CASE("ssph_basis: in one dimension m + 1 particles are needed and suffice") {
    const Points<1> x{{0.1, 0.4, 0.9, 1.1}};
    for (const int m : {1, 2, 3}) {
        CHECK_NOTHROW(support::bases(m, x.leftCols(m + 1), 3, Point<1>(0.5), 0.3));
        if (m > 1)
            CHECK_THROWS_AS(support::bases(m, x.leftCols(m), 3, Point<1>(0.5), 0.3), base::FailedComputation);
    }
}
