#include "particles/region_check.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/errors.hpp"
#include "base/text.hpp"
#include "particles/points.hpp"

namespace particles {

using base::InvalidInput;
using base::shown;

std::string shown_curve(const Curve& curve) {
    if (const auto* side = std::get_if<Segment>(&curve))
        return "the side from " + shown_point(side->from) + " to " + shown_point(side->to);
    const Arc& arc = std::get<Arc>(curve);
    return "the arc of radius " + shown(arc.radius) + " around " + shown_point(arc.centre);
}

namespace {

double cross(const Point<2>& a, const Point<2>& b) {
    return a[0] * b[1] - a[1] * b[0];
}

/// \throws InvalidInput for a curve without meaning
void check_curve(const Curve& curve, double slack) {
    if (const auto* side = std::get_if<Segment>(&curve)) {
        if (!side->from.allFinite() || !side->to.allFinite() || !((side->to - side->from).norm() > slack))
            throw InvalidInput(shown_curve(curve) + " needs two different, finite ends");
        return;
    }
    const auto& [centre, radius, from, to] = std::get<Arc>(curve);
    const double turn = 2 * std::acos(-1.0);
    if (!centre.allFinite() || !(radius > slack && std::isfinite(radius)))
        throw InvalidInput(shown_curve(curve) + " needs a positive, finite radius");
    if (!(from < to && to - from <= turn * (1 + 1e-12)))
        throw InvalidInput(shown_curve(curve) + " runs from the angle " + shown(from) + " to " + shown(to) +
                           ": the smaller one comes first, and a circle is at most one turn");
}

/// An end of a curve: the first or the second of ends().
struct End {
    std::size_t curve;
    std::size_t which;
};

/// The way once around a part of the boundary, by the ends at which its curves are entered.
using Loop = std::vector<End>;

/// The closed parts of a boundary. \throws InvalidInput where an end meets no other end, or several
class Loops {
  public:
    Loops(const Region& region, double slack) {
        for (const Curve& curve : region) {
            const auto both = ends(curve);
            at_.insert(at_.end(), both.begin(), both.end());
        }
        for (std::size_t end = 0; end < at_.size(); ++end) partner_.push_back(partner(region, end, slack));
        std::vector<bool> seen(region.size(), false);
        for (std::size_t first = 0; first < region.size(); ++first) {
            if (seen[first]) continue;
            Loop loop;
            std::size_t enter = 2 * first;
            do {
                seen[enter / 2] = true;
                loop.push_back({enter / 2, enter % 2});
                enter = partner_[enter ^ 1U];
            } while (enter != 2 * first);
            all.push_back(loop);
        }
    }

    std::vector<Loop> all;

  private:
    [[nodiscard]] std::size_t partner(const Region& region, std::size_t end, double slack) const {
        std::vector<std::size_t> others;
        for (std::size_t other = 0; other < at_.size(); ++other)
            if (other != end && (at_[other] - at_[end]).norm() <= slack) others.push_back(other);
        if (others.size() == 1) return others.front();
        const std::string here = shown_curve(region[end / 2]) + " ends at " + shown_point(at_[end]);
        if (others.size() > 1)
            throw InvalidInput(here + ", where " + std::to_string(others.size()) +
                               " other ends of sides lie: a boundary passes a place once");
        const auto gap = [&](std::size_t other) {
            return other == end ? INFINITY : (at_[other] - at_[end]).norm();
        };
        std::size_t nearest = 0;
        for (std::size_t other = 1; other < at_.size(); ++other)
            if (gap(other) < gap(nearest)) nearest = other;
        throw InvalidInput("the boundary is not closed: " + here +
                           (at_.size() > 2
                                ? ", and the nearest end of another side lies " + shown(gap(nearest), 3) +
                                      " from there, at " + shown_point(at_[nearest])
                                : ""));
    }

    std::vector<Point<2>> at_;
    std::vector<std::size_t> partner_;
};

/// Whether the inner parts of two sides meet.
bool cross_each_other(const Segment& a, const Segment& b, double slack) {
    const auto apart = [&](const Segment& line, const Point<2>& x) {
        return cross((line.to - line.from).normalized(), x - line.from);
    };
    const double from = apart(a, b.from), to = apart(a, b.to), first = apart(b, a.from),
                 last = apart(b, a.to);
    return std::min(std::abs(from), std::abs(to)) > slack &&
           std::min(std::abs(first), std::abs(last)) > slack && from * to < 0 && first * last < 0;
}

/// Twice the area that the chords of a loop enclose, negative for a clockwise way.
double twice_area(const Region& region, const Loop& loop) {
    double sum = 0;
    for (const auto& [curve, which] : loop) {
        const auto both = ends(region[curve]);
        sum += cross(both[which], both[1 - which]);
    }
    return sum;
}

/// Turns the sides of the outer loop so that the region lies to their left.
void turn(Region& region, Loop& loop) {
    if (twice_area(region, loop) < 0) {
        std::reverse(loop.begin(), loop.end());
        for (End& end : loop) end.which = 1 - end.which;
    }
    for (End& end : loop)
        if (auto* side = std::get_if<Segment>(&region[end.curve]); side != nullptr && end.which == 1) {
            std::swap(side->from, side->to);
            end.which = 0;
        }
}

/// Places of a curve of which one lies beyond another curve if any place of it does.
std::vector<Point<2>> extremes(const Curve& curve, const Region& region) {
    const auto both = ends(curve);
    std::vector<Point<2>> places(both.begin(), both.end());
    const auto* arc = std::get_if<Arc>(&curve);
    for (const Curve& other : region) {
        if (&other == &curve) continue;
        if (const auto* side = std::get_if<Segment>(&other)) {
            if (arc != nullptr) {
                const Point<2> out = normal_at(*side, side->from);
                places.push_back(closest(curve, arc->centre + 2 * arc->radius * out));
            }
        } else {
            places.push_back(closest(curve, std::get<Arc>(other).centre));
        }
    }
    return places;
}

/// \throws InvalidInput where two sides cross
void check_crossings(const Region& region, double slack) {
    for (std::size_t j = 0; j < region.size(); ++j)
        for (std::size_t k = j + 1; k < region.size(); ++k) {
            const auto *a = std::get_if<Segment>(&region[j]), *b = std::get_if<Segment>(&region[k]);
            if (a != nullptr && b != nullptr && cross_each_other(*a, *b, slack))
                throw InvalidInput("the boundary crosses itself: " + shown_curve(*a) + " and " +
                                   shown_curve(*b));
        }
}

/// \throws InvalidInput where the way around the body is not that around a convex polygon, cut by holes
void check_joints(const Region& region, const Loop& loop, double size) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const Curve &curve = region[loop[k].curve], &next = region[loop[(k + 1) % loop.size()].curve];
        const auto *side = std::get_if<Segment>(&curve), *next_side = std::get_if<Segment>(&next);
        // With the body to the left, the edge of a hole is passed clockwise.
        if (side == nullptr && loop[k].which == 0)
            throw InvalidInput("bodies with edges that bulge outward do not work yet: " + shown_curve(curve));
        if (side != nullptr && next_side != nullptr && lies_beyond(curve, next_side->to, size))
            throw InvalidInput("bodies that are not convex do not work yet: the boundary turns inward at " +
                               shown_point(side->to));
    }
}

}  // namespace

Region checked(Region region, double size) {
    if (!(std::isfinite(size) && size > 0))
        throw InvalidInput("the size of a body must be positive and finite, got " + shown(size));
    const double slack = negligible * size;
    for (const Curve& curve : region) check_curve(curve, slack);
    std::vector<Loop> loops = Loops(region, slack).all;
    const auto has_side = [&](const Loop& loop) {
        return std::any_of(loop.begin(), loop.end(), [&](const End& end) {
            return std::holds_alternative<Segment>(region[end.curve]);
        });
    };
    const auto outer = std::find_if(loops.begin(), loops.end(), has_side);
    if (outer == loops.end()) throw InvalidInput("a body without straight sides around it does not work yet");
    if (std::find_if(std::next(outer), loops.end(), has_side) != loops.end())
        throw InvalidInput("bodies in pieces, or with holes that have straight sides, do not work yet");
    check_crossings(region, slack);
    if (!(std::abs(twice_area(region, *outer)) > slack * size))
        throw InvalidInput("the boundary encloses no area");
    turn(region, *outer);
    check_joints(region, *outer, size);
    for (const Curve& curve : region)
        for (const Point<2>& place : extremes(curve, region))
            for (const Curve& other : region)
                if (lies_beyond(other, place, size))
                    throw InvalidInput(
                        "the boundary crosses itself, or the body is not a convex polygon with circular holes, the only kind that works yet: near " +
                        shown_point(place) + ", " + shown_curve(curve) + " lies beyond " +
                        shown_curve(other));
    return region;
}

}  // namespace particles
