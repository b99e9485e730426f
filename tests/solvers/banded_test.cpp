#include "solvers/banded.hpp"

#include <doctest/doctest.h>
#include <lapacke.h>

#include <Eigen/SparseLU>
#include <random>

#include "asprone2010/section_5_2_static_test.hpp"
#include "base/quad.hpp"
#include "tests/support/lines.hpp"

namespace {

using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

Matrix random_banded(int N, int below, int above, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> entry(-1, 1);
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < N; ++i)
        for (int j = std::max(0, i - below); j <= std::min(N - 1, i + above); ++j)
            entries.emplace_back(i, j, entry(random));
    Matrix A(N, N);
    A.setFromTriplets(entries.begin(), entries.end());
    return A;
}

}  // namespace

TEST_CASE("banded: agrees with Eigen's SparseLU, for unsymmetric bands and rows of very different size") {
    for (const auto& [below, above] : {std::pair{1, 1}, {6, 6}, {12, 3}, {0, 4}, {5, 0}}) {
        Matrix A = random_banded(200, below, above, 42);
        for (int i = 0; i < 200; ++i) A.coeffRef(i, i) += 4;
        A.row(0) *= 1e-7;
        A.row(199) *= 1e6;
        const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(200, -1, 2);
        const Eigen::VectorXd b = A * x;
        const Eigen::SparseLU<Eigen::SparseMatrix<double>> lu{Eigen::SparseMatrix<double>(A)};
        const Eigen::ArrayXd found = solvers::solve_banded(A, b);
        CHECK((found - x.array()).abs().maxCoeff() < 1e-9);
        CHECK((found - lu.solve(b).array()).abs().maxCoeff() < 1e-9);
    }
}

TEST_CASE(
    "banded: the static test's systems have the solutions of SparseLU, to what their condition leaves") {
    using namespace asprone2010;
    const Index N = 150;
    for (const auto& formulation : formulations<double>())
        for (const auto volumes : {particles::Volumes::equal, particles::Volumes::partition})
            for (const unsigned long seed : {1UL, 2UL, 3UL}) {
                CAPTURE(formulation.name);
                CAPTURE(seed);
                const auto [line, smoothing] =
                    support::particles_of(N, {volumes, particles::Gaussian{}, 1.1, 0.25}, seed);
                auto [D, D2] = formulation.operators(line, smoothing);
                Matrix A = static_test::system(std::move(D2), D);
                Column<double> f = static_test::right_hand_side(line, static_test::exponential_load());
                const solvers::BandedFactors<double> factors(A);
                const Column<double> u = factors.solve(f);
                for (Index i = 0; i < N; ++i) {
                    const double largest = Eigen::VectorXd(A.row(i)).cwiseAbs().maxCoeff();
                    A.row(i) /= largest;
                    f[i] /= largest;
                }
                const Eigen::SparseLU<Eigen::SparseMatrix<double>> lu{Eigen::SparseMatrix<double>(A)};
                const Column<double> expected = lu.solve(f.matrix()).array();
                const double round_off = static_cast<double>(N) * std::numeric_limits<double>::epsilon() /
                                         factors.reciprocal_condition();
                CHECK((u - expected).abs().sum() < round_off * expected.abs().sum());
            }
}

TEST_CASE("banded: the condition is estimated as LAPACK's dgbcon estimates it") {
    for (const double diagonal : {4.0, 1.0, 0.3}) {
        const int N = 150, below = 3, above = 5, height = 2 * below + above + 1;
        Matrix A = random_banded(N, below, above, 7);
        for (int i = 0; i < N; ++i) A.coeffRef(i, i) += diagonal;
        for (int i = 0; i < N; ++i) A.row(i) /= Eigen::RowVectorXd(A.row(i)).cwiseAbs().maxCoeff();
        Eigen::MatrixXd band = Eigen::MatrixXd::Zero(height, N);
        for (int i = 0; i < N; ++i)
            for (Matrix::InnerIterator entry(A, i); entry; ++entry)
                band(below + above + i - entry.col(), entry.col()) = entry.value();
        const double norm = band.cwiseAbs().colwise().sum().maxCoeff();
        std::vector<lapack_int> pivots(N);
        double expected = 0;
        LAPACKE_dgbtrf(LAPACK_COL_MAJOR, N, N, below, above, band.data(), height, pivots.data());
        LAPACKE_dgbcon(LAPACK_COL_MAJOR, '1', N, below, above, band.data(), height, pivots.data(), norm,
                       &expected);
        CHECK(solvers::BandedFactors<double>(A).reciprocal_condition() == support::relative(expected, 1e-9));
        const Eigen::SparseMatrix<long double, Eigen::RowMajor> longer = A.cast<long double>();
        CHECK(static_cast<double>(solvers::BandedFactors<long double>(longer).reciprocal_condition()) ==
              support::relative(expected, 1e-9));
    }
}

TEST_CASE("banded: rows are exchanged where the diagonal is zero") {
    Matrix A(3, 3);
    const std::vector<Eigen::Triplet<double>> entries{{0, 1, 1}, {1, 0, 2}, {2, 2, 4}};
    A.setFromTriplets(entries.begin(), entries.end());
    const Eigen::ArrayXd x = solvers::solve_banded(A, Eigen::Array3d(3, 4, 8));
    CHECK(x[0] == 2);
    CHECK(x[1] == 3);
    CHECK(x[2] == 2);
}

TEST_CASE(
    "banded: what is singular to the precision is refused in that precision, and solved in a longer one") {
    using Longer = Eigen::SparseMatrix<long double, Eigen::RowMajor>;
    // The Hilbert matrix with 14 unknowns has a reciprocal condition of about 1e-19.
    Longer A(14, 14);
    for (int i = 0; i < 14; ++i)
        for (int j = 0; j < 14; ++j) A.insert(i, j) = 1.0L / (i + j + 1);
    const Matrix shorter = A.cast<double>();
    const Eigen::SparseMatrix<base::Quad, Eigen::RowMajor> quad = A.cast<base::Quad>();
    const solvers::BandedFactors<double> in_double(shorter);
    const solvers::BandedFactors<long double> in_long(A);
    const solvers::BandedFactors<base::Quad> in_quad(quad);
    CHECK_THROWS_WITH_AS(in_double.require_regular(),
                         doctest::Contains("14 unknowns is singular (reciprocal condition"),
                         base::FailedComputation);
    CHECK_THROWS_AS(in_long.require_regular(), base::FailedComputation);
    CHECK_NOTHROW(in_quad.require_regular());
}

TEST_CASE("banded: a singular system is reported, exactly and nearly singular ones, and what is not finite") {
    Matrix A(3, 3);
    std::vector<Eigen::Triplet<double>> entries{{0, 0, 1}, {0, 1, 2}, {1, 0, 2}, {1, 1, 4}, {2, 2, 1}};
    A.setFromTriplets(entries.begin(), entries.end());
    CHECK_THROWS_WITH_AS(
        solvers::solve_banded(A, Eigen::Array3d::Ones()),
        "the linear system of 3 unknowns is singular (reciprocal condition 0); take another smoothing length, another formulation or other particles",
        base::FailedComputation);
    A.coeffRef(1, 1) = 4 * (1 + 3e-16);
    CHECK_THROWS_AS(solvers::solve_banded(A, Eigen::Array3d::Ones()), base::FailedComputation);
    A.coeffRef(1, 1) = std::nan("");
    CHECK_THROWS_WITH_AS(
        solvers::solve_banded(A, Eigen::Array3d::Ones()),
        "row 1 of the linear system is zero or not finite; take another smoothing length or other particles",
        base::FailedComputation);
    A.coeffRef(1, 1) = 5;
    CHECK_THROWS_WITH_AS(solvers::solve_banded(A, Eigen::Array3d(1, std::nan(""), 1)),
                         "the linear system has a right-hand side that is not finite",
                         base::FailedComputation);
    CHECK_THROWS_AS(solvers::solve_banded(Matrix(3, 3), Eigen::Array3d::Ones()), base::FailedComputation);
}
