#pragma once

#include "fpm_in_space/section_1_second_order_fpm.hpp"
#include "particles/moments.hpp"
#include "solvers/cholesky.hpp"

namespace fpm_in_space {

/// The derivatives by the SSPH basis \eq{B2.8} of degree m whose expansion takes the value at the particle as
/// given: without the constant monomial, on differences, weighted by W V. Of degree 3 its second derivatives
/// are those of second_order_fpm::derivatives(). Of degree 2 it needs few neighbours, sees values that
/// alternate from particle to particle as FPM does, and preconditions the equations of FPM: SSPH that leaves
/// the value free does not see them, and the iteration fails.
/// \return weights on \f$B(x_j) - B(x_i)\f$ [1/h, 1/h²]
template <int m, class Scalar, int dim>
Derivatives<Scalar, dim> ssph_with_value_given(const Neighbourhood<Scalar, dim>& near) {
    constexpr int n = terms<dim, m> - 1, wanted = dim + second_derivatives<dim>;
    const Column<Scalar> WV = near.W * near.V;
    const solvers::Cholesky<Scalar, n> factors(
        particles::moment_matrix<dim, m>(near.r, WV).template bottomRightCorner<n, n>());
    using Rows = Eigen::Matrix<Scalar, wanted, n + 1, Eigen::RowMajor>;
    Rows q = Rows::Zero();
    q.template rightCols<n>() = factors.solve(Eigen::Matrix<Scalar, n, wanted>::Identity()).transpose();
    static constexpr auto a = particles::monomials<dim, 2>();
    for (Index k = 0; k < wanted; ++k)
        q.row(k) *= Scalar(particles::factorial<dim>(a[static_cast<std::size_t>(1 + k)]));
    const Table<Scalar> all = particles::polynomials<dim, m>(q, near.r, WV);
    return {all.topRows(dim).transpose().array(),
            all.bottomRows(second_derivatives<dim>).transpose().array()};
}

}  // namespace fpm_in_space
