#pragma once

#include "report/ledger.hpp"

namespace fpm_in_space {

/// The computations that decide the claims of paper/claims.csv, section by section.
namespace claims {

report::Computations section_1();
report::Computations section_2();
report::Computations section_3();
report::Computations section_4();
report::Computations section_5();
report::Computations section_6();
report::Computations section_7();

/// All computations. Convention 0 is the plane, and convention 1 space. Those on perturbed particles, on the
/// literal extensions and on the quality number read the tables of data/fpm_in_space.
report::Ledger ledger();

}  // namespace claims
}  // namespace fpm_in_space
