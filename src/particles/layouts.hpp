#pragma once

#include <cstddef>
#include <vector>

#include "base/index.hpp"
#include "particles/cells.hpp"

/// Layouts of particles whose distances suit the body.
namespace particles {

using base::Index;

/// A quarter of a square with a circular hole around its corner, which is the origin.
struct QuarterWithHole {
    double b = 0.3;   ///< radius of the hole [length]
    double side = 3;  ///< side of the quarter [length]
};

/// The coordinates \f$(\ln(r/b), \theta)\f$. The map keeps angles, and equal distances in the logarithmic
/// plane are distances in proportion to r in the body.
namespace logarithmic {

/// The place in the body with given logarithmic coordinates.
Point<2> place(const QuarterWithHole& shape, const Point<2>& at);

/// \f$\ln(r/b)\f$ of the outer edge at the angle θ.
double edge(const QuarterWithHole& shape, double theta);

/// Particles on the boundary at nearly equal distances, in logarithmic coordinates.
/// \param on_arc number of particles on the hole
std::vector<Point<2>> boundary_layout(const QuarterWithHole& shape, Index on_arc);

/// Random places, equally dense all over the logarithmic plane; the same for the same seed.
std::vector<Point<2>> random_places(const QuarterWithHole& shape, Index count, unsigned long seed);

}  // namespace logarithmic

/// Adds places to some particles until there are N: each is the place farthest from all particles before it,
/// of equals the first.
void add_farthest(std::vector<Point<2>>& x, const std::vector<Point<2>>& places, Index N);

/// Moves each particle to the centre of the places nearest to it (Lloyd), except the first few.
/// \param fixed number of particles that stay \param rounds how often
void move_to_centres(std::vector<Point<2>>& x, const std::vector<Point<2>>& places, std::size_t fixed,
                     int rounds = 1);

/// Particles whose distances grow in proportion to r. In the logarithmic plane those on the boundary have
/// equal distances; the others start by add_farthest() and move by move_to_centres() in 60 rounds. The result
/// is a hexagonal pattern with faults. No curve of second degree runs through a neighbourhood, so that local
/// fits of quadratics are well conditioned.
/// \param N number of particles
/// \param on_arc number of particles on the hole
/// \param seed of the random places: another seed gives another layout of the same kind
/// \throws base::InvalidInput if the boundary needs more particles than N
Points<2> graded_layout(const QuarterWithHole& shape, Index N, Index on_arc, unsigned long seed);

/// Particles on rays through the origin; along a ray their distances from it are in geometric progression.
/// \throws base::InvalidInput for an even number of rays or fewer than three rays or rings
Points<2> polar_layout(const QuarterWithHole& shape, Index rays, Index rings);

}  // namespace particles
