#pragma once

#include "report/table.hpp"

namespace batra2008 {

/// Measures what the choices change that the print leaves open: error norm, displacement at a particle,
/// conditions at corners, Gauss points, penalty, and around the hole layout and radius.
report::Table choices();

}  // namespace batra2008
