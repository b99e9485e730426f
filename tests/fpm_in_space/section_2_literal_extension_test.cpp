#include "fpm_in_space/section_2_literal_extension.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "asprone2010/local_conditions.hpp"
#include "asprone2010/section_4_second_order_fpm.hpp"
#include "fpm_in_space/claims/measures.hpp"
#include "tests/support/clouds.hpp"
#include "tests/support/polynomial.hpp"

using namespace fpm_in_space;
using particles::Cloud;
using particles::Gaussian;
using particles::Operators;
using particles::Points;
using particles::Smoothing;

namespace {

constexpr std::array literal{"literal_modified_fpm", "literal_fpm_by_derivatives",
                             "literal_second_order_fpm"};

/// Particles of the unit square, moved by up to a times their distance; those on an edge stay on it.
Cloud<2> square(Index n, double a, unsigned long seed = 1) {
    return derivative_test::body<2>(n, a, seed).cloud;
}

Smoothing<double, 2> smoothing(Index n) {
    return {Gaussian<2>{}, 1 / static_cast<double>(n - 1)};
}

template <int dim>
Operators<double, dim> operators(std::string_view name, const Cloud<dim>& cloud, double h) {
    const auto& formulation = formulation_named<double, dim>(name);
    return particles::assemble(cloud, Smoothing<double, dim>(Gaussian<dim>{}, h), formulation.required(),
                               formulation.weights);
}

/// Largest error of the second derivatives of (F14) on the square: among all particles, and among those in
/// the middle half, far from the edges.
struct Errors {
    double all = 0, inside = 0;
};
Errors errors(std::string_view name, Index n, double a, unsigned long seed = 1) {
    const Cloud<2> cloud = square(n, a, seed);
    const auto found = derivative_test::errors<2>(
        formulation_named<double, 2>(name), cloud, smoothing(n), Column<double>::Constant(1, cloud.spacing()),
        derivative_test::exponential_and_wave<2>, {{0, cloud.size()}})[0];
    Errors most;
    for (const auto& at : found) {
        most.all = std::max(most.all, at.second);
        if ((cloud.x().col(at.particle).array() - 0.5).abs().maxCoeff() < 0.25)
            most.inside = std::max(most.inside, at.second);
    }
    return most;
}

double median(std::vector<double> of) {
    std::sort(of.begin(), of.end());
    return of[of.size() / 2];
}

/// Median of the largest errors of nine draws.
double median_error(std::string_view name, Index n) {
    std::vector<double> all;
    for (unsigned long seed = 1; seed <= 9; ++seed) all.push_back(errors(name, n, 0.25, seed).all);
    return median(all);
}

/// Largest condition of the local systems on the square.
double largest_condition(Table<double> kernels(const Neighbourhood<double, 2>&), Index n, double a) {
    const Cloud<2> cloud = square(n, a);
    double most = 0;
    for (Index i = 0; i < cloud.size(); ++i) {
        const auto near =
            particles::neighbourhood(cloud, smoothing(n), i, particles::within_reach(cloud, smoothing(n), i));
        most = std::max(
            most, asprone2010::local_conditions::condition(literal_extension::matrix(kernels(near), near)));
    }
    return most;
}

template <int dim>
void check_exactness() {
    const Cloud<dim> cloud(support::irregular_points<dim>(dim == 2 ? 10 : 6, 0.1, 3));
    for (const char* const name : literal) {
        CAPTURE(name);
        const auto exact = formulation_named<double, dim>(name).exact;
        const auto all = operators(name, cloud, 1.5 * cloud.spacing());
        for (const auto& a : particles::monomials<dim, 2>()) {
            const int order = particles::order<dim>(a);
            if (order == 0) continue;
            const support::Polynomial f(dim, order == 1 ? exact.first : exact.second, 3);
            Column<double> B(cloud.size()), expected(cloud.size());
            for (Index j = 0; j < B.size(); ++j) {
                B[j] = f(cloud.x().col(j));
                expected[j] = f.derivative(support::powers(a), cloud.x().col(j));
            }
            CHECK((particles::apply(derivative(all, a), B) - expected).abs().maxCoeff() < 1e-6);
        }
    }
}

}  // namespace

TEST_CASE("(F7), (F9): on a line they are the paper's modified and second-order FPM") {
    for (const double a : {0.0, 0.25}) {
        const Points<1> x = support::irregular_points<1>(30, a, 2);
        std::vector<double> sorted(x.data(), x.data() + x.size());
        std::sort(sorted.begin(), sorted.end());
        const auto line =
            particles::line_at(Column<double>(Eigen::Map<const Column<double>>(sorted.data(), 30)),
                               particles::Volumes::partition);
        for (Index i = 0; i < line.size(); ++i) {
            const auto near =
                particles::neighbourhood(line, Smoothing<double>(Gaussian<1>{}, line.spacing()), i);
            const auto same = [](const Derivatives<double>& one, const Derivatives<double>& other) {
                return (one.first - other.first).abs().maxCoeff() < 1e-10 * other.first.abs().maxCoeff() &&
                       (one.second - other.second).abs().maxCoeff() < 1e-10 * other.second.abs().maxCoeff();
            };
            CHECK(same(literal_extension::modified(near), asprone2010::modified_fpm::derivatives(near)));
            CHECK(same(literal_extension::second_order(near),
                       asprone2010::second_order_fpm::derivatives(near)));
        }
    }
}

TEST_CASE("(F7), (F8), (F9): D and D² are exact on polynomials of the degree that the list names") {
    check_exactness<2>();
    check_exactness<3>();
}

TEST_CASE(
    "(F7): in the plane W is multiplied by 1, x² − y² and xy; (F8): on a line the second kernel is D²W") {
    const Cloud<2> cloud = square(9, 0.25);
    const auto plane =
        particles::neighbourhood(cloud, smoothing(9), 40, particles::within_reach(cloud, smoothing(9), 40));
    const Column<double> x = plane.r.col(0), y = plane.r.col(1), WV = plane.W * plane.V;
    const auto all = literal_extension::harmonic_kernels(plane);
    CHECK((all.row(0).transpose().array() - WV).abs().maxCoeff() < 1e-14);
    CHECK((all.row(1).transpose().array() - (x * x - y * y) * WV).abs().maxCoeff() < 1e-14);
    CHECK((all.row(2).transpose().array() - x * y * WV).abs().maxCoeff() < 1e-14);
    CHECK((all.bottomRows(2).transpose().array() - plane.DW.colwise() * plane.V).abs().maxCoeff() < 1e-14);

    const auto line =
        particles::line_at(Column<double>(Column<double>::LinSpaced(9, 0, 1)), particles::Volumes::equal);
    const auto near = particles::neighbourhood(line, Smoothing<double>(Gaussian<1>{}, 0.2), 3);
    for (Index j = 0; j < near.W.size(); ++j)
        CHECK(literal_extension::kernel_derivatives(near)(1, j) ==
              doctest::Approx(Gaussian<1>::D2W(near.r[j]) * near.V[j]).epsilon(1e-12));
}

TEST_CASE("(F9): no kernel has an odd moment, and the gradients are those of the first kernel") {
    const Cloud<2> cloud = square(9, 0.25);
    const auto near =
        particles::neighbourhood(cloud, smoothing(9), 3, particles::within_reach(cloud, smoothing(9), 3));
    const auto all = literal_extension::corrected_kernels(near);
    const Table<double> o = second_order_fpm::monomials_of(near)(second_order_fpm::odd<2>, Eigen::all);
    CHECK((all.topRows(3) * o.transpose()).cwiseAbs().maxCoeff() < 1e-12 * all.cwiseAbs().maxCoeff());

    // The same particles and one more, without volume, that moves.
    const auto K_1 = [&](double x, double y) {
        auto with_one = near;
        const Index last = near.W.size();
        with_one.r.conservativeResize(last + 1, 2);
        with_one.r.row(last) << x, y;
        with_one.V.conservativeResize(last + 1);
        with_one.V[last] = 1e-300;
        particles::evaluate(Gaussian<2>{}, with_one.r, with_one.W, with_one.DW);
        return Eigen::VectorXd(literal_extension::corrected_kernels(with_one).col(last) * 1e300);
    };
    const double step = 1e-5;
    const Eigen::VectorXd here = K_1(0.7, 0.4);
    CHECK(here[3] ==
          doctest::Approx((K_1(0.7 + step, 0.4) - K_1(0.7 - step, 0.4))[0] / (2 * step)).epsilon(1e-8));
    CHECK(here[4] ==
          doctest::Approx((K_1(0.7, 0.4 + step) - K_1(0.7, 0.4 - step))[0] / (2 * step)).epsilon(1e-8));
}

TEST_CASE(
    "(F9): on a grid it is of second order, with errors at the edges a thousand times those of Section 1") {
    const Errors coarse = errors("literal_second_order_fpm", 16, 0),
                 fine = errors("literal_second_order_fpm", 31, 0), ours = errors("definite_fpm", 31, 0);
    CHECK(std::log2(coarse.all / fine.all) == doctest::Approx(2).epsilon(0.1));
    CHECK(fine.all > 1000 * ours.all);
    CHECK(fine.inside < 2 * ours.inside);
}

TEST_CASE("(F7), (F9): on particles perturbed by δ/4 the error of D² stays above 1 as they become more") {
    for (const char* const name : {"literal_modified_fpm", "literal_second_order_fpm"}) {
        CAPTURE(name);
        CHECK(median_error(name, 16) > 1);
        CHECK(median_error(name, 31) > 1);
    }
    CHECK(median_error("literal_fpm_by_derivatives", 31) <
          0.7 * median_error("literal_fpm_by_derivatives", 16));
}

TEST_CASE("(F9), (F7): the local systems of some edge are nearly singular, of (F9) on a grid already") {
    namespace literal = literal_extension;
    CHECK(largest_condition(literal::corrected_kernels, 21, 0) > 1e5);
    CHECK(largest_condition(literal::corrected_kernels, 21, 0.25) > 1e5);
    CHECK(largest_condition(literal::harmonic_kernels, 21, 0.25) > 1e3);
    CHECK(largest_condition(literal::kernel_derivatives, 21, 0.25) < 1e3);
}

TEST_CASE("(F8): some eigenvalues of a membrane on perturbed particles have the wrong sign") {
    for (const double least : claims::least_eigenvalues<2>("literal_fpm_by_derivatives")) CHECK(least < 0);
}

TEST_CASE("(F7), (F8), (F9): neighbours that do not determine the derivatives are refused") {
    const Cloud<2> cloud = square(9, 0.25);
    auto near =
        particles::neighbourhood(cloud, smoothing(9), 40, particles::within_reach(cloud, smoothing(9), 40));
    near.r.col(1) = near.r.col(0);
    CHECK_THROWS_AS(literal_extension::modified(near), particles::SingularNeighbourhood);
    CHECK_THROWS_AS(literal_extension::modified_by_derivatives(near), particles::SingularNeighbourhood);
    CHECK_THROWS_AS(literal_extension::second_order(near), particles::SingularNeighbourhood);
}
