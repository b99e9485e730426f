#include "particles/region.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace particles {

Point<2> direction(double angle) {
    return {std::cos(angle), std::sin(angle)};
}

double angle_of(const Point<2>& v) {
    return std::atan2(v[1], v[0]);
}

Point<2> normal_at(const Curve& curve, const Point<2>& x) {
    if (const auto* side = std::get_if<Segment>(&curve)) {
        const Point<2> along = (side->to - side->from).normalized();
        return {along[1], -along[0]};
    }
    const Arc& arc = std::get<Arc>(curve);
    return (arc.bulges ? Point<2>(x - arc.centre) : Point<2>(arc.centre - x)).normalized();
}

std::array<Point<2>, 2> ends(const Curve& curve) {
    if (const auto* side = std::get_if<Segment>(&curve)) return {side->from, side->to};
    const Arc& arc = std::get<Arc>(curve);
    return {arc.centre + arc.radius * direction(arc.from), arc.centre + arc.radius * direction(arc.to)};
}

std::array<Point<2>, 2> way(const Curve& curve) {
    auto both = ends(curve);
    if (const auto* arc = std::get_if<Arc>(&curve); arc != nullptr && !arc->bulges)
        std::swap(both[0], both[1]);
    return both;
}

bool holds(const Arc& arc, double angle) {
    constexpr double slack = 1e-12;  // arcs that follow each other leave no gap
    const double turn = 2 * std::acos(-1.0), from = arc.from - slack;
    return angle - from - turn * std::floor((angle - from) / turn) <= arc.to + slack - from;
}

Point<2> closest(const Curve& curve, const Point<2>& x) {
    if (const auto* side = std::get_if<Segment>(&curve)) {
        const Point<2> way = side->to - side->from;
        return side->from + std::clamp((x - side->from).dot(way) / way.squaredNorm(), 0.0, 1.0) * way;
    }
    const Arc& arc = std::get<Arc>(curve);
    const double angle = angle_of(x - arc.centre);
    if (holds(arc, angle)) return arc.centre + arc.radius * direction(angle);
    const auto [first, last] = ends(curve);
    return (x - first).norm() < (x - last).norm() ? first : last;
}

Box box(const Curve& curve) {
    const auto [first, last] = ends(curve);
    Box around(first);
    around.extend(last);
    if (const auto* arc = std::get_if<Arc>(&curve))
        for (const Point<2>& axis : {Point<2>(1, 0), Point<2>(0, 1), Point<2>(-1, 0), Point<2>(0, -1)})
            if (holds(*arc, angle_of(axis))) around.extend(arc->centre + arc->radius * axis);
    return around;
}

bool lies_on(const Curve& curve, const Point<2>& x, double size) {
    return (x - closest(curve, x)).norm() <= negligible * size;
}

bool lies_at_end(const Curve& curve, const Point<2>& x, double size) {
    const auto both = ends(curve);
    return std::any_of(both.begin(), both.end(),
                       [&](const Point<2>& end) { return (end - x).norm() <= negligible * size; });
}

}  // namespace particles
