#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "base/errors.hpp"
#include "base/index.hpp"
#include "base/pack.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "particles/cloud.hpp"
#include "particles/line.hpp"
#include "particles/smoothing.hpp"

namespace particles {

using base::chosen;
using base::for_each_index;
using base::Index;
using base::InvalidInput;
using base::Pack;
using base::shown;

/// The particles near a place, plain local data with one entry for each of them: those within reach of a
/// particle, itself included, or those in the kernel's support around any place.
///
/// All lengths are in units of the smoothing length h. The papers' equations hold in every unit of length, so
/// that formulations read as printed, and the condition of their local systems does not depend on h. Weights
/// for a k-th derivative are in units of \f$1/h^k\f$.
/// \tparam Scalar a real type, or Pack: then entry k holds the k-th neighbour of each of several particles
/// \tparam dim dimension of space: one number, or a row of numbers, for each particle
template <class Scalar = double, int dim = 1>
struct Neighbourhood {
    Offsets<Scalar, dim> r;   ///< offsets \f$(x_j - x_i)/h\f$
    Column<Scalar> W;         ///< kernel values \f$h^{\dim}\,W_i(x_j)\f$
    Offsets<Scalar, dim> DW;  ///< kernel gradients \f$h^{\dim+1}\,DW_i(x_j)\f$
    Column<Scalar> V;         ///< volumes \f$\Delta\Omega_j/h^{\dim}\f$
};

/// Consecutive particles, first … last − 1.
struct Range {
    Index first = 0, last = 0;
    [[nodiscard]] Index size() const { return last - first; }
};

/// The particles within reach of particle i of a line, itself included.
/// \param guess where the search begins, for example the answer for the particle before it
template <class Scalar>
Range within_reach(const Line<Scalar>& line, const Smoothing<Scalar>& smoothing, Index i,
                   const Range& guess) {
    const Scalar* const x = line.x().data();
    const Scalar reach = smoothing.reach(i), least = x[i] - reach, most = x[i] + reach;
    Index first = std::min(guess.first, i), last = std::max(guess.last, i + 1);
    while (first > 0 && x[first - 1] > least) --first;
    while (first < i && !(x[first] > least)) ++first;
    while (last < line.size() && x[last] < most) ++last;
    while (last > i + 1 && !(x[last - 1] < most)) --last;
    return {first, last};
}

template <class Scalar>
Range within_reach(const Line<Scalar>& line, const Smoothing<Scalar>& smoothing, Index i) {
    const Scalar* const x = line.x().data();
    const Scalar reach = smoothing.reach(i);
    const auto* const first = std::upper_bound(x, x + i, x[i] - reach);
    const auto* const last = std::lower_bound(x + i + 1, x + line.size(), x[i] + reach);
    return {first - x, last - x};
}

/// The neighbours of the particles of a Pack, from particle i on: counted for all at once, since the
/// branches of a search of each are foreseen by no processor.
/// \param[out] near one for each particle of the Pack
/// \return false where the counting would leave the line; then nothing is written
bool within_reach_of_pack(const Line<double>& line, const Smoothing<double>& smoothing, Index i, Range* near);

/// The neighbours of some particles of a line, in their order.
template <class Scalar>
std::vector<Range> all_within_reach(const Line<Scalar>& line, const Smoothing<Scalar>& smoothing,
                                    const Range& some) {
    std::vector<Range> near(static_cast<std::size_t>(some.size()));
    Range* next = near.data();
    for (Index i = some.first; i < some.last; ++i, ++next) {
        if constexpr (std::is_same_v<Scalar, double>)
            while (i + Pack::lanes <= some.last && within_reach_of_pack(line, smoothing, i, next)) {
                i += Pack::lanes;
                next += Pack::lanes;
            }
        if (i < some.last) *next = within_reach(line, smoothing, i, {i, i + 1});
    }
    return near;
}

/// The particles within reach of particle i of a cloud, itself included, in increasing order.
template <int dim>
std::vector<int> within_reach(const Cloud<dim>& cloud, const Smoothing<double, dim>& smoothing, Index i) {
    return cloud.within(cloud.x().col(i), smoothing.reach(i));
}

/// The neighbours of each particle of a cloud, for some particles; the others' are left empty.
template <int dim>
std::vector<std::vector<int>> all_within_reach(const Cloud<dim>& cloud,
                                               const Smoothing<double, dim>& smoothing, const Range& some) {
    std::vector<std::vector<int>> near(static_cast<std::size_t>(cloud.size()));
    for_each_index(some.size(), [&](Index k) {
        near[static_cast<std::size_t>(some.first + k)] = within_reach(cloud, smoothing, some.first + k);
    });
    return near;
}

/// The neighbourhood of particle i of a line.
template <class Scalar>
Neighbourhood<Scalar> neighbourhood(const Line<Scalar>& line, const Smoothing<Scalar>& smoothing, Index i,
                                    const Range& near) {
    const Scalar per_h = 1 / smoothing.h(i);
    Neighbourhood<Scalar> near_i;
    near_i.r = (line.x().segment(near.first, near.size()) - line.x()[i]) * per_h;
    near_i.V = line.V().segment(near.first, near.size()) * per_h;
    evaluate(smoothing.kernel(), near_i.r, near_i.W, near_i.DW);
    return near_i;
}

// Compiled once: neighbourhood.cpp.
extern template Neighbourhood<double> neighbourhood(const Line<double>&, const Smoothing<double>&, Index,
                                                    const Range&);

template <class Scalar>
Neighbourhood<Scalar> neighbourhood(const Line<Scalar>& line, const Smoothing<Scalar>& smoothing, Index i) {
    return neighbourhood(line, smoothing, i, within_reach(line, smoothing, i));
}

/// What a place sees of some particles of a cloud.
/// \param kernel a Kernel, or one of the kernels itself
/// \param h smoothing length [length] \param near numbers of the particles
template <int dim, class AnyKernel>
Neighbourhood<double, dim> neighbourhood(const Cloud<dim>& cloud, const AnyKernel& kernel,
                                         const Point<dim>& place, double h, const std::vector<int>& near) {
    const double per_h = 1 / h, per_volume = std::pow(per_h, dim);
    const auto count = static_cast<Index>(near.size());
    Neighbourhood<double, dim> near_x{Offsets<double, dim>(count, dim), {}, {}, Column<double>(count)};
    for (Index k = 0; k < count; ++k) {
        const int j = near[static_cast<std::size_t>(k)];
        near_x.r.row(k) = ((cloud.x().col(j) - place) * per_h).transpose();
        near_x.V[k] = cloud.V()[j] * per_volume;
    }
    evaluate(kernel, near_x.r, near_x.W, near_x.DW);
    return near_x;
}

extern template Neighbourhood<double, 1> neighbourhood(const Cloud<1>&, const Kernel<1>&, const Point<1>&,
                                                       double, const std::vector<int>&);
extern template Neighbourhood<double, 2> neighbourhood(const Cloud<2>&, const Kernel<2>&, const Point<2>&,
                                                       double, const std::vector<int>&);
extern template Neighbourhood<double, 3> neighbourhood(const Cloud<3>&, const Kernel<3>&, const Point<3>&,
                                                       double, const std::vector<int>&);

/// The neighbourhood of particle i of a cloud.
template <int dim>
Neighbourhood<double, dim> neighbourhood(const Cloud<dim>& cloud, const Smoothing<double, dim>& smoothing,
                                         Index i, const std::vector<int>& near) {
    return neighbourhood<dim>(cloud, smoothing.kernel(), cloud.x().col(i), smoothing.h(i), near);
}

template <int dim>
Neighbourhood<double, dim> neighbourhood(const Cloud<dim>& cloud, const Smoothing<double, dim>& smoothing,
                                         Index i) {
    return neighbourhood(cloud, smoothing, i, within_reach(cloud, smoothing, i));
}

/// Particles in the kernel's support around a place: their numbers, and their offsets in units of h.
template <int dim>
struct Support {
    std::vector<int> particle;
    Offsets<double, dim> r;
};

/// Those of some particles of a cloud that lie in the kernel's support around a place.
/// \param edge reach() of the kernel \param among numbers of the particles to choose from
template <int dim>
Support<dim> support_at(const Cloud<dim>& cloud, double edge, const Point<dim>& place, double h,
                        std::vector<int> among) {
    const double per_h = 1 / h;
    const auto offset = [&](int j) -> Point<dim> { return (cloud.x().col(j) - place) * per_h; };
    const auto beyond = std::remove_if(among.begin(), among.end(),
                                       [&](int j) { return !(offset(j).squaredNorm() < edge * edge); });
    among.erase(beyond, among.end());
    Offsets<double, dim> r(static_cast<Index>(among.size()), dim);
    for (Index k = 0; k < r.rows(); ++k) r.row(k) = offset(among[static_cast<std::size_t>(k)]).transpose();
    return {std::move(among), std::move(r)};
}

/// The numbers of these particles.
template <int dim>
std::vector<int> in_support(const Cloud<dim>& cloud, const Kernel<dim>& kernel, const Point<dim>& place,
                            double h, std::vector<int> among) {
    return support_at(cloud, reach<double>(kernel), place, h, std::move(among)).particle;
}

/// All of them, in the order of the search.
template <int dim>
std::vector<int> in_support(const Cloud<dim>& cloud, const Kernel<dim>& kernel, const Point<dim>& place,
                            double h) {
    return in_support(cloud, kernel, place, h, cloud.around(place, support<double>(kernel) * h));
}

/// The neighbourhoods of the particles i, i + 1, … of a Pack, one in each lane. All have the same number of
/// entries: for particles that a lane does not reach, W = DW = V = 0.
/// \param left, right numbers of entries on either side of the lane's own particle; these particles must
///        exist
Neighbourhood<Pack> neighbourhoods(const Line<double>& line, const Smoothing<double>& smoothing, Index i,
                                   Index left, Index right);

}  // namespace particles
