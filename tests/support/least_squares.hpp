#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "particles/multi_index.hpp"
#include "particles/operators.hpp"
#include "solvers/cholesky.hpp"

namespace support {

/// Weighted least squares with the monomials of degree 1 and 2, in any dimension: a formulation of the tests'
/// own, which uses all that a neighbourhood holds but DW.
struct LeastSquares {
    template <int dim>
    particles::Derivatives<double, dim> operator()(const particles::Neighbourhood<double, dim>& near) const {
        const auto& [r, W, DW, V] = near;
        constexpr int n = particles::terms<dim, 2> - 1;
        Eigen::MatrixXd P = Eigen::MatrixXd::Ones(r.rows(), n);
        for (int k = 0; k < n; ++k) {
            const auto a = particles::monomials<dim, 2>()[static_cast<std::size_t>(k + 1)];
            for (int axis = 0; axis < dim; ++axis)
                for (int power = 0; power < a[static_cast<std::size_t>(axis)]; ++power)
                    P.col(k).array() *= r.col(axis);
            P.col(k) /= particles::factorial<dim>(a);
        }
        const Eigen::MatrixXd weighted = (W * V).matrix().asDiagonal() * P;
        const solvers::Cholesky<double> factors(P.transpose().lazyProduct(weighted));
        const Eigen::ArrayXXd weights = factors.solve(weighted.transpose());
        return {weights.topRows(dim).transpose(), weights.bottomRows(n - dim).transpose()};
    }
};

}  // namespace support
