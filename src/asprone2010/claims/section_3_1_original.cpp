#include "asprone2010/section_3_1_original.hpp"

#include <algorithm>
#include <cmath>

#include "asprone2010/claims/ledger.hpp"
#include "asprone2010/claims/measures.hpp"

namespace asprone2010::claims {

namespace {

double one(double /*x*/) {
    return 1;
}

Column<double> rule(const Neighbourhood<double>& near) {
    return original::first_derivative(near);
}

/// Error of (8) at the last of N particles.
double error_without_differences(Index N, Volumes volumes) {
    const auto [near, x, h] = last_neighbourhood(N, volumes);
    const Column<double> weights = original::interior_derivative(near);
    double sum = 0;
    for (Index k = 0; k < weights.size(); ++k) sum += weights[k] * B(x[k]);
    return sum / h - DB(1);
}

}  // namespace

report::Computations section_3_1() {
    return {
        // Largest difference between (10) and (7) inside
        {"A-3.1-equivalent-inside", measured([] {
             return largest(inside, [](double x) {
                 return original::first_derivative(B, kernel_at(x)) -
                        original::interior_derivative(B, kernel_at(x));
             });
         })},
        // Largest derivative of a constant by (10)
        {"A-3.1-constants", measured([] {
             return largest(everywhere,
                            [](double x) { return original::first_derivative(one, kernel_at(x)); });
         })},
        // Largest difference between (6) and (5)
        {"A-3.1-green", measured([] {
             return largest(everywhere, [](double x) {
                 return original::derivative_by_parts(B, kernel_at(x)) -
                        original::smoothed_derivative(DB, kernel_at(x));
             });
         })},
        // Largest derivative of a constant by (7) inside
        {"A-3.1-constants-inside", measured([] {
             return largest(inside,
                            [](double x) { return original::interior_derivative(one, kernel_at(x)); });
         })},
        // The integral of (9) at the ends, the smaller absolute value
        {"A-3.1-boundary", measured([] {
             return std::min(std::abs(original::total_derivative(kernel_at(0))),
                             std::abs(original::total_derivative(kernel_at(1))));
         })},
        // Order of DB by (11) at an end
        {"A-3.1-DB-at-end", order_at_end(rule, DB, 1)},
        // Error of (11) over that of (8) at an end, 640 particles
        {"A-3.1-improvement", measured([](Volumes volumes) {
             return std::abs(error_at_end(640, volumes, rule, DB, 1) /
                             error_without_differences(640, volumes));
         })},
    };
}

}  // namespace asprone2010::claims
