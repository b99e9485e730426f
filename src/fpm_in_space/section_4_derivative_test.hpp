#pragma once

#include <array>
#include <functional>
#include <string_view>
#include <type_traits>
#include <vector>

#include "fpm_in_space/formulations.hpp"
#include "particles/cloud.hpp"
#include "particles/smoothing.hpp"

namespace fpm_in_space {

/// Section 4, the derivative test in the plane and in space: errors of the first and second derivatives by
/// the place of the particles.
///
/// | symbol | code | meaning |
/// | --- | --- | --- |
/// | \f$n\f$ | `n` | particles along a side; \f$N = n^d\f$ |
/// | \f$\delta\f$ | `cloud.spacing()` | their distance, \f$1/(n-1)\f$ |
/// | \f$a\f$ | `perturbation` | amplitude of their random displacement, in units of δ |
/// | \f$B\f$ | `Function` | the function, with its derivatives |
/// | \f$R\f$ | `AtParticle::R` | quality number of second derivatives, particles::quality() |
///
/// The first paper's Section 5.1 asks for the worst particle, and finds it at the boundary. In space a
/// boundary has several kinds of places: an edge and a corner in the plane; a face, an edge and a corner in
/// space. A particle at a corner sees a quarter or an eighth of what one inside sees. The test therefore
/// says the largest error of each place.
///
/// Each particle is differentiated on its own, so that in medians of many draws a sample of the particles can
/// stand for all. The operators are made some hundred rows at a time: those of all 48³ particles would fill
/// two gigabytes.
///
/// \image html fpm_in_space_figure_plane.svg "Largest errors of second derivatives (above) and of first derivatives (below) by place against the particles along a side, in the plane: a grid (left), and medians of 25 draws perturbed by δ/4 (right)."
/// \image html fpm_in_space_figure_space.svg "The same in space."
///
/// **Does a number without a solution predict the error?** The figure has two errors on the layouts of
/// particles around the hole of the second paper. At each particle, the error of the derivatives of ln r
/// stands below the bound that the quality number R gives with the size of the fourth derivatives, and goes
/// with it; R alone says much less. The error of a solution by collocation does not go with the largest R of
/// its rows: there the layouts differ mostly by unknowns that alternate from particle to particle, the noise,
/// which R cannot see.
///
/// \image html fpm_in_space_figure_quality.svg "Left: errors of second derivatives of ln r at each particle against the bound from R. Right: errors of displacements by collocation against the largest R of each of 25 layouts; the colour is the noise."
///
/// What this section claims, and what was measured: \claims{F-4}.
/// On particles that you move: \ref live_plane.
namespace derivative_test {

using particles::Cloud;
using particles::Exponents;
using particles::Index;
using particles::Point;
using particles::Range;
using particles::Smoothing;

/// A function B of a place: \f$\partial^a B(x)\f$ for multi-indices a up to order 2, of which order 0 is the
/// value. It may be called from several threads at once.
template <int dim>
using Function = std::function<double(const Point<dim>&, const Exponents<dim>&)>;

/// The function of the test, as one types it.
template <int dim>
inline constexpr std::string_view function_typed =
    dim == 2 ? "exp(x+y/2)+sin(x+2*y)" : "exp(x+y/2-0.3*z)+sin(x+2*y+1.5*z)";

/// The function of the test, without symmetries of the square and the cube. \defeq{F14}
/// \f[ B(x) = e^{c \cdot x} + \sin(k \cdot x), \qquad c = (1, \tfrac12, -\tfrac{3}{10}),
///     \ k = (1, 2, \tfrac32) \tag{F14} \f]
/// in the plane without the third coordinate.
template <int dim>
double exponential_and_wave(const Point<dim>& x, const Exponents<dim>& a);

/// Particles of the unit square or cube, sorted by their place.
template <int dim>
struct Body {
    Cloud<dim> cloud;
    std::array<Range, dim + 1> on_sides;  ///< those that lie on no side, on one, …
};

/// A grid of \f$n^d\f$ particles, each moved at random along the sides that it lies on. \defeq{F15}
/// \f[ x_j = \delta\,(j + a\,U(-1, 1)), \qquad \delta = \frac{1}{n - 1} \tag{F15} \f]
/// in each coordinate with 0 < j < n − 1; others stay 0 or 1. Volumes are equal. The particles of a place are
/// in random order, so that its first ones are a sample. A stretched grid has these coordinates mapped by
/// stretched(): where one axis is stretched and the other is not yet, its cells are as many times longer than
/// wide.
/// \param perturbation a, in units of δ \param seed of the displacements, and of the order
/// \param growth G of stretched()
/// \throws base::InvalidInput for n < 3, a perturbation outside [0, 1/2), and as stretched()
template <int dim>
Body<dim> body(Index n, double perturbation, unsigned long seed, double growth = 1);

/// A map of [0, 1] onto itself along which distances grow by a factor,
/// \f[ x = \frac{G^s - 1}{G - 1} \f]
/// \param growth G; 1 leaves all places where they are
/// \throws base::InvalidInput for G outside [1/1000, 1000]
double stretched(double s, double growth);

/// The distance of the neighbours of a stretched grid along the axes at a place, the largest of them. A
/// smoothing length that follows it sees enough particles along all axes. [length]
/// \param spacing δ of the grid before it is stretched
template <int dim>
double stretched_spacing(const Point<dim>& x, double spacing, double growth);

/// What the test finds at a particle.
struct AtParticle {
    Index particle;
    double first, second;  ///< largest errors of the derivatives of order 1 and 2
    double laplacian;      ///< error of the sum of the second derivatives along the axes
    double R;              ///< largest quality number of the second derivatives, in units of δ
};

/// The errors at some particles, \defeq{F16}
/// \f[ \max_{|a| = k} \big| \sum_j w^a_j\,[B(x_j) - B(x_i)] - \partial^a B(x_i) \big|, \qquad k = 1, 2
///     \tag{F16} \f]
/// \param spacing δ of R: one for all particles, or one for each [length]
/// \param places ranges of particles
/// \return what is found at the particles of each range
/// \throws base::InvalidInput where B is not finite
/// \throws base::FailedComputation as particles::assemble()
template <int dim>
std::vector<std::vector<AtParticle>> errors(const Formulation<double, dim>& formulation,
                                            const Cloud<dim>& cloud, const Smoothing<double, dim>& smoothing,
                                            const particles::Column<double>& spacing,
                                            const std::type_identity_t<Function<dim>>& B,
                                            const std::vector<Range>& places);

/// The largest of each, and the particle with the largest error of second derivatives.
AtParticle largest(const std::vector<AtParticle>& all);

// Compiled once: section_4_derivative_test.cpp.
extern template double exponential_and_wave<2>(const Point<2>&, const Exponents<2>&);
extern template double exponential_and_wave<3>(const Point<3>&, const Exponents<3>&);
extern template Body<2> body(Index, double, unsigned long, double);
extern template Body<3> body(Index, double, unsigned long, double);
extern template double stretched_spacing<2>(const Point<2>&, double, double);
extern template double stretched_spacing<3>(const Point<3>&, double, double);
extern template std::vector<std::vector<AtParticle>> errors(const Formulation<double, 2>&, const Cloud<2>&,
                                                            const Smoothing<double, 2>&,
                                                            const particles::Column<double>&,
                                                            const Function<2>&, const std::vector<Range>&);
extern template std::vector<std::vector<AtParticle>> errors(const Formulation<double, 3>&, const Cloud<3>&,
                                                            const Smoothing<double, 3>&,
                                                            const particles::Column<double>&,
                                                            const Function<3>&, const std::vector<Range>&);

}  // namespace derivative_test
}  // namespace fpm_in_space
