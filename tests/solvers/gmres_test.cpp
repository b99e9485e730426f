#include "solvers/gmres.hpp"

#include <doctest/doctest.h>

#include <Eigen/LU>
#include <Eigen/QR>

#include "tests/support/clouds.hpp"

using solvers::gmres;

TEST_CASE("gmres: after N steps the solution is exact, and after fewer the residual is the least") {
    const int N = 12;
    support::Draws draw(1);
    const Eigen::MatrixXd A =
        Eigen::MatrixXd::NullaryExpr(N, N, [&] { return draw(); }) + 2 * Eigen::MatrixXd::Identity(N, N);
    const Eigen::VectorXd c = Eigen::VectorXd::NullaryExpr(N, [&] { return draw(); });
    const auto apply = [&](const Eigen::VectorXd& v) -> Eigen::VectorXd { return A * v; };
    const auto x = gmres(apply, c, 1e-13, N);
    REQUIRE(x.has_value());
    CHECK((*x - A.lu().solve(c)).norm() < 1e-11);

    Eigen::MatrixXd krylov(N, 4);
    krylov.col(0) = c;
    for (int k = 1; k < 4; ++k) krylov.col(k) = A * krylov.col(k - 1);
    const Eigen::MatrixXd image = A * krylov;
    const double least = (c - image * image.colPivHouseholderQr().solve(c)).norm();
    const auto few = gmres(apply, c, least * 1.001, N);
    REQUIRE(few.has_value());
    CHECK((c - A * *few).norm() < least * 1.001);
    CHECK(!gmres(apply, c, least * 0.999, 4).has_value());
}

TEST_CASE("gmres: an identity needs one step, nothing none, and what is singular is not solved") {
    const Eigen::Vector3d c(1, 2, 3);
    int steps = 0;
    const auto same = [&](const Eigen::VectorXd& v) {
        ++steps;
        return v;
    };
    CHECK((*gmres(same, c, 1e-14, 10) - c).norm() < 1e-15);
    CHECK(steps == 1);
    CHECK(gmres(same, Eigen::VectorXd::Zero(3), 0, 10)->isZero(0));
    CHECK(steps == 1);
    const auto singular = [](const Eigen::VectorXd& v) -> Eigen::VectorXd {
        return Eigen::Vector3d(v[0], v[1], 0);
    };
    CHECK(!gmres(singular, c, 1e-10, 10).has_value());
    const auto singular_by_round_off = [](const Eigen::VectorXd& v) -> Eigen::VectorXd {
        return Eigen::Vector3d(v[0], v[1], 1e-17 * v[2]);
    };
    CHECK(!gmres(singular_by_round_off, c, 1e-10, 10).has_value());
    const auto no_number = [](const Eigen::VectorXd& v) -> Eigen::VectorXd { return v * std::nan(""); };
    CHECK(!gmres(no_number, c, 1e-10, 10).has_value());
}
