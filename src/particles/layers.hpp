#pragma once

#include <algorithm>
#include <string>

#include "base/index.hpp"
#include "particles/cloud.hpp"
#include "particles/multi_index.hpp"

namespace particles {

/// The number of layers of particles along an axis: of coordinates that differ by more than round-off.
template <int dim>
Index layers(const Cloud<dim>& cloud, int axis) {
    Column<double> x = cloud.x().row(axis).transpose();
    std::sort(x.begin(), x.end());
    const double same = 1e-6 * cloud.spacing();
    return 1 + ((x.tail(x.size() - 1) - x.head(x.size() - 1)) > same).count();
}

/// "take at least 4 layers of particles along x2: fewer do not determine polynomials of degree 3", with any
/// smoothing length: the product of \f$x_2 - c\f$ over three layers c vanishes at all particles. Empty where
/// there are enough.
/// \param degree of the polynomials that particles must determine
template <int dim>
std::string more_layers(const Cloud<dim>& cloud, int degree) {
    std::string axes;
    for (int axis = 0; axis < dim; ++axis)
        if (layers(cloud, axis) <= degree) axes += (axes.empty() ? "x" : ", x") + std::to_string(axis + 1);
    if (axes.empty()) return "";
    return "take at least " + std::to_string(degree + 1) + " layers of particles along " + axes +
           ": fewer do not determine polynomials of degree " + std::to_string(degree);
}

/// What helps where there are too few particles in all, or too few layers of them; or nothing.
/// \param number of particles that are needed \param degree of the polynomials that they must determine
template <int dim>
std::string more_particles(const Cloud<dim>& cloud, Index number, int degree) {
    if (std::string more = more_layers(cloud, degree); dim > 1 && !more.empty()) return more;
    if (cloud.size() >= number) return "";
    return "take at least " + std::to_string(number) + (dim > 1 ? " particles in all" : " particles");
}

/// The degree m of the complete polynomials that so many particles determine; zero where no m up to 3 has so
/// many monomials.
template <int dim>
constexpr int degree_of(Index terms_in_all) {
    return terms_in_all == terms<dim, 3>   ? 3
           : terms_in_all == terms<dim, 2> ? 2
           : terms_in_all == terms<dim, 1> ? 1
                                           : 0;
}

}  // namespace particles
