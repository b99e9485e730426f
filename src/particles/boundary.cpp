#include "particles/boundary.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace particles {

namespace {

double curvature(const Curve& curve) {
    const auto* arc = std::get_if<Arc>(&curve);
    return arc == nullptr ? 0 : (arc->bulges ? 1 : -1) / arc->radius;
}

Joint joint(const Curve& curve, const Curve& next) {
    const Point<2> before = normal_at(curve, way(curve)[1]), after = normal_at(next, way(next)[0]);
    const double bend = curvature(curve), next_bend = curvature(next);
    double turn = std::atan2(before[0] * after[1] - before[1] * after[0], before.dot(after));
    const double half_turn = std::acos(-1.0);
    if (std::abs(turn) > half_turn - negligible)  // a cusp, of the region or into it
        turn = bend + next_bend < 0 ? half_turn : -half_turn;
    return {before, after, turn,
            std::abs(turn) <= negligible && std::abs(next_bend - bend) <= negligible * std::abs(bend)};
}

}  // namespace

bool Joint::sees(const Point<2>& along) const {
    const bool one = along.dot(before) < 0, other = along.dot(after) < 0;
    return turn >= 0 ? one && other : one || other;
}

Boundary::Boundary(Region region)
    : curves_(std::move(region)), boxes_(boxes_around(curves_)), before_(curves_.size()) {
    std::vector<Box> starts;
    starts.reserve(curves_.size());
    for (const Curve& curve : curves_) starts.emplace_back(way(curve)[0]);
    const Boxes tree(starts);
    std::vector<std::size_t> next;
    next.reserve(curves_.size());
    for (std::size_t k = 0; k < curves_.size(); ++k) {
        const Point<2> end = way(curves_[k])[1];
        next.push_back(tree.nearest(end, [&](std::size_t j) { return (starts[j].min() - end).norm(); }));
        before_[next[k]] = k;
        end_.push_back(joint(curves_[k], curves_[next[k]]));
    }
    const auto none = curves_.size();
    run_.assign(curves_.size(), none);
    const auto mark = [&](std::size_t first) {
        for (std::size_t k = first; run_[k] == none; k = next[k]) {
            run_[k] = first;
            if (std::abs(end_[k].turn) > Joint::sharp) return;
        }
    };
    for (std::size_t k = 0; k < curves_.size(); ++k)
        if (std::abs(start(k).turn) > Joint::sharp) mark(k);
    for (std::size_t k = 0; k < curves_.size(); ++k) mark(k);
}

std::vector<std::size_t> Boundary::near(const Point<2>& x, double reach) const {
    std::vector<std::size_t> found;
    const Point<2> span(reach, reach);
    boxes_.for_each_meeting(Box(x - span, x + span), [&](std::size_t k) {
        if ((closest(curves_[k], x) - x).norm() <= reach) found.push_back(k);
    });
    std::sort(found.begin(), found.end());
    return found;
}

Nearest Boundary::nearest(const Point<2>& x) const {
    const auto distance = [&](std::size_t k) { return (closest(curves_[k], x) - x).norm(); };
    const std::size_t k = boxes_.nearest(x, distance);
    return {k, closest(curves_[k], x), distance(k)};
}

double signed_distance(const Boundary& boundary, const Point<2>& x) {
    if (boundary.curves().empty()) return -HUGE_VAL;  // the whole plane
    const Nearest nearest = boundary.nearest(x);
    const Curve& curve = boundary.curves()[nearest.curve];
    const Point<2> away = x - nearest.place;
    const auto is_at = [&](const Point<2>& end) {
        return (end - nearest.place).norm() <= negligible * nearest.distance;
    };
    const auto [first, last] = way(curve);
    const bool inside = is_at(first)  ? boundary.start(nearest.curve).sees(away)
                        : is_at(last) ? boundary.end(nearest.curve).sees(away)
                                      : away.dot(normal_at(curve, nearest.place)) < 0;
    return inside ? -nearest.distance : nearest.distance;
}

bool contains(const Boundary& boundary, const Point<2>& x, double size) {
    return signed_distance(boundary, x) <= negligible * size;
}

}  // namespace particles
