#pragma once

#include "batra2008/section_2_ssph_basis.hpp"
#include "fpm_in_space/section_1_second_order_fpm.hpp"

namespace fpm_in_space {

/// The derivatives by the SSPH basis \eq{B2.8} of degree m whose expansion takes the value at the particle as
/// given: without the constant monomial, on differences, weighted by W V. Of degree 3 its second derivatives are
/// those of second_order_fpm::derivatives(). Of degree 2 it needs few neighbours, sees values that alternate
/// from particle to particle as FPM does, and preconditions the equations of FPM: SSPH that leaves the value
/// free does not see them, and the iteration fails.
/// \return weights on \f$B(x_j) - B(x_i)\f$ [1/h, 1/h²]
template <int m, class Scalar, int dim>
Derivatives<Scalar, dim> ssph_with_value_given(const Neighbourhood<Scalar, dim>& near) {
    namespace ssph = batra2008::ssph_basis;
    const Table<Scalar> H = ssph::H<dim, m, Scalar>(near.r).bottomRows(terms<dim, m> - 1);
    const Table<Scalar> D = ssph::D<Scalar>(H, near.W * near.V);
    const solvers::Cholesky<Scalar> factors(ssph::C<Scalar>(D, H));
    Table<Scalar> all = factors.solve(D).topRows(dim + second_derivatives<dim>);
    static constexpr auto a = particles::monomials<dim, 2>();
    for (Index n = 0; n < all.rows(); ++n)
        all.row(n) *= Scalar(particles::factorial<dim>(a[static_cast<std::size_t>(1 + n)]));
    return {all.topRows(dim).transpose().array(),
            all.bottomRows(second_derivatives<dim>).transpose().array()};
}

}  // namespace fpm_in_space
