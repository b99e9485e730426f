#include "solvers/spectrum.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "base/errors.hpp"
#include "tests/support/clouds.hpp"

namespace {

/// Q K Q with a random reflection Q, which is its own inverse.
void reflect(Eigen::MatrixXd& K, support::Draws& draw) {
    const Eigen::VectorXd v = Eigen::VectorXd::NullaryExpr(K.rows(), [&] { return draw(); }).normalized();
    K -= 2 * v * (v.transpose() * K).eval();
    K -= 2 * (K * v).eval() * v.transpose();
}

/// The largest distance of a number of `some` from the nearest of `all`.
template <class Some, class All>
double farthest(const Some& some, const All& all) {
    double largest = 0;
    for (const std::complex<double>& one : some) {
        double nearest = HUGE_VAL;
        for (const std::complex<double>& other : all) nearest = std::min(nearest, std::abs(one - other));
        largest = std::max(largest, nearest);
    }
    return largest;
}

}  // namespace

TEST_CASE("spectrum: eigenvalues of a companion matrix are the roots of its polynomial") {
    // (x − 1)(x² + 4) = x³ − x² + 4x − 4
    const Eigen::Matrix3d companion{{1, -4, 4}, {1, 0, 0}, {0, 1, 0}};
    auto lambda = solvers::eigenvalues(companion);
    std::sort(lambda.begin(), lambda.end(), [](auto a, auto b) { return a.imag() < b.imag(); });
    CHECK(std::abs(lambda[0] - std::complex<double>(0, -2)) < 1e-14);
    CHECK(std::abs(lambda[1] - 1.0) < 1e-14);
    CHECK(std::abs(lambda[2] - std::complex<double>(0, 2)) < 1e-14);
}

TEST_CASE("spectrum: symmetric problems come out in increasing order") {
    const Eigen::Matrix2d K{{2, 0}, {0, 3}}, M{{4, 0}, {0, 1}};
    CHECK(solvers::symmetric_eigenvalues(K, M) == std::vector<double>{0.5, 3});
}

TEST_CASE("spectrum: what has no eigenvalues is an error") {
    Eigen::Matrix2d K{{1, 2}, {3, std::nan("")}};
    CHECK_THROWS_AS(solvers::eigenvalues(K), base::FailedComputation);
    CHECK_THROWS_AS(solvers::symmetric_eigenvalues(Eigen::Matrix2d::Identity(), -Eigen::Matrix2d::Identity()),
                    base::FailedComputation);
}

TEST_CASE("spectrum: a matrix that is made of its eigenvalues, pairs and real ones, has these") {
    for (const int N : {3, 8, 41, 100}) {
        CAPTURE(N);
        support::Draws draw(1);
        // K = Q S P Λ P S⁻¹ Q with reflections Q and P and a diagonal S: the condition of the eigenvectors is
        // that of S.
        Eigen::MatrixXd K = Eigen::MatrixXd::Zero(N, N);
        std::vector<std::complex<double>> exact;
        for (int k = 0; k + 1 < N; k += 2) {
            const double a = draw(), b = draw();
            K.block<2, 2>(k, k) << a, b, -b, a;
            exact.insert(exact.end(), {{a, b}, {a, -b}});
        }
        if (N % 2 == 1) exact.emplace_back(K(N - 1, N - 1) = 0.7);
        const double condition = 30;
        const Eigen::ArrayXd S = Eigen::ArrayXd::LinSpaced(N, 1, condition);
        reflect(K, draw);
        K = S.matrix().asDiagonal() * K * (1 / S).matrix().asDiagonal();
        reflect(K, draw);
        // Bauer and Fike: an error of K moves its eigenvalues by as much, times that condition.
        const double round_off = N * std::numeric_limits<double>::epsilon() * K.norm() * condition;
        const auto found = solvers::eigenvalues(K);
        REQUIRE(static_cast<int>(found.size()) == N);
        CHECK(farthest(found, exact) < round_off);
        CHECK(farthest(exact, found) < round_off);
    }
}

TEST_CASE("spectrum: a symmetric problem that is made of its eigenvalues has these") {
    for (const int N : {1, 5, 60}) {
        CAPTURE(N);
        support::Draws draw(2);
        // M = L Lᵀ and K = L Q Λ Q Lᵀ with a reflection Q.
        Eigen::MatrixXd L = Eigen::MatrixXd::Zero(N, N), K = L;
        for (int i = 0; i < N; ++i)
            for (int j = 0; j < i; ++j) L(i, j) = 0.5 * draw() / N;
        L.diagonal().setOnes();
        std::vector<double> exact;
        for (int k = 0; k < N; ++k) exact.push_back(K(k, k) = draw());
        std::sort(exact.begin(), exact.end());
        reflect(K, draw);
        const auto found = solvers::symmetric_eigenvalues(L * K * L.transpose(), L * L.transpose());
        REQUIRE(found.size() == exact.size());
        // All eigenvalues lie in [−1, 1], and ‖L‖ ‖L⁻¹‖ < 1.5 / 0.5 = 3, since the entries below the diagonal
        // have a norm below 1/2.
        for (std::size_t k = 0; k < exact.size(); ++k)
            CHECK(std::abs(found[k] - exact[k]) < 3 * 3 * N * std::numeric_limits<double>::epsilon());
    }
}

TEST_CASE(
    "spectrum: the eigenvectors nearest zero belong to the eigenvalues nearest zero of LAPACK's dgeev") {
    const int N = 80, count = 8;
    support::Draws draw(6);
    Eigen::MatrixXd K = Eigen::MatrixXd::NullaryExpr(N, N, [&] { return draw(); });
    for (int i = 0; i < N; ++i)
        for (int j = 0; j < N; ++j)
            if (std::abs(i - j) > 3) K(i, j) = 0;
    K.diagonal().array() += 0.5;
    auto all = solvers::eigenvalues(K);
    std::sort(all.begin(), all.end(), [](auto a, auto b) { return std::abs(a) < std::abs(b); });
    const Eigen::SparseMatrix<double, Eigen::RowMajor> sparse = K.sparseView();
    const Eigen::MatrixXcd x =
        solvers::largest_of_inverse(solvers::BandedFactors<double>(sparse), N, count).vectors;
    REQUIRE(x.cols() >= count - 1);  // of a conjugate pair, one may be beyond the count
    std::vector<std::complex<double>> found;
    for (const auto& vector : x.colwise()) found.push_back(vector.dot(K * vector) / vector.squaredNorm());
    all.resize(static_cast<std::size_t>(count - 1));
    // The iteration stops at 1e-10, which the condition of the eigenvectors amplifies.
    CHECK(farthest(all, found) < 1e-9);
}
