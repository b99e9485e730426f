#pragma once

#include <vector>

#include "batra2008/basis_at.hpp"

namespace batra2008::ssph_basis {

/// The SSPH basis at many places of the plane that share some particles of a cloud, as those of a disc do.
/// Particles that are not in the kernel's support around a place have no weight there, so that no place needs
/// a search.
/// \tparam m degree of the monomials, 1 to 3
template <int m>
class BasesNear {
  public:
    /// \param h smoothing length at all places [length] \param particle numbers of the particles, which must
    ///        outlive the bases \param lengths as for basis_at()
    BasesNear(const particles::Cloud<2>& cloud, const particles::TruncatedGaussian<2>& kernel, double h,
              const std::vector<int>& particle, Slopes slopes, const Column<double>& lengths);

    /// The particles that share the bases: \f$K_{IJ}\f$ belongs to the J-th of them, at each place.
    [[nodiscard]] const std::vector<int>& particle() const { return particle_; }

    /// \throws base::FailedComputation as basis_at()
    [[nodiscard]] Basis<2, m> basis_at(const Point<2>& x) const;

  private:
    const particles::Cloud<2>& cloud_;
    const particles::TruncatedGaussian<2>& kernel_;
    double h_;
    const std::vector<int>& particle_;
    Slopes slopes_;
    const Column<double>& lengths_;
    particles::Offsets<double, 2> x_;  // positions of the particles
};

extern template class BasesNear<1>;
extern template class BasesNear<2>;
extern template class BasesNear<3>;

}  // namespace batra2008::ssph_basis
