#pragma once

#include <vector>

#include "batra2008/section_2_ssph_basis.hpp"

/// The SSPH basis at any place of a cloud of particles. Compiled once, in basis_at.cpp, for one to three
/// dimensions and monomials of degree 1 to 3.
namespace batra2008::ssph_basis {

/// Whether the derivatives of the basis functions, Basis::DK(), will be asked: they need the kernel's
/// gradient.
enum class Slopes { none, known };

/// The basis from some particles of a cloud.
/// \param among numbers of the particles to choose from
/// \throws base::FailedComputation if the particles do not determine the monomials, with the place, the
///         number of particles, the number of monomials and a remedy that works
template <int m, int dim>
Basis<dim, m> basis_at(const particles::Cloud<dim>& cloud, const particles::TruncatedGaussian<dim>& kernel,
                       const Point<dim>& x, double h, const std::vector<int>& among,
                       Slopes slopes = Slopes::known);

/// The basis from all particles within the kernel's support.
template <int m, int dim>
Basis<dim, m> basis_at(const particles::Cloud<dim>& cloud, const particles::TruncatedGaussian<dim>& kernel,
                       const Point<dim>& x, double h, Slopes slopes = Slopes::known);

/// \param h smoothing length of each particle [length]
/// \throws base::FailedComputation unless each particle sees as many particles as there are monomials of
///         degree m, itself included; it names the first, and a scaling factor that is enough for all
template <int m, int dim>
void require_particles(const particles::Cloud<dim>& cloud, const particles::TruncatedGaussian<dim>& kernel,
                       const Column<double>& h);

/// The particles of a growing disc around a particle, as soon as there are enough of them and they determine
/// the monomials; all within the kernel's support if that is not larger.
/// \param h smoothing length of the particle [length] \param enough least number of particles
/// \return numbers in increasing order
template <int m, int dim>
std::vector<int> nearest_that_determine(const particles::Cloud<dim>& cloud,
                                        const particles::TruncatedGaussian<dim>& kernel, Index particle,
                                        double h, Index enough);

}  // namespace batra2008::ssph_basis
