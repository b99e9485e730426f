#pragma once

#include <string>
#include <vector>

#include "bodies/approximation.hpp"
#include "bodies/conditions.hpp"
#include "particles/quality.hpp"

namespace bodies {

/// Stands for the order of the derivatives of a particle whose equations are made elsewhere.
inline constexpr int no_equations = -1;

/// The order of the highest derivative in the equations of each particle by a method.
template <int dim, int n>
std::vector<int> highest_derivatives(const Conditions<dim, n>& conditions, Method method);

/// The quality number R of each particle's derivatives, particles::quality(), and the worst row.
struct Quality {
    Column<double> R;  ///< zero for a particle without equations
    particles::WorstRow worst;
};

/// \param order of the highest derivative in the equations of each particle, or no_equations
/// \throws base::FailedComputation with the place and a remedy where neighbours do not determine the
///         derivatives, and where the worst row is too bad for a solution
template <int dim>
Quality checked_quality(const Body<dim>& body, const Approximation<dim>& approximation,
                        const std::vector<int>& order);

/// ", or the method hats"; empty for hats itself, and for a body without cells.
template <int dim>
std::string or_hats(const Body<dim>& body, Method method) {
    return body.cells.empty() || method == Method::hats ? "" : ", or the method hats";
}

}  // namespace bodies
