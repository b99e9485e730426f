#include "asprone2010/section_5_2_static_test.hpp"

#include <algorithm>
#include <cmath>

#include "asprone2010/claims/ledger.hpp"
#include "asprone2010/claims/measures.hpp"

namespace asprone2010::claims {

namespace {

/// Infinity norm of the displacement's error.
double error(std::string_view formulation, Index N, const numerical_tests::Discretisation& how,
             unsigned long seed = 1) {
    return static_test::error(formulation_named<double>(formulation),
                              numerical_tests::discretise<double>(how, N, seed),
                              static_test::exponential_load());
}

Computation order_of_displacement(std::string_view formulation, const std::vector<Index>& numbers) {
    return measured([=](Volumes volumes) {
        return order(numbers, [&](Index N) { return error(formulation, N, {volumes}); });
    });
}

}  // namespace

report::Computations section_5_2() {
    return {
        // Order of the displacement with 320 to 1280 particles
        {"A-5.2-second-order-fpm", order_of_displacement("second_order_fpm", usual)},
        {"A-5.2-modified-fpm", order_of_displacement("modified_fpm", usual)},
        {"A-5.2-chen-beraun", order_of_displacement("chen_beraun", usual)},
        // With 10240 to 40960
        {"A-5.2-original", order_of_displacement("original", many)},
        {"A-5.2-rkpm-first-order", order_of_displacement("rkpm_first_order", many)},
        {"A-5.2-rkpm-second-order", order_of_displacement("rkpm_second_order", many)},
        // With 20 to 160
        {"A-5.2-few-original", order_of_displacement("original", few)},
        {"A-5.2-few-rkpm-first-order", order_of_displacement("rkpm_first_order", few)},
        // Least error of modified FPM over that of second-order FPM, 20 to 1280 particles
        {"A-5.2-errs-less", measured([](Volumes volumes) {
             double least = HUGE_VAL;
             for (const Index N : {20, 40, 80, 160, 320, 640, 1280})
                 least = std::min(
                     least, error("modified_fpm", N, {volumes}) / error("second_order_fpm", N, {volumes}));
             return least;
         })},
        // Order of the median error over 51 perturbed lines
        {"A-5.2-perturbed", order_of_median([](Index N, Volumes volumes, unsigned long seed) {
             return error("second_order_fpm", N, {volumes, particles::Gaussian{}, 1, 0.25}, seed);
         })},
    };
}

}  // namespace asprone2010::claims
