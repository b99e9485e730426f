#include "base/pack.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>

#include "particles/kernels.hpp"

using namespace base;
using namespace particles;

namespace {

/// Numbers of all sizes and signs, one a lane.
Pack some(double scale) {
    std::array<double, Pack::lanes> each{};
    for (std::size_t lane = 0; lane < each.size(); ++lane)
        each[lane] = scale * std::cos(1 + 2.3 * static_cast<double>(lane));
    return Pack::from(each.data());
}

}  // namespace

TEST_CASE("pack: every operation is that of the lanes, to the last bit") {
    const Pack a = some(3), b = some(-0.7);
    Pack c = a;
    c += b;
    c *= a;
    c -= b;
    c /= a;
    for (int lane = 0; lane < Pack::lanes; ++lane) {
        const double x = a[lane], y = b[lane];
        CHECK((a + b)[lane] == x + y);
        CHECK((a - b)[lane] == x - y);
        CHECK((a * b)[lane] == x * y);
        CHECK((a / b)[lane] == x / y);
        CHECK((-a)[lane] == -x);
        CHECK(c[lane] == ((x + y) * x - y) / x);
        CHECK(abs(a)[lane] == std::abs(x));
        CHECK(max(a, b)[lane] == std::max(x, y));
        CHECK(min(a, b)[lane] == std::min(x, y));
        CHECK(chosen(a < b, a, b)[lane] == (x < y ? x : y));
    }
}

TEST_CASE(
    "pack: a comparison holds everywhere only if it holds in each lane, and never for what is no number") {
    const Pack a = some(3);
    CHECK(everywhere(a < 4));
    CHECK_FALSE(everywhere(a > 0));
    CHECK_FALSE(everywhere(a > std::numeric_limits<double>::quiet_NaN()));
    CHECK(everywhere(1 < 2));
    CHECK_FALSE(everywhere(2 < 1));
}

TEST_CASE("pack: the least lane") {
    double expected = some(3)[0];
    for (int lane = 1; lane < Pack::lanes; ++lane) expected = std::min(expected, some(3)[lane]);
    CHECK(least(some(3)) == expected);
    CHECK(least(2.5) == 2.5);
}

TEST_CASE("pack: kernels of a pack are those of its lanes, exponentials to two units in the last place") {
    for_each_kernel([](const Kernel<>& any) {
        std::visit(
            [](const auto& kernel) {
                CAPTURE(kernel.name);
                for (double scale = 0.01; scale < 8; scale *= 1.3) {
                    const Pack s = some(scale), W = kernel.W(s), DW = kernel.DW(s), D2W = kernel.D2W(s);
                    for (int lane = 0; lane < Pack::lanes; ++lane) {
                        const double one = s[lane], most = 4 * std::numeric_limits<double>::epsilon();
                        CHECK(std::abs(W[lane] - kernel.W(one)) <= most * kernel.W(one));
                        CHECK(std::abs(DW[lane] - kernel.DW(one)) <= most * std::abs(kernel.DW(one)));
                        CHECK(std::abs(D2W[lane] - kernel.D2W(one)) <= most * std::abs(kernel.D2W(one)));
                    }
                }
            },
            any);
    });
}
