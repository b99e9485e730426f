#pragma once

#include <optional>
#include <string>
#include <vector>

#include "batra2008/section_3_elastostatics.hpp"
#include "bodies/problem.hpp"
#include "command_line/command_line.hpp"

namespace command_line {

/// A problem on a body as it is typed, in the user's units.
struct TypedProblem {
    std::string equation = "elasticity";  ///< or poisson
    std::optional<double> young, poisson;
    std::optional<std::string> plane, body_force, source, conductivity;
    double reaction = 0;
    std::vector<Typed> conditions;  ///< on sides, in the order of the command line
    std::vector<Typed> corners;
};

/// Adds the options of a problem to a command line.
void add_options(CommandLine& app, TypedProblem& typed);

/// Whether the unknown is one scalar, not a displacement.
bool is_scalar(const TypedProblem& typed);

/// Refuses what belongs to the other equation, or to another dimension, and an incomplete material.
/// \throws base::InvalidInput with what to write instead
void check(const TypedProblem& typed, int dim);

/// The material of an elastic body. \throws base::InvalidInput for numbers that no material has
batra2008::elastostatics::Material material(const TypedProblem& typed);

/// The largest coefficient of the equation: E0 of the material, or the conductivity.
template <int dim>
double largest_coefficient(const TypedProblem& typed, const bodies::Body<dim>& body);

/// The problem on a body: elasticity for n = dim, a scalar for n = 1. Tractions and pressures on a side add.
/// All functions are evaluated at the particles where they hold.
/// \throws base::InvalidInput as given_on_sides() and corner(), for functions that are not finite at a
///         particle, and for a conductivity that is not positive
template <int dim, int n>
bodies::Problem<dim, n> problem(const TypedProblem& typed, const bodies::Body<dim>& body);

}  // namespace command_line
