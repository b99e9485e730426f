#include "expressions/parser.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "base/errors.hpp"

namespace {

/// Text as a list of expressions of several variables.
void read_list(const std::string& text) {
    for (const std::string& part : expressions::separated(text)) try {
            const expressions::Evaluator<double> f(expressions::parsed(part, {"x", "y", "z"}));
            const std::array<double, 3> at{0.5, -1, 2};
            static_cast<void>(f(at));
        } catch (const base::InvalidInput&) {
        }
}

}  // namespace

/// Any text is an expression with finite values and derivatives on [0, 1], or is refused as invalid input.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    read_list(text);
    try {
        const auto [f, Df, D2f] = expressions::smooth<double>("--function", text);
        for (const double x : {0.0, 0.1, 0.5, 1.0})
            if (!std::isfinite(f(x)) || !std::isfinite(Df(x)) || !std::isfinite(D2f(x))) std::abort();
    } catch (const base::InvalidInput&) {
    }
    return 0;
}
