#include <Eigen/Core>
#include <memory>

#include "base/memory.hpp"
#include "base/parallel.hpp"
#include "tests/benchmarks/report.hpp"

namespace benchmarks {

namespace {

constexpr Eigen::Index block = 4096;

/// Three arrays, far larger than any cache.
struct Arrays {
    Eigen::ArrayXd a, b, c;
    explicit Arrays(Eigen::Index N) : a(N), b(N), c(N) {
        for (auto* array : {&a, &b, &c}) {
            base::prefer_large_pages(array->data(), N);
            array->setLinSpaced(-36, 0);
        }
    }
};

}  // namespace

void add_limits() {
    for (const int threads : {1, 2}) {
        // a = b + s c moves 24 bytes a number, not counting that a is read before it is written.
        add({"limit", "triad", 20 * 1000 * 1000, threads, 24}, [] {
            auto arrays = std::make_shared<Arrays>(20 * 1000 * 1000);
            return [arrays] {
                auto& [a, b, c] = *arrays;
                base::for_each_index((a.size() + block - 1) / block, [&](Eigen::Index k) {
                    const Eigen::Index size = std::min(block, a.size() - k * block);
                    a.segment(k * block, size) =
                        b.segment(k * block, size) + 3.0 * c.segment(k * block, size);
                });
                benchmark::ClobberMemory();
            };
        });
        add({"limit", "exp", 64 * block, threads}, [] {
            auto arrays = std::make_shared<Arrays>(64 * block);
            return [arrays] {
                auto& [a, b, c] = *arrays;
                base::for_each_index(64, [&](Eigen::Index k) {
                    a.segment(k * block, block) = b.segment(k * block, block).exp();
                });
                benchmark::ClobberMemory();
            };
        });
    }
}

}  // namespace benchmarks
