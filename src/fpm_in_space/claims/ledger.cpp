#include "fpm_in_space/claims/ledger.hpp"

namespace fpm_in_space::claims {

report::Ledger ledger() {
    return {"fpm_in_space", report::joined({section_1(), section_2(), section_3(), section_4(), section_5(),
                                            section_6(), section_7()})};
}

}  // namespace fpm_in_space::claims
