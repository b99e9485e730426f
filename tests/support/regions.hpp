#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

#include "particles/region.hpp"
#include "particles/region_rules.hpp"
#include "tests/support/clouds.hpp"

/// Regions of many shapes, and areas that are known exactly.
namespace support {

using particles::Arc;
using particles::Curve;
using particles::QuadraturePoint;
using particles::Region;
using particles::Segment;

inline const double pi = std::acos(-1.0);

/// The sides of a polygon through given corners.
inline Region polygon(const std::vector<Point<2>>& corners) {
    Region region;
    for (std::size_t k = 0; k < corners.size(); ++k)
        region.emplace_back(Segment{corners[k], corners[(k + 1) % corners.size()]});
    return region;
}

/// A rectangle, its sides anticlockwise from the bottom.
inline Region rectangle(const Point<2>& low, const Point<2>& high) {
    return polygon({low, {high[0], low[1]}, high, {low[0], high[1]}});
}

/// The quarter of a plate with a hole, of Section 4.2 of batra2008.
inline Region quarter(double b, double side) {
    return {Segment{{b, 0}, {side, 0}}, Segment{{side, 0}, {side, side}}, Segment{{side, side}, {0, side}},
            Segment{{0, side}, {0, b}}, Arc{{0, 0}, b, 0, pi / 2}};
}

/// The edge of a disc, or of a hole.
inline Curve circle(const Point<2>& centre, double radius, bool bulges) {
    return Arc{centre, radius, 0, 2 * pi, bulges};
}

/// The corners of a star around the origin, at random radii from 0.3 to 1.
inline std::vector<Point<2>> star(int n, unsigned seed) {
    Draws draw(seed);
    std::vector<Point<2>> corners;
    for (int k = 0; k < n; ++k)
        corners.push_back((0.65 + 0.35 * draw()) * particles::direction(2 * pi * k / n));
    return corners;
}

/// The corners of a regular polygon around the origin, of radius 1.
inline std::vector<Point<2>> regular(int n) {
    std::vector<Point<2>> corners;
    for (int k = 0; k < n; ++k) corners.push_back(particles::direction(2 * pi * k / n));
    return corners;
}

/// Area of the part of a polygon in a disc: triangles from the centre where a side lies in the disc, sectors
/// where it lies outside.
inline double area_in_disc(const std::vector<Point<2>>& corners, const Point<2>& centre, double radius) {
    const auto cross = [](const Point<2>& a, const Point<2>& b) { return a[0] * b[1] - a[1] * b[0]; };
    const auto sector = [&](const Point<2>& a, const Point<2>& b) {
        return radius * radius * std::atan2(cross(a, b), a.dot(b)) / 2;
    };
    double sum = 0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Point<2> a = corners[k] - centre, way = corners[(k + 1) % corners.size()] - centre - a;
        const double foot = -a.dot(way) / way.squaredNorm();
        const double root = foot * foot - (a.squaredNorm() - radius * radius) / way.squaredNorm();
        const double half = std::sqrt(std::max(root, 0.0));
        const double enter = std::clamp(foot - half, 0.0, 1.0), leave = std::clamp(foot + half, 0.0, 1.0);
        const Point<2> b = a + way, in = a + enter * way, out = a + leave * way;
        sum += enter < leave ? sector(a, in) + cross(in, out) / 2 + sector(out, b) : sector(a, b);
    }
    return sum;
}

/// Both regions.
inline Region together(Region region, const Region& more) {
    region.insert(region.end(), more.begin(), more.end());
    return region;
}

using Function = std::function<double(const Point<2>&)>;

inline double integral(const std::vector<QuadraturePoint>& rule, const Function& f) {
    double sum = 0;
    for (const QuadraturePoint& at : rule) sum += at.weight * f(at.x);
    return sum;
}

/// What the weights of a rule sum to.
inline double integral(const std::vector<QuadraturePoint>& rule) {
    return integral(rule, [](const Point<2>&) { return 1; });
}

/// Area of a disc in a region, with 4 n angles and n points along each ray.
inline double area(const particles::Boundary& boundary, const Point<2>& x, double radius, Index n) {
    return integral(particles::polar_rule(boundary, x, radius, n, 4 * n));
}

}  // namespace support
