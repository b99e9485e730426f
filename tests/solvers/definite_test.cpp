#include "solvers/definite.hpp"

#include <doctest/doctest.h>
#include <omp.h>

using namespace solvers;

namespace {

/// Minus the second differences of a square of n × n points, with zero around it, or without.
SparseRows laplacian(int n, bool held) {
    std::vector<Eigen::Triplet<double>> entries;
    const auto link = [&](int i, int j) {
        entries.emplace_back(i, j, -1);
        entries.emplace_back(j, i, -1);
        entries.emplace_back(i, i, 1);
        entries.emplace_back(j, j, 1);
    };
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            if (i + 1 < n) link(i * n + j, i * n + n + j);
            if (j + 1 < n) link(i * n + j, i * n + j + 1);
            if (held && (i == 0 || j == 0)) entries.emplace_back(i * n + j, i * n + j, 1);
        }
    SparseRows K(n * n, n * n);
    K.setFromTriplets(entries.begin(), entries.end());
    return K;
}

}  // namespace

TEST_CASE("definite: a known solution is found to single precision, on any number of threads") {
    const int threads = omp_get_max_threads(), levels = omp_get_max_active_levels();
    for (const int n : {1, 2, 9, 60}) {
        const SparseRows K = laplacian(n, true);
        const DefiniteFactors factors(K);
        REQUIRE(factors.succeeded());
        const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(n * n, -1, 3), found = factors.solve(K * x);
        CHECK((found - x).norm() < 1e-4 * x.norm());
        omp_set_num_threads(threads == 1 ? 3 : 1);
        CHECK(DefiniteFactors(K).solve(K * x) == found);
        omp_set_num_threads(threads);
        CHECK(omp_get_max_active_levels() == levels);
    }
}

TEST_CASE("definite: a matrix that is singular or indefinite has no factors") {
    CHECK(!DefiniteFactors(laplacian(9, false)).succeeded());
    SparseRows hardly_held = laplacian(9, false);
    hardly_held.coeffRef(0, 0) += 1e-11;
    CHECK(!DefiniteFactors(hardly_held).succeeded());
    SparseRows negative = laplacian(9, true);
    negative.coeffRef(40, 40) = -4;
    CHECK(!DefiniteFactors(negative).succeeded());
}
