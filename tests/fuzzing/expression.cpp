#include "expressions/expression.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "base/errors.hpp"

/// Any text is an expression with finite values and derivatives on [0, 1], or is refused as invalid input.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const auto [f, Df, D2f] =
            expressions::expression<double>("--function", {reinterpret_cast<const char*>(data), size});
        for (const double x : {0.0, 0.1, 0.5, 1.0})
            if (!std::isfinite(f(x)) || !std::isfinite(Df(x)) || !std::isfinite(D2f(x))) std::abort();
    } catch (const base::InvalidInput&) {
    }
    return 0;
}
