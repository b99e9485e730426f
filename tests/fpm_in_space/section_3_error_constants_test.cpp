#include "fpm_in_space/section_3_error_constants.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string_view>
#include <tuple>
#include <vector>

#include "fpm_in_space/section_1_second_order_fpm.hpp"
#include "tests/support/clouds.hpp"
#include "tests/support/relative.hpp"

using namespace fpm_in_space;
using namespace fpm_in_space::error_constants;
using base::Quad;
using particles::Cloud;
using std::numbers::pi;
using support::relative;

namespace {

/// A row on a few neighbours in the plane: their offsets and weights.
Stencil<Quad, 2> stencil(const std::vector<std::array<double, 3>>& neighbours) {
    const auto count = static_cast<Index>(neighbours.size());
    Stencil<Quad, 2> row{Offsets<Quad, 2>(count, 2), Column<Quad>(count)};
    for (Index j = 0; j < count; ++j) {
        const auto& [x, y, w] = neighbours[static_cast<std::size_t>(j)];
        row.r.row(j) << x, y;
        row.w[j] = w;
    }
    return row;
}

const Stencil<Quad, 2> second = stencil({{-1, 0, 1}, {0, 0, -2}, {1, 0, 1}});
const Stencil<Quad, 2> mixed = stencil({{1, 1, 0.25}, {1, -1, -0.25}, {-1, 1, -0.25}, {-1, -1, 0.25}});
const Stencil<Quad, 2> five_points = stencil({{-1, 0, 1}, {1, 0, 1}, {0, -1, 1}, {0, 1, 1}, {0, 0, -4}});

/// The stencils of a formulation at a place, calculated once for all tests.
template <int dim>
const Rows<Quad, dim>& rows_of(std::string_view name, int bounded, double smoothing = 1) {
    static std::map<std::tuple<std::string_view, int, double>, Rows<Quad, dim>> known;
    const auto [one, added] = known.try_emplace({name, bounded, smoothing});
    if (added)
        one->second =
            limit_stencils(formulation_named<Quad, dim>(name), Lattice<dim>{{}, smoothing, bounded});
    return one->second;
}

template <int dim>
LeadingError<Quad, dim> leading(std::string_view name, int bounded, const Exponents<dim>& a) {
    return leading_error(row(rows_of<dim>(name, bounded), a), a);
}

/// The constant of one derivative; zero if it is no part of the leading error.
template <int dim>
double constant(std::string_view name, int bounded, const Exponents<dim>& a, const Exponents<dim>& b) {
    const auto error = leading<dim>(name, bounded, a);
    const auto at = std::find(error.b.begin(), error.b.end(), b);
    return at == error.b.end() ? 0 : static_cast<double>(error.C[at - error.b.begin()]);
}

double symbol_at(std::string_view name, double smoothing, double theta_1, double theta_2) {
    const auto row = laplacian(rows_of<2>(name, 0, smoothing));
    return static_cast<double>(symbol(row, Point<2, Quad>(theta_1, theta_2)));
}

}  // namespace

TEST_CASE("error constants: a lattice inside is whole, and a half, a quarter or an eighth at its boundary") {
    const auto inside = within_reach(Lattice<2>{}), edge = within_reach(Lattice<2>{{}, 1, 1}),
               corner = within_reach(Lattice<2>{{}, 1, 2});
    CHECK(inside.cols() == 113);  // whole coordinates in a circle of radius six
    CHECK(inside.rowwise().sum().norm() == 0);
    CHECK(edge.row(0).minCoeff() == 0);
    CHECK(edge.row(1).minCoeff() == -6);
    CHECK(2 * edge.cols() == inside.cols() + 13);
    CHECK(corner.minCoeff() == 0);
    CHECK(within_reach(Lattice<3>{}).cols() == 925);
}

TEST_CASE("error constants: multi-indices of a degree in the order of their derivatives") {
    CHECK(of_degree<2>(3) == std::vector<Exponents<2>>{{3, 0}, {2, 1}, {1, 2}, {0, 3}});
    CHECK(of_degree<3>(1) == std::vector<Exponents<3>>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    CHECK(of_degree<3>(4).size() == 15);
    CHECK(different_derivatives<2>(0) == std::vector<Exponents<2>>{{1, 0}, {2, 0}, {1, 1}});
    CHECK(different_derivatives<2>(1).size() == 5);
    CHECK(different_derivatives<3>(1) ==
          std::vector<Exponents<3>>{{1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {0, 2, 0}, {1, 1, 0}, {0, 1, 1}});
}

TEST_CASE("(F10): the coefficients of differences on few points are those of the textbooks") {
    CHECK(moment<Quad, 2>(second, {2, 0}) == 2);
    CHECK(moment<Quad, 2>(second, {0, 2}) == 0);
    CHECK(taylor_coefficient<Quad, 2>(second, {2, 0}, {2, 0}) == 0);
    CHECK(taylor_coefficient<Quad, 2>(second, {2, 0}, {3, 1}) == 0);
    CHECK(taylor_coefficient<Quad, 2>(mixed, {1, 1}, {1, 1}) == 0);
    CHECK(static_cast<double>(taylor_coefficient<Quad, 2>(mixed, {1, 1}, {1, 3})) ==
          relative(1.0 / 6, 1e-15));
}

TEST_CASE("(F11): the leading error is that of the lowest degree that has any") {
    const auto error = leading_error<Quad, 2>(second, {2, 0});
    CHECK(error.exponent == 2);
    CHECK(error.b == of_degree<2>(4));
    CHECK(static_cast<double>(error.C[0]) == relative(1.0 / 12, 1e-15));
    CHECK((error.C.tail(4) == 0).all());
    const auto none = stencil({{0, 0, 0}});
    CHECK(leading_error<Quad, 2>(none, {2, 0}).exponent == 0);
    CHECK(leading_error<Quad, 2>(none, {2, 0}).C[0] == -1);
}

TEST_CASE("(F12): exponentials show the constants of differences on few points") {
    for (const double d : {0.5, 0.1}) {
        const double exact = (2 * std::cosh(2 * d) - 2) / (d * d) - 4;
        CHECK(static_cast<double>(scaled_error<Quad, 2>(second, {2, 0}, {2, 3}, d, 2)) ==
              relative(exact / (d * d), 1e-9));
    }
    CHECK(static_cast<double>(measured_error<Quad, 2>(second, {2, 0}, {2, 3}, 2)) ==
          relative(16.0 / 12, 1e-15));
    const Column<Quad> C = measured_constants<Quad, 2>(mixed, {1, 1}, 2);
    const std::array expected{0.0, 1.0 / 6, 0.0, 1.0 / 6, 0.0};
    for (Index k = 0; k < 5; ++k)
        CHECK(std::abs(static_cast<double>(C[k]) - expected.at(static_cast<std::size_t>(k))) < 1e-14);
}

TEST_CASE(
    "(F12): what exponentials show is what the moments say, at all places of the plane, to ten digits") {
    for (const std::string_view name : {"definite_fpm", "ssph", "cubic_ssph"})
        for (int bounded = 0; bounded <= 2; ++bounded) {
            const auto& all = rows_of<2>(name, bounded);
            for (const auto& a : different_derivatives<2>(bounded)) {
                const auto [exponent, b, C] = leading_error(row(all, a), a);
                const Column<Quad> measured = measured_constants(row(all, a), a, exponent);
                CHECK((measured - C).abs().maxCoeff() < 1e-10 * C.abs().maxCoeff());
            }
        }
}

TEST_CASE("(F11): exponents of the formulations, inside and at the boundary") {
    for (int bounded = 0; bounded <= 3; ++bounded) {
        CHECK(leading<3>("definite_fpm", bounded, {1, 0, 0}).exponent == 2);
        CHECK(leading<3>("definite_fpm", bounded, {2, 0, 0}).exponent == 2);
        CHECK(leading<3>("definite_fpm", bounded, {1, 1, 0}).exponent == 2);
        CHECK(leading<3>("ssph", bounded, {1, 0, 0}).exponent == 2);
        CHECK(leading<3>("ssph", bounded, {2, 0, 0}).exponent == (bounded == 0 ? 2 : 1));
        CHECK(leading<3>("cubic_ssph", bounded, {1, 0, 0}).exponent == (bounded == 0 ? 4 : 3));
        CHECK(leading<3>("cubic_ssph", bounded, {2, 0, 0}).exponent == 2);
    }
}

namespace {

/// Sums \f$\mu_k = \sum n^k e^{-n^2}\f$ over a line of particles, or over half of it.
double sum(int k, int first = -6) {
    double all = 0;
    for (int n = first; n <= 6; ++n) all += std::pow(n, k) * std::exp(-n * n);
    return all;
}

/// Coefficients of the monic orthogonal polynomial of degree n on a line of particles or on half of it.
std::vector<double> orthogonal(int n, int first) {
    std::vector<double> P(static_cast<std::size_t>(n + 1));
    P.back() = 1;
    const auto times = [&](const std::vector<double>& p, const std::vector<double>& q) {
        double product = 0;
        for (std::size_t k = 0; k < p.size(); ++k)
            for (std::size_t l = 0; l < q.size(); ++l)
                product += p[k] * q[l] * sum(static_cast<int>(k + l), first);
        return product;
    };
    for (int lower = 0; lower < n; ++lower) {
        const auto Q = orthogonal(lower, first);
        const double part = times(P, Q) / times(Q, Q);
        for (std::size_t k = 0; k < Q.size(); ++k) P[k] -= part * Q[k];
    }
    return P;
}

/// \f$-\frac{1}{b!} \prod_k P_{b_k}^{(a_k)}(0)\f$
template <int dim>
double product_of_polynomials(const Exponents<dim>& a, const Exponents<dim>& b, int bounded) {
    double product = -1.0 * particles::factorial<dim>(a) / particles::factorial<dim>(b);
    for (std::size_t axis = 0; axis < dim; ++axis) {
        const auto P = orthogonal(b[axis], static_cast<int>(axis) < bounded ? 0 : -6);
        const auto k = static_cast<std::size_t>(a[axis]);
        product *= k < P.size() ? P[k] : 0;
    }
    return product;
}

template <int dim>
void check_products(std::string_view name, int m) {
    for (int bounded = 0; bounded <= dim; ++bounded) {
        const auto& all = rows_of<dim>(name, bounded);
        for (const auto& a : different_derivatives<dim>(bounded))
            for (const auto& b : of_degree<dim>(m + 1)) {
                CAPTURE(name);
                CAPTURE(bounded);
                CHECK(std::abs(static_cast<double>(taylor_coefficient(row(all, a), a, b)) -
                               product_of_polynomials<dim>(a, b, bounded)) < 1e-8);
            }
    }
}

}  // namespace

TEST_CASE(
    "(F11): constants of SSPH are products of the orthogonal polynomials of a line and of half a line") {
    check_products<2>("ssph", 2);
    check_products<2>("cubic_ssph", 3);
    check_products<3>("ssph", 2);
    check_products<3>("cubic_ssph", 3);
}

TEST_CASE("(F11): constants of the second-order FPM inside, in sums over a line") {
    const double m_0 = sum(0), m_2 = sum(2), m_4 = sum(4), m_6 = sum(6);
    const double own = m_4 * m_0, other = m_2 * m_2, det = own * own - other * other;
    const auto check = [](const Exponents<2>& a, const Exponents<2>& b, double expected) {
        CHECK(constant<2>("definite_fpm", 0, a, b) == relative(expected, 1e-9));
    };
    check({1, 0}, {3, 0}, m_4 / m_2 / 6);
    check({1, 0}, {1, 2}, m_2 / m_0 / 2);
    check({1, 1}, {3, 1}, m_4 / m_2 / 6);
    check({2, 0}, {4, 0}, (m_6 * m_0 * own - m_4 * m_2 * other) / det / 12);
    check({2, 0}, {2, 2}, m_4 * m_2 / (own + other) / 2);
    check({2, 0}, {0, 4}, (m_4 * m_2 * own - m_6 * m_0 * other) / det / 12);
}

TEST_CASE(
    "(F11): across a face, D² of the second-order FPM errs as on a line, four times as much as inside") {
    Neighbourhood<Quad, 1> line;  // beginning at the particle
    line.r = Column<Quad>::LinSpaced(7, 0, 6);
    line.W = (-line.r.square()).exp();
    line.V = Column<Quad>::Ones(7);
    const Column<Quad> w = second_order_fpm::derivatives(line).second;
    const auto at_end = static_cast<double>((w * line.r.pow(4)).sum()) / 24;
    const auto across = [](auto dimension, int bounded) {
        constexpr int dim = dimension;
        return constant<dim>("definite_fpm", bounded, {2}, {4});
    };
    for (const int bounded : {1, 2})
        CHECK(across(std::integral_constant<int, 2>{}, bounded) == relative(at_end, 1e-6));
    for (const int bounded : {1, 2, 3})
        CHECK(across(std::integral_constant<int, 3>{}, bounded) == relative(at_end, 1e-6));
    CHECK(at_end / across(std::integral_constant<int, 2>{}, 0) == relative(-4.35, 0.01));
}

TEST_CASE(
    "(F11): at a corner, D² of the second-order FPM and of SSPH of degree 3 have nearly the same constants") {
    const auto differ = [](int bounded, const Exponents<2>& a) {
        const auto ours = leading<2>("definite_fpm", bounded, a),
                   theirs = leading<2>("cubic_ssph", bounded, a);
        return static_cast<double>((ours.C - theirs.C).abs().maxCoeff() / ours.C.abs().maxCoeff());
    };
    CHECK(differ(2, {2, 0}) < 2e-3);
    CHECK(differ(2, {1, 1}) < 2e-3);
    CHECK(differ(0, {2, 0}) > 0.1);
}

TEST_CASE(
    "(F11): no constant is larger than that across a face, but a thousandfold ones by the literal extension") {
    double largest = 0;
    for (int bounded = 0; bounded <= 3; ++bounded) {
        const auto& all = rows_of<3>("definite_fpm", bounded);
        for (const auto& a : different_derivatives<3>(bounded))
            largest =
                std::max(largest, static_cast<double>(leading_error(row(all, a), a).C.abs().maxCoeff()));
    }
    CHECK(largest == relative(-constant<3>("definite_fpm", 1, {2}, {4}), 1e-6));
    CHECK(leading<2>("literal_second_order_fpm", 1, {2, 0}).exponent == 2);
    CHECK(constant<2>("literal_second_order_fpm", 1, {2, 0}, {0, 4}) > 1000 * largest);
}

TEST_CASE("(F11): a mirrored corner has the same constants, odd ones with the other sign") {
    const auto& formulation = formulation_named<Quad, 2>("definite_fpm");
    auto near = neighbourhood<Quad>(Lattice<2>{{}, 1, 2});
    near.r.col(0) *= -1;
    const Rows<Quad, 2> mirrored{near.r, formulation.weights(near)};
    for (const auto& a : particles::monomials<2, 2>()) {
        if (particles::order<2>(a) == 0) continue;
        const auto here = leading<2>("definite_fpm", 2, a), there = leading_error(row(mirrored, a), a);
        REQUIRE(here.exponent == there.exponent);
        for (std::size_t k = 0; k < here.b.size(); ++k) {
            const int sign = (a[0] + here.b[k][0]) % 2 == 0 ? 1 : -1;
            const auto at = static_cast<Index>(k);
            CHECK(static_cast<double>(abs(here.C[at] - sign * there.C[at])) < 1e-20);
        }
    }
}

TEST_CASE(
    "(F11): derivatives that an exchange of coordinates turns into one another have the same constants") {
    const auto one = leading<2>("definite_fpm", 2, {2, 0}), other = leading<2>("definite_fpm", 2, {0, 2});
    CHECK(static_cast<double>((one.C - other.C.reverse()).abs().maxCoeff()) < 1e-20);
}

namespace {

/// A place of a grid of n^dim particles on the unit square or cube, with its rows in double precision.
template <int dim>
struct OnGrid {
    double spacing;
    Points<dim> r;  ///< offsets of all particles, in units of length
    particles::Operators<double, dim> operators;
};

template <int dim>
OnGrid<dim> on_grid(std::string_view name, const Cloud<dim>& cloud, Index n, int bounded) {
    Point<dim> place = Point<dim>::Constant(0.5);
    place.head(bounded).setZero();
    const Index i = cloud.nearest(place);
    const double spacing = 1 / static_cast<double>(n - 1);
    const auto& formulation = formulation_named<double, dim>(name);
    const particles::Smoothing<double, dim> smoothing(particles::Gaussian<dim>{}, spacing);
    return {
        spacing, cloud.x().colwise() - cloud.x().col(i),
        particles::assemble<dim>(cloud, smoothing, formulation.required(), formulation.weights, {i, i + 1})};
}

/// \f$c^a\f$
template <int dim>
double power(const Point<dim>& c, const Exponents<dim>& a) {
    double product = 1;
    for (std::size_t k = 0; k < dim; ++k) product *= std::pow(c[static_cast<Index>(k)], a[k]);
    return product;
}

/// The error of \f$e^{c \cdot x}\f$ over its value and δ^p.
template <int dim>
double error(const OnGrid<dim>& grid, const Exponents<dim>& a, const Point<dim>& c, int exponent) {
    const particles::Operator<double>& D = derivative(grid.operators, a);
    double found = 0;
    for (particles::Operator<double>::InnerIterator entry(D, 0); entry; ++entry)
        found += entry.value() * std::expm1(c.dot(grid.r.col(entry.col())));
    return (found - power<dim>(c, a)) * std::pow(grid.spacing, -exponent);
}

/// Checks that errors on grids approach the predicted polynomial, linearly at least.
template <int dim>
void check_grids(const Point<dim>& c) {
    const Cloud<dim> of_15(support::grid_points<dim>(15)), of_29(support::grid_points<dim>(29));
    for (const std::string_view name : {"definite_fpm", "cubic_ssph"})
        for (int bounded = 0; bounded <= dim; ++bounded) {
            const auto coarse = on_grid<dim>(name, of_15, 15, bounded),
                       fine = on_grid<dim>(name, of_29, 29, bounded);
            for (const auto& a : different_derivatives<dim>(bounded)) {
                const auto [exponent, b, C] = leading<dim>(name, bounded, a);
                if (exponent > 2) continue;  // round-off covers it
                double predicted = 0;
                for (std::size_t k = 0; k < b.size(); ++k)
                    predicted += static_cast<double>(C[static_cast<Index>(k)]) * power<dim>(c, b[k]);
                const double before = error<dim>(coarse, a, c, exponent) - predicted,
                             after = error<dim>(fine, a, c, exponent) - predicted;
                CAPTURE(name);
                CAPTURE(bounded);
                CAPTURE(predicted);
                CHECK(std::abs(after) < 0.15 * std::abs(predicted));
                CHECK(std::abs(after) < 0.65 * std::abs(before));
            }
        }
}

}  // namespace

TEST_CASE(
    "(F11): on grids in double precision, errors inside, at faces, edges and corners approach the constants") {
    check_grids<2>({1, 0.5});
    check_grids<3>({1, 0.5, 0.7});
}

TEST_CASE("(F13): the symbol of five points is 2 cos θ₁ + 2 cos θ₂ − 4") {
    for (const double t : {0.1, 1.0, 3.0})
        CHECK(static_cast<double>(symbol(five_points, Point<2, Quad>(t, 2 * t))) ==
              relative(2 * std::cos(t) + 2 * std::cos(2 * t) - 4, 1e-14));
}

TEST_CASE("(F13): the error of long waves has the constants of the Laplacian") {
    const double t = 1e-3;
    const double axis =
        constant<2>("definite_fpm", 0, {2, 0}, {4, 0}) + constant<2>("definite_fpm", 0, {2, 0}, {0, 4});
    CHECK(symbol_at("definite_fpm", 1, t, 0) == relative(-t * t * (1 - axis * t * t), 1e-11));
    const double diagonal = axis + constant<2>("definite_fpm", 0, {2, 0}, {2, 2});
    CHECK(symbol_at("definite_fpm", 1, t, t) == relative(-2 * t * t * (1 - diagonal * t * t), 1e-11));
}

TEST_CASE("(F13): the second-order FPM gives every wave a frequency, SSPH nearly none to the shortest") {
    const auto least = [](std::string_view name, double smoothing) {
        const auto row = laplacian(rows_of<2>(name, 0, smoothing));
        double found = 1;
        for (int k = 0; k <= 16; ++k)
            for (int l = 0; l <= k; ++l) {
                const Point<2, Quad> theta(k * pi / 16, l * pi / 16);
                if (k > 0)
                    found = std::min(found, static_cast<double>(-symbol(row, theta) / theta.squaredNorm()));
            }
        return found;
    };
    CHECK(least("definite_fpm", 1) > 0.1);
    CHECK(least("definite_fpm", 2) > 0.025);
    CHECK(least("definite_fpm", 2) == relative(-symbol_at("definite_fpm", 2, pi, pi) / (2 * pi * pi), 1e-9));
    CHECK(least("cubic_ssph", 2) < 1e-6);
    CHECK(least("cubic_ssph", 2) > 0);
    CHECK(least("definite_fpm", 2) > 0.01);
    CHECK(symbol_at("ssph", 1.5, 1, 2) == relative(symbol_at("cubic_ssph", 1.5, 1, 2), 1e-12));
}

TEST_CASE("(F13): short waves are slower along the diagonal than along an axis; in space, too, all advance") {
    for (const std::string_view name : {"definite_fpm", "ssph", "cubic_ssph"})
        for (const double length : {1.0, 2.0, 3.0})
            CHECK(symbol_at(name, 1, length, 0) <
                  symbol_at(name, 1, length / std::sqrt(2), length / std::sqrt(2)));
    const auto row = laplacian(rows_of<3>("definite_fpm", 0));
    const auto ratio = [&](const Point<3, Quad>& theta) {
        return static_cast<double>(-symbol(row, theta) / theta.squaredNorm());
    };
    CHECK(ratio({0, 0, pi}) > ratio({0, pi, pi}));
    CHECK(ratio({0, pi, pi}) > ratio({pi, pi, pi}));
    CHECK(ratio({pi, pi, pi}) > 0.05);
}

TEST_CASE("error constants: a support with too few particles is refused, with a remedy that works") {
    const auto& formulation = formulation_named<Quad, 2>("definite_fpm");
    Lattice<2> corner{particles::CubicSpline<2>{}, 1, 2};
    CHECK_THROWS_WITH_AS(
        limit_stencils(formulation, corner),
        "definite_fpm, corner: a particle has 4 neighbours within 2h, needs 10; try --smoothing 1.7",
        base::FailedComputation);
    corner.smoothing = 1.7;
    CHECK_NOTHROW(limit_stencils(formulation, corner));
}

TEST_CASE("error constants: a smoothing length that no stencil can have is refused") {
    for (const double smoothing : {0.0, -1.0, 6.0, std::nan("")})
        CHECK_THROWS_AS(reach_in_spacings(Lattice<3>{{}, smoothing, 0}), base::InvalidInput);
}
