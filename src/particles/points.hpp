#pragma once

#include <Eigen/Core>
#include <string>
#include <type_traits>

#include "base/index.hpp"
#include "base/pack.hpp"
#include "base/text.hpp"

namespace particles {

using base::Index;
using base::Pack;
using base::shown;

/// Largest number of neighbours of a Pack, whose columns lie on the stack.
inline constexpr int most_in_pack = 64;

/// Largest number of neighbours that is known when compiling. It has a name, since Eigen::Dynamic in a
/// signature would make a function local to each file.
template <class Scalar>
inline constexpr int most_neighbours = std::is_same_v<Scalar, Pack> ? most_in_pack : Eigen::Dynamic;

/// Offsets, or other vectors, of particles or neighbours: a row for each, a column for each coordinate.
template <class Scalar, int dim = 1>
using Offsets = Eigen::Array<Scalar, Eigen::Dynamic, dim, 0, most_neighbours<Scalar>, dim>;

/// One number per particle, or per neighbour.
template <class Scalar = double>
using Column = Offsets<Scalar, 1>;

/// The squared length of each offset.
template <class Scalar, int dim>
Column<Scalar> squared_lengths(const Offsets<Scalar, dim>& s) {
    Column<Scalar> q = s.col(0).square();
    for (int axis = 1; axis < dim; ++axis) q += s.col(axis).square();
    return q;
}

/// A position on a line, in the plane or in space.
template <int dim, class Scalar = double>
using Point = Eigen::Matrix<Scalar, dim, 1>;

/// Positions, a column for each particle.
template <int dim>
using Points = Eigen::Matrix<double, dim, Eigen::Dynamic>;

/// "(0.5, 0.2)"
template <class Position>
std::string shown_point(const Position& x) {
    std::string text = "(";
    for (Index axis = 0; axis < x.size(); ++axis) text += (axis ? ", " : "") + shown(x[axis]);
    return text + ")";
}

}  // namespace particles
