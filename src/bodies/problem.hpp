#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "batra2008/section_3_elastostatics.hpp"
#include "bodies/body.hpp"

namespace bodies {

/// The unknowns of a particle: a displacement, or one scalar.
template <int n>
using Values = Eigen::Matrix<double, n, 1>;

/// A function of the place; empty where nothing is given.
template <int dim, class Value = double>
using Field = std::function<Value(const Point<dim>&)>;

/// A function of the place and of the unit outward normal there; empty where nothing is given.
template <int dim, int n>
using Load = std::function<Values<n>(const Point<dim>& x, const Point<dim>& normal)>;

/// A linear differential equation of second order for n functions, in the form of a balance:
/// \f[ \sum_a \partial_a F_{ia} + b_i = c\,u_i, \qquad F_{ia} = \sum_{jb} A_{ia,jb}\,\partial_b u_j \f]
///
/// | | n | F | A |
/// | --- | --- | --- | --- |
/// | elasticity | dim | stress | Hooke's law, elasticity() |
/// | Poisson's equation, heat | 1 | minus the heat flux, \f$k\nabla u\f$ | k times unity, diffusion() |
///
/// The pair of indices ia is the row dim·i + a of a matrix.
template <int dim, int n>
struct Equation {
    static constexpr int pairs = n * dim;
    using Coefficients = Eigen::Matrix<double, pairs, pairs>;
    using Divergence = Eigen::Matrix<double, n, pairs>;

    Field<dim, Coefficients> A;
    Field<dim, Divergence> div_A{};  ///< \f$\sum_a \partial_a A_{ia,jb}\f$; empty for a constant A
    Field<dim, Values<n>> b{};       ///< body force or source; empty for none
    double c = 0;                    ///< reaction
};

/// Elasticity, plane or in space. [force/area]
/// \throws base::InvalidInput as batra2008::elastostatics::checked(); in space as for plane strain
template <int dim>
Equation<dim, dim> elasticity(const batra2008::elastostatics::Material& material);

/// \f$\nabla\cdot(k\nabla u) + f = c\,u\f$.
/// \param k conductivity, positive \param grad_k its gradient; empty for a constant k
template <int dim>
Equation<dim, 1> diffusion(const Field<dim>& k, const Field<dim, Point<dim>>& grad_k = {});

/// What is given on a side. Of each component either the value is given or the load \f$t_i = F_{ia} n_a\f$:
/// a traction, or a flux into the body. A component without both is free: its load is zero.
template <int dim, int n>
struct Given {
    std::string side;
    std::array<Field<dim>, static_cast<std::size_t>(n)> value{};
    std::vector<Load<dim, n>> loads{};  ///< they add up
    /// Convection: the load is \f$t = a\,(u_0 - u)\f$.
    Field<dim> exchange{};      ///< a
    Field<dim> surroundings{};  ///< \f$u_0\f$
    bool symmetry = false;      ///< of a displacement: no motion along the normal, and no shear
};

/// At particles where two sides meet: for each component, the side whose condition holds.
struct Corner {
    std::array<std::string, 2> sides;
    std::vector<std::string> by_component;
};

/// A boundary-value problem on a body.
template <int dim, int n>
struct Problem {
    Equation<dim, n> equation;
    std::vector<Given<dim, n>> given{};  ///< in the order in which sides are named; others are free
    std::vector<Corner> corners{};

    /// What is given on a side; null for a free one.
    [[nodiscard]] const Given<dim, n>* given_on(const Side<dim>& side) const {
        const auto found =
            std::find_if(given.begin(), given.end(), [&](const auto& one) { return one.side == side.name; });
        return found == given.end() ? nullptr : &*found;
    }
};

}  // namespace bodies
