#include "batra2008/bases_near.hpp"

#include <utility>

namespace batra2008::ssph_basis {

template <int m>
BasesNear<m>::BasesNear(const particles::Cloud<2>& cloud, const particles::TruncatedGaussian<2>& kernel,
                        double h, const std::vector<int>& particle, Slopes slopes,
                        const Column<double>& lengths)
    : cloud_(cloud),
      kernel_(kernel),
      h_(h),
      particle_(particle),
      slopes_(slopes),
      lengths_(lengths),
      x_(static_cast<Index>(particle.size()), 2) {
    for (Index J = 0; J < x_.rows(); ++J)
        x_.row(J) = cloud.x().col(particle[static_cast<std::size_t>(J)]).transpose();
}

template <int m>
Basis<2, m> BasesNear<m>::basis_at(const Point<2>& x) const {
    const auto edge = particles::reach<double>(kernel_);
    Neighbourhood<double, 2> near{(x_.rowwise() - x.transpose().array()) / h_, {}, {}, {}};
    const Column<double> q = particles::squared_lengths(near.r);
    near.W = (q < edge * edge).select(kernel_.at(q), 0);
    if (slopes_ == Slopes::known)
        near.DW = near.r.colwise() * (q < edge * edge).select(-2 * (near.W + kernel_.edge()), 0);
    try {
        return Basis<2, m>(std::move(near), {}, h_);
    } catch (const particles::SingularNeighbourhood&) {
        // This refuses, too, and says what helps.
        static_cast<void>(ssph_basis::basis_at<m>(cloud_, kernel_, x, h_, particle_, slopes_, lengths_));
        throw;
    }
}

template class BasesNear<1>;
template class BasesNear<2>;
template class BasesNear<3>;

}  // namespace batra2008::ssph_basis
