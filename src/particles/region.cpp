#include "particles/region.hpp"

#include <algorithm>
#include <cmath>

#include "particles/quadrature.hpp"

namespace particles {

namespace {

Point<2> direction(double angle) {
    return {std::cos(angle), std::sin(angle)};
}

/// Unit normal of a segment, to its right.
Point<2> outward(const Segment& side) {
    const Point<2> along = (side.to - side.from).normalized();
    return {along[1], -along[0]};
}

double angle_of(const Point<2>& v) {
    return std::atan2(v[1], v[0]);
}

}  // namespace

Point<2> normal_at(const Curve& curve, const Point<2>& x) {
    if (const auto* side = std::get_if<Segment>(&curve)) return outward(*side);
    return (std::get<Arc>(curve).centre - x).normalized();
}

std::array<Point<2>, 2> ends(const Curve& curve) {
    if (const auto* side = std::get_if<Segment>(&curve)) return {side->from, side->to};
    const auto& [centre, radius, from, to] = std::get<Arc>(curve);
    return {centre + radius * direction(from), centre + radius * direction(to)};
}

Point<2> closest(const Curve& curve, const Point<2>& x) {
    if (const auto* side = std::get_if<Segment>(&curve)) {
        const Point<2> way = side->to - side->from;
        return side->from + std::clamp((x - side->from).dot(way) / way.squaredNorm(), 0.0, 1.0) * way;
    }
    const auto& [centre, radius, from, to] = std::get<Arc>(curve);
    const double turn = 2 * std::acos(-1.0);
    const double angle = angle_of(x - centre);
    const double after = angle - from - turn * std::floor((angle - from) / turn);
    if (after <= to - from) return centre + radius * direction(angle);
    const auto [first, last] = ends(curve);
    return (x - first).norm() < (x - last).norm() ? first : last;
}

bool lies_on(const Curve& curve, const Point<2>& x, double size) {
    return (x - closest(curve, x)).norm() <= negligible * size;
}

bool lies_at_end(const Curve& curve, const Point<2>& x, double size) {
    const auto both = ends(curve);
    return std::any_of(both.begin(), both.end(),
                       [&](const Point<2>& end) { return (end - x).norm() <= negligible * size; });
}

bool lies_beyond(const Curve& curve, const Point<2>& x, double size) {
    if (const auto* side = std::get_if<Segment>(&curve))
        return (x - side->from).dot(outward(*side)) > negligible * size;
    const Arc& hole = std::get<Arc>(curve);
    return (x - hole.centre).norm() < hole.radius - negligible * size;
}

bool contains(const Region& region, const Point<2>& x, double size) {
    return std::none_of(region.begin(), region.end(),
                        [&](const Curve& curve) { return lies_beyond(curve, x, size); });
}

namespace {

/// The intervals of a ray, from a place in the region, that lie in the region: one, or two where the ray
/// crosses a hole.
std::vector<std::array<double, 2>> inside_along(const Region& region, const Point<2>& x,
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

std::vector<Break> breaks(const Region& region, const Point<2>& x, double reach) {
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

}  // namespace

std::vector<QuadraturePoint> polar_rule(const Region& region, const Point<2>& x, double reach, Index radial,
                                        Index angular) {
    struct Piece {
        Break from, to;
    };
    std::vector<Piece> pieces;
    double seen = 0;
    const std::vector<Break> angles = breaks(region, x, reach);
    for (std::size_t k = 0; k + 1 < angles.size(); ++k) {
        const double middle = (angles[k].angle + angles[k + 1].angle) / 2;
        if (inside_along(region, x, direction(middle), reach).empty()) continue;
        pieces.push_back({angles[k], angles[k + 1]});
        seen += angles[k + 1].angle - angles[k].angle;
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
            const Point<2> ray = direction(from.angle + width * t);
            for (const auto& [near, far] : inside_along(region, x, ray, reach))
                for (Index n = 0; n < radial; ++n) {
                    const double r = near + (far - near) * along_ray.x[n];
                    rule.push_back({x + r * ray, weight * along_ray.w[n] * (far - near) * r});
                }
        }
    }
    return rule;
}

std::vector<QuadraturePoint> boundary_rule(const Curve& curve, const Point<2>& x, double reach,
                                           Index points) {
    std::vector<QuadraturePoint> rule;
    if (const auto* side = std::get_if<Segment>(&curve)) {
        const Point<2> along = (side->to - side->from).normalized(), n = outward(*side);
        const double middle = (x - side->from).dot(along);
        const double away = (x - side->from).dot(n);
        const double half = std::sqrt(std::max(reach * reach - away * away, 0.0));
        const double from = std::max(middle - half, 0.0),
                     to = std::min(middle + half, (side->to - side->from).norm());
        if (to - from <= negligible * reach) return rule;
        const GaussRule gauss = gauss_rule(points, from, to);
        for (Index k = 0; k < points; ++k) rule.push_back({side->from + gauss.x[k] * along, gauss.w[k], n});
        return rule;
    }
    const auto& [centre, radius, first, last] = std::get<Arc>(curve);
    const double away = (x - centre).norm();
    const double cosine = (radius * radius + away * away - reach * reach) / (2 * radius * away);
    if (cosine >= 1) return rule;
    const auto add = [&, radius = radius, centre = centre](double from, double to) {
        if (to - from <= negligible * reach / radius) return;
        const GaussRule gauss = gauss_rule(points, from, to);
        for (Index k = 0; k < points; ++k) {
            const Point<2> outward_of_hole = direction(gauss.x[k]);
            rule.push_back({centre + radius * outward_of_hole, gauss.w[k] * radius, -outward_of_hole});
        }
    };
    if (!(cosine > -1)) {  // all of the circle lies in the disc
        add(first, last);
        return rule;
    }
    const double half = std::acos(cosine), turn = 2 * std::acos(-1.0);
    double middle = angle_of(x - centre);
    middle -= turn * std::round((middle - (first + last) / 2) / turn);
    for (const double angle : {middle - turn, middle, middle + turn})
        add(std::max(angle - half, first), std::min(angle + half, last));
    return rule;
}

}  // namespace particles
