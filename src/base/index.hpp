#pragma once

#include <Eigen/Core>

#include "base/vector_width.hpp"

/// The ground floor, on which all other folders stand: errors, numbers and their text, threads, memory. It
/// knows no particles.
namespace base {

using Index = Eigen::Index;

}  // namespace base
