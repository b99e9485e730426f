#include "batra2008/section_3_2_mlpg.hpp"

#include "batra2008/claims/ledger.hpp"
#include "batra2008/claims/measures.hpp"
#include "batra2008/section_4_1_plate.hpp"

namespace batra2008::claims {

namespace {

/// Bases that the weak forms evaluate for each basis of collocation, on a grid of the plate.
double bases_for_one(Index nx, Index ny) {
    const Problem problem = plate::problem({plate::E, plate::nu});
    const Cloud<2> cloud(plate::grid(nx, ny));
    const particles::Region region = elastostatics::region(problem);
    double bases = 0;
    for (Index I = 0; I < cloud.size(); ++I) {
        const auto Omega =
            mlpg::subdomain(problem, region, cloud.x().col(I), cloud.apart()[I], Kernel(1), 10);
        bases += static_cast<double>(Omega.inside.size());
        for (const auto& at : Omega.boundary) bases += at.displaced[0] || at.displaced[1] ? 1 : 0;
    }
    return bases / static_cast<double>(cloud.size());
}

}  // namespace

report::Computations section_3_2() {
    return {
        // Evaluations of the basis for each one of collocation
        {"B-3.2-cost", measured([] { return bases_for_one(16, 4); })},
    };
}

}  // namespace batra2008::claims
