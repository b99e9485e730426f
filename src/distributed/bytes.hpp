#pragma once

#include <vector>

#include "distributed/part.hpp"

namespace distributed {

/// A part as bytes, to be sent from one process to another.
template <int dim>
std::vector<char> bytes_of(const Part<dim>& part);

/// The part that bytes_of() has written.
template <int dim>
Part<dim> part_from(const std::vector<char>& bytes);

}  // namespace distributed
