#include "fpm_in_space/claims/ledger.hpp"

namespace fpm_in_space::claims {

report::Computations section_5() {
    return {};
}

}  // namespace fpm_in_space::claims
