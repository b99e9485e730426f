#include "batra2008/section_2_ssph_basis.hpp"

#include <Eigen/Cholesky>

#include "report/statistics.hpp"
#include "tests/batra2008/bases.hpp"
#include "tests/support/relative.hpp"

using namespace batra2008;
using namespace batra2008::ssph_basis;
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
particles::Neighbourhood<double, 2> seen(const Points<2>& x) {
    const Column<double> one = Column<double>::Ones(x.cols());
    return {x.transpose().array(), one, particles::Offsets<double, 2>::Zero(x.cols(), 2), one};
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
            CHECK(support::order(all[k]) <= m);
            if (k > 0) CHECK(support::order(all[k]) >= support::order(all[k - 1]));
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

TEST_CASE("(2.11): the basis, whose sums are moments, is C⁻¹ D with the matrices of (2.6), (2.8) and (2.9)") {
    for_some_dimensions_and_degrees([](auto dimension, auto degree) {
        constexpr int dim = dimension, m = degree, n = terms<dim, m>;
        const Sample<dim, m> near(3 * n, 5);
        const Basis<dim, m> basis({near.s, near.W, {}, {}}, {}, 1);
        const auto D_near = D<double>(near.H, near.W);
        const Eigen::MatrixXd C_near = C<double>(D_near, near.H), K = C_near.llt().solve(D_near);
        CHECK((basis.matrix() - C_near).norm() < 1e-14 * C_near.norm());
        CHECK((basis.K() - K).norm() < 1e-10 * K.norm());
    });
}

TEST_CASE("(2.9), (2.11): no derivative of the kernel enters, so that weights may be constant") {
    const Polynomial f(2, 2, 12);
    const Points<2> x = 2 * support::random_points<2>(11, 3) - Points<2>::Ones(2, 11);
    const Basis<2, 2> basis(seen(x), {}, 1);
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
