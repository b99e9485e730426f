#include "asprone2010/section_3_5_modified_fpm.hpp"

#include "asprone2010/claims/ledger.hpp"
#include "asprone2010/claims/measures.hpp"

namespace asprone2010::claims {

namespace {

Column<double> first(const Neighbourhood<double>& near) {
    return modified_fpm::derivatives(near).first;
}

Column<double> second(const Neighbourhood<double>& near) {
    return modified_fpm::derivatives(near).second;
}

}  // namespace

report::Computations section_3_5() {
    return {
        // Order of DB at an end
        {"A-3.5-DB-at-end", order_at_end(first, DB, 1)},
        // Order of D²B at an end
        {"A-3.5-D2B-at-end", order_at_end(second, D2B, 2)},
        // Order of DB inside
        {"A-3.5-DB-inside", order_inside("modified_fpm", Derivative::first)},
        // Order of D²B inside
        {"A-3.5-D2B-inside", order_inside("modified_fpm", Derivative::second)},
    };
}

}  // namespace asprone2010::claims
