#include "asprone2010/claims/ledger.hpp"

namespace asprone2010::claims {

report::Ledger ledger() {
    return {"asprone2010",
            report::joined({section_2(), section_3_1(), section_3_2(), section_3_3(), section_3_4(),
                            section_3_5(), section_4(), section_5_1(), section_5_2(), section_5_3()})};
}

}  // namespace asprone2010::claims
