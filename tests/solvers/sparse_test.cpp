#include "solvers/sparse.hpp"

#include <doctest/doctest.h>
#include <omp.h>

#include "base/errors.hpp"
#include "tests/support/clouds.hpp"

using namespace solvers;
using particles::Index;

namespace {

/// Particles on a ring, each with the neighbours up to two places away, in increasing order.
std::vector<std::vector<int>> ring(int N) {
    std::vector<std::vector<int>> near(static_cast<std::size_t>(N));
    for (int i = 0; i < N; ++i) {
        for (const int step : {-2, -1, 0, 1, 2})
            near[static_cast<std::size_t>(i)].push_back((i + step + N) % N);
        std::sort(near[static_cast<std::size_t>(i)].begin(), near[static_cast<std::size_t>(i)].end());
    }
    return near;
}

/// Random entries, with a diagonal that keeps the matrix well conditioned unless it is zero.
SparseRows random_matrix(int N, double diagonal, unsigned seed) {
    support::Draws draw(seed);
    const auto near = ring(N);
    SparseRows A = rows_in_blocks(near, 2);
    for (Index row = 0; row < A.rows(); ++row) {
        const auto& neighbours = near[static_cast<std::size_t>(row / 2)];
        const auto count = static_cast<Index>(neighbours.size());
        set_row(A, row, neighbours, Eigen::ArrayXd::NullaryExpr(count, [&] { return draw(); }),
                Eigen::ArrayXd::NullaryExpr(count, [&] { return draw(); }));
        A.coeffRef(row, row) = diagonal;
    }
    return A;
}

/// 2 × 2 blocks of a matrix of two particles that are each other's neighbours.
SparseRows full(const Eigen::Matrix4d& entries) {
    SparseRows A = rows_in_blocks({{0, 1}, {0, 1}}, 2);
    for (Index row = 0; row < 4; ++row)
        set_row(A, row, {0, 1}, Eigen::Array2d(entries(row, 0), entries(row, 2)),
                Eigen::Array2d(entries(row, 1), entries(row, 3)));
    return A;
}

}  // namespace

TEST_CASE("sparse: rows in blocks have room for all unknowns of each neighbour, and are zero") {
    const SparseRows A = rows_in_blocks({{0, 2}, {1}, {0, 1, 2}}, 2);
    CHECK(A.rows() == 6);
    CHECK(A.cols() == 6);
    CHECK(A.nonZeros() == 2 * 4 + 2 * 2 + 2 * 6);
    const Eigen::MatrixXi expected{{1, 1, 0, 0, 1, 1}, {1, 1, 0, 0, 1, 1}, {0, 0, 1, 1, 0, 0},
                                   {0, 0, 1, 1, 0, 0}, {1, 1, 1, 1, 1, 1}, {1, 1, 1, 1, 1, 1}};
    Eigen::MatrixXi room = Eigen::MatrixXi::Zero(6, 6);
    for (Index row = 0; row < 6; ++row)
        for (SparseRows::InnerIterator entry(A, row); entry; ++entry) {
            room(row, entry.col()) = 1;
            CHECK(entry.value() == 0);
        }
    CHECK(room == expected);
}

TEST_CASE("sparse: a row that is set holds the factors of the named particles and nothing else") {
    SparseRows A = rows_in_blocks({{0, 1, 2, 3}, {1}, {2}, {3}}, 2);
    set_row(A, 1, {1, 3}, Eigen::Array2d(5, 7), Eigen::Array2d(6, 8));
    CHECK(Eigen::MatrixXd(A).row(1) == Eigen::RowVectorXd{{0, 0, 5, 6, 0, 0, 7, 8}});
    CHECK(Eigen::MatrixXd(A).row(0).isZero(0));
    CHECK(Eigen::MatrixXd(A).bottomRows(6).isZero(0));
    set_row(A, 7, {3}, Eigen::ArrayXd::Constant(1, 2), Eigen::ArrayXd::Constant(1, 3));
    CHECK(Eigen::MatrixXd(A).row(7) == Eigen::RowVectorXd{{0, 0, 0, 0, 0, 0, 2, 3}});
}

TEST_CASE("sparse: one unknown at a point, and three") {
    SparseRows one = rows_in_blocks({{0, 1}, {1}, {0, 2}}, 1);
    CHECK(one.nonZeros() == 5);
    set_row(one, 2, {0, 2}, Eigen::Array2d(4, 5));
    CHECK(Eigen::MatrixXd(one).row(2) == Eigen::RowVector3d(4, 0, 5));
    SparseRows three = rows_in_blocks({{0, 1}, {1}}, 3);
    CHECK(three.nonZeros() == 3 * 6 + 3 * 3);
    set_row(three, 1, {1}, Eigen::ArrayXd::Constant(1, 7), Eigen::ArrayXd::Constant(1, 8),
            Eigen::ArrayXd::Constant(1, 9));
    CHECK(Eigen::MatrixXd(three).row(1) == Eigen::RowVectorXd{{0, 0, 0, 7, 8, 9}});
    CHECK(Eigen::MatrixXd(three).row(2).isZero(0));
}

TEST_CASE("sparse: a known solution is found") {
    const SparseRows A = random_matrix(200, 5, 1);
    const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(400, -1, 3);
    CHECK((solve_sparse(SparseRows(A), A * x) - x).cwiseAbs().maxCoeff() < 1e-13);
}

TEST_CASE("sparse: rows whose sizes differ by 1e12 are solved as well") {
    SparseRows A = random_matrix(200, 5, 2);
    for (Index row = 0; row < A.rows(); ++row) A.row(row) *= std::pow(10, (row * 7) % 13 - 6);
    const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(400, -1, 3);
    CHECK((solve_sparse(SparseRows(A), A * x) - x).cwiseAbs().maxCoeff() < 1e-10);
}

TEST_CASE("sparse: rows are exchanged where the diagonal is zero") {
    const SparseRows A = random_matrix(60, 0, 3);
    const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(120, -1, 3);
    CHECK((solve_sparse(SparseRows(A), A * x) - x).cwiseAbs().maxCoeff() < 1e-10);
    const SparseRows exchanged =
        full(Eigen::Matrix4d{{0, 1, 0, 0}, {0, 0, 0, 2}, {4, 0, 0, 0}, {0, 0, 8, 0}});
    CHECK(solve_sparse(SparseRows(exchanged), Eigen::Vector4d(1, 2, 4, 8)) == Eigen::Vector4d::Ones());
}

TEST_CASE("sparse: without a load nothing moves") {
    CHECK(solve_sparse(random_matrix(20, 5, 4), Eigen::VectorXd::Zero(40)).isZero(0));
}

TEST_CASE("sparse: a singular system is refused with its size") {
    const auto refused = [](const Eigen::Matrix4d& entries) {
        CHECK_THROWS_WITH_AS(
            solve_sparse(full(entries), Eigen::Vector4d::Ones()),
            "the linear system of 4 unknowns is singular; take another scaling factor, another smoothing length or other particles",
            base::FailedComputation);
    };
    refused(Eigen::Matrix4d{
        {1, 2, 0, 0}, {2, 4, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}});  // equal rows once they are scaled
    refused(Eigen::Matrix4d{{1, 0, 2, 3}, {0, 0, 1, 5}, {2, 0, 1, 1}, {1, 0, 1, 1}});  // a column of zeros
    const double nearly = 4 * (1 + 3e-16);
    refused(Eigen::Matrix4d{{1, 2, 0, 0}, {2, nearly, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}});
    refused(Eigen::Matrix4d{{1, 2, 3, 0}, {4, 5, 6, 0}, {7, 8, 9, 0}, {0, 0, 0, 1}});
}

TEST_CASE("sparse: rows that are zero or not finite are refused by their number, and so are such loads") {
    const Eigen::Matrix4d I = Eigen::Matrix4d::Identity();
    const auto refused = [&](const Eigen::Matrix4d& A, const Eigen::Vector4d& b, const std::string& row) {
        CHECK_THROWS_WITH_AS(
            solve_sparse(full(A), b),
            ("the linear system of 4 unknowns has a row " + row +
             " that is zero or not finite; take another scaling factor, another smoothing length or other particles")
                .c_str(),
            base::FailedComputation);
    };
    const auto with = [&](int row, int column, double entry) {
        Eigen::Matrix4d A = I;
        A(row, column) = entry;
        return A;
    };
    refused(with(2, 2, 0), Eigen::Vector4d::Ones(), "2");
    refused(with(1, 1, std::nan("")), Eigen::Vector4d::Ones(), "1");
    refused(with(1, 2, HUGE_VAL), Eigen::Vector4d::Ones(), "1");
    refused(with(3, 0, -HUGE_VAL), Eigen::Vector4d::Ones(), "3");
    refused(I, Eigen::Vector4d(1, std::nan(""), 0, 0), "1");
}

TEST_CASE(
    "sparse: rows are scaled to a largest entry of 1, with the load and the rows on the nearest particles") {
    SparseRows A = full(Eigen::Matrix4d{{2, -4, 0, 0}, {0, 1e9, 0, 0}, {0, 0, -5e-3, 0}, {0, 0, 0, 1}});
    SparseRows nearest = full(Eigen::Matrix4d::Identity());
    Eigen::VectorXd b = Eigen::Vector4d(1, 2, 3, 4);
    scale_rows(A, b, nearest);
    CHECK(Eigen::Matrix4d(A).isApprox(
        Eigen::Matrix4d{{0.5, -1, 0, 0}, {0, 1, 0, 0}, {0, 0, -1, 0}, {0, 0, 0, 1}}, 1e-15));
    CHECK(b.isApprox(Eigen::Vector4d(0.25, 2e-9, 600, 4), 1e-15));
    CHECK(Eigen::Vector4d(Eigen::Matrix4d(nearest).diagonal())
              .isApprox(Eigen::Vector4d(0.25, 1e-9, 200, 1), 1e-15));
}

TEST_CASE(
    "sparse: with a matrix that is nearly A the iteration finds the known solution, and with its own too") {
    const SparseRows A = random_matrix(200, 5, 1);
    SparseRows nearly = A;
    for (Index k = 0; k < A.nonZeros(); ++k) nearly.valuePtr()[k] *= k % 3 == 0 ? 1.2 : 1;
    const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(400, -1, 3), b = A * x;
    for (const SparseRows& nearest : {A, nearly}) {
        const auto found = iterated(A, b, nearest);
        REQUIRE(found.has_value());
        CHECK((*found - x).cwiseAbs().maxCoeff() < 1e-12);
    }
    CHECK(iterated(A, Eigen::VectorXd::Zero(400), nearly)->isZero(0));
}

TEST_CASE("sparse: where the iteration fails the factorisation of A solves") {
    const SparseRows A = random_matrix(200, 5, 1), other = random_matrix(200, 0, 7);
    const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(400, -1, 3), b = A * x;
    CHECK(!iterated(A, b, other).has_value());
    SparseRows singular = A;
    for (SparseRows::InnerIterator entry(singular, 0); entry; ++entry) entry.valueRef() = 0;
    CHECK(!iterated(A, b, singular).has_value());
    for (const SparseRows& nearest : {other, singular})
        CHECK((solve_sparse(SparseRows(A), b, SparseRows(nearest)) - x).cwiseAbs().maxCoeff() < 1e-13);
}

TEST_CASE("sparse: a singular system is refused whatever stands for the nearest particles") {
    const SparseRows singular = full(Eigen::Matrix4d{{1, 2, 3, 0}, {4, 5, 6, 0}, {7, 8, 9, 0}, {0, 0, 0, 1}});
    const SparseRows regular = full(Eigen::Matrix4d{{1, 0, 1, 0}, {0, 1, 0, 0}, {0, 1, 1, 0}, {0, 0, 0, 1}});
    for (const SparseRows& nearest : {singular, regular})
        CHECK_THROWS_WITH_AS(
            solve_sparse(SparseRows(singular), Eigen::Vector4d(1, 2, 5, 1), SparseRows(nearest)),
            "the linear system of 4 unknowns is singular; take another scaling factor, another smoothing length or other particles",
            base::FailedComputation);
}

TEST_CASE("sparse: with elements, too, what is singular is refused and what fails is factorised") {
    const SparseRows A = random_matrix(200, 5, 1);
    SparseRows K = rows_in_blocks(ring(200), 2), none = K;
    K.diagonal().setConstant(3);
    const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(400, -1, 3), b = A * x;
    const auto with = [](const SparseRows& K_) { return Elements{K_, {0, 1, 398, 399}}; };
    Eigen::VectorXd b_scaled = b;
    SparseRows scaled = A, no_rows;
    scale_rows(scaled, b_scaled, no_rows);
    const auto found = iterated(scaled, b_scaled, with(K));
    REQUIRE(found.has_value());
    CHECK((*found - x).cwiseAbs().maxCoeff() < 1e-11);
    CHECK(!iterated(scaled, b_scaled, with(none)).has_value());
    CHECK((solve_sparse(SparseRows(A), b, with(none)) - x).cwiseAbs().maxCoeff() < 1e-13);
    SparseRows singular = A;
    singular.row(7) = 2 * singular.row(9);
    CHECK_THROWS_WITH_AS(solve_sparse(SparseRows(singular), b, with(K)), doctest::Contains("is singular"),
                         base::FailedComputation);
}

TEST_CASE("sparse: the same bits on any number of threads") {
    const SparseRows A = random_matrix(300, 5, 5);
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(600, -1, 3);
    const int threads = omp_get_max_threads();
    omp_set_num_threads(1);
    const Eigen::VectorXd alone = solve_sparse(SparseRows(A), b);
    const Eigen::VectorXd iterated_alone = solve_sparse(SparseRows(A), b, SparseRows(A));
    omp_set_num_threads(3);
    CHECK(solve_sparse(SparseRows(A), b) == alone);
    CHECK(solve_sparse(SparseRows(A), b, SparseRows(A)) == iterated_alone);
    omp_set_num_threads(threads);
}
