#pragma once

#include <cstdint>
#include <random>

namespace base {

/// Uniform random numbers: the Mersenne twister mt19937, divided by 2³². They have the bits of GSL's mt19937
/// and gsl_ran_flat on every platform; std::uniform_real_distribution differs between libraries.
class Random {
  public:
    /// \param seed 0 means 4357, as in GSL; of larger seeds the last 32 bits count
    explicit Random(unsigned long seed)
        : twister_(static_cast<std::uint32_t>(seed == 0 ? 4357 : seed & 0xffffffffUL)) {}

    /// The next number of \f$U(a, b)\f$; b itself is not drawn.
    double uniform(double a, double b) {
        const double u = static_cast<double>(twister_()) / 4294967296.0;
        return a * (1 - u) + b * u;
    }

  private:
    std::mt19937 twister_;
};

}  // namespace base
