#include "expressions/expression.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "base/errors.hpp"

/// Any text is an expression with finite values and derivatives on [0, 1], or is refused as invalid input.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const auto [value, first, second] =
            expressions::expression<double>("--function", {reinterpret_cast<const char*>(data), size});
        for (const double x : {0.0, 0.1, 0.5, 1.0})
            if (!std::isfinite(value(x)) || !std::isfinite(first(x)) || !std::isfinite(second(x)))
                std::abort();
    } catch (const base::InvalidInput&) {
    }
    return 0;
}
