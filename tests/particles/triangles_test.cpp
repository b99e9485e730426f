#include "particles/triangles.hpp"

#include <doctest/doctest.h>

#include <Eigen/LU>
#include <map>
#include <set>

#include "tests/support/clouds.hpp"

using namespace particles;

namespace {

double twice_area(const Cloud<2>& cloud, const std::array<int, 3>& triangle) {
    const auto at = [&](std::size_t k) -> Point<2> { return cloud.x().col(triangle[k]); };
    const Point<2> a = at(1) - at(0), b = at(2) - at(0);
    return a[0] * b[1] - a[1] * b[0];
}

/// All triangles, each with the number of corners at which it was found.
std::map<std::set<int>, int> all_triangles(const Cloud<2>& cloud) {
    std::map<std::set<int>, int> found;
    for (Index I = 0; I < cloud.size(); ++I)
        for (const auto& [J, K] : triangles_at(cloud, I)) {
            CHECK(twice_area(cloud, {static_cast<int>(I), J, K}) > 0);
            ++found[{static_cast<int>(I), J, K}];
        }
    return found;
}

double area(const Cloud<2>& cloud, const std::map<std::set<int>, int>& triangles) {
    double sum = 0;
    for (const auto& [corners, count] : triangles) {
        std::array<int, 3> triangle{};
        std::copy(corners.begin(), corners.end(), triangle.begin());
        sum += std::abs(twice_area(cloud, triangle)) / 2;
    }
    return sum;
}

}  // namespace

TEST_CASE("triangles: those of a grid fill the square once, and each corner knows them") {
    const Cloud<2> cloud(support::grid_points<2>(12));
    const auto triangles = all_triangles(cloud);
    CHECK(triangles.size() == 2 * 11 * 11);
    for (const auto& [corners, count] : triangles) CHECK(count == 3);
    CHECK(std::abs(area(cloud, triangles) - 1) < 1e-12);
}

TEST_CASE("triangles: no particle lies in their circles, and inside of the cloud none is missing") {
    const Cloud<2> cloud(support::irregular_points<2>(14, 0.3, 3));
    const auto triangles = all_triangles(cloud);
    for (const auto& [corners, count] : triangles) {
        std::array<int, 3> of{};
        std::copy(corners.begin(), corners.end(), of.begin());
        const Point<2> a = cloud.x().col(of[0]), b = cloud.x().col(of[1]), c = cloud.x().col(of[2]);
        Eigen::Matrix2d edges;
        edges << (b - a).transpose(), (c - a).transpose();
        const Point<2> centre =
            a + edges.inverse() * Point<2>((b - a).squaredNorm() / 2, (c - a).squaredNorm() / 2);
        const double radius = (centre - a).norm();
        for (Index J = 0; J < cloud.size(); ++J)
            CHECK((cloud.x().col(J) - centre).norm() > radius * (1 - 1e-5));
    }
    for (Index I = 0; I < cloud.size(); ++I) {
        const Point<2> x = cloud.x().col(I);
        if ((x.array() < 0.2).any() || (x.array() > 0.8).any()) continue;
        std::set<int> starts, ends;
        for (const auto& [J, K] : triangles_at(cloud, I)) {
            starts.insert(J);
            ends.insert(K);
            CHECK(triangles.at({static_cast<int>(I), J, K}) == 3);
        }
        CHECK(starts == ends);  // they go all around
    }
}

TEST_CASE("triangles: none reaches across a hole") {
    Points<2> ring(2, 3 * 40);
    for (int layer = 0; layer < 3; ++layer)
        for (int k = 0; k < 40; ++k) {
            const double angle = std::acos(-1) / 20 * (k + 0.5 * layer), radius = 1 + 0.15 * layer;
            ring.col(40 * layer + k) << radius * std::cos(angle), radius * std::sin(angle);
        }
    const Cloud<2> cloud(ring);
    for (const auto& [corners, count] : all_triangles(cloud)) {
        Point<2> centre = Point<2>::Zero();
        for (const int corner : corners) centre += cloud.x().col(corner) / 3;
        CHECK(centre.norm() > 0.99);
    }
}

TEST_CASE("triangles: of three particles there is one, and of a row none") {
    const Cloud<2> three(Points<2>{{0, 1, 0}, {0, 0, 1}});
    CHECK(triangles_at(three, 0) == std::vector<std::array<int, 2>>{{1, 2}});
    const Cloud<2> row(Points<2>{{0, 1, 2, 3}, {0, 0, 0, 0}});
    CHECK(triangles_at(row, 1).empty());
}
