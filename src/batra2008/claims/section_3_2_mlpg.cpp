#include "batra2008/section_3_2_mlpg.hpp"

#include <algorithm>
#include <string>

#include "batra2008/claims/ledger.hpp"
#include "batra2008/claims/measures.hpp"
#include "batra2008/section_4_1_plate.hpp"
#include "report/read_table.hpp"

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

/// Seconds of a method in data/batra2008/seconds.csv, assembly and solution, over the grids that all methods
/// solved.
double seconds(const std::string& method) {
    const report::Table table = report::read_table("data/batra2008/seconds.csv");
    double total = 0;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const auto value = [&](const char* column) {
            return std::get<double>(table.rows[row][table.column(column)]);
        };
        if (table.word(row, "method") == method && value("particles") <= 8241)
            total += value("seconds_assembly") + value("seconds_solution");
    }
    return total;
}

}  // namespace

report::Computations section_3_2() {
    return {
        // Evaluations of the basis for each one of collocation
        {"B-3.2-cost", measured([] { return bases_for_one(16, 4); })},
        // Seconds of weak1 over those of weak2
        {"B-3.2-time-weak1", measured([] { return seconds("weak1") / seconds("weak2"); })},
        // Seconds of the faster weak form over those of collocation
        {"B-3.2-time",
         measured([] { return std::min(seconds("weak1"), seconds("weak2")) / seconds("strong"); })},
    };
}

}  // namespace batra2008::claims
