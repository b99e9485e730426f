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
    Smoothing(const Kernel<>& kernel, const Scalar& h) : Smoothing(kernel, Column<Scalar>::Constant(1, h)) {}

    /// \param h of each particle
    /// \throws InvalidInput unless each h is positive and finite
    Smoothing(const Kernel<>& kernel, Column<Scalar> h) : kernel_(kernel), h_(std::move(h)) {
        using std::isfinite;
        for (const Scalar& each : h_)
            if (!(isfinite(each) && each > 0))
                throw InvalidInput("the smoothing length must be positive and finite, got " +
                                   shown(static_cast<double>(each)));
        largest_ = h_.maxCoeff();
        reach_per_h_ = reach_per_h(kernel_);
    }
    [[nodiscard]] const Kernel<>& kernel() const { return kernel_; }
    [[nodiscard]] bool is_local() const { return h_.size() > 1; }

    /// The smoothing length; the largest, where each particle has its own.
    [[nodiscard]] const Scalar& h() const { return largest_; }
    /// The smoothing length of particle i.
    [[nodiscard]] const Scalar& h(Index i) const { return h_[is_local() ? i : 0]; }
    /// The smoothing lengths of the particles of a Pack, from particle i on.
    [[nodiscard]] Pack pack_of_h(Index i) const {
        return is_local() ? Pack::from(h_.data() + i) : Pack(h_[0]);
    }

    /// Distance within which particles are neighbours: the radius of the support, less a fraction √ε. A
    /// particle on the very edge has no weight, and round-off must not decide whether it counts as a
    /// neighbour.
    [[nodiscard]] Scalar reach() const { return reach_of(h()); }
    [[nodiscard]] Scalar reach(Index i) const { return reach_of(h(i)); }
    [[nodiscard]] Pack pack_of_reaches(Index i) const { return pack_of_h(i) * reach_per_h_; }

  private:
    [[nodiscard]] Scalar reach_of(const Scalar& h) const { return h * reach_per_h_; }
    [[nodiscard]] static Scalar reach_per_h(const Kernel<>& kernel) {
        using std::sqrt;
        return support<Scalar>(kernel) * (1 - sqrt(std::numeric_limits<Scalar>::epsilon()));
    }

    Kernel<> kernel_;
    Column<Scalar> h_;
    Scalar largest_, reach_per_h_;
};

/// The particles within reach of one particle, itself included: plain local data, one entry for each of them.
///
/// All lengths are in units of the smoothing length h. The papers' equations hold in every unit of length, so
/// that formulations read as printed, and the condition of their local systems does not depend on h. Weights
/// for a k-th derivative are in units of \f$1/h^k\f$.
/// \tparam Scalar a real type, or Pack: then entry k holds the k-th neighbour of each of several particles
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

/// The particles within reach of each particle of the line.
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

/// The neighbourhood of particle i.
template <class Scalar>
Neighbourhood<Scalar> neighbourhood(const Line<Scalar>& line, const Smoothing<Scalar>& smoothing, Index i,
                                    const Range& near) {
    const Scalar per_h = 1 / smoothing.h(i);
    Neighbourhood<Scalar> near_i;
    near_i.r = (line.x().segment(near.first, near.size()) - line.x()[i]) * per_h;
    near_i.V = line.V().segment(near.first, near.size()) * per_h;
    std::visit(
        [&](const auto& kernel) {
            near_i.W = near_i.r.unaryExpr([&](const Scalar& s) { return kernel.W(s); });
            near_i.DW = near_i.r.binaryExpr(
                near_i.W, [&](const Scalar& s, const Scalar& W) { return detail::derivative(kernel, s, W); });
        },
        smoothing.kernel());
    return near_i;
}

template <class Scalar>
Neighbourhood<Scalar> neighbourhood(const Line<Scalar>& line, const Smoothing<Scalar>& smoothing, Index i) {
    return neighbourhood(line, smoothing, i, within_reach(line, smoothing, i));
}

/// The neighbourhoods of the particles i, i + 1, … of a Pack, one in each lane. All have the same number of
/// entries: for particles that a lane does not reach, W = DW = V = 0.
/// \param left, right numbers of entries on either side of the lane's own particle; these particles must
///        exist
inline Neighbourhood<Pack> neighbourhoods(const Line<double>& line, const Smoothing<double>& smoothing,
                                          Index i, Index left, Index right) {
    const Index size = left + 1 + right;
    const double *const x = line.x().data() + i, *const V = line.V().data() + i;
    const Pack per_h = 1 / smoothing.pack_of_h(i), reach = smoothing.pack_of_reaches(i);
    const Pack x_i = Pack::from(x), least = x_i - reach, most = x_i + reach;
    Neighbourhood<Pack> all{Column<Pack>(size), Column<Pack>(size), Column<Pack>(size), Column<Pack>(size)};
    std::visit(
        [&](const auto& kernel) {
            for (Index k = 0; k < size; ++k) {
                const Pack x_j = Pack::from(x + k - left), V_j = Pack::from(V + k - left);
                const Pack r = (x_j - x_i) * per_h, W = kernel.W(r);
                const auto reached = (x_j > least) & (x_j < most);
                all.r[k] = r;
                all.W[k] = chosen(reached, W, Pack(0));
                all.DW[k] = chosen(reached, detail::derivative(kernel, r, W), Pack(0));
                all.V[k] = chosen(reached, V_j * per_h, Pack(0));
            }
        },
        smoothing.kernel());
    return all;
}

}  // namespace particles
