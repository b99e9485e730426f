#pragma once

#include "report/ledger.hpp"

namespace asprone2010 {

/// The computations that decide the claims of paper/claims.csv, section by section.
namespace claims {

report::Computations section_2();
report::Computations section_3_1();
report::Computations section_3_2();
report::Computations section_3_3();
report::Computations section_3_4();
report::Computations section_3_5();
report::Computations section_4();
report::Computations section_5_1();
report::Computations section_5_2();
report::Computations section_5_3();

/// All computations. Convention 0 takes equal volumes, convention 1 a partition.
report::Ledger ledger();

}  // namespace claims
}  // namespace asprone2010
