#pragma once

#include <algorithm>
#include <vector>

#include "batra2008/section_2_ssph_basis.hpp"
#include "particles/quality.hpp"

/// The SSPH basis at any place of a cloud of particles. Compiled once, in basis_at.cpp, for one to three
/// dimensions and monomials of degree 1 to 3.
namespace batra2008::ssph_basis {

/// Whether the derivatives of the basis functions, Basis::DK(), will be asked: they need the kernel's
/// gradient.
enum class Slopes { none, known };

/// The basis from some particles of a cloud.
/// \param among numbers of the particles to choose from
/// \param lengths smoothing length of each particle, which a remedy must serve, too; or none
/// \throws base::FailedComputation if the particles do not determine the monomials, with the place, the
///         number of particles, the number of monomials and a remedy that works
template <int m, int dim>
Basis<dim, m> basis_at(const particles::Cloud<dim>& cloud, const particles::TruncatedGaussian<dim>& kernel,
                       const Point<dim>& x, double h, const std::vector<int>& among,
                       Slopes slopes = Slopes::known, const Column<double>& lengths = {});

/// The basis from all particles within the kernel's support.
template <int m, int dim>
Basis<dim, m> basis_at(const particles::Cloud<dim>& cloud, const particles::TruncatedGaussian<dim>& kernel,
                       const Point<dim>& x, double h, Slopes slopes = Slopes::known,
                       const Column<double>& lengths = {});

/// Largest R of a derivative that is worth a solution. The paper's cases stay below 4, grids with three
/// particles on a side below 150.
inline constexpr double most = 1000;

/// The quality number of the derivatives of order k at a place, the largest of them, by
/// particles::quality(): in units of h, a derivative errs by at most \f$R\,h^{m+1-k}\,\max|f^{(m+1)}|\f$.
/// It judges each derivative by itself, not the system that is made of them: how well collocation solves a
/// problem depends on the layout, too.
/// \param basis with offsets and weights in units of h
template <int m, int dim>
double quality(const Basis<dim, m>& basis, int k) {
    double largest = 0;
    for (const Exponents<dim>& a : monomials<dim, m>())
        if (order<dim>(a) == k)
            largest = std::max(largest, particles::quality<double, dim>(derivative(basis, a), basis.r(), m));
    return largest;
}

/// \param h smoothing length of each particle [length]
/// \param derivative order k of the highest derivative in the equations of each particle; −1 where it has
/// none
/// \return the worst of these derivatives
/// \throws base::FailedComputation unless each particle sees as many particles as there are monomials of
///         degree m, itself included, these determine the monomials, and R is at most \ref most; it names the
///         first particle, and a remedy that is good for all
template <int m, int dim>
particles::WorstRow require_quality(const particles::Cloud<dim>& cloud,
                                    const particles::TruncatedGaussian<dim>& kernel, const Column<double>& h,
                                    const std::vector<int>& derivative);

/// The particles of a growing disc around a particle, as soon as there are enough of them and they determine
/// the monomials; all within the kernel's support if that is not larger.
/// \param h smoothing length of the particle [length] \param enough least number of particles
/// \return numbers in increasing order
template <int m, int dim>
std::vector<int> nearest_that_determine(const particles::Cloud<dim>& cloud,
                                        const particles::TruncatedGaussian<dim>& kernel, Index particle,
                                        double h, Index enough);

}  // namespace batra2008::ssph_basis
