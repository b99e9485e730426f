#include "batra2008/claims/ledger.hpp"

namespace batra2008::claims {

report::Ledger ledger() {
    return {"batra2008",
            report::joined({section_2(), section_3_1(), section_3_2(), section_4_1(), section_4_2()})};
}

}  // namespace batra2008::claims
