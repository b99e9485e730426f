#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bodies/body.hpp"
#include "particles/cloud.hpp"
#include "particles/operators.hpp"
#include "particles/smoothing.hpp"
#include "particles/spacing.hpp"

namespace bodies {

using particles::Cloud;
using particles::Column;
using particles::Offsets;
using particles::second_derivatives;

/// The methods by their names in the papers; `fpm` is the second-order FPM of fpm_in_space. `hats` is weak1
/// with other test functions: the hats of the cells, linear on each cell, one at one particle and zero at all
/// others.
enum class Method { fpm, strong, weak1, weak2, hats };

const std::vector<std::pair<std::string, Method>>& methods();

std::string name(Method method);

/// \throws base::InvalidInput for another name
Method method_named(std::string_view wanted);

/// Whether a method works in this dimension, on a body with cells or without.
bool works(Method method, int dim, bool has_cells);

/// How a problem is solved.
struct Discretisation {
    Method method = Method::fpm;
    int degree = 2;          ///< m of the SSPH basis; 3 leaves less noise, in space above all
    double scaling = 3;      ///< ρ of the SSPH basis, whose h is the spacing
    double smoothing = 1.2;  ///< h of FPM over the spacing
    particles::Spacing spacing = particles::Spacing::local;
    double penalty = 0;       ///< α [coefficient/length]; for the weak forms
    double test_scaling = 1;  ///< ρ of the test function
    Index gauss = 10;         ///< \f$n_G\f$ of the weak forms
};

/// Weights on the unknowns of some particles for a function and its derivatives at a place.
template <int dim>
struct Weights {
    std::vector<int> particle;  ///< in increasing order
    Column<double> value;
    Offsets<double, dim> first;                       ///< [1/length]
    Offsets<double, second_derivatives<dim>> second;  ///< in the order of particles::monomials() [1/length²]
};

/// \f$\sum_J w_J u_J\f$ over some particles, for each column of weights w.
/// \param u n unknowns of each particle \return a column of n for each of w
template <int n, int columns>
Eigen::Matrix<double, n, columns> combined(const std::vector<int>& particle,
                                           const Offsets<double, columns>& w, const Eigen::VectorXd& u) {
    Eigen::Matrix<double, n, columns> sum = Eigen::Matrix<double, n, columns>::Zero();
    for (std::size_t J = 0; J < particle.size(); ++J)
        sum += u.segment<n>(n * particle[J]) * w.row(static_cast<Index>(J)).matrix();
    return sum;
}

/// Which derivatives are asked for.
enum class Derivatives { first, second };

/// The field that the unknowns of the particles define.
///
/// With an SSPH basis it is the field \f$\sum_J K_{1J} u_J\f$. With FPM the unknowns are its values, and
/// between the particles it is the Taylor polynomial of degree 2 of the nearest one.
template <int dim>
class Approximation {
  public:
    /// \throws base::InvalidInput as particles::spacing(), such as for a wrong number of given lengths
    Approximation(Cloud<dim> cloud, const Discretisation& how);

    [[nodiscard]] const Cloud<dim>& cloud() const { return cloud_; }
    [[nodiscard]] const Discretisation& how() const { return how_; }
    /// Smoothing length of each particle. [length]
    [[nodiscard]] const Column<double>& h() const { return h_; }

    /// The kernel of FPM, its smoothing lengths given as multiples of the spacing.
    [[nodiscard]] particles::Smoothing<double, dim> smoothing() const;

    /// At a particle.
    /// \throws base::FailedComputation where the neighbours do not determine the derivatives
    [[nodiscard]] Weights<dim> at_particle(Index I, Derivatives which = Derivatives::second) const;

    /// At any place of the body.
    [[nodiscard]] Weights<dim> at(const Point<dim>& x, Derivatives which = Derivatives::first) const;

    /// The same from few neighbours, for a preconditioner.
    [[nodiscard]] Weights<dim> at_particle_from_nearest(Index I, Index enough) const;

    /// At any place with a given smoothing length and given particles to choose from, for an SSPH basis.
    /// \param among particles, in increasing order
    [[nodiscard]] Weights<dim> at(const Point<dim>& x, double h, const std::vector<int>& among,
                                  Derivatives which = Derivatives::first) const;

    /// The fewest neighbours that determine the derivatives of at_particle_from_nearest().
    [[nodiscard]] Index least_neighbours() const;

    /// Distance within which particles may enter the weights of one. [length]
    [[nodiscard]] double reach(Index I) const;

    /// The neighbours of a particle that may enter its weights, in increasing order.
    [[nodiscard]] std::vector<int> neighbours(Index I) const;

    /// The particles that may enter the weights at a place of the body.
    [[nodiscard]] std::vector<int> neighbours_at(const Point<dim>& x) const;

  private:
    Cloud<dim> cloud_;
    Discretisation how_;
    Column<double> h_;
};

extern template class Approximation<2>;
extern template class Approximation<3>;

}  // namespace bodies
