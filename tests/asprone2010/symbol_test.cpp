#include "asprone2010/symbol.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/asprone2010/stencils.hpp"

using namespace asprone2010;
using namespace limit_stencils;
using support::relative;

TEST_CASE("symbol: that of central differences is 2 cos θ − 2") {
    for (const double theta : {0.1, 1.0, 3.0})
        CHECK(symbol(support::central_difference(), theta) == relative(2 * std::cos(theta) - 2, 1e-14));
}

TEST_CASE("symbol_frequencies: they increase, and long waves have the exact ones") {
    const auto frequencies = symbol_frequencies(formulation_named<double>("second_order_fpm"), {}, 100);
    REQUIRE(frequencies.size() == 98);
    CHECK(std::is_sorted(frequencies.begin(), frequencies.end()));
    for (const int n : {1, 2, 3}) CHECK(frequencies[n - 1] == relative(std::numbers::pi * n, 2e-3));
}
