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

/// \f$e''_1\f$ of (33) over the norm of W, and \f$e''_2\f$ of (34) over that of DW.
double e_33(const CentredKernel& W_i) {
    return modified_fpm::first_remainder(B, DB(W_i.x), D2B(W_i.x), W_i) / W_i.norm(W_i.W);
}
double e_34(const CentredKernel& W_i) {
    return modified_fpm::second_remainder(B, DB(W_i.x), D2B(W_i.x), W_i) / W_i.norm(W_i.DW);
}

}  // namespace

report::Computations section_3_5() {
    return {
        // Orders of the remainders over the norms
        {"A-3.5-e-33-at-end", order_at_ends(e_33)},
        {"A-3.5-e-33-inside", order_far_inside(e_33)},
        {"A-3.5-e-34", order_everywhere(e_34)},
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
