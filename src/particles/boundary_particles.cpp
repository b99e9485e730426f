#include "particles/boundary_particles.hpp"

#include <algorithm>
#include <cmath>
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

bool lies_on_boundary(const Region& region, const Point<2>& x, double size) {
    return nearest_part(region, x).distance <= negligible * size;
}

/// Whether a particle is neither in the body, on its boundary, nor clearly beside it.
bool is_astray(const Cloud<2>& cloud, const Region& region, double size, Index j) {
    const Point<2> x = cloud.x().col(j);
    if (lies_on_boundary(region, x, size)) return false;
    return !contains(region, x, size) ||
           nearest_part(region, x).distance < boundary_margin * cloud.apart()[j];
}

/// The first particle that is astray, or their number.
Index first_astray(const Cloud<2>& cloud, const Region& region, double size) {
    Index j = 0;
    while (j < cloud.size() && !is_astray(cloud, region, size, j)) ++j;
    return j;
}

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

/// "; try --snap 6.1e-08": the least distance that moves all particles that are astray, if they are not far
/// from the boundary, onto it. Empty if no particle would be left where it must not be.
std::string snap_remedy(const Cloud<2>& cloud, const Region& region, double size) {
    double farthest = 0;
    for (Index j = 0; j < cloud.size(); ++j) {
        if (!is_astray(cloud, region, size, j)) continue;
        const double distance = nearest_part(region, cloud.x().col(j)).distance;
        if (distance > cloud.apart()[j] / 2) return "";
        farthest = std::max(farthest, distance);
    }
    const std::string rounded = shown(1.1 * farthest, 2);
    try {
        check_particles(Cloud<2>(snapped(cloud.x(), region, std::stod(rounded)).x), region, size);
        return "; try --snap " + rounded;
    } catch (const InvalidInput&) {
        return "";
    }
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

}  // namespace

void check_particles(const Cloud<2>& cloud, const Region& region, double size) {
    if (const Index j = first_astray(cloud, region, size); j < cloud.size()) {
        const Point<2> x = cloud.x().col(j);
        const auto [curve, distance] = nearest_part(region, x);
        const bool inside = contains(region, x, size);
        throw InvalidInput("particle " + std::to_string(j) + " at " + shown_point(x) + " lies " +
                           (inside ? "inside the body, but only " : "outside the body, ") +
                           shown(distance, 3) + " from " + shown_curve(*curve) +
                           (inside ? ", less than a thousandth of its distance to the next particle" : "") +
                           snap_remedy(cloud, region, size) + other_span(cloud, region));
    }
    for (const Curve& curve : region) require_particles_on(curve, cloud, region, size);
}

Snapped snapped(Points<2> x, const Region& region, double distance) {
    if (!(std::isfinite(distance) && distance > 0))
        throw InvalidInput("the distance to snap must be positive and finite, got " + shown(distance));
    Snapped result{std::move(x)};
    for (auto place : result.x.colwise()) {
        const auto [curve, away] = nearest_part(region, place);
        if (away > distance) continue;
        Point<2> there = closest(*curve, place);
        for (const Curve& any : region)
            for (const Point<2>& end : ends(any))
                if ((end - place).norm() <= distance) there = end;
        const double way = (there - place).norm();
        if (way == 0) continue;
        place = there;
        ++result.moved;
        result.farthest = std::max(result.farthest, way);
    }
    return result;
}

}  // namespace particles
