#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "particles/centred_kernel.hpp"
#include "particles/neighbourhood.hpp"
#include "report/ledger.hpp"

namespace asprone2010::claims {

using particles::CentredKernel;
using particles::Column;
using particles::Index;
using particles::Neighbourhood;
using particles::Volumes;
using report::Computation;
using report::Measurement;

// Computations from measured numbers

/// A number that depends on the convention of the volumes.
Computation measured(const std::function<double(Volumes)>& number);

/// A number that does not: the claim is about integrals or about the continuous problem.
Computation measured(const std::function<double()>& number);

/// The claim as it stands, then readings that add a condition.
Computation readings(const std::function<std::vector<Measurement>(Volumes)>& measurements);

// Functions that the claims speak of

/// A function without symmetries, for what the print says of any B, and its derivatives.
double B(double x);
double DB(double x);
double D2B(double x);

// Integral forms, on Ω = [0, 1]

/// The Gaussian around a place, with h = 0.05.
CentredKernel kernel_at(double x);

/// Places at the ends, near them and in the middle; and places whose support lies inside Ω.
inline const std::vector<double> everywhere{0, 0.013, 0.06, 0.5, 0.94, 1}, inside{0.4, 0.5, 0.6};

/// The largest absolute value over some places.
double largest(const std::vector<double>& places, const std::function<double(double)>& value);

/// Order in h of an error of the integral forms, at a place.
double order_in_h(double place, const std::function<double(const CentredKernel&)>& error);

/// An error of the integral forms around a particle.
using IntegralError = std::function<double(const CentredKernel&)>;

/// The smaller of its orders in h at both ends; the order in the middle; the smallest of the three.
Computation order_at_ends(const IntegralError& error);
Computation order_far_inside(const IntegralError& error);
Computation order_everywhere(const IntegralError& error);

// Sums over neighbourhoods

/// Numbers of particles over which an order is observed: the usual, and with few and with many particles.
inline const std::vector<Index> usual{320, 640, 1280}, few{20, 40, 80, 160}, many{10240, 20480, 40960};

/// Observed order in δ of errors with these numbers of particles; the sign of an error does not count.
double order(const std::vector<Index>& numbers, const std::function<double(Index)>& error);

/// Which of 100 particles: all, or those whose support lies inside Ω.
enum class Where { all, interior };

/// The largest absolute value over the neighbourhoods of 100 particles. \param perturbation of their
/// positions, in δ
double over_particles(Volumes volumes, Where where,
                      const std::function<double(const Neighbourhood<double>&)>& value,
                      double perturbation = 0, unsigned long seed = 1);

/// Weights on the differences \f$B(x_j) - B(x_i)\f$ of a neighbourhood.
using Rule = std::function<Column<double>(const Neighbourhood<double>&)>;

/// The last neighbourhood of N uniform particles, where its weights apply, and what they are multiplied by.
struct LastNeighbourhood {
    Neighbourhood<double> near;
    Column<double> x;  ///< positions of its particles, the last its own
    double h;          ///< smoothing length
};
LastNeighbourhood last_neighbourhood(Index N, Volumes volumes);

/// Error of DB (power 1) or D²B (power 2) by a rule at the last of N particles.
double error_at_end(Index N, Volumes volumes, const Rule& rule, double exact(double), int power);

/// Its order over the usual numbers of particles.
Computation order_at_end(const Rule& rule, double exact(double), int power);

// Operators on lines of particles

/// The derivatives that an operator approximates.
enum class Derivative { first = 1, second = 2 };

/// Order of the largest error of a formulation's derivative of eˣ, over the usual numbers of particles.
Computation order_of_largest_error(std::string_view formulation, Derivative which);

/// The same over the particles whose support lies inside Ω.
double order_inside(std::string_view formulation, Derivative which, Volumes volumes, double perturbation = 0,
                    double smoothing = 1);
Computation order_inside(std::string_view formulation, Derivative which);

/// Order of the median error over 51 lines, perturbed by δ/4. \param error of N particles drawn with a seed
Computation order_of_median(const std::function<double(Index N, Volumes, unsigned long seed)>& error);

}  // namespace asprone2010::claims
