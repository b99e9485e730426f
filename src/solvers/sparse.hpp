#pragma once

#include <Eigen/SparseCore>
#include <Eigen/UmfPackSupport>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "particles/errors.hpp"
#include "particles/operators.hpp"
#include "particles/parallel.hpp"

namespace solvers {

/// A sparse matrix by rows, as the operators are.
using SparseRows = particles::Operator<double>;

/// A matrix of two rows and two columns for each particle, with room for the neighbours of each; its values are zero.
/// \param near neighbours of each particle, in increasing order
inline SparseRows rows_in_pairs(const std::vector<std::vector<int>>& near) {
    using particles::Index;
    const auto N = static_cast<Index>(near.size());
    std::size_t entries = 0;
    for (const auto& neighbours : near) entries += 4 * neighbours.size();
    if (entries > static_cast<std::size_t>(std::numeric_limits<int>::max()))
        throw particles::InvalidInput(
            "a system of " + std::to_string(entries) +
            " entries is too large; take fewer particles or a smaller scaling factor");
    SparseRows A(2 * N, 2 * N);
    A.resizeNonZeros(static_cast<Index>(entries));
    A.outerIndexPtr()[0] = 0;
    for (Index i = 0; i < 2 * N; ++i)
        A.outerIndexPtr()[i + 1] =
            A.outerIndexPtr()[i] + 2 * static_cast<int>(near[static_cast<std::size_t>(i / 2)].size());
    particles::for_each_index(N, [&](Index i) {
        for (int row = 0; row < 2; ++row) {
            int* column = A.innerIndexPtr() + A.outerIndexPtr()[2 * i + row];
            for (const int j : near[static_cast<std::size_t>(i)]) {
                *column++ = 2 * j;
                *column++ = 2 * j + 1;
            }
        }
    });
    std::fill(A.valuePtr(), A.valuePtr() + A.nonZeros(), 0.0);
    return A;
}

/// Writes a row: the factors of the two unknowns of some particles, which the row has room for.
/// \param particle in increasing order
inline void set_row(SparseRows& A, Eigen::Index row, const std::vector<int>& particle,
                    const Eigen::ArrayXd& first, const Eigen::ArrayXd& second) {
    Eigen::Index place = A.outerIndexPtr()[row];
    for (std::size_t j = 0; j < particle.size(); ++j) {
        while (A.innerIndexPtr()[place] != 2 * particle[j]) place += 2;
        A.valuePtr()[place] = first[static_cast<Eigen::Index>(j)];
        A.valuePtr()[place + 1] = second[static_cast<Eigen::Index>(j)];
    }
}

/// Solves A x = b by a sparse factorisation with row exchanges, after the rows are scaled to a largest entry of 1: rows of
/// boundary conditions and of equilibrium differ by many powers of ten, and unscaled ruin the choice of pivots.
/// \throws particles::FailedComputation where A is singular to working precision or the residual stays large
inline Eigen::VectorXd solve_sparse(const SparseRows& A, const Eigen::VectorXd& b) {
    const auto refuse = [&](const std::string& why) {
        throw particles::FailedComputation("the linear system of " + std::to_string(A.rows()) + " unknowns " +
                                           why + "; take another scaling factor or other particles");
    };
    Eigen::VectorXd scale(A.rows());
    particles::for_each_index(A.rows(), [&](Eigen::Index row) {
        double largest = 0;
        for (SparseRows::InnerIterator entry(A, row); entry; ++entry)
            largest = std::max(largest, std::abs(entry.value()));
        scale[row] = 1 / largest;
    });
    const Eigen::SparseMatrix<double> scaled = scale.asDiagonal() * A;
    const Eigen::VectorXd load = scale.cwiseProduct(b);
    if (!load.allFinite() ||
        !Eigen::Map<const Eigen::ArrayXd>(scaled.valuePtr(), scaled.nonZeros()).allFinite())
        refuse("has rows that are zero or not finite");

    Eigen::UmfPackLU<Eigen::SparseMatrix<double>> factors;
    auto& control = factors.umfpackControl();
    control[UMFPACK_STRATEGY] = UMFPACK_STRATEGY_SYMMETRIC;  // neighbours are so mutually, or nearly
    control[UMFPACK_ORDERING] = UMFPACK_ORDERING_METIS;
    control[UMFPACK_SCALE] = UMFPACK_SCALE_NONE;
    factors.compute(scaled);
    if (factors.info() != Eigen::Success) refuse("is singular");
    // Nearly every vector shows that a matrix is singular; the load may be one of the few that do not.
    const Eigen::VectorXd probe = Eigen::VectorXd::NullaryExpr(
        A.rows(), [](Eigen::Index k) { return std::cos(static_cast<double>(k) * static_cast<double>(k)); });
    const double growth = Eigen::VectorXd(factors.solve(probe)).cwiseAbs().maxCoeff();
    if (!(growth < 1 / (100 * std::numeric_limits<double>::epsilon()))) refuse("is singular");

    Eigen::VectorXd x = factors.solve(load);
    const double size =
        Eigen::VectorXd(scaled.cwiseAbs() * x.cwiseAbs()).maxCoeff() + load.cwiseAbs().maxCoeff();
    const double residual = size == 0 ? 0 : (load - scaled * x).cwiseAbs().maxCoeff() / size;
    if (!(residual < 1e-12))
        refuse("was not solved (relative residual " + particles::shown(residual, 2) + ")");
    return x;
}

}  // namespace solvers
