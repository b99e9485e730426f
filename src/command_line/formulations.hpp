#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "asprone2010/formulations.hpp"

namespace command_line {

/// The formulations of asprone2010 and, as an eighth, the SSPH basis of batra2008 in one dimension, "ssph":
/// what the three numerical tests can compare.
/// \tparam Scalar double, long double or base::Quad
template <class Scalar = double>
const std::vector<asprone2010::Formulation<Scalar>>& formulations();

/// Their names.
std::vector<std::string> formulation_names();

/// The names of formulations that "all" leaves out, since neither paper has them: definite_fpm, that of
/// fpm_in_space on a line.
std::vector<std::string> names_beside_all();

/// The names of the kernels without a parameter.
std::vector<std::string> kernel_names();

/// The formulation of this name, also one of names_beside_all().
/// \throws base::InvalidInput for a name that no formulation has
template <class Scalar = double>
const asprone2010::Formulation<Scalar>& formulation_named(std::string_view wanted);

}  // namespace command_line
