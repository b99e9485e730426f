#include "particles/region_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "base/errors.hpp"
#include "base/text.hpp"
#include "particles/boxes.hpp"
#include "particles/cells.hpp"
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

constexpr double turn = 6.283185307179586;

/// \throws InvalidInput for a curve without meaning
void check_curve(const Curve& curve, double slack) {
    if (const auto* side = std::get_if<Segment>(&curve)) {
        if (!side->from.allFinite() || !side->to.allFinite() || !((side->to - side->from).norm() > slack))
            throw InvalidInput(shown_curve(curve) + " needs two different, finite ends");
        return;
    }
    const Arc& arc = std::get<Arc>(curve);
    if (!arc.centre.allFinite() || !(arc.radius > slack && std::isfinite(arc.radius)))
        throw InvalidInput(shown_curve(curve) + " needs a positive, finite radius");
    if (!(arc.from < arc.to && arc.to - arc.from <= turn * (1 + 1e-12)))
        throw InvalidInput(shown_curve(curve) + " runs from the angle " + shown(arc.from) + " to " +
                           shown(arc.to) + ": the smaller one comes first, and a circle is at most one turn");
}

/// An end of a curve: the first or the second of ends().
struct End {
    std::size_t curve;
    std::size_t which;
};

/// The way once around a part of the boundary, by the ends at which its curves are entered.
using Loop = std::vector<End>;

/// The closed loops of a boundary. \throws InvalidInput where an end meets no other end, or several
class Loops {
  public:
    Loops(const Region& region, double slack)
        : region_(region), at_(2, 2 * static_cast<Index>(region.size())) {
        for (std::size_t k = 0; k < region.size(); ++k) {
            const auto both = ends(region[k]);
            at_.col(static_cast<Index>(2 * k)) = both[0];
            at_.col(static_cast<Index>(2 * k + 1)) = both[1];
        }
        const Cells<2> cells(at_);
        for (std::size_t end = 0; end < 2 * region.size(); ++end)
            partner_.push_back(partner(cells, end, slack));
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

    /// Where an end lies, the same for both ends that meet there.
    [[nodiscard]] Point<2> vertex(const End& end) const {
        const std::size_t number = 2 * end.curve + end.which;
        return at(std::min(number, partner_[number]));
    }

  private:
    [[nodiscard]] Point<2> at(std::size_t end) const { return at_.col(static_cast<Index>(end)); }

    [[nodiscard]] std::size_t partner(const Cells<2>& cells, std::size_t end, double slack) const {
        std::vector<std::size_t> others;
        cells.for_each_candidate(at(end), slack, [&](int other, double) {
            const auto k = static_cast<std::size_t>(other);
            if (k != end && (at(k) - at(end)).norm() <= slack) others.push_back(k);
        });
        if (others.size() == 1) return others.front();
        const std::string here = shown_curve(region_[end / 2]) + " ends at " + shown_point(at(end));
        if (others.size() > 1)
            throw InvalidInput(here + ", where " + std::to_string(others.size()) +
                               " other ends of sides lie: a boundary passes a place once");
        const auto gap = [&](std::size_t other) {
            return other == end ? INFINITY : (at(other) - at(end)).norm();
        };
        std::size_t nearest = 0;
        for (std::size_t other = 1; other < 2 * region_.size(); ++other)
            if (gap(other) < gap(nearest)) nearest = other;
        throw InvalidInput("the boundary is not closed: " + here +
                           (region_.size() > 1
                                ? ", and the nearest end of another side lies " + shown(gap(nearest), 3) +
                                      " from there, at " + shown_point(at(nearest))
                                : ""));
    }

    const Region& region_;
    Points<2> at_;
    std::vector<std::size_t> partner_;
};

/// Twice the area that a loop encloses, negative for a clockwise way: that of its chords, and of what lies
/// between its arcs and their chords.
double twice_area(const Region& region, const Loop& loop) {
    double sum = 0;
    for (const auto& [curve, which] : loop) {
        const auto both = ends(region[curve]);
        sum += cross(both[which], both[1 - which]);
        if (const auto* arc = std::get_if<Arc>(&region[curve])) {
            const double angle = arc->to - arc->from;
            sum += (which == 0 ? 1 : -1) * arc->radius * arc->radius * (angle - std::sin(angle));
        }
    }
    return sum;
}

/// Where a line, from a place in a direction of length 1, crosses a circle: none, or two places.
std::vector<Point<2>> on_circle(const Arc& arc, const Point<2>& from, const Point<2>& along) {
    const double beta = (arc.centre - from).dot(along);
    const Point<2> foot = from + beta * along;
    const double root = arc.radius * arc.radius - (foot - arc.centre).squaredNorm();
    if (root < 0) return {};
    return {foot - std::sqrt(root) * along, foot + std::sqrt(root) * along};
}

/// Places among which one lies on both curves, wherever these meet: where their lines or circles cross, where
/// they are nearest to each other, and their ends.
std::vector<Point<2>> common(const Segment& a, const Segment& b) {
    const Point<2> way = a.to - a.from, other = b.to - b.from;
    const double sine = cross(way, other);
    if (sine == 0) return {};
    return {a.from + cross(b.from - a.from, other) / sine * way};
}
std::vector<Point<2>> common(const Segment& a, const Arc& b) {
    const Point<2> n = normal_at(a, a.from);
    auto places = on_circle(b, a.from, (a.to - a.from).normalized());
    places.insert(places.end(), {b.centre + b.radius * n, b.centre - b.radius * n});
    return places;
}
std::vector<Point<2>> common(const Arc& a, const Segment& b) {
    return common(b, a);
}
std::vector<Point<2>> common(const Arc& a, const Arc& b) {
    const Point<2> way = b.centre - a.centre;
    const double apart = way.norm();
    if (apart == 0) return {};
    const Point<2> along = way / apart, across(-along[1], along[0]);
    const double chord = (apart * apart + a.radius * a.radius - b.radius * b.radius) / (2 * apart);
    auto places = on_circle(a, a.centre + chord * along, across);
    places.insert(places.end(), {a.centre + a.radius * along, a.centre - a.radius * along});
    return places;
}

/// A place where two parts of a boundary meet though none follows the other there.
struct Meeting {
    std::size_t one, other;
    Point<2> at;
    bool crosses;  ///< not at an end, nor along each other
};

/// Where two parts of a boundary meet though none follows the other there, if anywhere.
std::optional<Meeting> meeting(const Region& region, std::size_t one, std::size_t other, double slack) {
    const Curve &a = region[one], &b = region[other];
    auto places = std::visit([](const auto& x, const auto& y) { return common(x, y); }, a, b);
    for (const Curve* curve : {&a, &b})
        for (const Point<2>& end : ends(*curve)) places.push_back(end);
    const auto is_on = [&](const Curve& curve, const Point<2>& x) {
        return (closest(curve, x) - x).norm() <= slack;
    };
    const auto is_at_end = [&](const Curve& curve, const Point<2>& x) {
        const auto [first, last] = ends(curve);
        return std::min((first - x).norm(), (last - x).norm()) <= 4 * slack;
    };
    for (const Point<2>& place : places) {
        if (!is_on(a, place) || !is_on(b, place)) continue;
        const bool ends_a = is_at_end(a, place), ends_b = is_at_end(b, place);
        const bool along = std::abs(cross(normal_at(a, place), normal_at(b, place))) < 1e-3;
        if (!ends_a || !ends_b) return Meeting{one, other, place, !ends_a && !ends_b && !along};
    }
    return std::nullopt;
}

/// The places where a boundary meets itself, one for each two of its parts.
std::vector<Meeting> meetings_of(const Region& region, const Boxes& boxes, double slack) {
    std::vector<Meeting> found;
    const Point<2> wide(slack, slack);
    for (std::size_t one = 0; one < region.size(); ++one) {
        const Box around = box(region[one]);
        std::vector<std::size_t> near;
        boxes.for_each_meeting(Box(around.min() - wide, around.max() + wide), [&](std::size_t other) {
            if (other > one) near.push_back(other);
        });
        std::sort(near.begin(), near.end());
        for (const std::size_t other : near)
            if (const auto place = meeting(region, one, other, slack)) found.push_back(*place);
    }
    return found;
}

/// \throws InvalidInput for the first of some meetings
void refuse(const Meeting& meeting, const Region& region) {
    throw InvalidInput(std::string("the boundary ") + (meeting.crosses ? "crosses" : "touches") +
                       " itself: " + shown_curve(region[meeting.one]) + " and " +
                       shown_curve(region[meeting.other]) + " meet at " + shown_point(meeting.at));
}

/// Whether a ray in the first direction, x1, crosses a curve an odd number of times.
/// \param vertices the ends of the curve
bool crosses_oddly(const Point<2>& x, const Curve& curve, const std::array<Point<2>, 2>& vertices) {
    const auto& [from, to] = vertices;
    const Point<2> chord = to - from;
    const bool left = cross(chord, x - from) > 0;
    const bool crosses_chord = (from[1] > x[1]) != (to[1] > x[1]) && left == (chord[1] > 0);
    const auto* arc = std::get_if<Arc>(&curve);
    if (arc == nullptr || (x - arc->centre).norm() >= arc->radius) return crosses_chord;
    const bool is_circle = arc->to - arc->from > turn * (1 - 1e-12);
    return crosses_chord != (is_circle || !left);  // it leaves what lies between arc and chord
}

/// For each loop, whether it lies in an even number of others: it is then an outer one.
std::vector<bool> is_outer(const Region& region, const Loops& loops, const Boxes& boxes, double slack) {
    std::vector<std::size_t> loop_of(region.size());
    for (std::size_t k = 0; k < loops.all.size(); ++k)
        for (const End& end : loops.all[k]) loop_of[end.curve] = k;
    std::vector<bool> outer;
    for (std::size_t k = 0; k < loops.all.size(); ++k) {
        const Point<2> x = loops.vertex(loops.all[k].front());
        bool even = true;
        const Point<2> low(x[0], x[1] - slack), high(HUGE_VAL, x[1] + slack);
        boxes.for_each_meeting(Box(low, high), [&](std::size_t other) {
            if (loop_of[other] != k &&
                crosses_oddly(x, region[other], {loops.vertex({other, 0}), loops.vertex({other, 1})}))
                even = !even;
        });
        outer.push_back(even);
    }
    return outer;
}

/// Turns the parts of a loop so that it encloses an area to its left, or to its right.
void turn_loop(Region& region, Loop loop, bool to_left) {
    if ((twice_area(region, loop) > 0) != to_left) {
        std::reverse(loop.begin(), loop.end());
        for (End& end : loop) end.which = 1 - end.which;
    }
    for (const auto& [curve, which] : loop) {
        if (auto* arc = std::get_if<Arc>(&region[curve]))
            arc->bulges = which == 0;
        else if (auto& side = std::get<Segment>(region[curve]); which == 1)
            std::swap(side.from, side.to);
    }
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const auto* side = std::get_if<Segment>(&region[loop[k].curve]);
        auto* next = std::get_if<Segment>(&region[loop[(k + 1) % loop.size()].curve]);
        if (side != nullptr && next != nullptr) next->from = side->to;
    }
}

}  // namespace

Region checked(Region region, double size) {
    if (!(std::isfinite(size) && size > 0))
        throw InvalidInput("the size of a body must be positive and finite, got " + shown(size));
    if (region.empty()) throw InvalidInput("a body without a boundary: it needs at least one side");
    const double slack = negligible * size;
    for (const Curve& curve : region) check_curve(curve, slack);
    const Loops loops(region, slack);
    const Boxes boxes(boxes_around(region));
    const std::vector<Meeting> meetings = meetings_of(region, boxes, slack);
    const auto crossing =
        std::find_if(meetings.begin(), meetings.end(), [](const Meeting& each) { return each.crosses; });
    if (crossing != meetings.end()) refuse(*crossing, region);
    for (const Loop& loop : loops.all)
        if (!(std::abs(twice_area(region, loop)) > slack * size))
            throw InvalidInput("the boundary encloses no area");
    if (!meetings.empty()) refuse(meetings.front(), region);
    const std::vector<bool> outer = is_outer(region, loops, boxes, slack);
    for (std::size_t k = 0; k < loops.all.size(); ++k) turn_loop(region, loops.all[k], outer[k]);
    return region;
}

}  // namespace particles
