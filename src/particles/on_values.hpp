#pragma once

#include "base/index.hpp"
#include "particles/points.hpp"

namespace particles {

/// Weights on the differences \f$B(x_j) - B(x_i)\f$ as weights on the values \f$B(x_j)\f$: that of particle i
/// itself is minus the sum of the others, \f$w_i = -\sum_{j \ne i} w_j\f$.
/// \param w a row for each neighbour, a column for each derivative
/// \param own the place of particle i among its neighbours
template <class Scalar, int columns>
Offsets<Scalar, columns> on_values(Offsets<Scalar, columns> w, base::Index own) {
    w.row(own).setZero();
    w.row(own) = -w.colwise().sum();
    return w;
}

}  // namespace particles
