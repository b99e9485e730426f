#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>
#include <vector>

#include "base/index.hpp"
#include "particles/cloud.hpp"
#include "particles/quadrature.hpp"

namespace particles {

using base::Index;

/// A straight part of a boundary; the region lies to its left, seen along the way from one end to the other.
struct Segment {
    Point<2> from, to;
};

/// A part of the edge of a circular hole, between two angles, the smaller one first [radian].
struct Arc {
    Point<2> centre;
    double radius, from, to;
};

/// A smooth part of the boundary of a region.
using Curve = std::variant<Segment, Arc>;

/// A convex polygon with circular holes, which may cut its corners and sides.
using Region = std::vector<Curve>;

/// A point of a quadrature rule over an area or along a boundary.
struct QuadraturePoint {
    Point<2> x;
    double weight;
    Point<2> normal = Point<2>::Zero();  ///< unit outward normal, on a boundary
};

namespace detail {

/// Relative tolerance below which a length counts as zero: positions may come from a file with ten digits.
constexpr double negligible = 1e-8;

inline Point<2> direction(double angle) {
    return {std::cos(angle), std::sin(angle)};
}

/// Unit normal of a segment, to its right.
inline Point<2> outward(const Segment& side) {
    const Point<2> along = (side.to - side.from).normalized();
    return {along[1], -along[0]};
}

inline double angle_of(const Point<2>& v) {
    return std::atan2(v[1], v[0]);
}

}  // namespace detail

/// Unit outward normal of a boundary at a place on it.
inline Point<2> normal_at(const Curve& curve, const Point<2>& x) {
    if (const auto* side = std::get_if<Segment>(&curve)) return detail::outward(*side);
    return (std::get<Arc>(curve).centre - x).normalized();
}

/// Both ends of a part of the boundary.
inline std::array<Point<2>, 2> ends(const Curve& curve) {
    if (const auto* side = std::get_if<Segment>(&curve)) return {side->from, side->to};
    const auto& [centre, radius, from, to] = std::get<Arc>(curve);
    return {centre + radius * detail::direction(from), centre + radius * detail::direction(to)};
}

/// Does a place lie on a part of the boundary, its ends included? \param size a length that counts as large
inline bool lies_on(const Curve& curve, const Point<2>& x, double size) {
    const double slack = detail::negligible * size;
    for (const Point<2>& end : ends(curve))
        if ((x - end).norm() <= slack) return true;
    if (const auto* side = std::get_if<Segment>(&curve)) {
        const Point<2> way = side->to - side->from;
        const double along = (x - side->from).dot(way.normalized());
        return std::abs((x - side->from).dot(detail::outward(*side))) <= slack && along >= 0 &&
               along <= way.norm();
    }
    const auto& [centre, radius, from, to] = std::get<Arc>(curve);
    if (std::abs((x - centre).norm() - radius) > slack) return false;
    const double turn = 2 * std::acos(-1.0);
    const double angle = detail::angle_of(x - centre);
    return angle - from - turn * std::floor((angle - from) / turn) <= to - from;
}

/// Does a place lie in the region or on its boundary?
inline bool contains(const Region& region, const Point<2>& x, double size) {
    return std::all_of(region.begin(), region.end(), [&](const Curve& curve) {
        if (const auto* side = std::get_if<Segment>(&curve))
            return (x - side->from).dot(detail::outward(*side)) <= detail::negligible * size;
        const Arc& hole = std::get<Arc>(curve);
        return (x - hole.centre).norm() >= hole.radius - detail::negligible * size;
    });
}

namespace detail {

/// The intervals of a ray, from a place in the region, that lie in the region: one, or two where the ray
/// crosses a hole.
inline std::vector<std::array<double, 2>> inside_along(const Region& region, const Point<2>& x,
                                                       const Point<2>& along, double reach) {
    std::vector<std::array<double, 2>> inside{{0, reach}};
    for (const Curve& curve : region) {
        double enter = reach, leave = reach;  // the ray is outside between these distances
        if (const auto* side = std::get_if<Segment>(&curve)) {
            const double approach = along.dot(outward(*side));
            const double distance = std::max((side->from - x).dot(outward(*side)), 0.0);
            if (approach > negligible) enter = std::min(distance / approach, reach);
        } else {
            const Arc& hole = std::get<Arc>(curve);
            const Point<2> offset = x - hole.centre;
            const double beta = offset.dot(along);
            const double outside = offset.squaredNorm() - hole.radius * hole.radius;
            const double gamma = outside > negligible * hole.radius * reach ? outside : 0;
            if (const double root = beta * beta - gamma; beta < 0 && root > 0) {
                enter = std::min(-beta - std::sqrt(root), reach);
                leave = std::min(-beta + std::sqrt(root), reach);
            }
        }
        std::vector<std::array<double, 2>> left;
        for (const auto& [from, to] : inside) {
            if (from < std::min(to, enter)) left.push_back({from, std::min(to, enter)});
            if (std::max(from, leave) < to) left.push_back({std::max(from, leave), to});
        }
        inside = left;
    }
    return inside;
}

/// An angle at which the interval of a ray in the region is not a smooth function of the angle. At a tangent
/// to a hole it behaves like a square root.
struct Break {
    double angle;
    bool tangent;
};

inline std::vector<Break> breaks(const Region& region, const Point<2>& x, double reach) {
    std::vector<Break> found;
    const auto add_both = [&](double middle, double half, bool tangent) {
        found.push_back({middle - half, tangent});
        found.push_back({middle + half, tangent});
    };
    for (const Curve& curve : region) {
        for (const Point<2>& end : ends(curve))
            if (const double distance = (end - x).norm();
                distance > negligible * reach && distance < reach * (1 - negligible))
                found.push_back({angle_of(end - x), false});
        if (const auto* side = std::get_if<Segment>(&curve)) {
            const Point<2> n = outward(*side);
            const double distance = std::max((side->from - x).dot(n), 0.0);
            if (distance < reach * (1 - negligible))
                add_both(angle_of(n), std::acos(distance < negligible * reach ? 0 : distance / reach), false);
        } else {
            const Arc& hole = std::get<Arc>(curve);
            const Point<2> inward = hole.centre - x;
            const double away = inward.norm(), b = hole.radius;
            if (away - b >= reach * (1 - negligible)) continue;
            add_both(
                angle_of(inward),
                std::acos(std::clamp((reach * reach + away * away - b * b) / (2 * reach * away), -1.0, 1.0)),
                false);
            const double tangent_squared = away * away - b * b;
            if (tangent_squared <= negligible * b * reach)
                add_both(angle_of(inward), std::acos(0.0), false);
            else if (tangent_squared < reach * reach)
                add_both(angle_of(inward), std::asin(b / away), true);
        }
    }
    const double turn = 2 * std::acos(-1.0);
    for (Break& each : found) each.angle -= turn * std::floor(each.angle / turn + negligible);
    std::sort(found.begin(), found.end(), [](const Break& a, const Break& b) { return a.angle < b.angle; });
    const auto same = [](const Break& a, const Break& b) { return b.angle - a.angle < negligible; };
    found.erase(std::unique(found.begin(), found.end(), same), found.end());
    if (found.empty()) found.push_back({0, false});
    found.push_back({found.front().angle + turn, found.front().tangent});
    return found;
}

}  // namespace detail

/// Gauss rule in polar coordinates over the part of a disc that lies in the region. The angles of rays that
/// meet the region are cut into pieces on which the boundary is smooth: a whole disc, a half at a side and a
/// quarter at a corner are one piece. Each piece has its share of the angular points.
/// \param x centre, in the region
/// \param reach radius of the disc
/// \param radial number of points along a ray
/// \param angular number of points over all these angles
/// \return points with weights that sum to the area
inline std::vector<QuadraturePoint> polar_rule(const Region& region, const Point<2>& x, double reach,
                                               Index radial, Index angular) {
    struct Piece {
        detail::Break from, to;
    };
    std::vector<Piece> pieces;
    double seen = 0;
    const std::vector<detail::Break> breaks = detail::breaks(region, x, reach);
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
        const double middle = (breaks[k].angle + breaks[k + 1].angle) / 2;
        if (detail::inside_along(region, x, detail::direction(middle), reach).empty()) continue;
        pieces.push_back({breaks[k], breaks[k + 1]});
        seen += breaks[k + 1].angle - breaks[k].angle;
    }
    const GaussRule along_ray = gauss_rule(radial);
    std::vector<QuadraturePoint> rule;
    for (const auto& [from, to] : pieces) {
        const double width = to.angle - from.angle;
        const Index share = std::max<Index>(pieces.size() > 1 ? radial : 1,
                                            std::lround(static_cast<double>(angular) * width / seen));
        const GaussRule across = gauss_rule(share);
        for (Index k = 0; k < share; ++k) {
            // With angle − tangent = width t², a square root at a tangent is smooth in t.
            double t = across.x[k], weight = across.w[k] * width;
            if (from.tangent && to.tangent) {
                weight *= 6 * t * (1 - t);
                t = t * t * (3 - 2 * t);
            } else if (from.tangent) {
                weight *= 2 * t;
                t = t * t;
            } else if (to.tangent) {
                weight *= 2 * (1 - t);
                t = 1 - (1 - t) * (1 - t);
            }
            const Point<2> ray = detail::direction(from.angle + width * t);
            for (const auto& [near, far] : detail::inside_along(region, x, ray, reach))
                for (Index n = 0; n < radial; ++n) {
                    const double r = near + (far - near) * along_ray.x[n];
                    rule.push_back({x + r * ray, weight * along_ray.w[n] * (far - near) * r});
                }
        }
    }
    return rule;
}

/// Gauss rule along the part of a boundary that lies in a disc.
/// \param x centre of the disc
/// \return points with normals and weights that sum to the length
inline std::vector<QuadraturePoint> boundary_rule(const Curve& curve, const Point<2>& x, double reach,
                                                  Index points) {
    std::vector<QuadraturePoint> rule;
    if (const auto* side = std::get_if<Segment>(&curve)) {
        const Point<2> along = (side->to - side->from).normalized(), n = detail::outward(*side);
        const double middle = (x - side->from).dot(along);
        const double away = (x - side->from).dot(n);
        const double half = std::sqrt(std::max(reach * reach - away * away, 0.0));
        const double from = std::max(middle - half, 0.0),
                     to = std::min(middle + half, (side->to - side->from).norm());
        if (to - from <= detail::negligible * reach) return rule;
        const GaussRule gauss = gauss_rule(points, from, to);
        for (Index k = 0; k < points; ++k) rule.push_back({side->from + gauss.x[k] * along, gauss.w[k], n});
        return rule;
    }
    const auto& [centre, radius, first, last] = std::get<Arc>(curve);
    const double away = (x - centre).norm();
    const double cosine = (radius * radius + away * away - reach * reach) / (2 * radius * away);
    if (cosine >= 1) return rule;
    const double half = std::acos(std::max(cosine, -1.0));
    const double turn = 2 * std::acos(-1.0);
    double middle = detail::angle_of(x - centre);
    middle -= turn * std::round((middle - (first + last) / 2) / turn);
    const double from = std::max(middle - half, first), to = std::min(middle + half, last);
    if (to - from <= detail::negligible * reach / radius) return rule;
    const GaussRule gauss = gauss_rule(points, from, to);
    for (Index k = 0; k < points; ++k) {
        const Point<2> outward_of_hole = detail::direction(gauss.x[k]);
        rule.push_back({centre + radius * outward_of_hole, gauss.w[k] * radius, -outward_of_hole});
    }
    return rule;
}

}  // namespace particles
