#pragma once

#include <array>
#include <charconv>
#include <stdexcept>
#include <string>

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error \
    "-ffast-math takes away infinity and NaN, by which what cannot be computed is found; compile without it"
#endif

/// The shared vocabulary of particle methods; it knows no paper.
namespace particles {

/// The caller asked for something that has no meaning: N < 2, unsorted positions, h ≤ 0, an unknown name.
class InvalidInput : public std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

/// A well-posed question without an answer: a singular neighbourhood, a singular system.
class FailedComputation : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A number as messages and tables show it: shortest form with so many significant digits, in no locale.
inline std::string shown(double number, int digits = 6) {
    std::array<char, 64> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::general, digits);
    return {text.data(), end.ptr};
}

}  // namespace particles
