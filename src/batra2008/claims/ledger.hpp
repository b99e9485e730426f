#pragma once

#include "report/ledger.hpp"

namespace batra2008 {

/// The computations that decide the claims of paper/claims.csv, section by section.
namespace claims {

report::Computations section_2();
report::Computations section_3_1();
report::Computations section_3_2();
report::Computations section_4_1();
report::Computations section_4_2();

/// All computations. Convention 0 takes the error norm as printed, a difference of norms; convention 1 the
/// norm of the difference. Those about the hole's layouts read data/batra2008/layouts.csv.
report::Ledger ledger();

}  // namespace claims
}  // namespace batra2008
