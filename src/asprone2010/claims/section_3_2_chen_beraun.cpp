#include "asprone2010/section_3_2_chen_beraun.hpp"

#include "asprone2010/claims/ledger.hpp"
#include "asprone2010/claims/measures.hpp"
#include "asprone2010/section_5_numerical_tests.hpp"

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

/// The denominator of (16) at the middle of 101 particles.
double denominator(Volumes volumes) {
    const auto [line, smoothing] = numerical_tests::discretise<double>({volumes}, 101, 1);
    const auto [r, W, DW, V] = particles::neighbourhood(line, smoothing, 50);
    return (r * DW * V).sum();
}

/// e of (14) over the norm of DW, and e of (18) over that of W.
double e_14(const CentredKernel& W_i) {
    return chen_beraun::first_remainder(B, DB(W_i.x), W_i) / W_i.norm(W_i.DW);
}
double e_18(const CentredKernel& W_i) {
    return chen_beraun::second_remainder(B, DB(W_i.x), D2B(W_i.x), W_i) / W_i.norm(W_i.W);
}

/// Largest error of DB by (15) with e times a sign in it, and of D²B by (19).
double error_of_15(double sign) {
    return largest(everywhere, [=](double x) {
        const auto W_i = kernel_at(x);
        return chen_beraun::first_derivative(B, W_i) +
               sign * chen_beraun::first_remainder(B, DB(x), W_i) / W_i.moment(1, W_i.DW) - DB(x);
    });
}
double error_of_19(double sign) {
    return largest(everywhere, [=](double x) {
        const auto W_i = kernel_at(x);
        return chen_beraun::second_derivative(B, DB(x), W_i) +
               sign * chen_beraun::second_remainder(B, DB(x), D2B(x), W_i) / (W_i.moment(2, W_i.W) / 2) -
               D2B(x);
    });
}

}  // namespace

report::Computations section_3_2() {
    return {
        // Order of DB at an end
        {"A-3.2-DB-at-end", order_at_end(first, DB, 1)},
        // Order of DB inside, on uniform particles
        {"A-3.2-DB-inside", order_inside("chen_beraun", Derivative::first)},
        // Order of DB by (11) inside with h = δ, then with h = 2δ, where the denominator of (16) is closer to
        // one
        {"A-3.2-original-inside", readings([](Volumes volumes) -> std::vector<Measurement> {
             const auto order_with = [&](double smoothing) {
                 return order_inside("original", Derivative::first, volumes, 0, smoothing);
             };
             return {{"", order_with(1)}, {"h/δ is 2", order_with(2)}};
         })},
        // Denominator of (16) inside, then with the other sign
        {"A-3.2-denominator", readings([](Volumes volumes) -> std::vector<Measurement> {
             const double sum = denominator(volumes);
             return {{"", sum}, {"the sign is changed", -sum}};
         })},
        // Order in h of D²B at the ends by (19) with the exact DB, without e
        {"A-3.2-19-at-end", order_at_ends([](const CentredKernel& W_i) {
             return chen_beraun::second_derivative(B, DB(W_i.x), W_i) - D2B(W_i.x);
         })},
        // Order of D²B at an end with DB from (16), then with the exact DB
        {"A-3.2-D2B-at-end", readings([](Volumes volumes) -> std::vector<Measurement> {
             const auto with_own_DB = [&](Index N) { return error_at_end(N, volumes, second, D2B, 2); };
             const auto with_exact_DB = [&](Index N) { return error_with_exact_DB(N, volumes); };
             return {{"", order(usual, with_own_DB)}, {"DB is exact", order(usual, with_exact_DB)}};
         })},
        // Order of D²B inside
        {"A-3.2-D2B-inside", order_inside("chen_beraun", Derivative::second)},
        // Order of e over the norm, of (14) and of (18)
        {"A-3.2-e-14-at-end", order_at_ends(e_14)},
        {"A-3.2-e-14-inside", order_far_inside(e_14)},
        {"A-3.2-e-18-at-end", order_at_ends(e_18)},
        {"A-3.2-e-18-inside", order_far_inside(e_18)},
        // First moment of DW over its norm times h, inside; then with the other sign
        {"A-3.2-first-moment", readings([](Volumes) -> std::vector<Measurement> {
             const auto W_i = kernel_at(0.5);
             const double ratio = W_i.moment(1, W_i.DW) / (W_i.norm(W_i.DW) * W_i.h);
             return {{"", ratio}, {"the sign is changed", -ratio}};
         })},
        // Largest error of (15) with the sign that is printed before the remainder, then with the other one
        {"A-3.2-printed-15", readings([](Volumes) -> std::vector<Measurement> {
             return {{"", error_of_15(1)}, {"the sign of e is changed", error_of_15(-1)}};
         })},
        // The same of (19)
        {"A-3.2-printed-19", readings([](Volumes) -> std::vector<Measurement> {
             return {{"", error_of_19(1)}, {"the sign of e is changed", error_of_19(-1)}};
         })},
    };
}

}  // namespace asprone2010::claims
