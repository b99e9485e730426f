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

TEST_CASE("pack: every function is that of <cmath> in each lane, to the last bit") {
    // Numbers of all signs, and numbers in each function's domain.
    const Pack a = some(3), positive = exp(some(2)), small = some(0.9), large = 1 + positive;
    const auto check = [](const Pack& found, const auto& function, const auto&... of) {
        for (int lane = 0; lane < Pack::lanes; ++lane) CHECK(found[lane] == function(of[lane]...));
    };
#define IS_THAT_OF_LANES(function, ...) \
    check(                              \
        function(__VA_ARGS__), [](auto... x) { return std::function(x...); }, __VA_ARGS__)
    IS_THAT_OF_LANES(sqrt, positive);
    IS_THAT_OF_LANES(cbrt, a);
    IS_THAT_OF_LANES(sin, a);
    IS_THAT_OF_LANES(cos, a);
    IS_THAT_OF_LANES(tan, a);
    IS_THAT_OF_LANES(asin, small);
    IS_THAT_OF_LANES(acos, small);
    IS_THAT_OF_LANES(atan, a);
    IS_THAT_OF_LANES(sinh, a);
    IS_THAT_OF_LANES(cosh, a);
    IS_THAT_OF_LANES(tanh, a);
    IS_THAT_OF_LANES(asinh, a);
    IS_THAT_OF_LANES(acosh, large);
    IS_THAT_OF_LANES(atanh, small);
    IS_THAT_OF_LANES(expm1, a);
    IS_THAT_OF_LANES(log, positive);
    IS_THAT_OF_LANES(log2, positive);
    IS_THAT_OF_LANES(log10, positive);
    IS_THAT_OF_LANES(log1p, positive);
    IS_THAT_OF_LANES(erf, a);
    IS_THAT_OF_LANES(erfc, a);
    IS_THAT_OF_LANES(tgamma, positive);
    IS_THAT_OF_LANES(floor, a);
    IS_THAT_OF_LANES(ceil, a);
    IS_THAT_OF_LANES(round, a);
    IS_THAT_OF_LANES(trunc, a);
    IS_THAT_OF_LANES(pow, positive, a);
    IS_THAT_OF_LANES(atan2, a, small);
    IS_THAT_OF_LANES(hypot, a, small);
    IS_THAT_OF_LANES(fmod, a, small);
#undef IS_THAT_OF_LANES
    check(
        pow(a, 3), [](double x) { return std::pow(x, 3); }, a);
    check(
        a.each_lane([](double x) { return x > 0 ? 1.0 : 0.0; }), [](double x) { return x > 0 ? 1.0 : 0.0; },
        a);
}

TEST_CASE("pack: functions that no wider scalar has are refused by name, not by templates") {
    const auto has_bessel = [](const auto& s) {
        return requires {
            cyl_bessel_i(0, s);
        };
    };
    const auto has_expint = [](const auto& s) {
        return requires {
            expint(s);
        };
    };
    CHECK_FALSE(has_bessel(some(1)));
    CHECK_FALSE(has_expint(some(1)));
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
