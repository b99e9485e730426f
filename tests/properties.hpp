#pragma once

#include <doctest/doctest.h>
#include <omp.h>

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <initializer_list>
#include <random>
#include <string>

/// Properties that hold whatever is drawn.
namespace support {

/// Calls `check(seed)` for the seeds 1 to 40; for one alone where the environment variable PROPERTY_SEED names it. What fails
/// says its seed, and `PROPERTY_SEED=17 build/bin/check -tc="properties*"` repeats it.
template <class Check>
void for_each_seed(const Check& check) {
    const char* const only = std::getenv("PROPERTY_SEED");
    const std::uint64_t first = only ? std::stoull(only) : 1, last = only ? first : 40;
    for (std::uint64_t seed = first; seed <= last; ++seed) {
        INFO("PROPERTY_SEED=", seed);
        check(seed);
    }
}

/// What is drawn from a seed: the same on every system, which the standard's distributions do not promise.
class Draw {
  public:
    explicit Draw(std::uint64_t seed) : random_(seed) {}

    [[nodiscard]] double between(double least, double most) {
        return least + (most - least) * std::ldexp(static_cast<double>(random_() >> 11), -53);
    }
    [[nodiscard]] Eigen::Index between(Eigen::Index least, Eigen::Index most) {
        return least + static_cast<Eigen::Index>(random_() % static_cast<std::uint64_t>(most - least + 1));
    }
    template <class Choice>
    [[nodiscard]] Choice one_of(std::initializer_list<Choice> choices) {
        return choices.begin()[random_() % choices.size()];
    }
    /// A factor from 1e-4 to 127 with few digits: what is on_lattice(), times it, is exact.
    [[nodiscard]] double factor() {
        const auto odd = static_cast<double>(2 * (random_() % 128) + 1);
        return std::ldexp(odd, static_cast<int>(between(Eigen::Index{-13}, Eigen::Index{-1})));
    }

  private:
    std::mt19937_64 random_;
};

/// Numbers of size 1 rounded to multiples of 2⁻³⁰: sums and differences of them are exact, and what a property is broken by is not
/// the rounding of the positions, which counts in units of the distance between particles.
template <class Numbers>
typename Numbers::PlainObject on_lattice(const Eigen::DenseBase<Numbers>& x) {
    return x.derived().unaryExpr(
        [](double each) { return std::ldexp(std::nearbyint(std::ldexp(each, 30)), -30); });
}

/// So many threads, until the end of a scope. Small cases run on one: where others compute as well, threads wait for each other.
class Threads {
  public:
    explicit Threads(int count) { omp_set_num_threads(count); }
    Threads(const Threads&) = delete;
    Threads& operator=(const Threads&) = delete;
    ~Threads() { omp_set_num_threads(before_); }

  private:
    int before_ = omp_get_max_threads();
};

}  // namespace support
