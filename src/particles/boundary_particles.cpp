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

/// The part of a boundary nearest to a place.
struct Nearest {
    const Curve* curve;
    double distance;
};

Nearest nearest_part(const Region& region, const Point<2>& x) {
    Nearest nearest{&region.front(), (x - closest(region.front(), x)).norm()};
    for (const Curve& curve : region)
        if (const double distance = (x - closest(curve, x)).norm(); distance < nearest.distance)
            nearest = {&curve, distance};
    return nearest;
}

/// Why a particle may not lie where it lies.
struct Fault {
    std::string why;  ///< the end of a sentence; empty if it may lie there
    double distance;  ///< what moves it onto the boundary
};

/// Finds the particles of a cloud that may not lie where they lie.
class Astray {
  public:
    Astray(const Cloud<2>& cloud, const Region& region, double size)
        : cloud_(cloud), region_(region), size_(size) {}

    [[nodiscard]] Fault operator()(Index j) const {
        const Point<2> x = cloud_.x().col(j);
        const bool on = nearest_part(region_, x).distance <= negligible * size_;
        if (!on && !contains(region_, x, size_)) {
            const auto [curve, distance] = nearest_part(region_, x);
            return {"lies outside the body, " + shown(distance, 3) + " from " + shown_curve(*curve),
                    distance};
        }
        for (const Curve& curve : region_) {
            const Point<2> foot = closest(curve, x);
            const double distance = (foot - x).norm();
            if (distance <= negligible * size_) continue;
            const bool bare = distance < beside * cloud_.apart()[j] && is_bare(curve, foot, j);
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

    /// Whether a place on a part of the boundary is farther from all particles on it than particles are from
    /// each other: the median distance, to the next one, of particle j and its eight nearest.
    [[nodiscard]] bool is_bare(const Curve& curve, const Point<2>& foot, Index j) const {
        const Point<2> x = cloud_.x().col(j);
        double reach = cloud_.apart()[j];
        std::vector<int> near;
        const auto wanted = static_cast<std::size_t>(std::min<Index>(9, cloud_.size()));
        while ((near = cloud_.within(x, reach *= 1.5)).size() < wanted) {
        }
        std::vector<double> apart;
        apart.reserve(near.size());
        for (const int k : near) apart.push_back(cloud_.apart()[k]);
        const auto middle = apart.begin() + static_cast<std::ptrdiff_t>(apart.size() / 2);
        std::nth_element(apart.begin(), middle, apart.end());
        const std::vector<int> around = cloud_.within(foot, 0.8 * *middle);
        return std::none_of(around.begin(), around.end(),
                            [&](int k) { return lies_on(curve, cloud_.x().col(k), size_); });
    }

    const Cloud<2>& cloud_;
    const Region& region_;
    double size_;
};

/// "2.5 x 2.5", the box around a set of positions.
std::string shown_span(const Points<2>& x) {
    const Point<2> span = x.rowwise().maxCoeff() - x.rowwise().minCoeff();
    return shown(span[0]) + " x " + shown(span[1]);
}

/// "; the particles span 2.5 x 2.5, the body 3 x 3", if these differ.
std::string other_span(const Cloud<2>& cloud, const Region& region) {
    Points<2> corners(2, 2 * static_cast<Index>(region.size()));
    Index k = 0;
    for (const Curve& curve : region)
        for (const Point<2>& end : ends(curve)) corners.col(k++) = end;
    const std::string particles = shown_span(cloud.x()), body = shown_span(corners);
    return particles == body ? "" : "; the particles span " + particles + ", the body " + body;
}

/// \throws InvalidInput naming a part of the boundary without a particle on it
void require_particles_on(const Curve& curve, const Cloud<2>& cloud, const Region& region, double size) {
    Index nearest = 0;
    double least = INFINITY;
    for (Index j = 0; j < cloud.size(); ++j)
        if (const double distance = (cloud.x().col(j) - closest(curve, cloud.x().col(j))).norm();
            distance < least) {
            nearest = j;
            least = distance;
        }
    if (least <= negligible * size) return;
    throw InvalidInput(shown_curve(curve) + " has no particle on it; the nearest is particle " +
                       std::to_string(nearest) + " at " + shown_point(cloud.x().col(nearest)) + ", " +
                       shown(least, 3) + " away" + other_span(cloud, region));
}

/// Whether check_particles() would take these particles.
bool fits(const Points<2>& x, const Region& region, double size) {
    try {
        const Cloud<2> cloud(x);
        const Astray astray(cloud, region, size);
        for (Index j = 0; j < cloud.size(); ++j)
            if (!astray(j).why.empty()) return false;
        for (const Curve& curve : region) require_particles_on(curve, cloud, region, size);
        return true;
    } catch (const InvalidInput&) {
        return false;
    }
}

/// "; try --snap 6.1e-08": the least distance that moves all particles that are astray onto the boundary.
/// Empty if that leaves a particle astray, or moves one by more than half its distance to the next.
std::string snap_remedy(const Cloud<2>& cloud, const Region& region, double size) {
    const Astray astray(cloud, region, size);
    double farthest = 0;
    for (Index j = 0; j < cloud.size(); ++j) {
        const auto [why, distance] = astray(j);
        if (distance > cloud.apart()[j] / 2) return "";
        farthest = std::max(farthest, distance);
    }
    for (const double more : {1.1, 1.6, 2.2}) {  // a corner is farther away than a side
        const std::string rounded = shown(more * farthest, 2);
        const Points<2> moved = snapped(cloud.x(), region, std::stod(rounded)).x;
        const Column<double> way = (moved - cloud.x()).colwise().norm().transpose();
        if ((way <= cloud.apart() / 2).all() && fits(moved, region, size)) return "; try --snap " + rounded;
    }
    return "";
}

}  // namespace

void check_particles(const Cloud<2>& cloud, const Region& region, double size) {
    const Astray astray(cloud, region, size);
    for (Index j = 0; j < cloud.size(); ++j)
        if (const std::string why = astray(j).why; !why.empty())
            throw InvalidInput("particle " + std::to_string(j) + " at " + shown_point(cloud.x().col(j)) +
                               " " + why + snap_remedy(cloud, region, size) + other_span(cloud, region));
    for (const Curve& curve : region) require_particles_on(curve, cloud, region, size);
}

Snapped snapped(Points<2> x, const Region& region, double distance) {
    if (!(std::isfinite(distance) && distance > 0))
        throw InvalidInput("the distance to snap must be positive and finite, got " + shown(distance));
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    Snapped result{std::move(x)};
    for (auto place : result.x.colwise()) {
        const auto [curve, away] = nearest_part(region, place);
        if (away > distance) continue;
        Point<2> there = closest(*curve, place);
        for (const Curve& any : region)
            for (const Point<2>& end : ends(any))
                if ((end - place).norm() <= distance) there = end;
        const double way = (there - place).norm(), round_off = 4 * epsilon * there.norm();
        place = there;
        if (way <= round_off) continue;
        ++result.moved;
        result.farthest = std::max(result.farthest, way);
    }
    return result;
}

}  // namespace particles
