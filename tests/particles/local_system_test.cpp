#include "particles/local_system.hpp"

#include <doctest/doctest.h>

using namespace particles;

TEST_CASE("local system: the inverse inverts") {
    const Eigen::Matrix3d A{{2, -1, 0.5}, {0.25, 3, 1}, {-1, 0.5, 4}};
    CHECK((A * inverse(A) - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < 1e-15);
    const Eigen::Matrix<long double, 2, 2> B{{1.0L, 2.0L}, {3.0L, 5.0L}};
    CHECK(static_cast<double>(
              (B * inverse(B) - Eigen::Matrix<long double, 2, 2>::Identity()).cwiseAbs().maxCoeff()) < 1e-17);
}

TEST_CASE("local system: a singular or nearly singular matrix is an error that says how nearly") {
    CHECK_THROWS_WITH_AS(inverse(Eigen::Matrix2d{{1, 2}, {2, 4}}),
                         "the local system is singular (reciprocal condition 0)", SingularNeighbourhood);
    CHECK_THROWS_AS(inverse(Eigen::Matrix2d{{1, 2}, {2, 4 + 1e-14}}), SingularNeighbourhood);
    CHECK_NOTHROW(inverse(Eigen::Matrix2d{{1, 2}, {2, 4 + 1e-10}}));
    CHECK_THROWS_AS(inverse(Eigen::Matrix2d{{std::nan(""), 2}, {2, 1}}), SingularNeighbourhood);
    CHECK_THROWS_AS(inverse(Eigen::Matrix3d(Eigen::Matrix3d::Zero())), SingularNeighbourhood);
}

TEST_CASE("local system: a sum to divide by must not vanish against its terms") {
    CHECK(nonzero_sum(Eigen::Array3d(1, 2, -0.5)) == 2.5);
    CHECK_THROWS_AS(nonzero_sum(Eigen::Array3d(1, -2, 1)), SingularNeighbourhood);
    CHECK_THROWS_AS(nonzero_sum(Eigen::Array3d(0, 0, 0)), SingularNeighbourhood);
    CHECK_THROWS_AS(nonzero_sum(Eigen::Array3d(1, std::nan(""), 1)), SingularNeighbourhood);
}
