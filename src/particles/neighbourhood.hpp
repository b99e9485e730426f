#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>
#include <vector>

#include "base/errors.hpp"
#include "base/index.hpp"
#include "base/pack.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "particles/kernels.hpp"
#include "particles/line.hpp"

namespace particles {

using base::chosen;
using base::for_each_index;
using base::Index;
using base::InvalidInput;
using base::Pack;
using base::shown;

/// A kernel with its smoothing length h [length], one for all particles or one for each.
template <class Scalar = double>
class Smoothing {
  public:
    /// \throws InvalidInput unless h is positive and finite
    Smoothing(const Kernel& kernel, const Scalar& h) : Smoothing(kernel, Column<Scalar>::Constant(1, h)) {}

    /// \param h of each particle
    /// \throws InvalidInput unless each h is positive and finite
    Smoothing(const Kernel& kernel, Column<Scalar> h) : kernel_(kernel), h_(std::move(h)) {
        using std::isfinite;
        for (const Scalar& each : h_)
            if (!(isfinite(each) && each > 0))
                throw InvalidInput("the smoothing length must be positive and finite, got " +
                                   shown(static_cast<double>(each)));
        largest_ = h_.maxCoeff();
        reach_per_h_ = reach_per_h(kernel_);
    }
    [[nodiscard]] const Kernel& kernel() const { return kernel_; }
    [[nodiscard]] bool is_local() const { return h_.size() > 1; }

    /// The smoothing length, the largest where each particle has its own.
    [[nodiscard]] const Scalar& h() const { return largest_; }
    /// That of a particle.
    [[nodiscard]] const Scalar& h(Index i) const { return h_[is_local() ? i : 0]; }
    /// Those of the particles of a Pack, from particle i on.
    [[nodiscard]] Pack pack_of_h(Index i) const {
        return is_local() ? Pack::from(h_.data() + i) : Pack(h_[0]);
    }

    /// Distance beyond which the kernel carries nothing. It stops short of the support's edge by √ε: a particle on the
    /// very edge has no weight, and whether it counts as a neighbour must not depend on round-off.
    [[nodiscard]] Scalar reach() const { return reach_of(h()); }
    [[nodiscard]] Scalar reach(Index i) const { return reach_of(h(i)); }
    [[nodiscard]] Pack pack_of_reaches(Index i) const { return pack_of_h(i) * reach_per_h_; }

  private:
    [[nodiscard]] Scalar reach_of(const Scalar& h) const { return h * reach_per_h_; }
    [[nodiscard]] static Scalar reach_per_h(const Kernel& kernel) {
        using std::sqrt;
        return support<Scalar>(kernel) * (1 - sqrt(std::numeric_limits<Scalar>::epsilon()));
    }

    Kernel kernel_;
    Column<Scalar> h_;
    Scalar largest_, reach_per_h_;
};

/// What one particle sees of the others: plain local data, one entry per particle within reach, itself included.
///
/// All lengths are in units of the smoothing length h. The papers' equations hold in every unit of length, so that
/// formulations read as printed, while the local systems they solve are conditioned alike for every h. A weight for a
/// k-th derivative that is computed here carries the unit \f$1/h^k\f$.
/// \tparam Scalar a real type, or Pack: then each entry holds the neighbours at that place of several particles
template <class Scalar>
struct Neighbourhood {
    Column<Scalar> r;   ///< offsets \f$(x_j - x_i)/h\f$
    Column<Scalar> W;   ///< kernel values \f$h\,W_i(x_j)\f$
    Column<Scalar> DW;  ///< kernel derivatives \f$h^2\,DW_i(x_j)\f$
    Column<Scalar> V;   ///< volumes \f$\Delta\Omega_j/h\f$
};

/// Consecutive particles, first … last − 1.
struct Range {
    Index first, last;
    [[nodiscard]] Index size() const { return last - first; }
};

/// The particles within reach of particle i, itself included.
/// \param guess where to look first, for example the answer for the particle before it
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

/// The same for each particle of the line.
template <class Scalar>
std::vector<Range> all_within_reach(const Line<Scalar>& line, const Smoothing<Scalar>& smoothing) {
    std::vector<Range> near(static_cast<std::size_t>(line.size()));
    constexpr Index block = 256;
    for_each_index((line.size() + block - 1) / block, [&](Index b) {
        Range range = within_reach(line, smoothing, b * block);
        for (Index i = b * block; i < std::min((b + 1) * block, line.size()); ++i) {
            range = within_reach(line, smoothing, i, range);
            near[static_cast<std::size_t>(i)] = range;
        }
    });
    return near;
}

namespace detail {

/// DW at an offset where W is known, which saves some kernels an exponential.
template <class Kernel, class Scalar>
Scalar derivative(const Kernel& kernel, const Scalar& s, const Scalar& W) {
    if constexpr (requires { kernel.DW(s, W); })
        return kernel.DW(s, W);
    else
        return kernel.DW(s);
}

}  // namespace detail

/// The neighbourhood of particle i.
template <class Scalar>
Neighbourhood<Scalar> neighbourhood(const Line<Scalar>& line, const Smoothing<Scalar>& smoothing, Index i,
                                    const Range& near) {
    const Scalar per_h = 1 / smoothing.h(i);
    Neighbourhood<Scalar> of_i;
    of_i.r = (line.x().segment(near.first, near.size()) - line.x()[i]) * per_h;
    of_i.V = line.V().segment(near.first, near.size()) * per_h;
    std::visit(
        [&](const auto& kernel) {
            of_i.W = of_i.r.unaryExpr([&](const Scalar& s) { return kernel.W(s); });
            of_i.DW = of_i.r.binaryExpr(
                of_i.W, [&](const Scalar& s, const Scalar& W) { return detail::derivative(kernel, s, W); });
        },
        smoothing.kernel());
    return of_i;
}

template <class Scalar>
Neighbourhood<Scalar> neighbourhood(const Line<Scalar>& line, const Smoothing<Scalar>& smoothing, Index i) {
    return neighbourhood(line, smoothing, i, within_reach(line, smoothing, i));
}

/// The neighbourhoods of the particles i, i + 1, … of a Pack, a lane each. All have the same number of entries: a particle that
/// a lane does not reach is there without weight, with W = DW = V = 0.
/// \param left, right how many particles on either side of its own a lane has entries for; all of them must exist
inline Neighbourhood<Pack> neighbourhoods(const Line<double>& line, const Smoothing<double>& smoothing,
                                          Index i, Index left, Index right) {
    const Index size = left + 1 + right;
    const double *const x = line.x().data() + i, *const V = line.V().data() + i;
    const Pack per_h = 1 / smoothing.pack_of_h(i), reach = smoothing.pack_of_reaches(i);
    const Pack x_i = Pack::from(x), least = x_i - reach, most = x_i + reach;
    Neighbourhood<Pack> of_each{Column<Pack>(size), Column<Pack>(size), Column<Pack>(size),
                                Column<Pack>(size)};
    std::visit(
        [&](const auto& kernel) {
            for (Index k = 0; k < size; ++k) {
                const Pack x_j = Pack::from(x + k - left), V_j = Pack::from(V + k - left);
                const Pack r = (x_j - x_i) * per_h, W = kernel.W(r);
                const auto reached = (x_j > least) & (x_j < most);
                of_each.r[k] = r;
                of_each.W[k] = chosen(reached, W, Pack(0));
                of_each.DW[k] = chosen(reached, detail::derivative(kernel, r, W), Pack(0));
                of_each.V[k] = chosen(reached, V_j * per_h, Pack(0));
            }
        },
        smoothing.kernel());
    return of_each;
}

}  // namespace particles
