#include "asprone2010/section_3_4_fpm.hpp"

#include <algorithm>
#include <cmath>

#include "asprone2010/claims/ledger.hpp"
#include "asprone2010/claims/measures.hpp"

namespace asprone2010::claims {

namespace {

Column<double> rule(const Neighbourhood<double>& near) {
    return fpm::first_derivative(near);
}

/// \f$e'_1\f$ of (27) over the norm of W, and \f$e'_2\f$ of (28) over that of DW.
double e_27(const CentredKernel& W_i) {
    return fpm::first_remainder(B, DB(W_i.x), W_i) / W_i.norm(W_i.W);
}
double e_28(const CentredKernel& W_i) {
    return fpm::second_remainder(B, DB(W_i.x), W_i) / W_i.norm(W_i.DW);
}

}  // namespace

report::Computations section_3_4() {
    return {
        // Orders of the remainders over the norms
        {"A-3.4-e-27", order_everywhere(e_27)},
        {"A-3.4-e-28-at-end", order_at_ends(e_28)},
        {"A-3.4-e-28-inside", order_far_inside(e_28)},
        // Order in h of B at the ends
        {"A-3.4-B-at-end",
         order_at_ends([](const CentredKernel& W_i) { return fpm::error(B, DB(W_i.x), W_i)[0]; })},
        // Order of DB at an end
        {"A-3.4-DB-at-end", order_at_end(rule, DB, 1)},
        // Order of DB inside
        {"A-3.4-DB-inside", order_inside("fpm", Derivative::first)},
        // Order of the largest error of D²B, the first derivative applied twice
        {"A-3.4-applied-twice", order_of_largest_error("fpm", Derivative::second)},
        // Largest of A12/h and A21 h inside
        {"A-3.4-moments-inside", measured([] {
             return largest(inside, [](double x) {
                 const auto W_i = kernel_at(x);
                 const auto A = fpm::matrix(W_i);
                 return std::max(std::abs(A(0, 1)) / W_i.h, std::abs(A(1, 0)) * W_i.h);
             });
         })},
    };
}

}  // namespace asprone2010::claims
