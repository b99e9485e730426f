#include "asprone2010/section_3_3_rkpm.hpp"

#include <algorithm>
#include <cmath>

#include "asprone2010/claims/ledger.hpp"
#include "asprone2010/claims/measures.hpp"

namespace asprone2010::claims {

namespace {

/// Largest deviation of the moments 0, …, m of a corrected kernel from 1, 0, …, 0, over all particles.
template <int... moments>
double deviation_of_moments(Volumes volumes) {
    return over_particles(volumes, Where::all, [](const Neighbourhood<double>& near) {
        const auto K = rkpm::corrected<moments...>(near);
        double most = 0;
        for (const int k : {moments...})
            most = std::max(most, std::abs((K.r.pow(k) * K.W * K.V).sum() - (k == 0 ? 1 : 0)));
        return most;
    });
}

/// Error of (21) with a corrected kernel.
template <int... moments>
double error_of_value(const CentredKernel& W_i) {
    return rkpm::value(B, rkpm::corrected<moments...>(W_i)) - B(W_i.x);
}

}  // namespace

report::Computations section_3_3() {
    return {
        // Largest deviation of the moments of the first-order kernel
        {"A-3.3-moments-first-order",
         measured([](Volumes volumes) { return deviation_of_moments<0, 1>(volumes); })},
        // Largest deviation of the moments of the second-order kernel
        {"A-3.3-moments-second-order",
         measured([](Volumes volumes) { return deviation_of_moments<0, 1, 2>(volumes); })},
        // Order in h of B at the ends, first-order kernel
        {"A-3.3-B-first-order", order_at_ends(error_of_value<0, 1>)},
        // Order in h of B at the ends, second-order kernel
        {"A-3.3-B-second-order", order_at_ends(error_of_value<0, 1, 2>)},
        // Order of the largest error of DB, first-order kernel
        {"A-3.3-DB-first-order", order_of_largest_error("rkpm_first_order", Derivative::first)},
        // Order of the largest error of DB, second-order kernel
        {"A-3.3-DB-second-order", order_of_largest_error("rkpm_second_order", Derivative::first)},
    };
}

}  // namespace asprone2010::claims
