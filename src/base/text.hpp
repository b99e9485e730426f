#pragma once

#include <array>
#include <charconv>
#include <string>

namespace base {

/// A number for messages and tables: the shortest form with the given number of significant digits, in every
/// locale.
inline std::string shown(double number, int digits = 6) {
    std::array<char, 64> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::general, digits);
    return {text.data(), end.ptr};
}

}  // namespace base
