#include "base/random.hpp"

#include <doctest/doctest.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>

#include <memory>

TEST_CASE(
    "random: the draws are those of GSL's mt19937 and gsl_ran_flat, bit by bit, for seeds of all kinds") {
    const std::unique_ptr<gsl_rng, void (*)(gsl_rng*)> gsl(gsl_rng_alloc(gsl_rng_mt19937), gsl_rng_free);
    for (const unsigned long seed : {0UL, 1UL, 51UL, 4357UL, 0xffffffffUL, 0x100000000UL, 0x123456789abcUL}) {
        CAPTURE(seed);
        gsl_rng_set(gsl.get(), seed);
        base::Random random(seed);
        for (int k = 0; k < 2000; ++k) {
            REQUIRE(random.uniform(-1, 1) == gsl_ran_flat(gsl.get(), -1, 1));
            REQUIRE(random.uniform(0, 0.7) == gsl_ran_flat(gsl.get(), 0, 0.7));
        }
    }
}
