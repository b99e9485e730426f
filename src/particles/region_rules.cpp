#include "particles/region_rules.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <variant>

#include "particles/quadrature.hpp"

namespace particles {

namespace {

/// An angle at which the parts of a ray in the region are not smooth functions of the angle. At a tangent to
/// an arc they behave like a square root.
struct Break {
    double angle;
    bool tangent;
};

/// A place where a ray crosses the boundary.
struct Crossing {
    double distance;
    bool leaves;  ///< the region
};

/// From and to which distance a ray lies in the region.
using Stretch = std::array<double, 2>;

/// What the rays from a place in a region meet.
class View {
  public:
    View(const Boundary& boundary, const Point<2>& x, double reach)
        : boundary_(boundary), x_(x), reach_(reach) {
        if (signed_distance(boundary, x) > round_off * reach) x_ = boundary.nearest(x).place;
        const auto is_x = [&](const Point<2>& place) { return (place - x_).norm() <= negligible * reach; };
        for (const std::size_t k : boundary.near(x_, reach * (1 + negligible))) {
            const Curve& curve = boundary.curves()[k];
            near_.push_back({k, curve, is_x(closest(curve, x_))});
            const auto [first, last] = way(curve);
            if (is_x(first)) turn_ = boundary.start(k).turn;
            if (is_x(last)) turn_ = boundary.end(k).turn;
        }
        for (Part& part : near_) {
            part.is_line = part.at_x && turn_ > 0;
            part.at_x = part.at_x && (turn_ < 0 || !is_crossed_near_x(part.curve));
            if (part.at_x) outward_.push_back(normal_at(part.curve, x_));
        }
    }

    /// Where the rays start: the place, or the nearest one on the boundary if it lies outside.
    [[nodiscard]] const Point<2>& x() const { return x_; }

    /// The parts of a ray that lie in the region.
    [[nodiscard]] std::vector<Stretch> inside_along(const Point<2>& along) const {
        std::vector<Crossing> crossings;
        for (const Part& part : near_)
            std::visit([&](const auto& curve) { cross(curve, part, along, crossings); }, part.curve);
        std::sort(crossings.begin(), crossings.end(),
                  [](const Crossing& a, const Crossing& b) { return a.distance < b.distance; });
        crossings.push_back({reach_, true});
        std::vector<Stretch> stretches;
        bool inside = starts_inside(along);
        double from = 0;
        for (const auto& [distance, leaves] : crossings) {
            if (inside && leaves && from < distance) stretches.push_back({from, distance});
            if (!inside && !leaves) from = distance;
            inside = !leaves;
        }
        return stretches;
    }

    /// The breaks in increasing order, the first one again after a turn.
    [[nodiscard]] std::vector<Break> breaks() const {
        std::vector<Break> found;
        for (const Part& part : near_) {
            const auto [first, last] = way(part.curve);
            if (!boundary_.start(part.number).smooth) break_at_end(first, found);
            if (!boundary_.end(part.number).smooth) break_at_end(last, found);
            std::visit([&](const auto& curve) { break_at(curve, part, found); }, part.curve);
        }
        const double turn = 2 * std::acos(-1.0);
        for (Break& each : found) each.angle -= turn * std::floor(each.angle / turn + negligible);
        std::sort(found.begin(), found.end(),
                  [](const Break& a, const Break& b) { return a.angle < b.angle; });
        const auto same = [](const Break& a, const Break& b) { return b.angle - a.angle < negligible; };
        found.erase(std::unique(found.begin(), found.end(), same), found.end());
        if (found.empty()) found.push_back({0, false});
        found.push_back({found.front().angle + turn, found.front().tangent});
        return found;
    }

  private:
    /// A part of the boundary within reach.
    struct Part {
        std::size_t number;
        const Curve& curve;
        bool at_x;  ///< whether the rays start on it
        bool is_line =
            false;  ///< whether rays from beside a corner cross a side's line beyond the corner, too
    };

    /// Whether a place lies inside of a side by round-off, so that rays out of the region cross the side.
    [[nodiscard]] bool is_crossed_near_x(const Curve& curve) const {
        const auto* side = std::get_if<Segment>(&curve);
        return side != nullptr && side->from != x_ && side->to != x_ &&
               (side->from - x_).dot(normal_at(curve, x_)) > 0;
    }

    [[nodiscard]] bool starts_inside(const Point<2>& along) const {
        const auto is_into = [&](const Point<2>& n) { return along.dot(n) < 0; };
        return turn_ >= 0 ? std::all_of(outward_.begin(), outward_.end(), is_into)
                          : std::any_of(outward_.begin(), outward_.end(), is_into);
    }

    void cross(const Segment& side, const Part& part, const Point<2>& along,
               std::vector<Crossing>& found) const {
        const Point<2> n = normal_at(side, x_), across(-along[1], along[0]);
        const double approach = along.dot(n), from = across.dot(side.from - x_),
                     to = across.dot(side.to - x_);
        const bool beside =
            std::min(from, to) > round_off * reach_ || std::max(from, to) < -round_off * reach_;
        if (part.at_x || (beside && !part.is_line) || std::abs(approach) <= negligible) return;
        const double distance = (side.from - x_).dot(n) / approach;
        if (distance > 0 && distance < reach_) found.push_back({distance, approach > 0});
    }

    void cross(const Arc& arc, const Part& part, const Point<2>& along, std::vector<Crossing>& found) const {
        const Point<2> offset = x_ - arc.centre;
        const double beta = offset.dot(along);
        const double gamma = part.at_x ? 0 : offset.squaredNorm() - arc.radius * arc.radius;
        const double root = beta * beta - gamma;
        if (root <= 0) return;
        for (const bool into_circle : {true, false}) {
            if (part.at_x && into_circle == (beta < 0)) continue;  // the place itself
            const double distance = -beta + (into_circle ? -std::sqrt(root) : std::sqrt(root));
            if (distance > 0 && distance < reach_ && holds(arc, angle_of(offset + distance * along)))
                found.push_back({distance, into_circle != arc.bulges});
        }
    }

    void break_at_end(const Point<2>& end, std::vector<Break>& found) const {
        const double distance = (end - x_).norm();
        if (distance > negligible * reach_ && distance < reach_ * (1 - negligible))
            found.push_back({angle_of(end - x_), false});
    }

    /// Beyond a sharp corner the line of a side still cuts the angles, and so does the circle of an arc: in
    /// narrower pieces the rays that end near the corner cost little.
    static bool is_continued(const Joint& joint) { return joint.turn > Joint::sharp; }

    /// Where the side leaves the disc.
    void break_at(const Segment& side, const Part& part, std::vector<Break>& found) const {
        const Point<2> n = normal_at(side, x_), along(-n[1], n[0]);
        const double offset = (side.from - x_).dot(n);
        const double distance = part.at_x || std::abs(offset) < negligible * reach_ ? 0 : offset;
        if (!(std::abs(distance) < reach_ * (1 - negligible))) return;
        const double half = std::acos(distance / reach_),
                     half_chord = std::sqrt(reach_ * reach_ - distance * distance);
        const double foot = (x_ - side.from).dot(along), length = (side.to - side.from).norm();
        const auto holds = [&](double place) {
            return (place >= -negligible * reach_ || is_continued(boundary_.start(part.number))) &&
                   (place <= length + negligible * reach_ || is_continued(boundary_.end(part.number)));
        };
        if (holds(foot - half_chord)) found.push_back({angle_of(n) - half, false});
        if (holds(foot + half_chord)) found.push_back({angle_of(n) + half, false});
    }

    /// Where the arc leaves the disc, and where rays touch it.
    void break_at(const Arc& arc, const Part& part, std::vector<Break>& found) const {
        const bool whole =
            is_continued(boundary_.start(part.number)) || is_continued(boundary_.end(part.number));
        const Point<2> inward = arc.centre - x_;
        const double away = inward.norm(), b = arc.radius;
        const auto add_both = [&](double half, double distance, bool tangent) {
            for (const double angle : {angle_of(inward) - half, angle_of(inward) + half})
                if (whole || part.at_x || holds(arc, angle_of(distance * direction(angle) - inward)))
                    found.push_back({angle, tangent});
        };
        if (away <= negligible * reach_ || away - b >= reach_ * (1 - negligible)) return;
        const double cosine = (reach_ * reach_ + away * away - b * b) / (2 * reach_ * away);
        if (cosine > -1) add_both(std::acos(std::min(cosine, 1.0)), reach_, false);
        const double tangent_squared = away * away - b * b;
        if (part.at_x)
            add_both(std::acos(0.0), 0, false);
        else if (tangent_squared > 0 && tangent_squared < reach_ * reach_)
            add_both(std::asin(b / away), std::sqrt(tangent_squared), true);
    }

    static constexpr double round_off = 1e-12;  ///< parts that follow each other leave no gap

    const Boundary& boundary_;
    Point<2> x_;
    double reach_;
    std::vector<Part> near_;
    double turn_ = 0;                ///< of the boundary at the place where the rays start
    std::vector<Point<2>> outward_;  ///< normals of the parts on which it lies
};

}  // namespace

std::vector<QuadraturePoint> polar_rule(const Boundary& boundary, const Point<2>& x, double reach,
                                        Index radial, Index angular) {
    struct Piece {
        Break from, to;
    };
    const View view(boundary, x, reach);
    std::vector<Piece> pieces;
    double seen = 0;
    const std::vector<Break> angles = view.breaks();
    for (std::size_t k = 0; k + 1 < angles.size(); ++k) {
        const double middle = (angles[k].angle + angles[k + 1].angle) / 2;
        if (view.inside_along(direction(middle)).empty()) continue;
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
            for (const auto& [near, far] : view.inside_along(ray))
                for (Index n = 0; n < radial; ++n) {
                    const double r = near + (far - near) * along_ray.x[n];
                    rule.push_back({view.x() + r * ray, weight * along_ray.w[n] * (far - near) * r});
                }
        }
    }
    return rule;
}

std::vector<QuadraturePoint> boundary_rule(const Curve& curve, const Point<2>& x, double reach,
                                           Index points) {
    std::vector<QuadraturePoint> rule;
    if (const auto* side = std::get_if<Segment>(&curve)) {
        const Point<2> along = (side->to - side->from).normalized(), n = normal_at(*side, x);
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
    const auto& [centre, radius, first, last, bulges] = std::get<Arc>(curve);
    const double away = (x - centre).norm();
    const double cosine = (radius * radius + away * away - reach * reach) / (2 * radius * away);
    if (cosine >= 1) return rule;
    const auto add = [&, radius = radius, centre = centre, bulges = bulges](double from, double to) {
        if (to - from <= negligible * reach / radius) return;
        const GaussRule gauss = gauss_rule(points, from, to);
        for (Index k = 0; k < points; ++k) {
            const Point<2> from_centre = direction(gauss.x[k]),
                           n = bulges ? from_centre : Point<2>(-from_centre);
            rule.push_back({centre + radius * from_centre, gauss.w[k] * radius, n});
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
