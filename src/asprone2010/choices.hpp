#pragma once

#include "report/table.hpp"

namespace asprone2010 {

/// Measures what the choices change that the print leaves open: volumes, numbers of particles, draw of the
/// perturbation, moments of RKPM, derivative at the end.
report::Table choices();

}  // namespace asprone2010
