#pragma once

#include <cstddef>
#include <vector>

#include "particles/boxes.hpp"
#include "particles/points.hpp"
#include "particles/region.hpp"

namespace particles {

/// The place where a part of a boundary ends and the next one starts, seen from the region.
struct Joint {
    Point<2> before, after;  ///< unit outward normals of the two parts
    double turn;             ///< angle by which the way turns left, negative at a re-entrant corner [radian]
    bool smooth;             ///< both parts have one tangent and one curvature: no corner at all

    /// Does a ray from the joint start into the region?
    [[nodiscard]] bool sees(const Point<2>& along) const;

    /// Angle of a turn from which a corner is sharp.
    static constexpr double sharp = 0.5235987755982988;  // 30°
};

/// The part of a boundary nearest to a place.
struct Nearest {
    std::size_t curve;
    Point<2> place;  ///< on it
    double distance;
};

/// The boundary of a region, made once for many searches. The time of a search grows with what it finds, not
/// with the number of parts.
class Boundary {
  public:
    /// \param region with each part's body to its left, as checked() returns it
    Boundary(Region region);

    /// The parts in the order in which they were given.
    [[nodiscard]] const Region& curves() const { return curves_; }

    /// Numbers of the parts that come within some distance of a place, in increasing order.
    [[nodiscard]] std::vector<std::size_t> near(const Point<2>& x, double reach) const;

    /// The first of the nearest parts; the region has at least one.
    [[nodiscard]] Nearest nearest(const Point<2>& x) const;

    /// The joint at which part k starts.
    [[nodiscard]] const Joint& start(std::size_t k) const { return end_[before_[k]]; }

    /// The joint at which part k ends.
    [[nodiscard]] const Joint& end(std::size_t k) const { return end_[k]; }

    /// Number of the first part of the run of parts to which part k belongs: from one sharp corner to the
    /// next, or a whole loop.
    [[nodiscard]] std::size_t run(std::size_t k) const { return run_[k]; }

  private:
    Region curves_;
    Boxes boxes_;
    std::vector<std::size_t> before_;  // the part that ends where part k starts
    std::vector<Joint> end_;
    std::vector<std::size_t> run_;
};

/// Distance of a place from a boundary, negative in the region. [length]
double signed_distance(const Boundary& boundary, const Point<2>& x);

/// Does a place lie in the region or on its boundary? \param size a length of the body
bool contains(const Boundary& boundary, const Point<2>& x, double size);

}  // namespace particles
