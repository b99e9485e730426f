#pragma once

#include <string>
#include <utility>
#include <vector>

#include "bodies/integrals.hpp"
#include "bodies/solution.hpp"

// Error measures of a solution without a reference: whether its forces are in equilibrium, whether its
// stresses meet the loads, and whether its unknowns alternate.
namespace bodies {

/// What acts on a body, each side by itself. [force, in the plane per unit thickness; or heat]
template <int n>
struct Balance {
    std::vector<std::pair<std::string, Values<n>>> loads;      ///< given, by side
    std::vector<std::pair<std::string, Values<n>>> reactions;  ///< of given values, by side
    Values<n> volume;  ///< of the body force or the source, less the reaction c u
    /// The sum of all forces over half of the sum of their sizes. The size of a load is an integral, that of
    /// a reaction the size of the side's resultant; for a scalar, and without loads, it is an integral, too,
    /// since reactions may cancel on a side.
    double defect = 0;
};

/// The error measures of a solution.
template <int n>
struct Judgement {
    /// Largest difference of an unknown from the field, over h and relative to the gradients, as
    /// batra2008::example_problems::noise().
    double noise;
    /// How far the solution's own load \f$F n\f$ is from the given one, zero on free sides: root mean
    /// squares over the boundary, relative to that of F. It shows stresses that are wrong where displacements
    /// are right, as in a material that is nearly incompressible.
    double missed_loads;
    /// The reactions of `hats` are the residuals of the particles' equations, in equilibrium with the loads
    /// to round-off; those of the other methods are integrals of the solution's own load over the sides with
    /// given values, and their defect tells whether the stresses can be trusted.
    Balance<n> balance;
    /// Root mean square of F over the boundary, relative to the terms whose sum is F. Where it is at most
    /// round_off_of_terms, F may be round-off, as in a rigid-body motion. Then noise is 0, and missed_loads
    /// is relative to the loads, or 0 without loads. Without loads, the defect is relative to no less than
    /// round_off_of_terms times the terms.
    double share_of_terms;
};

/// Largest Judgement::share_of_terms at which F may be round-off.
inline constexpr double round_off_of_terms = 1e-9;

template <int dim, int n>
Judgement<n> judgement(const Problem<dim, n>& problem, const Body<dim>& body,
                       const Solution<dim, n>& solution);

/// The integral of a vector, and that of its size.
template <int n>
struct Integral {
    Values<n> vector = Values<n>::Zero();
    double size = 0;

    void add(double weight, const Values<n>& value) {
        vector += weight * value;
        size += weight * value.stableNorm();
    }
};

/// What acts on a side or in the volume.
template <int n>
struct Forces {
    Integral<n> load;      ///< that is given
    Integral<n> reaction;  ///< the solution's own load where a value is given
    double parts = 0;      ///< integral of the sizes of the terms of a load, such as a u0 and a u
    double area = 0;       ///< of the side, or the volume of the body
};

/// The numbers that a judgement is made of, except for `hats`. Those of the parts of a body give those of the
/// whole: combine() says how.
template <int n>
struct Sums {
    std::vector<Forces<n>> on{};  ///< each side of Problem::given
    Forces<n> in{};
    double missed = 0, applied = 0, sizes = 0, area = 0;  ///< of loads and of F, squared, over the boundary
    double gradients = 0;                                 ///< squared, over the particles
    double unseen = 0;                      ///< largest part of the unknowns that the function misses, over h
    double largest_u = 0, coefficient = 0;  ///< sizes
    double error_of_values = 0, error_of_source = 0;  ///< of what is given, from round-off, above the level
};

/// Calls `add` for each number that is a sum over the parts of a body, and `most` for each that is the
/// largest over the parts.
template <int n, class Add, class Most>
void combine(Sums<n>& sums, const Add& add, const Most& most) {
    const auto forces = [&](Forces<n>& of) {
        for (Integral<n>* integral : {&of.load, &of.reaction}) {
            for (double& number : integral->vector) add(number);
            add(integral->size);
        }
        add(of.parts);
        add(of.area);
    };
    for (Forces<n>& of : sums.on) forces(of);
    forces(sums.in);
    for (double* number : {&sums.missed, &sums.applied, &sums.sizes, &sums.area, &sums.gradients})
        add(*number);
    for (double* number :
         {&sums.unseen, &sums.largest_u, &sums.coefficient, &sums.error_of_values, &sums.error_of_source})
        most(*number);
}

/// \param body or a part of it, with the pieces over which this part integrates
/// \param volume points of the body or the part, rule_in()
/// \param spacing mean distance of the body's particles \param own particles over which this part sums
template <int dim, int n>
Sums<n> sums(const Problem<dim, n>& problem, const Body<dim>& body, const Solution<dim, n>& solution,
             const std::vector<IntegrationPoint<dim>>& volume, double spacing, const std::vector<int>& own);

/// Where the particles of a body lie, and how many they are.
template <int dim>
struct Extent {
    Point<dim> low, high;
    Index particles;

    /// Mean distance of the particles, Cloud::spacing(). [length]
    [[nodiscard]] double spacing() const;
};

template <int dim>
Extent<dim> extent_of(const Body<dim>& body);

/// The judgement from the numbers of all parts.
template <int dim, int n>
Judgement<n> judgement(const Problem<dim, n>& problem, const Sums<n>& sums, const Extent<dim>& extent);

/// Particles with a neighbour across a gap: no path of cell edges within the neighbourhood leads to it, as
/// where a slot is narrower than the kernel's support. Their equations do not know of the gap. None without
/// cells.
template <int dim>
std::vector<Index> across_gaps(const Body<dim>& body, const Approximation<dim>& approximation);

}  // namespace bodies
