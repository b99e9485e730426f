#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "particles/kernels.hpp"
#include "particles/line.hpp"

namespace particles {

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
    }
    [[nodiscard]] const Kernel& kernel() const { return kernel_; }
    [[nodiscard]] bool is_local() const { return h_.size() > 1; }

    /// The smoothing length, the largest where each particle has its own.
    [[nodiscard]] const Scalar& h() const { return largest_; }
    /// That of a particle.
    [[nodiscard]] const Scalar& h(Index i) const { return h_[is_local() ? i : 0]; }

    /// Distance beyond which the kernel carries nothing. It stops short of the support's edge by √ε: a particle on the
    /// very edge has no weight, and whether it counts as a neighbour must not depend on round-off.
    [[nodiscard]] Scalar reach() const { return reach_of(h()); }
    [[nodiscard]] Scalar reach(Index i) const { return reach_of(h(i)); }

  private:
    [[nodiscard]] Scalar reach_of(const Scalar& h) const {
        using std::sqrt;
        return h * support<Scalar>(kernel_) * (1 - sqrt(std::numeric_limits<Scalar>::epsilon()));
    }

    Kernel kernel_;
    Column<Scalar> h_;
    Scalar largest_;
};

/// What one particle sees of the others: plain local data, one entry per particle within reach, itself included.
///
/// All lengths are in units of the smoothing length h. The papers' equations hold in every unit of length, so that
/// formulations read as printed, while the local systems they solve are conditioned alike for every h. A weight for a
/// k-th derivative that is computed here carries the unit \f$1/h^k\f$.
/// \tparam Size number of entries where it is known at compile time
template <class Scalar, int Size = Eigen::Dynamic>
struct Neighbourhood {
    Column<Scalar, Size> r;   ///< offsets \f$(x_j - x_i)/h\f$
    Column<Scalar, Size> W;   ///< kernel values \f$h\,W_i(x_j)\f$
    Column<Scalar, Size> DW;  ///< kernel derivatives \f$h^2\,DW_i(x_j)\f$
    Column<Scalar, Size> V;   ///< volumes \f$\Delta\Omega_j/h\f$
};

/// Consecutive particles, first … last − 1.
struct Range {
    Index first, last;
    [[nodiscard]] Index size() const { return last - first; }
};

/// The particles within reach of particle i, itself included.
template <class Scalar>
Range within_reach(const Line<Scalar>& line, const Smoothing<Scalar>& smoothing, Index i) {
    const Scalar* const x = line.x().data();
    const Scalar reach = smoothing.reach(i);
    const auto* const first = std::upper_bound(x, x + i, x[i] - reach);
    const auto* const last = std::lower_bound(x + i + 1, x + line.size(), x[i] + reach);
    return {first - x, last - x};
}

/// The neighbourhood of particle i.
template <class Scalar>
Neighbourhood<Scalar> neighbourhood(const Line<Scalar>& line, const Smoothing<Scalar>& smoothing, Index i,
                                    const Range& near) {
    const Scalar& h = smoothing.h(i);
    Neighbourhood<Scalar> of_i;
    of_i.r = (line.x().segment(near.first, near.size()) - line.x()[i]) / h;
    of_i.V = line.V().segment(near.first, near.size()) / h;
    std::visit(
        [&](const auto& kernel) {
            of_i.W = of_i.r.unaryExpr([&](const Scalar& s) { return kernel.W(s); });
            of_i.DW = of_i.r.unaryExpr([&](const Scalar& s) { return kernel.DW(s); });
        },
        smoothing.kernel());
    return of_i;
}

template <class Scalar>
Neighbourhood<Scalar> neighbourhood(const Line<Scalar>& line, const Smoothing<Scalar>& smoothing, Index i) {
    return neighbourhood(line, smoothing, i, within_reach(line, smoothing, i));
}

}  // namespace particles
