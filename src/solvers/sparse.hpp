#pragma once

#include <Eigen/SparseCore>
#include <Eigen/UmfPackSupport>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/errors.hpp"
#include "base/parallel.hpp"
#include "particles/operators.hpp"

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
        throw base::InvalidInput("a system of " + std::to_string(entries) +
                                 " entries is too large; take fewer particles or a smaller scaling factor");
    SparseRows A(2 * N, 2 * N);
    A.resizeNonZeros(static_cast<Index>(entries));
    A.outerIndexPtr()[0] = 0;
    for (Index i = 0; i < 2 * N; ++i)
        A.outerIndexPtr()[i + 1] =
            A.outerIndexPtr()[i] + 2 * static_cast<int>(near[static_cast<std::size_t>(i / 2)].size());
    base::for_each_index(N, [&](Index i) {
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

/// Scales each row of A to a largest entry of 1, and with it the load and the row of a matrix of the same equations: rows of
/// boundary conditions and of equilibrium differ by many powers of ten, and unscaled ruin the choice of pivots.
/// \param nearest as many rows as A, or none
inline void scale_rows(SparseRows& A, Eigen::VectorXd& b, SparseRows& nearest) {
    const auto values = [](SparseRows& of, Eigen::Index row) {
        const int first = of.outerIndexPtr()[row];
        return Eigen::Map<Eigen::ArrayXd>(of.valuePtr() + first, of.outerIndexPtr()[row + 1] - first);
    };
    base::for_each_index(A.rows(), [&](Eigen::Index row) {
        double largest = 0;
        for (const double entry : values(A, row)) largest = std::max(largest, std::abs(entry));
        const double scale = 1 / largest;
        values(A, row) *= scale;
        b[row] *= scale;
        if (nearest.rows() > 0) values(nearest, row) *= scale;
    });
}

/// What is left of a system's largest row, against the sizes of the terms that it sums.
inline double relative_residual(const SparseRows& A, const Eigen::VectorXd& x, const Eigen::VectorXd& b) {
    Eigen::VectorXd left(A.rows()), size(A.rows());
    base::for_each_index(A.rows(), [&](Eigen::Index row) {
        double sum = 0, terms = 0;
        for (SparseRows::InnerIterator entry(A, row); entry; ++entry) {
            sum += entry.value() * x[entry.col()];
            terms += std::abs(entry.value() * x[entry.col()]);
        }
        left[row] = std::abs(b[row] - sum);
        size[row] = terms;
    });
    const double largest = size.maxCoeff() + b.cwiseAbs().maxCoeff();
    return largest == 0 ? 0 : left.maxCoeff() / largest;
}

/// Relative residual of what counts as solved.
inline constexpr double largest_residual = 1e-12;

/// The triangular factors of a sparse matrix, with row exchanges.
class Factors {
  public:
    struct Settings {
        int ordering =
            UMFPACK_ORDERING_METIS;  ///< fills less than UMFPACK_ORDERING_AMD, which is found sooner
        bool refined = true;         ///< does solve() refine what it finds?
    };
    Factors(const SparseRows& A, const Settings& settings) : columns_(A) {
        auto& control = factors_.umfpackControl();
        control[UMFPACK_STRATEGY] = UMFPACK_STRATEGY_SYMMETRIC;  // neighbours are so mutually, or nearly
        control[UMFPACK_ORDERING] = settings.ordering;
        control[UMFPACK_SCALE] = UMFPACK_SCALE_NONE;
        if (!settings.refined) control[UMFPACK_IRSTEP] = 0;
        factors_.compute(columns_);
        if (factors_.info() != Eigen::Success) {
            fault_ = factors_.out_of_memory() ? "does not fit into memory" : "is singular";
            return;
        }
        // Nearly every vector shows that a matrix is singular; the load may be one of the few that do not.
        const Eigen::VectorXd probe = Eigen::VectorXd::NullaryExpr(A.rows(), [](Eigen::Index k) {
            return std::cos(static_cast<double>(k) * static_cast<double>(k));
        });
        const double growth = solve(probe).cwiseAbs().maxCoeff();
        if (!(growth < 1 / (100 * std::numeric_limits<double>::epsilon()))) fault_ = "is singular";
    }

    /// Why the matrix cannot be solved with; empty if it can.
    [[nodiscard]] const std::string& fault() const { return fault_; }
    [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const { return factors_.solve(b); }

  private:
    /// The factors of a million particles have too many entries for the indices of an int.
    using Columns = Eigen::SparseMatrix<double, Eigen::ColMajor, SuiteSparse_long>;
    struct Umfpack : Eigen::UmfPackLU<Columns> {
        [[nodiscard]] bool out_of_memory() const { return m_fact_errorCode < 0; }
    };

    Columns columns_;
    Umfpack factors_;
    std::string fault_;
};

/// Solves A x = b by GMRES. Its preconditioner are the factors of the same equations on fewer, the nearest, particles. Both agree on
/// all that varies slowly: the number of iterations does not grow with that of the particles. The residual that is made small is
/// the preconditioned one, which is as large as the error of x; how to choose what is nearest, and what else was tried, stands
/// in paper/batra2008.md.
/// \param nearest rows scaled as those of A are
/// \return nothing where the iteration does not converge, or where one of the matrices is singular: what moves freely without
///         the far neighbours does so with them
std::optional<Eigen::VectorXd> iterated(const SparseRows& A, const Eigen::VectorXd& b,
                                        const SparseRows& nearest);

/// Solves A x = b, after the rows are scaled: iterated() if the same equations on the nearest particles are given, and where that
/// fails or they are not by a sparse factorisation of A.
/// \param nearest those equations, unscaled; no rows for a small system, which is factorised in less time
/// \throws base::FailedComputation where A is singular to working precision or the residual stays large
Eigen::VectorXd solve_sparse(SparseRows A, Eigen::VectorXd b, SparseRows nearest = {});

}  // namespace solvers
