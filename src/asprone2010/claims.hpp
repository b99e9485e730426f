#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "particles/line.hpp"
#include "report/verdict.hpp"

namespace asprone2010 {

/// The computations that decide the claims of paper/claims.csv.
namespace claims {

/// What a claim's quantity measures under a convention of the volumes: first for the claim as it stands, then for readings that
/// add a condition.
using Measure = std::function<std::vector<report::Measurement>(particles::Volumes)>;

/// All computations, by the claim that each decides.
const std::map<std::string, Measure>& computations();

}  // namespace claims
}  // namespace asprone2010
