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

}  // namespace

report::Computations section_3_4() {
    return {
        // Order in h of B at the ends
        {"A-3.4-B-at-end", measured([] {
             return order_at_ends([](const CentredKernel& W_i) { return fpm::error(B, DB(W_i.x), W_i)[0]; });
         })},
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
