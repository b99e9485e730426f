#pragma once

#include <string>
#include <vector>

#include "bodies/problem.hpp"

namespace command_line {

/// The function of the place that a text says. \param where option and side, for messages
/// \throws base::InvalidInput for a text that cannot be read
template <int dim>
bodies::Field<dim> function(const std::string& where, const std::string& text);

/// Its gradient, from derivatives along the axes.
template <int dim>
bodies::Field<dim, bodies::Point<dim>> gradient(const std::string& where, const std::string& text);

/// Whether a text has no x, y or z.
template <int dim>
bool is_constant(const std::string& text);

/// A value at a particle. \throws base::InvalidInput with the place where it is not finite
template <int dim>
double finite(const std::string& where, const std::string& text, double value, const bodies::Point<dim>& x);

/// The function of a text that is finite at all particles of the body.
/// \throws base::InvalidInput with the place where it is not
template <int dim>
bodies::Field<dim> function_in(const bodies::Body<dim>& body, const std::string& option,
                               const std::string& text);

/// The entries of a list of functions, which commas separate outside of parentheses.
/// \throws base::InvalidInput unless there are as many as wanted
std::vector<std::string> entries(const std::string& where, const std::string& text, std::size_t wanted,
                                 const std::string& example);

}  // namespace command_line
