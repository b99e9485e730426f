#pragma once

#include "report/ledger.hpp"

namespace asprone2010 {

/// The computations that decide the claims of paper/claims.csv.
namespace claims {

/// All computations. Convention 0 takes volumes equal, 1 as a partition.
report::Ledger ledger();

}  // namespace claims
}  // namespace asprone2010
