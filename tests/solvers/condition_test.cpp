#include "solvers/condition.hpp"

#include <cmath>

#include "tests/support/relative.hpp"

using solvers::reciprocal_condition;

TEST_CASE("condition: it is one over the condition number, whatever the rows' and columns' units") {
    CHECK(reciprocal_condition(Eigen::MatrixXd::Identity(4, 4)) == support::relative(1, 1e-15));
    const Eigen::Matrix2d A{{1, 0.5}, {0.5, 1}};
    CHECK(reciprocal_condition(A) == support::relative(1.0 / 3, 1e-14));
    const Eigen::Matrix2d other{{1e12, 0.5e-3}, {0.5e-3, 1e-18}};
    CHECK(reciprocal_condition(other) == support::relative(1.0 / 3, 1e-12));
}

TEST_CASE("condition: a matrix that is singular, indefinite or not finite has none") {
    CHECK(reciprocal_condition(Eigen::Matrix2d{{1, 1}, {1, 1}}) < 1e-15);
    CHECK(reciprocal_condition(Eigen::Matrix2d{{1, 2}, {2, 1}}) == 0);
    CHECK(reciprocal_condition(Eigen::Matrix2d{{0, 0}, {0, 1}}) == 0);
    CHECK(reciprocal_condition(Eigen::Matrix2d{{1, std::nan("")}, {std::nan(""), 1}}) == 0);
    CHECK(reciprocal_condition(Eigen::MatrixXd(0, 0)) == 0);
}
