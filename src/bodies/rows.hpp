#pragma once

#include <vector>

#include "bodies/approximation.hpp"
#include "bodies/conditions.hpp"
#include "solvers/sparse.hpp"

// Rows of a linear system: how the unknowns of some particles enter an equation.
namespace bodies {

/// Coefficients of the n unknowns in an equation, a row for each of some particles.
template <int n>
using Factors = Eigen::Array<double, Eigen::Dynamic, n>;

template <int n>
struct Row {
    Factors<n> factors;
    double given = 0;
};

/// A linear system with n equations for each of some particles, or for all.
struct System {
    solvers::SparseRows A;
    Eigen::VectorXd b;
    solvers::SparseRows
        nearest{};  ///< the same equations on few neighbours, for solvers::iterated(); or none
    /// What λ multiplies in the equations \f$A u = \lambda M u\f$ of vibrations, on the pattern of A.
    solvers::SparseRows M{};
};

/// How much of a system is asked for.
enum class Wanted { solution, eigenvalues };

/// A system of zeros. \param near the particles in the equations of each particle, in increasing order
/// \param particles number of those that have unknowns
template <int n>
System empty_system(const std::vector<std::vector<int>>& near, Wanted wanted, Index particles) {
    System system{solvers::rows_in_blocks(near, n, particles),
                  Eigen::VectorXd::Zero(n * static_cast<Index>(near.size()))};
    if (wanted == Wanted::eigenvalues) system.M = solvers::rows_in_blocks(near, n, particles);
    return system;
}

/// Adds coefficients of some particles to those of more particles, both in increasing order.
template <int n>
void add(Factors<n>& sum, const std::vector<int>& among, const Factors<n>& more,
         const std::vector<int>& particle) {
    Index to = 0;
    for (std::size_t from = 0; from < particle.size(); ++from, ++to) {
        while (among[static_cast<std::size_t>(to)] != particle[from]) ++to;
        sum.row(to) += more.row(static_cast<Index>(from));
    }
}

template <int n>
void set_row(solvers::SparseRows& A, Index row, const std::vector<int>& particle, const Factors<n>& factors) {
    if constexpr (n == 1) solvers::set_row(A, row, particle, factors.col(0));
    if constexpr (n == 2) solvers::set_row(A, row, particle, factors.col(0), factors.col(1));
    if constexpr (n == 3) solvers::set_row(A, row, particle, factors.col(0), factors.col(1), factors.col(2));
}

/// \f$d\cdot u\f$ at a place. \param value weights of a function there
template <int n>
Factors<n> value_along(const Values<n>& d, const Column<double>& value) {
    return (value.matrix() * d.transpose()).array();
}

/// \f$\sum_{ia} G_{ia} F_{ia}\f$ at a place, with \f$F = A \nabla u\f$.
/// \param first weights of the first derivatives there
template <int dim, int n>
Factors<n> work(const Eigen::Matrix<double, n, dim>& G, const typename Equation<dim, n>::Coefficients& A,
                const Offsets<double, dim>& first) {
    Factors<n> factors = Factors<n>::Zero(first.rows(), n);
    for (int j = 0; j < n; ++j)
        for (int b = 0; b < dim; ++b) {
            double factor = 0;
            for (int i = 0; i < n; ++i)
                for (int a = 0; a < dim; ++a) factor += G(i, a) * A(dim * i + a, dim * j + b);
            factors.col(j) += factor * first.col(b);
        }
    return factors;
}

/// The load along a direction on a plane, \f$d\cdot F n + a\,d\cdot u\f$.
template <int dim, int n>
Factors<n> load(const Equation<dim, n>& equation, const Point<dim>& x, const Weights<dim>& at,
                const Condition<dim, n>& condition) {
    const Eigen::Matrix<double, n, dim> G = condition.direction * condition.normal.transpose();
    return work<dim, n>(G, equation.A(x), at.first) +
           condition.exchange * value_along<n>(condition.direction, at.value);
}

/// b of an equation at a place.
template <int dim, int n>
Values<n> source(const Equation<dim, n>& equation, const Point<dim>& x) {
    return equation.b ? equation.b(x) : Values<n>(Values<n>::Zero());
}

}  // namespace bodies
