#pragma once

#include <cmath>
#include <concepts>
#include <optional>
#include <string>
#include <utility>

#include "base/errors.hpp"
#include "base/index.hpp"
#include "base/pack.hpp"
#include "base/text.hpp"
#include "particles/kernels.hpp"
#include "particles/points.hpp"

namespace particles {

using base::Index;
using base::InvalidInput;
using base::Pack;
using base::shown;

/// A kernel with its smoothing length h [length], one for all particles or one for each.
/// \tparam Scalar a real type \tparam dim dimension of space, 1 to 3
template <class Scalar = double, int dim = 1>
class Smoothing {
  public:
    /// \throws InvalidInput unless h is positive and finite
    Smoothing(const Kernel<dim>& kernel, const Scalar& h)
        : Smoothing(kernel, Column<Scalar>::Constant(1, h)) {}

    /// \param h of each particle
    /// \throws InvalidInput unless there is one at least, and each is positive and finite
    Smoothing(const Kernel<dim>& kernel, Column<Scalar> h) : kernel_(kernel), h_(std::move(h)) {
        using std::isfinite;
        if (h_.size() == 0) throw InvalidInput("there is no smoothing length");
        for (const Scalar& each : h_)
            if (!(isfinite(each) && each > 0))
                throw InvalidInput("the smoothing length must be positive and finite, got " +
                                   shown(static_cast<double>(each)));
        largest_ = h_.maxCoeff();
        reach_per_h_ = particles::reach<Scalar>(kernel_);
    }

    /// A ratio h/δ and spacings δ: \f$h = (h/\delta)\,\delta\f$. Messages then speak of the ratio.
    Smoothing(const Kernel<dim>& kernel, const Column<Scalar>& spacing, const Scalar& ratio)
        : Smoothing(kernel, Column<Scalar>(ratio * spacing)) {
        ratio_ = static_cast<double>(ratio);
    }

    /// The same kernel with smoothing lengths that are so many times as large.
    [[nodiscard]] Smoothing times(double factor) const {
        Smoothing other(kernel_, Column<Scalar>(Scalar(factor) * h_));
        if (ratio_) other.ratio_ = factor * *ratio_;
        return other;
    }

    [[nodiscard]] const Kernel<dim>& kernel() const { return kernel_; }
    [[nodiscard]] bool is_local() const { return h_.size() > 1; }
    /// h/δ, where h was given so.
    [[nodiscard]] const std::optional<double>& ratio() const { return ratio_; }
    /// \throws InvalidInput unless there is one smoothing length, or one for each of N particles
    void require_lengths_of(Index N) const {
        if (is_local() && h_.size() != N)
            throw InvalidInput(std::to_string(N) + " particles need as many smoothing lengths, or one, got " +
                               std::to_string(h_.size()));
    }

    /// The smoothing length; the largest, where each particle has its own.
    [[nodiscard]] const Scalar& h() const { return largest_; }
    /// The smoothing length of particle i.
    [[nodiscard]] const Scalar& h(Index i) const { return h_[is_local() ? i : 0]; }
    /// The smoothing lengths of the particles of a Pack, from particle i on.
    [[nodiscard]] Pack pack_of_h(Index i) const {
        return is_local() ? Pack::from(h_.data() + i) : Pack(h_[0]);
    }

    /// Distance within which particles are neighbours, see reach() of a kernel. [length]
    [[nodiscard]] Scalar reach() const { return h() * reach_per_h_; }
    [[nodiscard]] Scalar reach(Index i) const { return h(i) * reach_per_h_; }
    [[nodiscard]] Pack pack_of_reaches(Index i) const { return pack_of_h(i) * reach_per_h_; }

  private:
    Kernel<dim> kernel_;
    Column<Scalar> h_;
    Scalar largest_, reach_per_h_;
    std::optional<double> ratio_;
};

// Smoothing smoothing(Gaussian<2>{}, h) has the dimension of its kernel and the scalar of its h.
template <template <int> class AnyKernel, int dim, std::floating_point Scalar>
Smoothing(const AnyKernel<dim>&, Scalar) -> Smoothing<Scalar, dim>;
template <template <int> class AnyKernel, int dim, class Lengths>
Smoothing(const AnyKernel<dim>&, const Eigen::ArrayBase<Lengths>&)
    -> Smoothing<typename Lengths::Scalar, dim>;

}  // namespace particles
