#include "particles/boundary_particles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "base/errors.hpp"
#include "base/text.hpp"
#include "particles/region_check.hpp"

namespace particles {

using base::InvalidInput;
using base::shown;

namespace {

/// Why a particle may not lie where it lies.
struct Fault {
    std::string why;  ///< the end of a sentence; empty if it may lie there
    double distance;  ///< what moves it onto the boundary
};

/// Finds the particles of a cloud that may not lie where they lie.
class Astray {
  public:
    Astray(const Cloud<2>& cloud, const Boundary& boundary, double size)
        : cloud_(cloud), boundary_(boundary), size_(size) {}

    [[nodiscard]] Fault operator()(Index j) const {
        const Point<2> x = cloud_.x().col(j);
        const Nearest nearest = boundary_.nearest(x);
        const bool on = nearest.distance <= negligible * size_;
        if (!on && !contains(boundary_, x, size_))
            return {"lies outside the body, " + shown(nearest.distance, 3) + " from " +
                        shown_curve(boundary_.curves()[nearest.curve]),
                    nearest.distance};
        for (const std::size_t k : nearest_of_runs(x, beside * cloud_.apart()[j])) {
            const Curve& curve = boundary_.curves()[k];
            const Point<2> foot = closest(curve, x);
            const double distance = (foot - x).norm();
            if (distance <= negligible * size_ || (on && is_along(k, x))) continue;
            const bool bare = is_bare(k, foot, j);
            if (!bare && distance >= boundary_margin * cloud_.apart()[j]) continue;
            const auto [first, last] = ends(curve);
            const double to_corner = std::min((first - x).norm(), (last - x).norm());
            return {"lies only " + shown(distance, 3) + " from " + shown_curve(curve) +
                        (bare ? ", which has no particle of its own there"
                              : ", less than a thousandth of its distance to the next particle"),
                    on ? to_corner : distance};
        }
        return {};
    }

  private:
    /// Share of the distance to the nearest particle within which a particle lies beside the boundary. If the
    /// boundary has no particle of its own there, that particle is meant to be on it.
    static constexpr double beside = 0.25;

    /// Of each run of parts that comes within a distance of a place, the nearest part.
    [[nodiscard]] std::vector<std::size_t> nearest_of_runs(const Point<2>& x, double reach) const {
        const auto away = [&](std::size_t k) { return (closest(boundary_.curves()[k], x) - x).norm(); };
        std::vector<std::size_t> found;
        for (const std::size_t k : boundary_.near(x, reach)) {
            const auto same = std::find_if(found.begin(), found.end(), [&](std::size_t other) {
                return boundary_.run(other) == boundary_.run(k);
            });
            if (same == found.end())
                found.push_back(k);
            else if (away(k) < away(*same))
                *same = k;
        }
        return found;
    }

    /// Whether a place lies on the run of parts to which part k belongs.
    [[nodiscard]] bool is_along(std::size_t k, const Point<2>& x) const {
        const std::vector<std::size_t> here = boundary_.near(x, negligible * size_);
        return std::any_of(here.begin(), here.end(),
                           [&](std::size_t other) { return boundary_.run(other) == boundary_.run(k); });
    }

    /// Whether a place on part k of the boundary is farther from all particles on its run than particles are
    /// from each other: the median distance, to the next one, of particle j and its eight nearest.
    [[nodiscard]] bool is_bare(std::size_t k, const Point<2>& foot, Index j) const {
        const Point<2> x = cloud_.x().col(j);
        double reach = cloud_.apart()[j];
        std::vector<int> near;
        const auto wanted = static_cast<std::size_t>(std::min<Index>(9, cloud_.size()));
        while ((near = cloud_.within(x, reach *= 1.5)).size() < wanted) {
        }
        std::vector<double> apart;
        apart.reserve(near.size());
        for (const int other : near) apart.push_back(cloud_.apart()[other]);
        const auto middle = apart.begin() + static_cast<std::ptrdiff_t>(apart.size() / 2);
        std::nth_element(apart.begin(), middle, apart.end());
        const std::vector<int> around = cloud_.within(foot, 0.8 * *middle);
        return std::none_of(around.begin(), around.end(),
                            [&](int other) { return is_along(k, cloud_.x().col(other)); });
    }

    const Cloud<2>& cloud_;
    const Boundary& boundary_;
    double size_;
};

/// "2.5 x 2.5", the box around a set of positions.
std::string shown_span(const Points<2>& x) {
    const Point<2> span = x.rowwise().maxCoeff() - x.rowwise().minCoeff();
    return shown(span[0]) + " x " + shown(span[1]);
}

/// "; the particles span 2.5 x 2.5, the body 3 x 3", if these differ.
std::string other_span(const Cloud<2>& cloud, const Boundary& boundary) {
    Box around;
    for (const Curve& curve : boundary.curves()) around.extend(box(curve));
    const std::string particles = shown_span(cloud.x()),
                      body = shown_span(
                          Points<2>{{around.min()[0], around.max()[0]}, {around.min()[1], around.max()[1]}});
    return particles == body ? "" : "; the particles span " + particles + ", the body " + body;
}

/// \throws InvalidInput naming a run of parts of the boundary, by its first one, without a particle on it
void require_particles_on(const Boundary& boundary, const Cloud<2>& cloud, double size) {
    const Region& curves = boundary.curves();
    std::vector<bool> met(curves.size(), false);
    for (const auto& x : cloud.x().colwise())
        for (const std::size_t k : boundary.near(x, negligible * size)) met[boundary.run(k)] = true;
    for (std::size_t k = 0; k < curves.size(); ++k) {
        if (met[boundary.run(k)]) continue;
        const auto away = [&](Index j) {
            return (cloud.x().col(j) - closest(curves[k], cloud.x().col(j))).norm();
        };
        Index nearest = 0;
        for (Index j = 1; j < cloud.size(); ++j)
            if (away(j) < away(nearest)) nearest = j;
        throw InvalidInput(shown_curve(curves[k]) + " has no particle on it; the nearest is particle " +
                           std::to_string(nearest) + " at " + shown_point(cloud.x().col(nearest)) + ", " +
                           shown(away(nearest), 3) + " away" + other_span(cloud, boundary));
    }
}

/// Whether check_particles() would take these particles.
bool fits(const Points<2>& x, const Boundary& boundary, double size) {
    try {
        const Cloud<2> cloud(x);
        const Astray astray(cloud, boundary, size);
        for (Index j = 0; j < cloud.size(); ++j)
            if (!astray(j).why.empty()) return false;
        require_particles_on(boundary, cloud, size);
        return true;
    } catch (const InvalidInput&) {
        return false;
    }
}

/// "; try --snap 6.1e-08": the least distance that moves all particles that are astray onto the boundary.
/// Empty if that leaves a particle astray, or moves one by more than half its distance to the next.
std::string snap_remedy(const Cloud<2>& cloud, const Boundary& boundary, double size) {
    const Astray astray(cloud, boundary, size);
    double farthest = 0;
    for (Index j = 0; j < cloud.size(); ++j) {
        const auto [why, distance] = astray(j);
        if (distance > cloud.apart()[j] / 2) return "";
        farthest = std::max(farthest, distance);
    }
    for (const double more : {1.1, 1.6, 2.2}) {  // a corner is farther away than a side
        const std::string rounded = shown(more * farthest, 2);
        const Points<2> moved = snapped(cloud.x(), boundary, std::stod(rounded)).x;
        const Column<double> way = (moved - cloud.x()).colwise().norm().transpose();
        if ((way <= cloud.apart() / 2).all() && fits(moved, boundary, size)) return "; try --snap " + rounded;
    }
    return "";
}

}  // namespace

void check_particles(const Cloud<2>& cloud, const Boundary& boundary, double size) {
    const Astray astray(cloud, boundary, size);
    for (Index j = 0; j < cloud.size(); ++j)
        if (const std::string why = astray(j).why; !why.empty())
            throw InvalidInput("particle " + std::to_string(j) + " at " + shown_point(cloud.x().col(j)) +
                               " " + why + snap_remedy(cloud, boundary, size) + other_span(cloud, boundary));
    require_particles_on(boundary, cloud, size);
}

Snapped snapped(Points<2> x, const Boundary& boundary, double distance) {
    if (!(std::isfinite(distance) && distance > 0))
        throw InvalidInput("the distance to snap must be positive and finite, got " + shown(distance));
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    Snapped result{std::move(x)};
    for (auto place : result.x.colwise()) {
        const Nearest nearest = boundary.nearest(place);
        if (nearest.distance > distance) continue;
        Point<2> there = nearest.place;
        double to_end = distance;
        for (const std::size_t k : boundary.near(place, distance))
            for (const Point<2>& end : ends(boundary.curves()[k]))
                if (const double away = (end - place).norm(); away <= to_end) {
                    there = end;
                    to_end = away;
                }
        const double way = (there - place).norm(), round_off = 4 * epsilon * there.norm();
        place = there;
        if (way <= round_off) continue;
        ++result.moved;
        result.farthest = std::max(result.farthest, way);
    }
    return result;
}

}  // namespace particles
