#pragma once

#include <Eigen/Core>

/// What every other folder stands on: errors, numbers and their text, threads, memory. It knows no particles.
namespace base {

using Index = Eigen::Index;

}  // namespace base
