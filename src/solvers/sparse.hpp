#pragma once

#include <Eigen/SparseCore>
#include <memory>
#include <optional>
#include <vector>

#include "base/vector_width.hpp"
#include "solvers/rows.hpp"

namespace solvers {

/// Scales each row of A to a largest entry of 1, and with it the right-hand side and the row of `nearest`:
/// unscaled, rows of boundary conditions and of equilibrium differ by many powers of ten and spoil the choice
/// of pivots.
/// \param nearest as many rows as A, or none
void scale_rows(SparseRows& A, Eigen::VectorXd& b, SparseRows& nearest);

/// Largest residual over all rows, relative to the largest sum of absolute terms in a row:
/// \f[ \frac{\max_i |b_i - \sum_j A_{ij} x_j|}{\max_i \sum_j |A_{ij} x_j| + \max_i |b_i|} \f]
double relative_residual(const SparseRows& A, const Eigen::VectorXd& x, const Eigen::VectorXd& b);

/// Relative residual below which a system counts as solved.
inline constexpr double largest_residual = 1e-12;

/// Solves \f$A x = b\f$ by GMRES. The preconditioner is the LU factorisation of the same equations restricted
/// to the nearest particles. Both matrices agree on whatever varies slowly, so that the number of iterations
/// does not grow with the number of particles. GMRES reduces the preconditioned residual, which is as large
/// as the error of x. paper/batra2008.md says how the nearest particles are chosen and what else was tried.
/// \param nearest its rows scaled as those of A
/// \return nothing where the iteration does not converge or one of the matrices is singular: a motion without
///         energy on the nearest neighbours has none on all of them
std::optional<Eigen::VectorXd> iterated(const SparseRows& A, const Eigen::VectorXd& b,
                                        const SparseRows& nearest);

/// Equations of the same body that are solved in little time: those of finite elements, or none.
struct Elements {
    SparseRows K{};                    ///< symmetric positive definite, with the unknowns of A
    std::vector<Eigen::Index> edge{};  ///< rows of A at the boundary, whose meaning is another one
};

/// The same, where the preconditioner is a solution by elements and then one of the equations of A on the
/// edge and two layers of neighbours, for what is left there. The elements know what varies slowly; the edge
/// knows the conditions, which collocation imposes in a way of its own.
/// \param A its rows scaled to a largest entry of 1 \param elements are freed as soon as they are factorised
std::optional<Eigen::VectorXd> iterated(const SparseRows& A, const Eigen::VectorXd& b, Elements&& elements);

/// Number of unknowns up to which a factorisation takes less time than the iteration.
inline constexpr Eigen::Index small_system = 4000;

/// How many neighbours the preconditioner's equations need: few for a large system, whose factors must stay
/// small.
/// \param least number of neighbours that an equation needs at least
inline Eigen::Index enough_neighbours(Eigen::Index unknowns, Eigen::Index least) {
    return unknowns > 400000 ? least + 3 : 2 * least + 1;
}

/// Solves \f$A x = b\f$ after scaling the rows: by iterated() if the same equations on the nearest particles
/// are given, and by a sparse factorisation of A if they are not or the iteration fails. The matrices are
/// scaled in place; Eigen would copy them to an argument by value, moved or not.
/// \param nearest those equations, unscaled; no rows for a small system, which is factorised in less time
/// \throws base::FailedComputation where A is singular to working precision or the residual stays large
Eigen::VectorXd solve_sparse(SparseRows&& A, Eigen::VectorXd b, SparseRows&& nearest = {});

/// The same with elements, or none for a small system.
Eigen::VectorXd solve_sparse(SparseRows&& A, Eigen::VectorXd b, Elements&& elements);

/// The factors of a matrix, for many right-hand sides. Each row is scaled as by scale_rows().
class SparseFactors {
  public:
    /// \throws base::FailedComputation where A is singular to working precision
    explicit SparseFactors(SparseRows A);
    ~SparseFactors();

    /// \return x of \f$A x = b\f$
    [[nodiscard]] Eigen::VectorXd solve(Eigen::VectorXd b) const;

  private:
    struct Factorised;
    std::unique_ptr<Factorised> factorised_;
};

}  // namespace solvers
