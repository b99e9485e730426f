#pragma once

#include <array>
#include <charconv>
#include <string>

namespace base {

/// A number as messages and tables show it: shortest form with so many significant digits, in no locale.
inline std::string shown(double number, int digits = 6) {
    std::array<char, 64> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::general, digits);
    return {text.data(), end.ptr};
}

}  // namespace base
