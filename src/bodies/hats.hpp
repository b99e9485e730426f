#pragma once

#include <array>
#include <functional>
#include <vector>

#include "bodies/rows.hpp"

namespace bodies {

/// A weak form whose test functions are the hats of the cells: \f$W_I\f$ is linear on each cell, one at
/// particle I and zero at all others.
/// \f[ \sum_{ja b}\int_\Omega \partial_a W_I\,A_{ia,jb}\,\partial_b u_j\,d\Omega + \int_\Omega c\,W_I u_i
///     \,d\Omega + \int_\Gamma a\,W_I u_i\,d\Gamma = \int_\Omega W_I b_i\,d\Omega + \int_\Gamma W_I
///     (t_i + a\,u_0)\,d\Gamma \f]
///
/// The trial function u is that of the particles, an SSPH field as in weak1 of Batra and Zhang; the cells
/// carry the test functions alone. The hats sum to one, and with the particles' positions as weights to the
/// position: forces and moments balance to round-off, whatever the approximation. Loads enter as integrals;
/// at edges and corners those of all sides add up. Where a value is given, \eq{B3.13} replaces the particle's
/// equation. Integrals over a cell take the integrand at its centre.
template <int dim, int n>
class Hats {
  public:
    /// \throws base::InvalidInput for a body without cells, and for a given side with an arc or with a corner
    ///         where no particle lies
    Hats(const Problem<dim, n>& problem, const Body<dim>& body, const Approximation<dim>& approximation);

    /// The equations, with a preconditioner if they are many: those of linear elements on the same cells.
    [[nodiscard]] System system(const Conditions<dim, n>& conditions, Wanted wanted = Wanted::solution) const;

    /// The equations of some particles by linear elements, where u, too, is made of hats: n rows for each of
    /// `rows`. A particle whose cells and pieces the body has needs no others.
    [[nodiscard]] solvers::SparseRows elements(const Conditions<dim, n>& conditions,
                                               const std::vector<int>& rows) const;

    /// \f$\int W_I\,d\Omega\f$
    [[nodiscard]] double volume(Index I) const;

    /// The residual of particle I's equations; where values are given, the reaction. [force]
    [[nodiscard]] Values<n> residual(Index I, const Eigen::VectorXd& u) const;

  private:
    /// Weights of the function, and on a cell of its gradient.
    struct Trial {
        std::function<Weights<dim>(int cell)> on_cell;  ///< at its centre
        std::function<Weights<dim>(const std::array<int, dim>& facet, const Point<dim>& x)> on_facet;
        std::function<Weights<dim>(Index)> at_particle;
    };
    /// A piece of the boundary with its particles and what is given there.
    struct Facet {
        std::array<int, dim> particle;
        Point<dim> normal;
        double measure;
        const Given<dim, n>* given;
    };
    /// The n equations of a particle, on its neighbours.
    struct Equations {
        std::array<Factors<n>, static_cast<std::size_t>(n)> K, M;
        Values<n> f = Values<n>::Zero();
    };

    [[nodiscard]] Trial of_particles() const;
    [[nodiscard]] Trial linear() const;
    [[nodiscard]] std::vector<int> near(Index I, const Trial& trial) const;
    [[nodiscard]] Equations equations(Index I, const std::vector<int>& near, const Trial& trial) const;
    [[nodiscard]] System system(const Trial& trial, const Conditions<dim, n>& conditions, Wanted wanted,
                                const std::vector<int>& rows) const;

    const Problem<dim, n>& problem_;
    const Body<dim>& body_;
    const Approximation<dim>& approximation_;
    std::vector<Facet> facets_;
    std::vector<std::vector<int>> cells_of_, facets_of_;  ///< of each particle
};

}  // namespace bodies
