#include "asprone2010/section_3_2_chen_beraun.hpp"

#include "asprone2010/claims/ledger.hpp"
#include "asprone2010/claims/measures.hpp"

namespace asprone2010::claims {

namespace {

Column<double> first(const Neighbourhood<double>& near) {
    return chen_beraun::first_derivative(near);
}

Column<double> second(const Neighbourhood<double>& near) {
    return chen_beraun::derivatives(near).second;
}

/// Error of (20) at the last of N particles with the exact DB in it.
double error_with_exact_DB(Index N, Volumes volumes) {
    const auto without_DB = [](const Neighbourhood<double>& near) {
        return chen_beraun::second_derivative(near, Column<double>(0 * near.r));
    };
    const auto [near, x, h] = last_neighbourhood(N, volumes);
    const auto& [r, W, DW, V] = near;
    return error_at_end(N, volumes, without_DB, D2B, 2) -
           DB(1) / h * (r * W * V).sum() / ((r * r * W * V).sum() / 2);
}

}  // namespace

report::Computations section_3_2() {
    return {
        // Order of DB at an end
        {"A-3.2-DB-at-end", order_at_end(first, DB, 1)},
        // Order of DB inside, on uniform particles
        {"A-3.2-DB-inside", order_inside("chen_beraun", Derivative::first)},
        // The same on perturbed particles, then on uniform ones
        {"A-3.2-DB-perturbed", readings([](Volumes volumes) -> std::vector<Measurement> {
             const auto order_with = [&](double perturbation) {
                 return order_inside("chen_beraun", Derivative::first, volumes, perturbation);
             };
             return {{"", order_with(0.25)}, {"particles are uniform", order_with(0)}};
         })},
        // Order of DB by (11) inside with h = δ, then with h = 2δ, where the denominator of (16) is closer to
        // one
        {"A-3.2-original-inside", readings([](Volumes volumes) -> std::vector<Measurement> {
             const auto order_with = [&](double smoothing) {
                 return order_inside("original", Derivative::first, volumes, 0, smoothing);
             };
             return {{"", order_with(1)}, {"h/δ is larger than 1 (here 2)", order_with(2)}};
         })},
        // Order of D²B at an end with DB from (16), then with the exact DB
        {"A-3.2-D2B-at-end", readings([](Volumes volumes) -> std::vector<Measurement> {
             const auto with_own_DB = [&](Index N) { return error_at_end(N, volumes, second, D2B, 2); };
             const auto with_exact_DB = [&](Index N) { return error_with_exact_DB(N, volumes); };
             return {{"", order(usual, with_own_DB)}, {"DB is exact", order(usual, with_exact_DB)}};
         })},
        // Order of D²B inside
        {"A-3.2-D2B-inside", order_inside("chen_beraun", Derivative::second)},
        // First moment of DW over its norm times h, inside
        {"A-3.2-first-moment", measured([] {
             const auto W_i = kernel_at(0.5);
             return W_i.moment(1, W_i.DW) / (W_i.norm(W_i.DW) * W_i.h);
         })},
        // Largest error of (15) with the sign that is printed before the remainder
        {"A-3.2-printed-15", measured([] {
             return largest(everywhere, [](double x) {
                 const auto W_i = kernel_at(x);
                 return chen_beraun::first_derivative(B, W_i) +
                        chen_beraun::first_remainder(B, DB(x), W_i) / W_i.moment(1, W_i.DW) - DB(x);
             });
         })},
        // The same of (19)
        {"A-3.2-printed-19", measured([] {
             return largest(everywhere, [](double x) {
                 const auto W_i = kernel_at(x);
                 return chen_beraun::second_derivative(B, DB(x), W_i) +
                        chen_beraun::second_remainder(B, DB(x), D2B(x), W_i) / (W_i.moment(2, W_i.W) / 2) -
                        D2B(x);
             });
         })},
    };
}

}  // namespace asprone2010::claims
