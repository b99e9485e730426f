#include "fpm_in_space/claims/ledger.hpp"

namespace fpm_in_space::claims {

report::Computations section_6() {
    return {};
}

}  // namespace fpm_in_space::claims
