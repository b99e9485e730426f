#pragma once

#include <complex>
#include <string>
#include <vector>

#include "bodies/approximation.hpp"
#include "bodies/conditions.hpp"

namespace bodies {

/// A solution: the unknowns, and the approximation that makes a field of them.
template <int dim, int n>
struct Solution {
    Approximation<dim> approximation;
    Conditions<dim, n> conditions;  ///< of each particle
    Column<double> R;               ///< quality number of each particle's derivatives, particles::quality()
    double quality = 0;             ///< R of the worst row
    Index worst = 0;                ///< its particle
    /// Unknowns less the level; the n of a particle are adjacent.
    Eigen::VectorXd above;
    /// Given value of a scalar nearest to zero, range_of(): small differences of large values keep digits.
    double level = 0;

    /// The unknowns.
    [[nodiscard]] Eigen::VectorXd u() const { return above.array() + level; }
};

/// The solution of a problem. Hats of degree 3 fall back to degree 2 where the neighbours determine the
/// monomials of degree 3 badly; Approximation::how() of the solution has the degree used.
/// \throws base::InvalidInput for an ill-posed problem and for a method that does not work on this body
/// \throws base::FailedComputation where the method cannot solve it
template <int dim, int n>
Solution<dim, n> solve(const Problem<dim, n>& problem, const Body<dim>& body, const Discretisation& how);

/// The unknown functions at a place, with \f$\partial_b u_j\f$ and \f$F_{ia}\f$ (stress, or k∇u), n × dim
/// matrices.
template <int dim, int n>
struct State {
    Values<n> u;
    Eigen::Matrix<double, n, dim> gradient, F;
};

/// \param x a place of the body
template <int dim, int n>
State<dim, n> state_at(const Problem<dim, n>& problem, const Solution<dim, n>& solution, const Point<dim>& x);

/// The same with u less the level of the solution.
template <int dim, int n>
State<dim, n> state_above_level(const Problem<dim, n>& problem, const Solution<dim, n>& solution,
                                const Point<dim>& x);

/// The von Mises stress. \param material for plane strain, whose third normal stress counts
template <int dim>
double von_mises(const Eigen::Matrix<double, dim, dim>& stress,
                 const batra2008::elastostatics::Material& material);

/// The lowest eigenvalues λ of \f$-\sum_a\partial_a F_{ia} + c\,u_i = \lambda\,u_i\f$ under the conditions
/// of the problem with all given values and loads zero, in increasing order.
/// \throws base::FailedComputation where the iteration does not converge or an eigenvalue is not real
template <int dim, int n>
std::vector<double> eigenvalues(const Problem<dim, n>& problem, const Body<dim>& body,
                                const Discretisation& how, Index count);

/// \throws base::InvalidInput unless count is between 1 and half of the number of particles
void require_modes(Index particles, Index count);

/// The eigenvalues as real numbers, in increasing order. \param or_else another remedy, the end of a message
/// \throws base::FailedComputation for a negative one, and for an imaginary part above 1 % of the size
std::vector<double> vibrations(const std::vector<std::complex<double>>& eigenvalues, Method method,
                               const std::string& or_else = "");

/// A quantity on three clouds, each finer than the one before by the same ratio.
struct Extrapolated {
    double order;        ///< observed; NaN unless the differences have one sign and an order in range
    double value;        ///< Richardson's extrapolation by this order; f3 where the order is NaN
    double uncertainty;  ///< 1.25 |f3 − f2|/(r^p − 1); three times the range where the order is NaN
};

/// Roache's grid convergence index with a factor of 1.25. \param ratio r of the spacings
/// \param formal order of the method: an observed order is in range between 0.5 and formal + 1
Extrapolated extrapolated(double f1, double f2, double f3, double ratio, double formal);

}  // namespace bodies
