#pragma once

#include <string>
#include <vector>

#include "bodies/problem.hpp"
#include "command_line/body_quantities.hpp"
#include "report/table.hpp"

// The table of the programs that solve a problem on a body.
namespace command_line {

/// method, particles, quantity, the place, value.
template <int dim>
std::vector<report::ColumnHead> columns();

template <int dim>
std::vector<report::Cell> row(const std::string& method, bodies::Index particles,
                              const Quantity<dim>& quantity);

/// The sides of a body with their numbers of particles, and those on which nothing is given: two comments.
/// \param counts number of particles of each side
template <int dim, int n>
std::vector<std::string> about_sides(const bodies::Problem<dim, n>& problem, const bodies::Body<dim>& body,
                                     const std::vector<bodies::Index>& counts);

/// What the numbers mean, a comment; empty where their names say it.
std::string about_numbers(bool is_scalar, int dim, bool are_eigenvalues);

}  // namespace command_line
