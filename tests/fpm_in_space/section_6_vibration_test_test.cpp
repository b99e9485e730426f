#include "fpm_in_space/section_6_vibration_test.hpp"

#include <doctest/doctest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/lines.hpp"
#include "tests/support/relative.hpp"

using namespace fpm_in_space;
using namespace fpm_in_space::vibration_test;
using derivative_test::body;
using support::relative;

namespace {

constexpr double pi = std::numbers::pi;

template <int dim>
Smoothing<double, dim> cut_gaussian(Index n) {
    return {particles::TruncatedGaussian<dim>(dim == 2 ? 3.5 : 3), 1.2 / static_cast<double>(n - 1)};
}

SparseRows stiffness_of(std::string_view name, const Body<2>& body, Index n) {
    return stiffness(formulation_named<double, 2>(name), body, cut_gaussian<2>(n));
}

double asymmetry(const SparseRows& K) {
    return (Eigen::MatrixXd(K) - Eigen::MatrixXd(K).transpose()).norm() / K.norm();
}

/// A function that vanishes on the sides of the square or the cube.
template <int dim>
double bubble(const Point<dim>& x) {
    return (x.array() * (1 - x.array())).prod();
}

/// A row of numbers 1, 2, … turned into a full matrix by a rotation of all coordinates.
SparseRows rotated(const Eigen::MatrixXd& A) {
    Eigen::MatrixXd wave(A.rows(), A.rows());
    for (Index i = 0; i < A.rows(); ++i)
        for (Index j = 0; j < A.rows(); ++j)
            wave(i, j) =
                std::sqrt(2 / (static_cast<double>(A.rows()) + 1)) *
                std::sin(pi * static_cast<double>((i + 1) * (j + 1)) / (static_cast<double>(A.rows()) + 1));
    return Eigen::MatrixXd(wave * A * wave).sparseView();
}

}  // namespace

TEST_CASE("(F20): K is the Laplacian of a function that vanishes on the sides, exact where it is quadratic") {
    const auto [cloud, on_sides] = body<2>(9, 0.25, 3);
    const Index inside = on_sides[0].size();
    REQUIRE(inside == 49);
    for (const char* name : {"definite_fpm", "cubic_ssph"}) {
        const SparseRows K = stiffness_of(name, {cloud, on_sides}, 9);
        REQUIRE(K.rows() == inside);
        REQUIRE(K.cols() == inside);
        // Of x(1 − x)y(1 − y), of degree 4, those that are exact on cubics err by its fourth derivative.
        Eigen::VectorXd u(inside);
        for (Index i = 0; i < inside; ++i) u[i] = bubble<2>(cloud.x().col(i));
        const Eigen::VectorXd found = K * u;
        for (Index i = 0; i < inside; ++i) {
            const auto x = cloud.x().col(i);
            CHECK(found[i] == doctest::Approx(-2 * (x[0] * (1 - x[0]) + x[1] * (1 - x[1]))).epsilon(0.15));
        }
    }
}

TEST_CASE("(F20): the lowest frequency converges with second order") {
    const auto error = [](Index n) {
        const SparseRows K = stiffness_of("definite_fpm", body<2>(n, 0, 1), n);
        return 1 - lowest_frequencies(K, 1)[0].real() / exact_frequency<2>({1, 1});
    };
    CHECK(std::log2(error(16) / error(31)) == doctest::Approx(2).epsilon(0.03));
}

TEST_CASE("(F20): in space, too") {
    const auto cube = body<3>(9, 0.25, 1);
    const SparseRows K = stiffness(formulation_named<double, 3>("definite_fpm"), cube, cut_gaussian<3>(9));
    REQUIRE(K.rows() == 343);
    CHECK(lowest_frequencies(K, 1)[0].real() == relative(exact_frequency<3>({1, 1, 1}), 0.06));
}

TEST_CASE("(F21): exact frequencies are those of whole half waves, in order") {
    const auto plane = exact_frequencies<2>(900);
    REQUIRE(plane.size() == 900);
    CHECK(std::is_sorted(plane.begin(), plane.end()));
    CHECK(plane[0] == relative(pi * std::sqrt(2.0), 1e-15));
    CHECK(plane[1] == plane[2]);
    CHECK(plane[3] == relative(pi * std::sqrt(8.0), 1e-15));
    // As many as there are points with whole coordinates in a quarter of a disc.
    Index below = 0;
    for (int m = 1; m < 40; ++m)
        for (int k = 1; k < 40; ++k) below += m * m + k * k <= 30 * 30 ? 1 : 0;
    CHECK(plane[static_cast<std::size_t>(below) - 1] <= pi * 30 * (1 + 1e-14));
    CHECK(plane[static_cast<std::size_t>(below)] > pi * 30 * (1 + 1e-14));
    const auto space = exact_frequencies<3>(11);
    CHECK(space[0] == relative(pi * std::sqrt(3.0), 1e-15));
    CHECK(space[10] == relative(pi * std::sqrt(12.0), 1e-15));
    CHECK(exact_frequencies<2>(1).size() == 1);
}

TEST_CASE("(F22): on a line, the frequencies are those of the first paper's original SPH") {
    for (const double perturbation : {0.0, 0.25}) {
        const auto discrete =
            support::particles_of(40, {particles::Volumes::equal, particles::Gaussian{}, 1.2, perturbation});
        const auto first_paper = asprone2010::vibration_test::frequencies(
            asprone2010::formulation_named<double>("original"), discrete);
        particles::Points<1> x(1, 40);
        const auto& on_line = discrete.line.x();
        for (Index j = 0; j < 38; ++j) x(0, j) = on_line[j + 1];  // those inside come first
        x(0, 38) = on_line[0];
        x(0, 39) = on_line[39];
        const Body<1> body{particles::Cloud<1>(x), {particles::Range{0, 38}, {38, 40}}};
        const auto ours =
            frequencies(original_stiffness(body, Smoothing<double, 1>(particles::Gaussian<1>{}, 1.2 / 39)));
        REQUIRE(ours.size() == first_paper.size());
        for (std::size_t k = 0; k < ours.size(); ++k)
            CHECK(std::abs(ours[k] - first_paper[k]) < 1e-6 * std::abs(first_paper.back()));
    }
}

TEST_CASE("(F22): far from the sides of a grid, with h = 2δ, it is the Laplacian of the Gaussian of √2 h") {
    const Index n = 33;
    const double spacing = 1.0 / (n - 1), h = 2 * spacing;
    const auto square = body<2>(n, 0, 1);
    const SparseRows K = original_stiffness(square, {particles::TruncatedGaussian<2>(4), h});
    const int centre = square.cloud.nearest({0.5, 0.5});
    for (int j = 0; j < K.cols(); ++j) {
        const double s2 =
            (square.cloud.x().col(j) - square.cloud.x().col(centre)).squaredNorm() / (2 * h * h);
        const double W = std::exp(-s2) / (pi * 2 * h * h), LaplacianW = (4 * s2 - 4) * W / (2 * h * h);
        CHECK(K.coeff(centre, j) == doctest::Approx(LaplacianW * spacing * spacing).epsilon(1e-5).scale(100));
    }
}

TEST_CASE("(F22): with weights on the values K is symmetric, with weights on differences not even on grids") {
    const auto smoothing = cut_gaussian<2>(15);
    CHECK(asymmetry(original_stiffness(body<2>(15, 0, 1), smoothing, On::values)) < 1e-14);
    CHECK(asymmetry(original_stiffness(body<2>(15, 0, 1), smoothing)) > 0.05);  // beside the sides
    for (const unsigned long seed : {1UL, 2UL}) {
        const auto square = body<2>(15, 0.25, seed);
        CHECK(asymmetry(original_stiffness(square, smoothing, On::values)) < 1e-14);
        CHECK(asymmetry(original_stiffness(square, smoothing)) > 0.1);
        CHECK(complex_pairs(frequencies(original_stiffness(square, smoothing, On::values))) == 0);
        CHECK(complex_pairs(frequencies(original_stiffness(square, smoothing))) > 20);
    }
}

TEST_CASE("(F23): on a grid, linear triangles with lumped masses are the five differences") {
    const Index n = 12;
    const double spacing = 1.0 / (n - 1);
    std::vector<double> exact;
    for (int m = 1; m < n - 1; ++m)
        for (int k = 1; k < n - 1; ++k)
            exact.push_back(2 / spacing *
                            std::hypot(std::sin(pi * m * spacing / 2), std::sin(pi * k * spacing / 2)));
    std::sort(exact.begin(), exact.end());
    const auto found = frequencies(elements(body<2>(n, 0, 1), Mass::lumped));
    REQUIRE(found.size() == exact.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
        CHECK(found[k].real() == relative(exact[k], 1e-12));
        CHECK(found[k].imag() == 0);
    }
}

TEST_CASE("(F23): masses and stiffnesses are those of the triangles, on perturbed particles") {
    const Index n = 10;
    const auto square = body<2>(n, 0.25, 2);
    const auto [K, lumped] = elements(square, Mass::lumped);
    const auto [same_K, consistent] = elements(square, Mass::consistent);
    CHECK((K - same_K).norm() == 0);
    CHECK(asymmetry(K) < 1e-14);
    CHECK(asymmetry(consistent) == 0);
    CHECK(Eigen::MatrixXd(lumped).isDiagonal(0));
    // Far from the sides a hat's lumped mass is the sum of its consistent ones, and K leaves linear
    // functions.
    Index far = 0;
    for (Index i = 0; i < K.rows(); ++i) {
        const auto x = square.cloud.x().col(i);
        if (!((x.array() - 0.5).abs() < 0.5 - 1.6 / (n - 1)).all()) continue;
        ++far;
        double mass = 0;
        Eigen::Vector3d linear = Eigen::Vector3d::Zero();
        for (SparseRows::InnerIterator entry(consistent, i); entry; ++entry) mass += entry.value();
        for (SparseRows::InnerIterator entry(K, i); entry; ++entry)
            linear += entry.value() *
                      Eigen::Vector3d(1, square.cloud.x()(0, entry.col()), square.cloud.x()(1, entry.col()));
        CHECK(mass == relative(lumped.coeff(i, i), 1e-13));
        CHECK(linear.norm() < 1e-12);
    }
    CHECK(far > 20);
    // The frequencies of a Galerkin method are not too low.
    const auto exact = exact_frequencies<2>(K.rows());
    const auto galerkin = frequencies(Elements{K, consistent});
    for (std::size_t k = 0; k < exact.size(); ++k) CHECK(galerkin[k].real() > exact[k]);
}

TEST_CASE("(F23): a triangle that is turned over is refused with a remedy") {
    bool refused = false;
    for (unsigned long seed = 1; seed <= 5; ++seed) {
        CHECK_NOTHROW(static_cast<void>(elements(body<2>(20, 0.25, seed), Mass::lumped)));
        try {
            static_cast<void>(elements(body<2>(20, 0.45, seed), Mass::lumped));
        } catch (const base::FailedComputation& failed) {
            refused = std::string(failed.what()).find("is turned over; take --perturb up to 0.25") !=
                      std::string::npos;
        }
    }
    CHECK(refused);
}

TEST_CASE(
    "frequencies: complex pairs are those of the matrix, and not the round-off of a double eigenvalue") {
    Eigen::MatrixXd A = Eigen::VectorXd::LinSpaced(12, -1, -12).asDiagonal();
    CHECK(complex_pairs(frequencies(rotated(A))) == 0);
    A(3, 2) = 1;  // −3 and −4, then a pair −3.5 ± 0.1i
    A(2, 3) = -0.26;
    const auto pair = frequencies(rotated(A));
    CHECK(complex_pairs(pair) == 1);
    const auto square = pair[2] * pair[2];
    CHECK(square.real() == relative(3.5, 1e-10));
    CHECK(std::abs(square.imag()) == relative(0.1, 1e-9));
    A(2, 3) = 0;
    Eigen::MatrixXd doubles = A;  // each eigenvalue twice, with one eigenvector
    for (Index k = 0; k < 12; ++k) doubles(k, k) = -1 - static_cast<double>(k / 2);
    for (Index k = 0; k < 12; k += 2) doubles(k + 1, k) = 1;
    const auto found = frequencies(rotated(doubles));
    CHECK(complex_pairs(found) == 0);
    CHECK(std::all_of(found.begin(), found.end(), [](const auto& omega) { return omega.imag() == 0; }));
    A(3, 3) = 3;  // grows, and is no pair
    const auto grows = frequencies(rotated(A));
    CHECK(complex_pairs(grows) == 0);
    CHECK(grows[0].real() == 0);
    CHECK(std::abs(grows[0].imag()) == relative(std::sqrt(3.0), 1e-10));
}

TEST_CASE("frequencies: the lowest are those of all") {
    const Index n = 14;
    for (const double perturbation : {0.0, 0.25}) {
        const auto square = body<2>(n, perturbation, 5);
        const SparseRows K = stiffness_of("definite_fpm", square, n);
        const auto all = frequencies(K), lowest = lowest_frequencies(K, 6);
        const auto triangles = elements(square, Mass::consistent);
        const auto all_elements = frequencies(triangles), lowest_elements = lowest_frequencies(triangles, 6);
        REQUIRE(lowest.size() == 6);
        for (std::size_t k = 0; k < 6; ++k) {
            CHECK(lowest[k].real() == relative(all[k].real(), 1e-8));
            CHECK(lowest_elements[k].real() == relative(all_elements[k].real(), 1e-8));
        }
    }
}

TEST_CASE("the symbol's frequencies are those of a grid far from its sides, and exact for long waves") {
    const Index n = 22;
    const Lattice<2> lattice{particles::TruncatedGaussian<2>(3.5), 1.2};
    for (const char* name : {"definite_fpm", "ssph"}) {
        const auto symbol = symbol_frequencies(formulation_named<base::Quad, 2>(name), lattice, n);
        REQUIRE(symbol.size() == 400);
        CHECK(std::is_sorted(symbol.begin(), symbol.end()));
        CHECK(symbol[0] == relative(exact_frequency<2>({1, 1}), 0.01));
        const auto found = frequencies(stiffness_of(name, body<2>(n, 0, 1), n));
        for (std::size_t k = 0; k < 100; ++k) CHECK(found[k].real() == relative(symbol[k], 0.02));
    }
    const auto space = symbol_frequencies(formulation_named<base::Quad, 3>("definite_fpm"),
                                          Lattice<3>{particles::TruncatedGaussian<3>(3), 1.2}, 12);
    REQUIRE(space.size() == 1000);
    CHECK(space[0] == relative(exact_frequency<3>({1, 1, 1}), 0.05));
}

TEST_CASE("the original's symbol is |θ| exp(−θ²h²/4) where the Gaussian is wide") {
    const double ratio = 2, theta = pi / 20;
    const auto symbol = original_symbol_frequencies(Lattice<2>{particles::Gaussian<2>{}, ratio}, 21);
    const double wide = std::sqrt(2.0) * theta * std::exp(-2 * theta * theta * ratio * ratio / 4) * 20;
    REQUIRE(symbol.size() == 361);
    CHECK(std::any_of(symbol.begin(), symbol.end(),
                      [&](double omega) { return std::abs(omega / wide - 1) < 1e-9; }));
    CHECK(symbol.front() < 1e-3);  // a wave that alternates in both directions is hardly seen
}
