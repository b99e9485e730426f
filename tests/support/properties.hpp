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

/// Tests of properties on random data.
namespace support {

/// Calls `check(seed)` for the seeds 1 to 40, or only for the seed in the environment variable PROPERTY_SEED.
/// A failure shows its seed; `PROPERTY_SEED=17 build/bin/check -tc="properties*"` repeats it.
template <class Check>
void for_each_seed(const Check& check) {
    const char* const only = std::getenv("PROPERTY_SEED");
    const std::uint64_t first = only ? std::stoull(only) : 1, last = only ? first : 40;
    for (std::uint64_t seed = first; seed <= last; ++seed) {
        INFO("PROPERTY_SEED=", seed);
        check(seed);
    }
}

/// Random numbers from a seed, the same on every system; the distributions of the standard library are not.
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
    /// A factor from 1e-4 to 127 with so few digits that its products with numbers of on_lattice() are exact.
    [[nodiscard]] double factor() {
        const auto odd = static_cast<double>(2 * (random_() % 128) + 1);
        return std::ldexp(odd, static_cast<int>(between(Eigen::Index{-13}, Eigen::Index{-1})));
    }

  private:
    std::mt19937_64 random_;
};

/// Numbers of size 1 rounded to multiples of 2⁻³⁰, whose sums and differences are exact: no property fails
/// because positions are rounded, which matters relative to the spacing.
template <class Numbers>
typename Numbers::PlainObject on_lattice(const Eigen::DenseBase<Numbers>& x) {
    return x.derived().unaryExpr(
        [](double each) { return std::ldexp(std::nearbyint(std::ldexp(each, 30)), -30); });
}

/// Sets the number of threads until the end of a scope. Small cases run on one thread: on a busy machine,
/// threads wait for each other.
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
