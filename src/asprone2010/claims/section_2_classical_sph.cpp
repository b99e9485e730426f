#include "asprone2010/section_2_classical_sph.hpp"

#include <algorithm>

#include "asprone2010/claims/ledger.hpp"
#include "asprone2010/claims/measures.hpp"

namespace asprone2010::claims {

report::Computations section_2() {
    const particles::Gaussian<> gaussian;
    return {
        // Smallest value of the Gaussian over offsets from −20 h to 20 h
        {"A-2-non-negative", measured([=] {
             double least = 1;
             for (double s = -20; s <= 20; s += 0.01) least = std::min(least, gaussian.W(s));
             return least;
         })},
        // Integral of the kernel around the middle of Ω
        {"A-2-integral", measured([] { return kernel_at(0.5).moment(0, kernel_at(0.5).W); })},
        // Value of the Gaussian at 20 h
        {"A-2-no-compact-support", measured([=] { return gaussian.W(20.0); })},
        // Order in h of the smoothed value's error in the middle of Ω
        {"A-2-delta", measured([] {
             return order_in_h(
                 0.5, [](const CentredKernel& W_i) { return classical_sph::value(B, W_i) - B(W_i.x); });
         })},
    };
}

}  // namespace asprone2010::claims
