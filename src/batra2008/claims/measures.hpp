#pragma once

#include <functional>
#include <vector>

#include "particles/cloud.hpp"
#include "report/ledger.hpp"

namespace batra2008::claims {

using particles::Index;
using particles::Point;
using particles::Points;
using report::Computation;
using report::Measurement;

/// The error norm in the two readings of the print: a difference of norms, or the norm of the difference.
enum class Norm { dn, nd };

/// A number that depends on the error norm.
Computation measured(const std::function<double(Norm)>& number);

/// A number that does not.
Computation measured(const std::function<double()>& number);

/// The claim as it stands, then readings that add a condition.
Computation readings(const std::function<std::vector<Measurement>(Norm)>& measurements);

/// The same where the error norm does not enter.
Computation readings(const std::function<std::vector<Measurement>()>& measurements);

/// Random particles around the origin, in a cube of side 2.
template <int dim>
particles::Cloud<dim> random_cloud(Index count, unsigned long seed);

}  // namespace batra2008::claims
