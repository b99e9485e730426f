#include "base/number.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <system_error>

#include "base/errors.hpp"

namespace base {

namespace {

constexpr std::string_view blanks = " \t\r";

[[noreturn]] void refuse(std::string_view text, const std::string& why) {
    throw InvalidInput(quoted(text) + " " + why);
}

/// The number as C++ writes it: without a plus, and with e in the exponent.
std::string in_cpp(std::string_view word) {
    const bool plus = word.starts_with('+') && !word.substr(1).starts_with('-');
    std::string text(word.substr(plus ? 1 : 0));
    const std::size_t exponent = text.find_first_of("dD");
    if (exponent != std::string::npos && exponent > 0 &&
        (std::isdigit(static_cast<unsigned char>(text[exponent - 1])) != 0 || text[exponent - 1] == '.'))
        text[exponent] = 'e';
    return text;
}

struct Parsed {
    double value;
    bool whole_text, in_range;
};

Parsed parsed(const std::string& text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool all = !text.empty() && error != std::errc::invalid_argument &&
                     end == text.data() + text.size() && std::isfinite(value);
    return {value, all, error == std::errc()};
}

/// The text with a point for its only comma, if that is a number.
std::optional<std::string> with_point(std::string_view word) {
    std::string text(word);
    if (std::count(text.begin(), text.end(), ',') != 1) return {};
    text[text.find(',')] = '.';
    return parsed(in_cpp(text)).whole_text ? std::optional(text) : std::nullopt;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string quoted(std::string_view text) {
    std::string shown(text.substr(0, 40));
    for (char& letter : shown)
        if (letter < ' ' || letter > '~') letter = '?';
    return "'" + shown + "'";
}

double number(std::string_view text) {
    const std::string_view word = trimmed(text);
    const std::string in_c = in_cpp(word);
    const auto [value, whole_text, in_range] = parsed(in_c);
    if (whole_text && in_range) return value;
    if (whole_text && std::abs(std::strtod(in_c.c_str(), nullptr)) > 1)
        refuse(word, "is larger than a double can be, 1.8e308");
    if (whole_text) refuse(word, "is smaller than a double can be, 4.9e-324; write 0");
    if (const auto pointed = with_point(word))
        refuse(word, "is no number; write a decimal comma as a point, " + *pointed);
    if (word.find(';') != std::string_view::npos)
        refuse(word, "is no number; write commas in place of semicolons");
    if (std::any_of(word.begin(), word.end(), [](unsigned char letter) { return letter > '~'; }))
        refuse(word, "is no number; a long minus, say, is to be written as a hyphen");
    refuse(word, "is no number");
}

long whole_number(std::string_view text) {
    const std::string_view word = trimmed(text);
    const std::size_t first = word.find_first_not_of("+-");
    if (first < word.size() && word[first] == '0' && first + 1 < word.size() && word[first + 1] != '.')
        refuse(word, "begins with 0; write it in decimal");
    const double value = number(word);
    constexpr bool short_long = sizeof(long) < 8;
    constexpr double most = short_long ? static_cast<double>(std::numeric_limits<long>::max()) : 1e15;
    if (value != std::round(value) || std::abs(value) > most)
        refuse(word, "is no whole number up to " +
                         (short_long ? std::to_string(std::numeric_limits<long>::max()) : "1e15"));
    return std::lround(value);
}

}  // namespace base
